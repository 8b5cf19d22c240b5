/// SHA-256, from OpenSSL: of what decides results, of blocks, and of finished files.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace overturn::store {

/// SHA-256 of some bytes, as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view content);

/// The same of bytes that come in parts.
class Sha256 {
  public:
    /// \throws SystemError if OpenSSL has none
    Sha256();
    ~Sha256();
    Sha256(Sha256 const&) = delete;
    Sha256& operator=(Sha256 const&) = delete;
    Sha256(Sha256&&) = delete;
    Sha256& operator=(Sha256&&) = delete;

    void add(std::span<std::byte const> part);
    /// Text with its length before it, so that no two sequences of texts are the same bytes.
    void add_text(std::string_view text);
    /// 64 hexadecimal digits. \pre called once
    [[nodiscard]] std::string digits();

  private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace overturn::store

#include "store/sha256.hpp"

#include <array>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "core/error.hpp"

namespace overturn::store {
namespace {

void require(bool done) {
    if (!done) {
        throw SystemError("OpenSSL cannot compute SHA-256 (a restricted build?). Install libssl");
    }
}

}  // namespace

struct Sha256::Context {
    EVP_MD_CTX* handle = EVP_MD_CTX_new();

    Context() = default;
    ~Context() { EVP_MD_CTX_free(handle); }
    Context(Context const&) = delete;
    Context& operator=(Context const&) = delete;
    Context(Context&&) = delete;
    Context& operator=(Context&&) = delete;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
    require(context_->handle != nullptr && EVP_DigestInit_ex(context_->handle, EVP_sha256(), nullptr) == 1);
}

Sha256::~Sha256() = default;

void Sha256::add(std::span<std::byte const> part) {
    require(EVP_DigestUpdate(context_->handle, part.data(), part.size()) == 1);
}

void Sha256::add_text(std::string_view text) {
    auto const length = fmt::format("{}:", text.size());
    add(std::as_bytes(std::span(length)));
    add(std::as_bytes(std::span(text)));
}

std::string Sha256::digits() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    require(EVP_DigestFinal_ex(context_->handle, digest.data(), &length) == 1);
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
        text += fmt::format("{:02x}", digest.at(i));
    }
    return text;
}

std::string sha256(std::string_view content) {
    Sha256 hash;
    hash.add(std::as_bytes(std::span(content)));
    return hash.digits();
}

}  // namespace overturn::store

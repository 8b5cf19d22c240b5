/// Values as bytes, from one process of this program to another: exact, and never kept.
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace overturn {

/// Plain values, lists and optional values of them, and structs for which there is `each_part(bytes, value)`, which
/// passes their parts to `bytes`.
class BytesOut {
  public:
    template <class... Values> void operator()(Values const&... values) { (put(values), ...); }
    [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }

  private:
    template <class Value> void put(Value const& value) {
        if constexpr (std::is_trivially_copyable_v<Value>) {
            static_assert(!std::is_pointer_v<Value>);
            bytes_.append(reinterpret_cast<char const*>(&value), sizeof(Value));
        } else {
            each_part(*this, value);
        }
    }
    template <class Value> void put(std::vector<Value> const& list) {
        put(list.size());
        if constexpr (std::is_trivially_copyable_v<Value>) {
            bytes_.append(reinterpret_cast<char const*>(list.data()), list.size() * sizeof(Value));
        } else {
            for (auto const& value : list) {
                put(value);
            }
        }
    }
    template <class Value>
    requires(!std::is_trivially_copyable_v<Value>) void put(std::optional<Value> const& value) {
        put(value.has_value());
        if (value) {
            put(*value);
        }
    }

    std::string bytes_;
};

/// Takes the values back in the order in which they were put.
class BytesIn {
  public:
    /// \param bytes outlive it
    explicit BytesIn(std::string_view bytes) : left_(bytes) {}
    template <class... Values> void operator()(Values&... values) { (take(values), ...); }
    [[nodiscard]] bool at_end() const { return left_.empty(); }

  private:
    template <class Value> void take(Value& value) {
        if constexpr (std::is_trivially_copyable_v<Value>) {
            copy(&value, sizeof(Value));
        } else {
            each_part(*this, value);
        }
    }
    template <class Value> void take(std::vector<Value>& list) {
        std::size_t size = 0;
        take(size);
        OVERTURN_ENSURE(size <= left_.size());
        list.resize(size);
        if constexpr (std::is_trivially_copyable_v<Value>) {
            copy(list.data(), size * sizeof(Value));
        } else {
            for (auto& value : list) {
                take(value);
            }
        }
    }
    template <class Value>
    requires(!std::is_trivially_copyable_v<Value>) void take(std::optional<Value>& value) {
        bool there = false;
        take(there);
        value.reset();
        if (there) {
            take(value.emplace());
        }
    }
    void copy(void* to, std::size_t size) {
        OVERTURN_ENSURE(size <= left_.size());
        if (size > 0) {
            std::memcpy(to, left_.data(), size);
        }
        left_.remove_prefix(size);
    }

    std::string_view left_;
};

}  // namespace overturn

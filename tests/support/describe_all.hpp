/// Whether a table of fields describes its row.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>

#include "core/field.hpp"

namespace overturn::testing {

/// Does every 8-byte word of a row of `bytes` bytes belong to exactly one field, and every name to one?
[[nodiscard]] inline bool describe_all(Fields const& fields, std::size_t bytes) {
    std::set<std::size_t> offsets;
    std::set<std::string> names;
    for (auto const& field : fields) {
        offsets.insert(field.offset);
        names.insert(field.name);
    }
    bool const each_once = offsets.size() == fields.size() && names.size() == fields.size();
    bool const aligned = std::ranges::all_of(offsets, [&](auto at) { return at % sizeof(double) == 0 && at < bytes; });
    return each_once && aligned && fields.size() * sizeof(double) == bytes;
}

}  // namespace overturn::testing

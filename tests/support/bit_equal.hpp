// Rows compared in every bit, by the table of their fields: what differs is named, and no field can be forgotten.
#pragma once

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "core/field.hpp"

namespace overturn::testing {

/// \param Row a struct with a table, or one that derives from it where its own members do not count
template <class Row>::testing::AssertionResult bit_equal(Row const& one, Row const& other) {
    auto const names = differing<Row>(one, other);
    return names.empty() ? ::testing::AssertionSuccess()
                         : ::testing::AssertionFailure() << fmt::format("{} differ", fmt::join(names, ", "));
}

}  // namespace overturn::testing

/// The tables of a results file as other programs take them: trials, waves, stripes and curves, row by row.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "store/results_file.hpp"

namespace overturn::output {

/// A value of a row: absent, a number, a count, a text (of a category its name).
using SheetCell = std::variant<std::monostate, double, std::int64_t, std::string_view>;

struct SheetColumn {
    std::string name;  ///< as in the file; of a group within "contact/peak_crush"
    std::string unit;  ///< "m"; "1": a pure number; the name of another column: each row's unit stands there
    std::string meaning;

    /// Heading of the column: "peak_slip [m]".
    [[nodiscard]] std::string title() const { return unit == "1" ? name : name + " [" + unit + "]"; }
};

struct Sheet {
    using Take = std::function<void(std::span<SheetCell const>)>;

    std::string name;  ///< "trials"
    std::vector<SheetColumn> columns = {};
    std::int64_t rows = 0;
    /// Calls `take` with the cells of every row, which are good until it returns. However many rows there are, some
    /// thousands at a time are in memory.
    std::function<void(Take const& take)> each_row = {};
};

/// trials, waves, stripes, curves of the file as it stores them, then `columns` (what every column means) and `about`
/// (what the file says of itself). Rows of stripes and curves are of all bodies and limit states, by name. A column in
/// the unit of the levels has one beside it in the unit in which the campaign states them, rounded to 12 digits.
/// \param file outlives the sheets \throws InputError if it is not complete
[[nodiscard]] std::vector<Sheet> sheets_of(store::ResultsReader const& file);

}  // namespace overturn::output

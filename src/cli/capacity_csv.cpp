#include "cli/capacity_csv.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "cli/named_column.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/cell_rows.hpp"
#include "motion/column_role.hpp"
#include "motion/named_recordings.hpp"
#include "motion/text_lines.hpp"

namespace overturn::cli {
namespace {

constexpr std::array<std::string_view, 6> verdict_names{"collapsed",  "collapse", "fell",
                                                        "overturned", "failed",   "reached"};
constexpr std::array<std::string_view, 6> row_labels{"record", "wave", "gm", "groundmotion", "motion", "name"};

template <std::size_t N> bool is_among(std::array<std::string_view, N> const& names, std::string const& name) {
    return std::ranges::find(names, name) != names.end();
}

class CapacityReader {
  public:
    CapacityReader(std::string const& text, std::string const& file)
        : rows_(text, file, "Begin with 'pga [g], collapsed'"), file_(file) {}

    [[nodiscard]] CapacityTable table() {
        read_header(rows_.header());
        while (auto const cells = rows_.next()) {
            table_.capacities.push_back(row_of(*cells));
            take_name(*cells);
        }
        check_recordings();
        if (table_.capacities.empty()) {
            rows_.fail("no capacity (a header alone). Add rows");
        }
        std::ranges::sort(table_.capacities, {}, &Capacity::intensity);
        auto read = intensity_text(rows_, file_, table_.column);
        table_.unit = std::move(read.unit);
        table_.unread = std::move(read.unread);
        return std::move(table_);
    }

  private:
    void read_header(std::vector<Cell> const& cells) {
        for (std::size_t c = 0; c < cells.size(); ++c) {
            auto const column = named_column(cells[c].text);
            auto const bare = lowered(column.bare);
            bool const verdict = is_among(verdict_names, bare);
            bool const is_label = is_among(row_labels, counted_things(bare));
            if (is_label && (!waves_ || lowered(named_column(cells[*waves_].text).bare) == "name")) {
                waves_ = c;  // a name may be that of an earthquake; a record's tells more
            }
            if (is_label || column_role(cells[c].text).quantity == Quantity::index) {
                continue;
            }
            if (!verdict && !column.is_intensity()) {
                rows_.fail(cells[c], fmt::format("column {} (unknown). Known: pga, pgv, sa(1 s), im, capacity with a "
                                                 "unit in brackets; collapsed; record",
                                                 in_quotes(cells[c].text)));
            }
            auto& place = verdict ? verdict_ : intensity_;
            if (place) {
                rows_.fail(cells[c], fmt::format("a second column of {} (which one counts?). Remove one",
                                                 verdict ? "verdicts" : "intensities"));
            }
            place = c;
            if (!verdict) {
                table_.column = cells[c].text;
                table_.measure = column.measure();
            }
        }
        if (!intensity_) {
            rows_.fail(cells.back(), "no column of intensities (the fit needs it). Call it for example 'pga [g]'");
        }
    }

    void take_name(std::vector<Cell> const& cells) {
        if (waves_ && !cells[*waves_].text.empty()) {
            names_.emplace_back(cells[*waves_].text);
            places_.push_back({file_, rows_.line(), cells[*waves_].column});
        }
    }

    /// The fit counts each row as a sample of its own.
    void check_recordings() const {
        auto const first = named_recordings(names_);
        for (std::size_t i = 0; i < first.size(); ++i) {
            if (auto const other = first[i]; other != i) {
                throw InputError(
                    places_[i],
                    fmt::format("{} beside {} in line {} ({}). Keep one row of them, or give different waves "
                                "different names",
                                in_quotes(names_[i]), in_quotes(names_[other]), places_[other].line,
                                names_[i] == names_[other] ? "one wave twice, no independent samples"
                                                           : "components of one recording, no independent samples"));
            }
        }
    }

    [[nodiscard]] Capacity row_of(std::vector<Cell> const& cells) const {
        auto const& cell = cells[*intensity_];
        bool const beyond = cell.text.starts_with('>');
        auto const word = lowered(cell.text);
        if (word.empty() || word == "nan" || word == "inf" || word == "-") {
            rows_.fail(cell, fmt::format("{} (it stood: up to which intensity?). Write for example >1.3",
                                         in_quotes(cell.text)));
        }
        Capacity capacity;
        if (!parse_number(trimmed(cell.text.substr(beyond ? 1 : 0)), capacity.intensity)) {
            rows_.fail(cell, fmt::format("{} ({}). Write one, or >1.3 for one that stood up to 1.3",
                                         in_quotes(cell.text), CellRows::why_no_number(cell)));
        }
        if (!(capacity.intensity > 0)) {
            rows_.fail(cell, fmt::format("{} (must be above 0). Leave the row out", in_quotes(cell.text)));
        }
        capacity.reached = !beyond;
        if (verdict_) {
            bool const fell = fell_in(cells[*verdict_]);
            if (fell && beyond) {
                rows_.fail(
                    cell,
                    fmt::format(
                        "{} marked as overturned (did it stand up to this value, or overturn at it?). Correct one",
                        in_quotes(cell.text)));
            }
            capacity.reached = fell;
        }
        return capacity;
    }

    [[nodiscard]] bool fell_in(Cell const& cell) const {
        auto const fell = CellRows::yes_or_no(cell);
        if (!fell) {
            rows_.fail(cell, fmt::format("{} (must be 1 or 0: did it fall there?). Write one", in_quotes(cell.text)));
        }
        return *fell;
    }

    CellRows rows_;
    std::string const& file_;
    std::optional<std::size_t> intensity_, verdict_;
    std::optional<std::size_t> waves_;  ///< column of their names
    std::vector<std::string> names_;    ///< of rows that have one
    std::vector<Location> places_;
    CapacityTable table_;
};

}  // namespace

CapacityTable parse_capacities(std::string const& text, std::string const& file) {
    return CapacityReader(text, file).table();
}

}  // namespace overturn::cli

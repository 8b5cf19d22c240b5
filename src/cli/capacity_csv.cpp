#include "cli/capacity_csv.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "cli/csv_rows.hpp"
#include "cli/named_column.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn::cli {
namespace {

constexpr std::array<std::string_view, 10> intensity_names{"amplitude", "im",          "iml", "intensity", "level",
                                                           "capacity",  "collapse_im", "pga", "pgv",       "sa"};
constexpr std::array<std::string_view, 6> verdict_names{"collapsed",  "collapse", "fell",
                                                        "overturned", "failed",   "reached"};
constexpr std::array<std::string_view, 4> row_labels{"record", "wave", "gm", "name"};

template <std::size_t N> bool is_among(std::array<std::string_view, N> const& names, std::string const& name) {
    return std::ranges::find(names, name) != names.end();
}

class CapacityReader {
  public:
    CapacityReader(std::string const& text, std::string const& file)
        : rows_(text, file, "Begin with 'pga [g], collapsed'") {}

    [[nodiscard]] CapacityTable table() {
        read_header(rows_.header());
        while (auto const cells = rows_.next()) {
            table_.capacities.push_back(row_of(*cells));
        }
        if (table_.capacities.empty()) {
            rows_.fail("no capacity (a header alone). Add rows");
        }
        std::ranges::sort(table_.capacities, {}, &Capacity::intensity);
        return std::move(table_);
    }

  private:
    void read_header(std::vector<CsvCell> const& cells) {
        for (std::size_t c = 0; c < cells.size(); ++c) {
            auto const column = named_column(cells[c].text);
            auto const bare = lowered(column.bare);
            bool const verdict = is_among(verdict_names, bare);
            if (is_among(row_labels, bare)) {
                continue;
            }
            if (!verdict && !is_among(intensity_names, bare)) {
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
                table_.unit = column.unit;
            }
        }
        if (!intensity_) {
            rows_.fail(cells.back(), "no column of intensities (the fit needs it). Call it for example 'pga [g]'");
        }
    }

    [[nodiscard]] Capacity row_of(std::vector<CsvCell> const& cells) const {
        auto const& cell = cells[*intensity_];
        bool const beyond = cell.text.starts_with('>');
        Capacity capacity;
        if (!parse_number(trimmed(cell.text.substr(beyond ? 1 : 0)), capacity.intensity)) {
            rows_.fail(cell, fmt::format("{} ({}). Write one, or >1.3 for one that stood up to 1.3",
                                         in_quotes(cell.text), CsvRows::why_no_number(cell)));
        }
        if (!(capacity.intensity > 0)) {
            rows_.fail(cell, fmt::format("{} (must be above 0). Leave the row out", in_quotes(cell.text)));
        }
        capacity.reached = !beyond;
        if (verdict_) {
            bool const fell = fell_in(cells[*verdict_]);
            if (fell && beyond) {
                rows_.fail(cell, fmt::format("{} that fell (it stood up to there, or it fell there?). Mend one",
                                             in_quotes(cell.text)));
            }
            capacity.reached = fell;
        }
        return capacity;
    }

    [[nodiscard]] bool fell_in(CsvCell const& cell) const {
        auto const word = lowered(cell.text);
        bool const yes = word == "1" || word == "yes" || word == "true";
        if (!yes && word != "0" && word != "no" && word != "false") {
            rows_.fail(cell, fmt::format("{} (must be 1 or 0: did it fall there?). Write one", in_quotes(cell.text)));
        }
        return yes;
    }

    CsvRows rows_;
    std::optional<std::size_t> intensity_, verdict_;
    CapacityTable table_;
};

}  // namespace

CapacityTable parse_capacities(std::string const& text, std::string const& file) {
    return CapacityReader(text, file).table();
}

}  // namespace overturn::cli

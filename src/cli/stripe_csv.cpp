#include "cli/stripe_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cli/csv_rows.hpp"
#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn::cli {
namespace {

enum Field : std::size_t { amplitude, trials, overturned, failed, fields };
constexpr std::array<char const*, fields> names{"amplitude", "trials", "overturned", "failed"};

class Reader {
  public:
    Reader(std::string const& text, std::string const& file)
        : rows_(text, file, "Begin with amplitude,trials,overturned") {}

    [[nodiscard]] std::vector<Stripe> stripes() {
        read_header(rows_.header());
        while (auto const cells = rows_.next()) {
            read_row(*cells);
        }
        if (stripes_.empty()) {
            rows_.fail("no stripe (a header alone). Add rows");
        }
        std::sort(stripes_.begin(), stripes_.end(),
                  [](Stripe const& a, Stripe const& b) { return a.amplitude < b.amplitude; });
        return std::move(stripes_);
    }

  private:
    void read_row(std::vector<CsvCell> const& cells) {
        add({.amplitude = positive(cells[*place_[amplitude]]),
             .trials = count(cells[*place_[trials]]),
             .overturned = count(cells[*place_[overturned]]),
             .failed = place_[failed] ? count(cells[*place_[failed]]) : 0},
            cells);
    }

    void read_header(std::vector<CsvCell> const& cells) {
        std::vector<std::string> const known(names.begin(), names.end());
        for (std::size_t c = 0; c < cells.size(); ++c) {
            auto const name = std::find(known.begin(), known.end(), lowered(cells[c].text));
            if (name == known.end()) {
                rows_.fail(cells[c], fmt::format("column {} (unknown). {}", in_quotes(cells[c].text),
                                                 config::suggestion(lowered(cells[c].text), known)));
            }
            auto& place = place_.at(static_cast<std::size_t>(name - known.begin()));
            if (place) {
                rows_.fail(cells[c], fmt::format("column '{}' twice (which one counts?). Remove one", *name));
            }
            place = c;
        }
        for (auto const field : {amplitude, trials, overturned}) {
            if (!place_.at(field)) {
                rows_.fail(cells.back(),
                           fmt::format("no column '{}' (the fit needs it). Add it to the header", names.at(field)));
            }
        }
    }

    [[nodiscard]] double value(CsvCell const& cell) const {
        double number = 0;
        if (!parse_number(cell.text, number)) {
            rows_.fail(cell, fmt::format("{} (not a number). Write one, without a unit", in_quotes(cell.text)));
        }
        return number;
    }
    [[nodiscard]] double positive(CsvCell const& cell) const {
        double const number = value(cell);
        if (!(number > 0)) {
            rows_.fail(cell,
                       fmt::format("amplitude {} (must be above 0). A stripe without shaking needs no trial", number));
        }
        return number;
    }
    [[nodiscard]] std::int64_t count(CsvCell const& cell) const {
        double const number = value(cell);
        constexpr double most = 1e9;
        if (!(number >= 0 && number <= most && number == std::floor(number))) {
            rows_.fail(cell, fmt::format("{} (not a count). Write a whole number from 0 to 1e9", in_quotes(cell.text)));
        }
        return static_cast<std::int64_t>(number);
    }

    void add(Stripe const& stripe, std::vector<CsvCell> const& cells) {
        if (stripe.trials == 0) {
            rows_.fail(cells[*place_[trials]], "no trial (nothing was seen). Leave the row out");
        }
        if (stripe.overturned + stripe.failed > stripe.trials) {
            rows_.fail(cells[*place_[overturned]],
                       fmt::format("{} overturned or failed of {} trials (more than there were). Correct the counts",
                                   stripe.overturned + stripe.failed, stripe.trials));
        }
        for (auto const& other : stripes_) {
            if (other.amplitude == stripe.amplitude) {
                rows_.fail(
                    cells[*place_[amplitude]],
                    fmt::format("amplitude {} twice (a stripe is one row). Add the counts up", stripe.amplitude));
            }
        }
        stripes_.push_back(stripe);
    }

    CsvRows rows_;
    std::array<std::optional<std::size_t>, fields> place_;
    std::vector<Stripe> stripes_;
};

}  // namespace

std::vector<Stripe> parse_stripes(std::string const& text, std::string const& file) {
    return Reader(text, file).stripes();
}

}  // namespace overturn::cli

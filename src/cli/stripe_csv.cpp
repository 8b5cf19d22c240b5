#include "cli/stripe_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cli/csv_cells.hpp"
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
    explicit Reader(std::string const& file) : file_(file) {}

    void read(std::string_view line, int number) {
        line_ = number;
        if (!has_header_) {
            separator_ = separator_of(line);
        }
        auto const cells = cells_of(line, separator_);
        if (is_blank(cells)) {
            return;
        }
        if (!has_header_) {
            read_header(cells);
            return;
        }
        if (cells.size() != columns_) {
            fail(cells.back(),
                 fmt::format("{} columns (the header has {}). Complete or shorten the row", cells.size(), columns_));
        }
        add({.amplitude = positive(cells[*place_[amplitude]]),
             .trials = count(cells[*place_[trials]]),
             .overturned = count(cells[*place_[overturned]]),
             .failed = place_[failed] ? count(cells[*place_[failed]]) : 0},
            cells);
    }

    [[nodiscard]] std::vector<Stripe> stripes() {
        if (!has_header_ || stripes_.empty()) {
            throw InputError({file_, line_, 0}, has_header_
                                                    ? "no stripe (a header alone). Add rows"
                                                    : "empty (no header). Begin with amplitude,trials,overturned");
        }
        std::sort(stripes_.begin(), stripes_.end(),
                  [](Stripe const& a, Stripe const& b) { return a.amplitude < b.amplitude; });
        return std::move(stripes_);
    }

  private:
    [[noreturn]] void fail(CsvCell const& cell, std::string const& message) const {
        throw InputError({file_, line_, cell.column}, message);
    }

    void read_header(std::vector<CsvCell> const& cells) {
        has_header_ = true;
        columns_ = cells.size();
        std::vector<std::string> const known(names.begin(), names.end());
        for (std::size_t c = 0; c < cells.size(); ++c) {
            auto const name = std::find(known.begin(), known.end(), lowered(cells[c].text));
            if (name == known.end()) {
                fail(cells[c], fmt::format("column {} (unknown). {}", in_quotes(cells[c].text),
                                           config::suggestion(lowered(cells[c].text), known)));
            }
            auto& place = place_.at(static_cast<std::size_t>(name - known.begin()));
            if (place) {
                fail(cells[c], fmt::format("column '{}' twice (which one counts?). Remove one", *name));
            }
            place = c;
        }
        for (auto const field : {amplitude, trials, overturned}) {
            if (!place_.at(field)) {
                fail(cells.back(),
                     fmt::format("no column '{}' (the fit needs it). Add it to the header", names.at(field)));
            }
        }
    }

    [[nodiscard]] double value(CsvCell const& cell) const {
        double number = 0;
        if (!parse_number(cell.text, number)) {
            fail(cell, fmt::format("{} (not a number). Write one, without a unit", in_quotes(cell.text)));
        }
        return number;
    }
    [[nodiscard]] double positive(CsvCell const& cell) const {
        double const number = value(cell);
        if (!(number > 0)) {
            fail(cell, fmt::format("amplitude {} (must be above 0). A stripe without shaking needs no trial", number));
        }
        return number;
    }
    [[nodiscard]] std::int64_t count(CsvCell const& cell) const {
        double const number = value(cell);
        constexpr double most = 1e9;
        if (!(number >= 0 && number <= most && number == std::floor(number))) {
            fail(cell, fmt::format("{} (not a count). Write a whole number from 0 to 1e9", in_quotes(cell.text)));
        }
        return static_cast<std::int64_t>(number);
    }

    void add(Stripe const& stripe, std::vector<CsvCell> const& cells) {
        if (stripe.trials == 0) {
            fail(cells[*place_[trials]], "no trial (nothing was seen). Leave the row out");
        }
        if (stripe.overturned + stripe.failed > stripe.trials) {
            fail(cells[*place_[overturned]],
                 fmt::format("{} overturned or failed of {} trials (more than there were). Correct the counts",
                             stripe.overturned + stripe.failed, stripe.trials));
        }
        for (auto const& other : stripes_) {
            if (other.amplitude == stripe.amplitude) {
                fail(cells[*place_[amplitude]],
                     fmt::format("amplitude {} twice (a stripe is one row). Add the counts up", stripe.amplitude));
            }
        }
        stripes_.push_back(stripe);
    }

    std::string const& file_;
    int line_ = 0;
    bool has_header_ = false;
    char separator_ = ',';
    std::size_t columns_ = 0;
    std::array<std::optional<std::size_t>, fields> place_;
    std::vector<Stripe> stripes_;
};

}  // namespace

std::vector<Stripe> parse_stripes(std::string const& text, std::string const& file) {
    Reader reader(file);
    TextLines lines(text);
    while (auto const line = lines.next()) {
        reader.read(*line, lines.number());
    }
    return reader.stripes();
}

}  // namespace overturn::cli

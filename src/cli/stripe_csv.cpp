#include "cli/stripe_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cli/named_column.hpp"
#include "cli/stripe_columns.hpp"
#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/shared_draws.hpp"
#include "core/units.hpp"
#include "motion/cell_rows.hpp"
#include "motion/column_role.hpp"
#include "motion/named_recordings.hpp"
#include "motion/text_lines.hpp"

namespace overturn::cli {
namespace {

using enum StripeField;
constexpr std::array<char const*, stripe_fields> names{"amplitude", "trials", "overturned", "failed"};

char const* name_of_field(StripeField field) { return names.at(static_cast<std::size_t>(field)); }

// Of one trial: did it fall?
constexpr auto verdicts = std::to_array<std::string_view>({"collapse", "collapsed", "fell", "overturned", "failure"});

bool is_verdict(std::string const& bare) {
    return std::ranges::find(verdicts, std::string_view(bare)) != verdicts.end();
}

/// "", "No.", "stripe": it counts the rows.
bool is_count_of_rows(std::string_view name) {
    return column_role(name).quantity == Quantity::index || lowered(trimmed(name)) == "stripe";
}

class Reader {
  public:
    Reader(std::string const& text, std::string const& file)
        : rows_(text, file, "Begin with amplitude,trials,overturned"),
          file_(file),
          trials_held_(trials_held(text, file)) {}

    [[nodiscard]] StripeTable table() {
        read_header(rows_.header());
        while (auto const cells = rows_.next()) {
            read_row(*cells);
        }
        count_waves();
        for (auto const& [level, stripe] : single_) {
            stripes_.push_back(stripe);
        }
        if (stripes_.empty()) {
            rows_.fail("no stripe (a header alone). Add rows");
        }
        std::sort(stripes_.begin(), stripes_.end(),
                  [](Stripe const& a, Stripe const& b) { return a.amplitude < b.amplitude; });
        auto read = intensity_text(rows_, file_, called_);
        return {std::move(stripes_), std::move(trials_),  waves_held_,          std::move(wave_column_),
                std::move(called_),  std::move(measure_), std::move(read.unit), std::move(read.unread)};
    }

  private:
    void read_row(std::vector<Cell> const& cells) {
        for (auto const place : counters_) {
            check_counter(cells[place]);
        }
        ++rows_read_;
        if (ones_) {
            check_is_one(cells[*ones_]);
        }
        if (verdict_) {
            add_trial(positive(cells[*place_of(amplitude)]), fell(cells[*verdict_]), cells);
            return;
        }
        add({.amplitude = positive(cells[*place_of(amplitude)]),
             .trials = count(cells[*place_of(trials)]),
             .overturned = count(cells[*place_of(overturned)]),
             .failed = place_of(failed) ? count(cells[*place_of(failed)]) : 0},
            cells);
    }

    void add_trial(double level, bool fell, std::vector<Cell> const& cells) {
        auto& stripe = single_[level];
        stripe.amplitude = level;
        ++stripe.trials;
        stripe.overturned += fell ? 1 : 0;
        if (!waves_) {
            return;
        }
        auto const& wave = cells[*waves_];
        if (wave.text.empty()) {
            rows_.fail(wave, "no name (trials of one wave are judged together). Name the wave");
        }
        auto const number = static_cast<std::int64_t>(wave_names_.size());
        auto const [named, is_new] = numbers_.emplace(wave.text, number);
        if (is_new) {
            wave_names_.emplace_back(wave.text);
        }
        trials_.push_back({level, named->second, fell, named->second});
    }

    /// Trials of one recording share what was shaken, at their level too.
    void count_waves() {
        auto const first = named_recordings(wave_names_);
        std::map<double, std::vector<std::int64_t>> at_level;
        std::set<std::int64_t> different;
        for (auto& trial : trials_) {
            trial.wave = static_cast<std::int64_t>(first[static_cast<std::size_t>(trial.wave)]);
            at_level[trial.intensity].push_back(trial.wave);
            different.insert(trial.wave);
        }
        waves_held_ = std::ssize(different);
        for (auto& [level, waves] : at_level) {
            single_[level].group_size = SharedDraws{.most = 1, .of = std::move(waves)}.effect();
        }
    }

    /// A row with a wave's name is one trial.
    void check_is_one(Cell const& cell) const {
        if (value(cell) != 1) {
            rows_.fail(cell,
                       fmt::format("{} trials of a named wave (which of them fell?). Write each trial in a row of "
                                   "its own, or leave the column {} out",
                                   in_quotes(cell.text), in_quotes(wave_column_)));
        }
    }

    /// "wave" beside "trials": each row is the one trial of the wave it names.
    void find_names_beside_counts(std::vector<Cell> const& cells) {
        std::vector<std::size_t> named;
        std::vector<std::size_t> counted;
        for (std::size_t place = 0; place < cells.size(); ++place) {
            if (stripe_field_of(named_column(cells[place].text)) == trials) {
                (may_name_trials(cells[place].text) ? named : counted).push_back(place);
            }
        }
        if (named.size() == 1 && counted.size() == 1) {
            ones_ = counted.front();
            trials_held_ = TrialsHeld::labels;
        }
    }

    /// 0, 1, 2, ... or 1, 2, 3, ...
    void check_counter(Cell const& cell) const {
        double const row = value(cell);
        if (row != static_cast<double>(rows_read_) && row != static_cast<double>(rows_read_ + 1)) {
            rows_.fail(cell,
                       fmt::format("{} (a count of rows by its name, but it does not count them). Leave the column "
                                   "out, or name it",
                                   in_quotes(cell.text)));
        }
    }

    void read_header(std::vector<Cell> const& cells) {
        if (is_like_a_number(cells.front())) {
            rows_.fail(cells.front(), fmt::format("{} where names belong (which column is which?). Begin with "
                                                  "amplitude,trials,overturned",
                                                  in_quotes(cells.front().text)));
        }
        find_names_beside_counts(cells);
        bool const counts = trials_held_ == TrialsHeld::counts && std::ranges::any_of(cells, [](Cell const& cell) {
                                return stripe_field_of(named_column(cell.text)) == trials;
                            });
        for (auto const& cell : cells) {
            std::size_t const place = &cell - cells.data();
            auto const column = named_column(cell.text);
            bool const verdict = column.unit.empty() && is_verdict(lowered(column.bare));
            if (place == ones_) {
                continue;
            }
            if (stripe_field_of(column) == trials && trials_held_ != TrialsHeld::counts) {
                check_are_labels(cell);
                take_waves(cell, place);
            } else if (!stripe_field_of(column) && is_count_of_rows(cell.text)) {
                counters_.push_back(place);
            } else if (verdict && !counts) {
                take_verdict(cell, place);
            } else {
                take_column(cell, column, place);
            }
        }
        for (auto const field : {amplitude, trials, overturned}) {
            if (!place_of(field) && !(verdict_ && field != amplitude)) {
                rows_.fail(cells.back(), fmt::format("no column '{}' (the fit needs it). Add it to the header",
                                                     name_of_field(field)));
            }
        }
        if (verdict_ && (place_of(failed) || place_of(overturned))) {
            rows_.fail(cells[*verdict_],
                       "beside a column of counts (without a column of trials each row is one trial). Add the trials, "
                       "or keep one of these columns");
        }
    }

    void check_are_labels(Cell const& cell) const {
        if (trials_held_ == TrialsHeld::either) {
            rows_.fail(cell, fmt::format("column {} (it numbers the rows: the name of each, or its number of trials?). "
                                         "Name it 'No.' where each row is one trial, or write the trials of each row",
                                         in_quotes(cell.text)));
        }
    }

    [[nodiscard]] std::optional<std::size_t>& place_of(StripeField field) {
        return place_.at(static_cast<std::size_t>(field));
    }

    void take_verdict(Cell const& cell, std::size_t place) {
        if (verdict_) {
            rows_.fail(cell, "a second column of verdicts (which one counts?). Remove one");
        }
        verdict_ = place;
    }

    void take_waves(Cell const& cell, std::size_t place) {
        if (waves_) {
            rows_.fail(cell, "a second column that names the waves (which one counts?). Remove one");
        }
        waves_ = place;
        wave_column_ = cell.text;
    }

    void take_column(Cell const& cell, NamedColumn const& column, std::size_t at) {
        auto const field = stripe_field_of(column);
        if (!field || !(column.unit.empty() || field == amplitude)) {
            std::vector<std::string> known(names.begin(), names.end());
            known.insert(known.end(), {"wave", "record"});
            rows_.fail(cell, fmt::format("column {} (unknown). {}", in_quotes(cell.text),
                                         config::suggestion(lowered(cell.text), known)));
        }
        auto& place = place_of(*field);
        if (place) {
            rows_.fail(cell, fmt::format("column '{}' twice (which one counts?). Remove one", name_of_field(*field)));
        }
        place = at;
        if (field == amplitude) {
            called_ = cell.text;
            measure_ = column.measure();
        }
    }

    [[nodiscard]] bool fell(Cell const& cell) const {
        auto const fell = CellRows::yes_or_no(cell);
        if (!fell) {
            rows_.fail(cell, fmt::format("{} (without a column of trials each row is one, which fell, 1, or stood, 0). "
                                         "Write 1 or 0, or add the trials",
                                         in_quotes(cell.text)));
        }
        return *fell;
    }

    [[nodiscard]] double value(Cell const& cell) const {
        double number = 0;
        if (!parse_number(cell.text, number)) {
            rows_.fail(cell, fmt::format("{} ({}). Write one, without a unit", in_quotes(cell.text),
                                         CellRows::why_no_number(cell)));
        }
        return number;
    }
    [[nodiscard]] double positive(Cell const& cell) const {
        double const number = value(cell);
        if (!(number > 0)) {
            rows_.fail(cell,
                       fmt::format("amplitude {} (must be above 0). A stripe without shaking needs no trial", number));
        }
        return number;
    }
    [[nodiscard]] std::int64_t count(Cell const& cell) const {
        double const number = value(cell);
        constexpr double most = 1e9;
        if (!(number >= 0 && number <= most && number == std::floor(number))) {
            rows_.fail(cell, fmt::format("{} (not a count). Write a whole number from 0 to 1e9", in_quotes(cell.text)));
        }
        return static_cast<std::int64_t>(number);
    }

    void add(Stripe const& stripe, std::vector<Cell> const& cells) {
        if (stripe.trials == 0) {
            rows_.fail(cells[*place_of(trials)], "no trial (nothing was seen). Leave the row out");
        }
        if (stripe.overturned + stripe.failed > stripe.trials) {
            rows_.fail(cells[*place_of(overturned)],
                       fmt::format("{} overturned or failed of {} trials (more than there were). Correct the counts",
                                   stripe.overturned + stripe.failed, stripe.trials));
        }
        for (auto const& other : stripes_) {
            if (other.amplitude == stripe.amplitude) {
                rows_.fail(
                    cells[*place_of(amplitude)],
                    fmt::format("amplitude {} twice (a stripe is one row). Add the counts up", stripe.amplitude));
            }
        }
        stripes_.push_back(stripe);
    }

    CellRows rows_;
    std::string const& file_;
    TrialsHeld trials_held_;
    std::array<std::optional<std::size_t>, stripe_fields> place_;  ///< by field
    std::vector<std::size_t> counters_;                            ///< columns that count the rows
    std::size_t rows_read_ = 0;
    std::vector<Stripe> stripes_;
    std::optional<std::size_t> verdict_;  ///< where each row is a trial
    std::map<double, Stripe> single_;     ///< of such rows, by amplitude
    std::optional<std::size_t> ones_;     ///< column of the trials of rows that name their wave
    std::optional<std::size_t> waves_;    ///< column of their waves' names
    std::string wave_column_;
    std::vector<std::string> wave_names_;
    std::map<std::string, std::int64_t, std::less<>> numbers_;  ///< places of those names
    std::vector<SingleTrial> trials_;
    std::int64_t waves_held_ = 0;
    std::string called_ = names.front();
    std::string measure_;
};

}  // namespace

StripeTable parse_stripes(std::string const& text, std::string const& file) { return Reader(text, file).table(); }

}  // namespace overturn::cli

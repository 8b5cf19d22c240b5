#include "output/answer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/assumptions.hpp"
#include "campaign/typed_units.hpp"
#include "campaign/validated_range.hpp"
#include "core/outward.hpp"
#include "core/text_width.hpp"
#include "core/texts_of.hpp"
#include "core/wrapped.hpp"
#include "output/detail/answer_cells.hpp"
#include "output/detail/answer_parts.hpp"
#include "output/detail/fit_words.hpp"
#include "output/waves_text.hpp"
#include "response/registry.hpp"
#include "results/few_waves.hpp"

namespace overturn::output {
namespace {

constexpr double least_slip_m = 1e-4;  // below it a slip is not printed as a number

// A row of a body, and the limit state that it is about.
struct BodyRow {
    enum class What : std::uint8_t { probability, slip, tilt, capacity, frequency };
    What what;
    std::size_t limit = 0;

    [[nodiscard]] bool is_of_levels() const { return what < What::capacity; }
};
using What = BodyRow::What;

class SheetMaker {
  public:
    SheetMaker(Answered const& of, std::size_t most_rows, std::size_t parts)
        : of_(of),
          most_rows_(most_rows),
          parts_(parts),
          levels_(answer_levels(of.spec.levels)),
          too_few_(!no_probability_text(of).empty()) {}

    [[nodiscard]] AnswerSheet sheet() {
        sheet_.head = {of_.spec.levels.measure_label(), ""};
        for (auto const l : levels_) {
            sheet_.head.push_back(heading(of_.spec.levels, l));
        }
        add_rows();
        sheet_.title = title();
        add_numerical_error();
        sheet_.dependence = dependence();
        return std::move(sheet_);
    }

  private:
    // Of the rows that were added.
    [[nodiscard]] std::string title() const {
        if (too_few_) {
            return no_probability_text(of_) + "; each record has its rows below";
        }
        auto const waves = waves_text(of_.statistics.waves(), of_.spec.source->about().acceptance, of_.confidence);
        return fmt::format(
            "{}; {:g} % intervals{}{}", waves.empty() ? count_text(of_.statistics.waves().waves, "wave") : waves,
            100 * of_.confidence, shows_rare_ ? "; P by [rare] (95 %)" : "",
            shows_responses_
                ? (shows_rare_ ? "; slip, tilt of these waves alone: " : "; slip, tilt: ") + responses_title()
                : "");
    }
    [[nodiscard]] std::string responses_title() const {
        std::string const percentiles = shows_open_ ? "median / 95th percentile (<= upper end; open: too few waves)"
                                                    : "median / 95th percentile (<= upper end)";
        std::string const ranges = "lowest to highest";
        return !shows_ranges_       ? percentiles
               : shows_percentiles_ ? percentiles + "; of fewer than 20 independent trials " + ranges
                                    : ranges + " (a 95th percentile needs 20 independent trials)";
    }

    // "600 gal = design", "900 gal = 1.5 x"
    static std::string heading(LevelSpec const& levels, std::size_t level) {
        auto const* const base = levels.design_basis();
        auto const value = levels.levels[level].value;
        return levels.text(value)
               + (base == nullptr        ? std::string()
                  : base->value == value ? std::string(" = design")
                                         : fmt::format(" = {:.3g} x", value / base->value));
    }

    // The annual frequency has a row of its own, or stands behind HCLPF.
    enum class Frequency : std::uint8_t { apart, behind };

    // All rows of a body, the weightiest first.
    [[nodiscard]] std::vector<BodyRow> all_rows(Frequency frequency) const {
        std::vector<BodyRow> rows{{What::probability}};
        if (!are_few_records(of_.spec, of_.statistics.waves().waves)) {  // else each is a row of its own below
            rows.insert(rows.end(), {{What::slip}, {What::tilt}});
        }
        auto const add_capacity = [&](std::size_t limit) {
            rows.push_back({What::capacity, limit});
            if (frequency == Frequency::apart && !of_.frequencies.empty()) {
                rows.push_back({What::frequency, limit});
            }
        };
        add_capacity(0);
        auto const limits = of_.spec.limits.size();
        for (std::size_t limit = 1; limit < limits; ++limit) {
            rows.push_back({What::probability, limit});
        }
        for (std::size_t limit = 1; limit < limits; ++limit) {
            add_capacity(limit);
        }
        return rows;
    }
    // Capacities stand once, all else in each part.
    [[nodiscard]] std::size_t lines_of(BodyRow const& row) const { return row.is_of_levels() ? parts_ : 1; }
    // As many as so many lines hold, at least P of overturning.
    [[nodiscard]] std::vector<BodyRow> first_rows(std::vector<BodyRow> rows, std::size_t lines) const {
        std::size_t taken = 1;
        std::size_t used = lines_of(rows.front());
        while (taken < rows.size() && used + lines_of(rows[taken]) <= lines) {
            used += lines_of(rows[taken++]);
        }
        rows.resize(taken);
        return rows;
    }

    void add_rows() {
        auto const bodies = of_.analysis.size();
        auto const room = most_rows_ / bodies;
        auto all = all_rows(Frequency::apart);
        auto rows = first_rows(all, room);
        frequency_behind_ = rows.size() < all.size();
        if (frequency_behind_) {
            all = all_rows(Frequency::behind);
            rows = first_rows(all, room);
        }
        auto const shown = most_first(std::min(bodies, std::max<std::size_t>(1, most_rows_ / parts_)));
        for (auto const b : shown) {
            for (auto const& row : rows) {
                add_row_of(b, row);
            }
        }
        sheet_.left_out = shown.size() < bodies ? fmt::format(
                              "{} more bodies, with lower P, and other rows: --section stripes, responses, curves",
                              bodies - shown.size())
                                                : left_out_text(std::span(all).subspan(rows.size()));
        highest_left_out_ = highest_left_out(std::span(all).subspan(rows.size()));
    }

    // "P(touches), HCLPF of 2 limit states: --section stripes, curves"
    [[nodiscard]] std::string left_out_text(std::span<BodyRow const> rows) const {
        std::vector<std::string> what, probabilities, sections;
        std::int64_t capacities = 0;
        bool responses = false;
        bool curves = false;
        for (auto const& row : rows) {
            auto const& limit = of_.spec.limits[row.limit];
            switch (row.what) {
                case What::slip:
                case What::tilt:
                    responses = true;
                    what.emplace_back(row.what == What::slip ? "slip" : "tilt");
                    break;
                case What::probability:
                    probabilities.push_back("P(" + full_name(limit, of_.spec.limits) + ")");
                    break;
                default:
                    curves = true;
                    capacities += row.limit == 0 ? 0 : 1;
                    if (row.limit == 0) {
                        what.emplace_back(of_.frequencies.empty() ? "HCLPF" : "HCLPF and annual frequency");
                    }
            }
        }
        for (auto const& [is_there, section] : {std::pair(!probabilities.empty(), "stripes"),
                                                {responses, "responses"},
                                                {curves, "curves"},
                                                {curves && !of_.frequencies.empty(), "frequency"}}) {
            if (is_there) {
                sections.emplace_back(section);
            }
        }
        auto const text_with = [&](std::vector<std::string> const& limits) {
            auto all = what;
            all.insert(all.end(), limits.begin(), limits.end());
            if (capacities > 0) {
                all.push_back("HCLPF of " + count_text(capacities, "limit state"));
            }
            return all.empty() ? std::string()
                               : fmt::format("{}: --section {}", fmt::join(all, ", "), fmt::join(sections, ", "));
        };
        auto const named = text_with(probabilities);
        return text_width(named) <= line_width ? named
                                               : text_with({fmt::format("P of {} limit states", probabilities.size())});
    }

    // Of limit states without a row: " Not in the table: P(slips) <= 0.492 (two, 600 gal), P(tilts) <= 0.317 (one, 600
    // gal)."
    [[nodiscard]] std::string highest_left_out(std::span<BodyRow const> rows) const {
        constexpr std::size_t most = 6;
        std::vector<std::string> all;
        for (auto const& row : rows) {
            if (row.what == What::probability && !too_few_) {
                all.push_back(fmt::format("P({}) {}", full_name(of_.spec.limits[row.limit], of_.spec.limits),
                                          highest_text(row.limit)));
            }
        }
        return all.empty() ? std::string() : fmt::format(" Not in the table: {}.", names_text(all, most));
    }

    // Of a limit state: how high P may be at most, of all bodies and levels in the table. "<= 0.492 (two, 600 gal)"
    [[nodiscard]] std::string highest_text(std::size_t limit) const {
        std::string text;
        double highest = -1;
        for (std::size_t b = 0; b < of_.analysis.size(); ++b) {
            for (auto const l : levels_) {
                auto const* const rare = rare_estimate_at(of_, b, limit, l);
                auto const& stripe = of_.statistics.bodies()[b].stripes_of(limit)[l];
                auto const upper = (rare != nullptr ? rare->interval_95 : stripe.interval(of_.confidence)).upper;
                if (upper > highest) {
                    highest = upper;
                    text = fmt::format("<= {:.3g} ({}, {})", rounded_up(upper), of_.analysis[b].body,
                                       of_.spec.levels.text(of_.spec.levels.levels[l].value));
                }
            }
        }
        return text;
    }

    // Bodies in their order; where they are too many, those with the highest P.
    [[nodiscard]] std::vector<std::size_t> most_first(std::size_t most) const {
        std::vector<std::size_t> places(of_.analysis.size());
        for (std::size_t b = 0; b < places.size(); ++b) {
            places[b] = b;
        }
        if (places.size() > most) {
            std::ranges::stable_sort(places, std::ranges::greater{}, [&](std::size_t b) {
                return of_.statistics.bodies()[b].stripes[levels_.back()].interval(of_.confidence).upper;
            });
            places.resize(most);
            std::ranges::sort(places);
        }
        return places;
    }

    template <class Cell> void add_row(std::string const& body, std::string const& name, Cell cell) {
        std::vector<std::string> row{body, name};
        for (auto const l : levels_) {
            row.push_back(cell(l));
        }
        sheet_.rows.push_back(std::move(row));
    }

    void add_row_of(std::size_t b, BodyRow const& row) {
        switch (row.what) {
            case What::probability:
                return add_probability(b, row.limit);
            case What::slip:
                return add_slip(b);
            case What::tilt:
                return add_tilt(b);
            case What::capacity:
                return add_capacity(of_.analysis[b], row.limit);
            case What::frequency:
                return add_frequency(of_.analysis[b], row.limit);
        }
    }

    void add_probability(std::size_t b, std::size_t limit) {
        auto const& counted = of_.statistics.bodies()[b].stripes_of(limit);
        auto const name = limit == 0 ? std::string() : full_name(of_.spec.limits[limit], of_.spec.limits);
        add_row(limit == 0 ? of_.analysis[b].body : "",
                too_few_     ? (limit == 0 ? "overturned" : name)
                : limit == 0 ? "P(overturn)"
                             : "P(" + name + ")",
                [&](std::size_t l) {
                    auto const* const rare = too_few_ ? nullptr : rare_estimate_at(of_, b, limit, l);
                    shows_rare_ = shows_rare_ || rare != nullptr;
                    return too_few_          ? passed_text(counted[l])
                           : rare != nullptr ? rare_text(*rare)
                                             : probability_text(counted[l], of_.confidence);
                });
    }

    [[nodiscard]] std::string named(std::string const& what, std::size_t limit) const {
        return limit == 0 ? what : what + " " + full_name(of_.spec.limits[limit], of_.spec.limits);
    }

    // HCLPF, and the annual frequency behind it where that has no row of its own.
    void add_capacity(BodyAnalysis const& body, std::size_t limit) {
        auto const& state = of_.spec.limits[limit];
        auto const& curve = body.curves_of(limit).front();
        auto const yearly = frequency_behind_ ? frequency_text(body.body, state.name, false) : std::string();
        sheet_.rows.push_back(
            {"", named("HCLPF", limit), capacity_text(curve, yearly.empty()) + (yearly.empty() ? "" : "; " + yearly)});
    }
    void add_frequency(BodyAnalysis const& body, std::size_t limit) {
        auto const yearly = frequency_text(body.body, of_.spec.limits[limit].name, true);
        if (!yearly.empty()) {
            sheet_.rows.push_back({"", named("annual frequency", limit), yearly});
        }
    }

    // "4.6e-05 to 8.5e-05 a year"; empty without a hazard curve.
    [[nodiscard]] std::string frequency_text(std::string const& body, std::string const& limit, bool whole) const {
        auto const* const f = frequency_at(of_, body, limit);
        return f == nullptr ? std::string()
               : too_few_   ? needs_more()
               : whole      ? frequency_words(*f)
                            : frequency_in_short(*f);
    }

    // ">= 0.2 g (estimate 0.245 g)"
    [[nodiscard]] std::string capacity_text(MeasuredFragility const& curve, bool low_point) const {
        return too_few_ ? needs_more()
                        : hclpf_text(curve, {.low_point = low_point,
                                             .beta_u_assumed = of_.beta_u_of_campaign && is_beta_u_assumed(of_.spec)});
    }

    [[nodiscard]] std::string needs_more() const {
        auto const& shared = of_.spec.source->about().shared;
        return fmt::format("needs {} {} or more ({} here)", least_records, shared.most > 1 ? "recordings" : "records",
                           shared.among(of_.statistics.waves().waves));
    }

    // \param least what is not printed as a number below it, in `unit`
    void add_percentiles(std::size_t b, std::string const& name, char const* quantity, double unit, double least) {
        shows_responses_ = true;
        auto const& body = of_.analysis[b];
        add_row("", name, [&](std::size_t l) {
            auto const* const at = quantiles_at(body, quantity, l);
            if (at != nullptr && !mostly_unknown(*at)) {
                (std::isnan(at->quantiles.back().value) ? shows_ranges_ : shows_percentiles_) = true;
            }
            auto text = percentiles_text(at, unit, least);
            shows_open_ = shows_open_ || text.ends_with(no_upper_end);
            return text;
        });
    }
    void add_slip(std::size_t b) {
        auto const slip = typed_units(of_.spec).slip;
        add_percentiles(b, fmt::format("slip [{}]", slip.symbol), "peak_slip", slip.si, least_slip_m / slip.si);
    }
    void add_tilt(std::size_t b) {
        // Where alpha is drawn, the stored ratio is not of one angle.
        bool const drawn = of_.spec.bodies[b].draws_alpha();
        auto const alpha = of_.spec.bodies[b].body.alpha_rad();
        add_percentiles(b, drawn ? "tilt / alpha" : "tilt [deg]", "peak_rotation_ratio", drawn ? 1 : pi / 180 / alpha,
                        0.01);
    }

    void add_numerical_error() {
        if (auto const& found = of_.numerical; found && !sheet_.rows.empty()) {
            sheet_.rows.push_back(
                {"all bodies", "numerical error of P",
                 fmt::format("{}{:.2g}, mean over levels (overturn cost, {} trials)", found->is_bound ? "at most " : "",
                             rounded_up(found->error, 2), found->trials)});
        }
    }

    // Trials on points or a rim are chaotic: two steps of integration part after some impacts.
    [[nodiscard]] std::string step_text() const {
        std::int64_t chaotic = 0;
        std::int64_t all = 0;
        for (auto const& body : of_.statistics.bodies()) {
            for (auto const& model : models()) {
                auto const trials = body.models[model_place(model.traits().number)];
                chaotic += has(model.traits().always, Effect::contact) ? trials : 0;
            }
            all = std::accumulate(body.models.begin(), body.models.end(), all);
        }
        return chaotic == 0 || of_.numerical
                   ? std::string()
                   : fmt::format(
                       " {} of {} trials used the contact model (points or a rim): a smaller time step may change "
                       "which of them overturn (effect on P: overturn cost CAMPAIGN.toml).",
                       chaotic, all);
    }

    // What the numbers rest on.
    [[nodiscard]] std::string dependence() const {
        auto text = fmt::format("Waves: {}. {}.", of_.spec.source->about().variability,
                                assumed_text(physical_inputs(of_.spec)));
        text += highest_left_out_ + step_text();
        auto const outside = outside_validated_range(of_.spec, Tested::left_out);
        if (!outside.empty()) {
            text += fmt::format(" Outside the shaking-table tests: {}{}.", outside.front(),
                                outside.size() == 1 ? "" : "; others: overturn plan");
        }
        return text;
    }

    Answered const& of_;
    std::size_t most_rows_, parts_;
    std::vector<std::size_t> levels_;
    bool too_few_;  // records, for probabilities
    bool frequency_behind_ = false;
    bool shows_responses_ = false, shows_ranges_ = false, shows_percentiles_ = false, shows_open_ = false;
    bool shows_rare_ = false;
    std::string highest_left_out_;
    AnswerSheet sheet_;
};

}  // namespace

std::vector<std::size_t> answer_levels(LevelSpec const& levels) {
    constexpr std::size_t usual = 3;
    constexpr std::size_t most_named = 6;
    auto const count = levels.levels.size();
    std::vector<std::size_t> places;
    auto const add = [&](std::size_t place, std::size_t most) {
        if (places.size() < most && place < count && std::ranges::find(places, place) == places.end()) {
            places.push_back(place);
        }
    };
    std::size_t first = 0;
    for (auto const purpose : {LevelClass::design_basis, LevelClass::beyond_design}) {
        for (std::size_t l = 0; l < count; ++l) {
            if (levels.levels[l].purpose == purpose) {
                add(l, most_named);
                first = purpose == LevelClass::design_basis ? l : first;
            }
        }
    }
    if (places.empty()) {
        add(0, usual);
    }
    add(count - 1, usual);
    add(first + (count - 1 - first) / 2, usual);
    std::ranges::sort(places);
    return places;
}

std::string no_probability_text(Answered const& of) {
    auto const waves = of.statistics.waves().waves;
    return are_too_few_records(of.spec, waves) ? few_records_text(waves, of.spec.source->about().shared.among(waves))
                                               : std::string();
}

AnswerSheet answer_sheet(Answered const& of, std::size_t most_rows, std::size_t parts) {
    return of.spec.is_grid() || of.analysis.empty() ? AnswerSheet{} : SheetMaker(of, most_rows, parts).sheet();
}

}  // namespace overturn::output

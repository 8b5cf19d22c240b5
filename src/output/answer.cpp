#include "output/answer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "campaign/assumptions.hpp"
#include "campaign/cautions.hpp"
#include "campaign/typed_units.hpp"
#include "campaign/validated_range.hpp"
#include "core/outward.hpp"
#include "output/detail/answer_cells.hpp"
#include "output/detail/answer_parts.hpp"
#include "output/detail/fit_words.hpp"
#include "output/waves_text.hpp"
#include "response/registry.hpp"
#include "results/few_waves.hpp"

namespace overturn::output {
namespace {

std::string count_text(std::int64_t waves) { return fmt::format("{} wave{}", waves, waves == 1 ? "" : "s"); }

constexpr double least_slip_m = 1e-4;  // below it a slip is not printed as a number

// What one body needs of rows. Merged: the annual frequency stands behind HCLPF.
enum class Detail { all, merged, probabilities, overturning };

bool has_responses(Detail detail) { return detail == Detail::all || detail == Detail::merged; }

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
        return fmt::format("{}; {:g} % intervals{}", waves.empty() ? count_text(of_.statistics.waves().waves) : waves,
                           100 * of_.confidence, shows_responses_ ? "; slip and tilt: " + responses_title() : "");
    }
    [[nodiscard]] std::string responses_title() const {
        std::string const percentiles = "median / 95th percentile (<= its upper end)";
        std::string const ranges = "lowest to highest";
        return !shows_ranges_       ? percentiles
               : shows_percentiles_ ? percentiles + "; of fewer than 20 independent trials " + ranges
                                    : ranges + " (a 95th percentile needs 20 independent trials)";
    }

    // "600 gal = design", "900 gal = 1.5 x"
    static std::string heading(LevelSpec const& levels, std::size_t level) {
        auto const base = std::ranges::find(levels.levels, LevelClass::design_basis, &Level::purpose);
        auto const value = levels.levels[level].value;
        return levels.text(value)
               + (base == levels.levels.end() ? std::string()
                  : base->value == value      ? std::string(" = design")
                                              : fmt::format(" = {:.3g} x", value / base->value));
    }

    // Of one body: capacities stand once, all else in each part.
    [[nodiscard]] std::size_t rows_of(Detail detail) const {
        auto const limits = of_.spec.limits.size();
        constexpr std::size_t responses = 2;
        auto const capacities = detail == Detail::all && !of_.frequencies.empty() ? 2 * limits : limits;
        return has_responses(detail) ? parts_ * (limits + responses) + capacities
                                     : parts_ * (detail == Detail::probabilities ? limits : 1);
    }

    void add_rows() {
        auto const bodies = of_.analysis.size();
        auto detail = Detail::all;
        for (auto const less : {Detail::merged, Detail::probabilities, Detail::overturning}) {
            detail = bodies * rows_of(detail) > most_rows_ ? less : detail;
        }
        auto const shown = most_first(std::min(bodies, most_rows_ / rows_of(detail)));
        for (auto const b : shown) {
            add_body(b, detail);
        }
        if (shown.size() < bodies) {
            sheet_.left_out = fmt::format(
                "{} more bodies, with lower P, and other rows: --section stripes, responses, "
                "curves",
                bodies - shown.size());
        } else if (!has_responses(detail)) {
            sheet_.left_out = of_.frequencies.empty()
                                  ? "slip, tilt, HCLPF and other limits: --section stripes, responses, curves"
                                  : "slip, tilt, HCLPF, frequency, other limits: --section stripes, responses, "
                                    "curves, frequency";
        }
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

    void add_body(std::size_t b, Detail detail) {
        auto const& body = of_.analysis[b];
        auto const& counted = of_.statistics.bodies()[b];
        auto const limits = detail == Detail::overturning ? 1 : of_.spec.limits.size();
        for (std::size_t limit = 0; limit < limits; ++limit) {
            auto const name = full_name(of_.spec.limits[limit], of_.spec.limits);
            add_row(limit == 0 ? body.body : "",
                    too_few_     ? (limit == 0 ? "overturned" : name)
                    : limit == 0 ? "P(overturn)"
                                 : "P(" + name + ")",
                    [&](std::size_t l) {
                        auto const& stripe = counted.stripes_of(limit)[l];
                        return too_few_ ? passed_text(stripe) : probability_text(stripe, of_.confidence);
                    });
        }
        if (!has_responses(detail)) {
            return;
        }
        if (!are_few_records(of_.spec, of_.statistics.waves().waves)) {  // else each is a row of its own below
            add_responses(b);
        }
        for (std::size_t limit = 0; limit < limits; ++limit) {
            add_capacity(body, limit, detail);
        }
    }

    // HCLPF, and the annual frequency where there is a hazard curve.
    void add_capacity(BodyAnalysis const& body, std::size_t limit, Detail detail) {
        auto const& state = of_.spec.limits[limit];
        auto const named = [&](std::string const& what) {
            return limit == 0 ? what : what + " " + full_name(state, of_.spec.limits);
        };
        auto const& curve = body.curves_of(limit).front();
        bool const apart = detail == Detail::all;
        auto const yearly = frequency_text(body.body, state.name, apart);
        sheet_.rows.push_back(
            {"", named("HCLPF"),
             capacity_text(curve, apart || yearly.empty()) + (apart || yearly.empty() ? "" : "; " + yearly)});
        if (apart && !yearly.empty()) {
            sheet_.rows.push_back({"", named("annual frequency"), yearly});
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

    void add_responses(std::size_t b) {
        shows_responses_ = true;
        auto const& body = of_.analysis[b];
        auto const percentiles = [&](char const* quantity, double unit, double least) {
            return [=, this, &body](std::size_t l) {
                auto const* const at = quantiles_at(body, quantity, l);
                if (at != nullptr && !mostly_unknown(*at)) {
                    (std::isnan(at->quantiles.back().value) ? shows_ranges_ : shows_percentiles_) = true;
                }
                return percentiles_text(at, unit, least);
            };
        };
        auto const slip = typed_units(of_.spec).slip;
        add_row("", fmt::format("slip [{}]", slip.symbol), percentiles("peak_slip", slip.si, least_slip_m / slip.si));
        // Where alpha is drawn too, the stored ratio is not of one angle.
        bool const drawn = !of_.spec.bodies[b].scattering().empty();
        auto const alpha = of_.spec.bodies[b].body.alpha_rad();
        add_row("", drawn ? "tilt / alpha" : "tilt [deg]",
                percentiles("peak_rotation_ratio", drawn ? 1 : pi / 180 / alpha, 0.01));
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
                       " {} of {} trials were computed on points or a rim: there a smaller time step can "
                       "change which bodies fall. overturn cost CAMPAIGN.toml measures how much this "
                       "changes P.",
                       chaotic, all);
    }

    // What the numbers rest on.
    [[nodiscard]] std::string dependence() const {
        auto text = fmt::format("Waves: {}. {}.", of_.spec.source->about().variability,
                                text_of(tally_of(physical_inputs(of_.spec))));
        text += step_text();
        auto const outside = outside_validated_range(of_.spec);
        if (!outside.empty()) {
            text += fmt::format(" Outside the range of the shaking-table tests: {}{}.", outside.front(),
                                outside.size() == 1 ? "" : "; for other bodies see overturn plan");
        }
        return text;
    }

    Answered const& of_;
    std::size_t most_rows_, parts_;
    std::vector<std::size_t> levels_;
    bool too_few_;  // records, for probabilities
    bool shows_responses_ = false, shows_ranges_ = false, shows_percentiles_ = false;
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

std::vector<std::string> cautions_of(Answered const& of) {
    auto lines = overturn::cautions_of(of.spec);
    for (auto& line : lines) {
        line += '.';
    }
    return lines;
}

}  // namespace overturn::output

#include "output/stripe_text.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "output/detail/limit_text.hpp"
#include "output/interval_text.hpp"
#include "output/shown_levels.hpp"
#include "response/registry.hpp"
#include "results/statistics.hpp"

namespace overturn::output {
namespace {

// Verdicts that every table shows; both movements at once, and the models' own, where some trial ended so.
std::vector<std::size_t> shown_ends(BodyStatistics const& s) {
    std::vector<std::size_t> shown;
    for (std::size_t v = 0; v < verdicts().size(); ++v) {
        bool const seen = std::ranges::any_of(s.ends[v], [](std::int64_t count) { return count > 0; });
        if ((v < common_verdicts().size() && verdicts()[v].value != Verdict::slid_and_rocked) || seen) {
            shown.push_back(v);
        }
    }
    return shown;
}

std::size_t width_of(std::size_t verdict) { return std::max<std::size_t>(7, verdicts()[verdict].name.size()); }

// Effects that trials called for and that were not simulated.
std::string left_out(CampaignSpec const& spec, BodySpec const& body, BodyStatistics const& s) {
    std::string text;
    auto const wanted = spec.effects.wanted();
    for (std::size_t e = 0; e < effects().size(); ++e) {
        auto const trials = std::accumulate(s.called[e].begin(), s.called[e].end(), std::int64_t{0});
        auto const effect = effects()[e].value;
        if (s.left_out[e] > 0) {
            text +=
                fmt::format("warning: {} trials call for {}, which no model holds beside the rest: it was left out\n",
                            s.left_out[e], effects()[e].name);
        }
        if (trials == 0 || has(wanted, effect)) {
            continue;
        }
        text += effect == Effect::sliding
                    ? fmt::format(
                        "note: {} trials would have slipped (friction demand above {}), and slip was not "
                        "simulated\n",
                        trials, body.friction ? body.friction->static_coefficient : 0)
                    : fmt::format("note: {} trials call for {}, which was not simulated\n", trials, effects()[e].name);
    }
    return text;
}

void append_body(std::string& text, CampaignSpec const& spec, BodySpec const& body, BodyStatistics const& s,
                 std::optional<IntensityUnit> const& velocities) {
    double const limit = body.body.limit_velocity_mps();
    text += fmt::format(
        "\n{}: alpha {:.1f} deg, R {}, e {:.3f}, {}V_Ereq {}\n", body.name, body.body.alpha_rad() * 180 / pi,
        typed_units(spec).length.text(body.body.radius_m()), body.body.restitution(),
        body.friction
            ? fmt::format("friction {:g}/{:g}, ", body.friction->static_coefficient, body.friction->kinetic_coefficient)
            : std::string("no slip, "),
        velocities.value_or(typed_units(spec).velocity).text(limit));
    auto const shown = shown_ends(s);
    text += fmt::format("{:>10} {:>7}", fmt::format("{} {}", spec.levels.measure_name(), spec.levels.shown_units()),
                        "trials");
    for (auto const v : shown) {
        text += fmt::format(" {:>{}}", verdicts()[v].name, width_of(v));
    }
    bool const grid = !s.grid.empty();
    if (!grid) {
        text += fmt::format("  {:>8}  {:>20}", "P", fmt::format("{:g} % interval", 100 * spec.confidence));
    }
    text += spec.measures.energy ? "  V_WES: safe / false safe\n" : "\n";
    for (auto const l : shown_levels(spec.levels)) {
        auto const& stripe = s.stripes[l];
        auto const interval = stripe.interval(spec.confidence);
        auto const purpose = spec.levels.levels[l].purpose;
        text += fmt::format("{:>10.4g} {:>7}", spec.levels.shown(stripe.amplitude), stripe.trials);
        for (auto const v : shown) {
            text += fmt::format(" {:>{}}", s.ends[v][l], width_of(v));
        }
        if (!grid) {
            text += fmt::format("  {:>8}  {}", estimate_text(stripe), millionths_text(interval));
        }
        if (spec.measures.energy) {
            text += fmt::format("  {:>9} / {:<5}", s.v_wes[l].true_safe + s.v_wes[l].false_safe, s.v_wes[l].false_safe);
        }
        text += purpose == LevelClass::ordinary ? "\n" : fmt::format(" {}\n", name_of(purpose));
    }
    text += left_out_levels(spec.levels);
    text += "models:";
    for (std::size_t r = 0; r < s.models.size(); ++r) {
        text += fmt::format("{} {} {}", r == 0 ? "" : ",", s.models[r], model_categories()[r].name);
    }
    text += '\n';
    text += left_out(spec, body, s);
    if (auto const note = cut_short_text(s); !note.empty()) {
        text += fmt::format("note: {}\n", note);
    }
}

}  // namespace

std::string stripes_text(CampaignSpec const& spec, Statistics const& statistics,
                         std::optional<IntensityUnit> const& velocities) {
    std::string text;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        auto const& counted = statistics.bodies()[b];
        append_body(text, spec, spec.bodies[b], counted, velocities);
        for (std::size_t limit = 1; limit < spec.limits.size(); ++limit) {
            text += limit_stripes_text(spec, counted, limit);
        }
    }
    return text;
}

std::string table_stripes_text(std::string const& amplitude, std::span<Stripe const> stripes, double confidence,
                               bool full) {
    constexpr std::size_t most = 40;
    if (!full && stripes.size() > most) {
        return fmt::format("{} of {:.4g} to {:.4g}, {} in all: --full shows each\n", amplitude,
                           stripes.front().amplitude, stripes.back().amplitude, stripes.size());
    }
    auto text = fmt::format("{:>10} {:>7} {:>11} {:>7}  {:>8}  {:>20}\n", amplitude, "trials", "overturned", "failed",
                            "P", fmt::format("{:g} % interval", 100 * confidence));
    for (auto const& stripe : stripes) {
        text += fmt::format("{:>10.4g} {:>7} {:>11} {:>7}  {:>8}  {}\n", stripe.amplitude, stripe.trials,
                            stripe.overturned, stripe.failed,
                            stripe.decided() > 0 ? fmt::format("{:.4f}", stripe.probability()) : std::string("-"),
                            millionths_text(stripe.interval(confidence)));
    }
    return text;
}

// What a longer record would have made of them nobody knows.
std::string cut_short_text(BodyStatistics const& counted) {
    auto const sum = [](std::vector<std::int64_t> const& levels) {
        return std::accumulate(levels.begin(), levels.end(), std::int64_t{0});
    };
    auto const fell = sum(counted.fell_after_record);
    auto const peaked = sum(counted.peaked_after_record);
    return fell + peaked == 0 ? ""
                              : fmt::format(
                                  "{} trials were still rocking at the end of the record ({} overturned and {} reached "
                                  "their peak after it, without ground motion). If the real motion is longer, state a "
                                  "longer duration (pulse: quiet_after)",
                                  fell + peaked, fell, peaked);
}

std::string model_costs(PhaseSeconds const& seconds) {
    std::string text;
    for (std::size_t r = 0; r < seconds.models.size(); ++r) {
        auto const& model = seconds.models[r];
        if (model.trials > 0) {
            text += fmt::format("{}{} {} trials, {:.1f} us each", text.empty() ? "" : "; ", model_categories()[r].name,
                                model.trials, 1e6 * model.seconds / static_cast<double>(model.trials));
        }
    }
    return text;
}

}  // namespace overturn::output

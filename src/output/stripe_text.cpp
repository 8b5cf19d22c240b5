#include "output/stripe_text.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/texts_of.hpp"
#include "output/detail/interval_text.hpp"
#include "output/detail/level_columns.hpp"
#include "output/detail/limit_text.hpp"
#include "output/shown_levels.hpp"
#include "response/registry.hpp"
#include "results/few_waves.hpp"
#include "results/statistics.hpp"

namespace overturn::output {
namespace {

// Verdicts that every table shows, and those that some trial ended with.
std::vector<std::size_t> shown_ends(BodyStatistics const& s) {
    std::vector<std::size_t> shown;
    for (std::size_t v = 0; v < verdicts().size(); ++v) {
        bool const seen = std::ranges::any_of(s.ends[v], [](std::int64_t count) { return count > 0; });
        auto const verdict = verdicts()[v].value;
        bool const always = verdict == Verdict::at_rest || verdict == Verdict::slid || verdict == Verdict::rocked
                            || verdict == Verdict::overturned;
        if (always || seen) {
            shown.push_back(v);
        }
    }
    return shown;
}

// Effects that trials required and that were not simulated.
std::string left_out(CampaignSpec const& spec, BodySpec const& body, BodyStatistics const& s) {
    std::string text;
    auto const wanted = spec.effects.wanted();
    for (std::size_t e = 0; e < effects().size(); ++e) {
        auto const trials = std::accumulate(s.required[e].begin(), s.required[e].end(), std::int64_t{0});
        auto const effect = effects()[e].value;
        if (s.left_out[e] > 0) {
            text += fmt::format(
                "warning: {} trials require {}, but no model supports it with their other effects: it was not "
                "simulated\n",
                s.left_out[e], effects()[e].name);
        }
        if (trials == 0 || has(wanted, effect)) {
            continue;
        }
        text += effect == Effect::sliding
                    ? fmt::format(
                        "note: {} trials would have slipped (friction demand above {}), but slip was not "
                        "simulated\n",
                        trials, body.friction ? body.friction->static_coefficient : 0)
                    : fmt::format("note: {} trials require {}, but it was not simulated\n", trials, effects()[e].name);
    }
    return text;
}

// How the trials of each level ended.
TextGroup ends_of(CampaignSpec const& spec, BodyStatistics const& s) {
    auto const levels = shown_levels(spec.levels);
    TextGroup columns{level_column(spec.levels, levels), {"trials"}};
    for (auto const l : levels) {
        columns.back().cells.push_back(std::to_string(s.stripes[l].trials));
    }
    for (auto const v : shown_ends(s)) {
        columns.push_back({std::string(verdicts()[v].name)});
        for (auto const l : levels) {
            columns.back().cells.push_back(std::to_string(s.ends[v][l]));
        }
    }
    return columns;
}

// Their probability, and what the energy criterion predicted.
TextGroup chances_of(CampaignSpec const& spec, BodyStatistics const& s, bool sample) {
    auto const levels = shown_levels(spec.levels);
    TextGroup columns;
    if (sample) {
        columns = {{"P"}, {fmt::format("{:g} % interval", 100 * spec.confidence)}};
        for (auto const l : levels) {
            append_row(columns,
                       std::array{estimate_text(s.stripes[l]), interval_text(s.stripes[l].interval(spec.confidence))});
        }
    }
    if (spec.measures.energy) {
        TextColumn safe{"safe by\nV_WES"};
        TextColumn false_safe{"but\nfell"};
        for (auto const l : levels) {
            safe.cells.push_back(std::to_string(s.v_wes[l].true_safe + s.v_wes[l].false_safe));
            false_safe.cells.push_back(std::to_string(s.v_wes[l].false_safe));
        }
        columns.insert(columns.end(), {safe, false_safe});
    }
    columns.push_back(purpose_column(spec.levels, levels));
    return columns;
}

// On points, rim or disc, where these are stated; else of the rigid corners.
double restitution_of(BodySpec const& body) {
    return body.footing.matched ? body.footing.matched->restitution : body.body.restitution();
}

std::string friction_of(BodySpec const& body) {
    if (!body.friction) {
        return "no friction stated";
    }
    auto const [at_rest, sliding] = *body.friction;
    return at_rest == sliding ? fmt::format("friction {:g}", at_rest)
                              : fmt::format("friction {:g} at rest and {:g} in motion", at_rest, sliding);
}

void append_body(std::string& text, CampaignSpec const& spec, BodySpec const& body, BodyStatistics const& s,
                 std::optional<IntensityUnit> const& velocities, bool sample) {
    double const limit = body.body.limit_velocity_mps();
    text += fmt::format("\n{}: alpha {:.1f} deg, R {}, restitution {:.3f}, {}, V_Ereq {}\n", body.name,
                        body.body.alpha_rad() * 180 / pi, typed_units(spec).length.text(body.body.radius_m()),
                        restitution_of(body), friction_of(body),
                        velocities.value_or(typed_units(spec).velocity).text(limit));
    text += columns_text({ends_of(spec, s), chances_of(spec, s, sample)});
    text += left_out_levels(spec.levels);
    std::string models;
    for (std::size_t r = 0; r < s.models.size(); ++r) {
        models += s.models[r] == 0
                      ? std::string()
                      : fmt::format("{} {} {}", models.empty() ? "" : ",", s.models[r], model_categories()[r].name);
    }
    text += "trials by model:" + models + '\n';
    text += left_out(spec, body, s);
    if (auto const note = cut_short_text(s); !note.empty()) {
        text += fmt::format("note: {}\n", note);
    }
}

}  // namespace

std::string stripes_text(CampaignSpec const& spec, Statistics const& statistics,
                         std::optional<IntensityUnit> const& velocities) {
    std::string text;
    bool const sample = !no_sample(spec, statistics.waves().waves);
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        auto const& counted = statistics.bodies()[b];
        append_body(text, spec, spec.bodies[b], counted, velocities, sample);
        for (std::size_t limit = 1; limit < spec.limits.size(); ++limit) {
            text += limit_stripes_text(spec, counted, limit, sample);
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
    TextGroup columns{{amplitude}, {"trials"}, {"overturned"},
                      {"failed"},  {"P"},      {fmt::format("{:g} % interval", 100 * confidence)}};
    for (auto const& stripe : stripes) {
        std::array const cells{fmt::format("{:.4g}", stripe.amplitude),
                               std::to_string(stripe.trials),
                               std::to_string(stripe.overturned),
                               std::to_string(stripe.failed),
                               stripe.decided() > 0 ? fmt::format("{:.4f}", stripe.probability()) : std::string("-"),
                               interval_text(stripe.interval(confidence))};
        append_row(columns, cells);
    }
    return columns_text({columns});
}

std::string capacities_text(std::span<Capacity const> capacities, IntensityUnit const& unit) {
    auto text =
        fmt::format("{}, {} to {}; {} not reached\n", count_text(std::ssize(capacities), "capacity", "capacities"),
                    unit.text(capacities.front().intensity), unit.text(capacities.back().intensity),
                    std::ranges::count(capacities, false, &Capacity::reached));
    if (auto const moments = moments_of(capacities)) {
        text +=
            moments->beta == 0
                ? fmt::format("  moments: all capacities equal {}: no spread\n", unit.text(moments->median))
                : fmt::format("  moments: median {}, beta {:.4g} (n - 1)\n", unit.text(moments->median), moments->beta);
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

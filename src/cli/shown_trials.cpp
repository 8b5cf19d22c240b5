#include "cli/shown_trials.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/trial.hpp"
#include "cli/json_values.hpp"
#include "cli/trial_history.hpp"
#include "output/trial_text.hpp"
#include "response/registry.hpp"
#include "results/recount.hpp"

namespace overturn::cli {
namespace {

// Histories on a page: each takes about 60 kB of it.
constexpr std::size_t fewest_at_most = 12;
constexpr std::size_t most_shown = 24;

// What a body did at the design basis.
struct AtDesignBasis {
    bool judged = false;                   ///< trials of it are there
    bool moved = false;                    ///< in any of them
    std::optional<std::int64_t> farthest;  ///< one that fell, else by tilt, else by slip; none: no decided one moved
};

// Of each body's trials those that a page shows beside the telling ones; a file may hold more than memory does.
struct Farthest {
    std::vector<std::optional<std::int64_t>> on_points;  ///< the highest peak that stood on compliant points
    std::vector<AtDesignBasis> basis;
};

Farthest farthest_trials(CampaignSpec const& spec, Plan const& plan, store::ResultsReader const& file) {
    constexpr std::array<std::string_view, 4> columns{"verdict", "effects", "peak_rotation_ratio", "peak_slip"};
    auto const count = spec.bodies.size();
    Farthest found{std::vector<std::optional<std::int64_t>>(count), std::vector<AtDesignBasis>(count)};
    std::vector<double> highest(count, 0);
    std::vector<std::tuple<bool, double, double>> reached(count);
    TrialRow unknown;
    unknown.peak_rotation_ratio = unknown.peak_slip_m = never;
    each_trial(file, spec, columns, unknown, [&](std::int64_t number, TrialRow const& row) {
        auto const trial = plan.trial(number);
        auto const& end = entry_of(row.verdict);
        bool const counts = end.moved && end.decided;
        bool const on_points = has(static_cast<EffectMask>(row.effects), Effect::contact);
        if (on_points && counts && !end.fell && row.peak_rotation_ratio > highest[trial.body]) {
            highest[trial.body] = row.peak_rotation_ratio;
            found.on_points[trial.body] = number;
        }
        if (spec.levels.levels.at(trial.level).purpose != LevelClass::design_basis) {
            return;
        }
        auto& body = found.basis[trial.body];
        std::tuple const here{end.fell, row.peak_rotation_ratio, row.peak_slip_m};
        body.judged = true;
        body.moved = body.moved || end.moved;
        if (counts && here > reached[trial.body]) {
            reached[trial.body] = here;
            body.farthest = number;
        }
    });
    return found;
}

// One that is there already only gets a further word.
void add(std::vector<ChosenTrial>& of_body, std::int64_t trial, std::string const& word) {
    auto const known = std::ranges::find(of_body, trial, &ChosenTrial::trial);
    if (known != of_body.end()) {
        known->words += ", " + word;
    } else {
        of_body.push_back({trial, word});
    }
}

std::vector<ChosenTrial> chosen(CampaignSpec const& spec, Plan const& plan, std::span<TellingTrial const> telling,
                                Farthest const& farthest) {
    std::vector<TellingTrial> by_kind(telling.begin(), telling.end());
    std::ranges::stable_sort(by_kind, {}, &TellingTrial::kind);
    std::vector<std::vector<ChosenTrial>> offered(spec.bodies.size());
    for (std::size_t b = 0; b < offered.size(); ++b) {
        if (auto const& trial = farthest.basis[b].farthest) {
            add(offered[b], *trial, "farthest at the design basis");
        }
    }
    for (auto const& t : by_kind) {
        add(offered.at(t.body), t.trial, std::string(telling_kinds.at(static_cast<std::size_t>(t.kind))));
    }
    for (auto const& trial : farthest.on_points) {
        if (trial) {
            add(offered.at(plan.trial(*trial).body), *trial, "nearest-miss on points");
        }
    }
    std::vector<std::size_t> counts;
    std::ranges::transform(offered, std::back_inserter(counts), &std::vector<ChosenTrial>::size);
    auto const gets = share_fairly(counts, std::clamp(spec.bodies.size(), fewest_at_most, most_shown));
    std::vector<ChosenTrial> all;
    for (std::size_t b = 0; b < offered.size(); ++b) {
        all.insert(all.end(), offered[b].begin(), offered[b].begin() + gets[b]);
    }
    return all;
}

}  // namespace

ShownTrials histories_of(CampaignSpec const& spec, Plan const& plan, std::span<ChosenTrial const> chosen) {
    ShownTrials shown{.drawn = Json::array(), .bodies = 0, .at_rest_at_design_basis = {}};
    std::int64_t last = -1;
    for (auto const& [number, words] : chosen) {
        auto const [wave, body, level] = plan.trial(number);
        PhaseSeconds ignored;
        KeptHistory kept;
        auto const prepared = prepare_wave(spec, plan, wave, ignored);
        auto const trial = run_trial(spec, prepared, body, level, &kept);
        if (kept.empty()) {
            continue;
        }
        auto const& row = trial.rows.front();
        auto const& stated = spec.bodies[body];
        auto const title =
            output::trial_title(spec, row, number, plan.number(wave), words, spec.source->name(plan.wave_id(wave)));
        MeasureSpec const* const measures = spec.measures.energy ? &spec.measures : nullptr;
        shown.drawn.push_back(history_data(
            kept, {title, stated, prepared.bodies[body].body, prepared.motion, row.scale, measures}, for_a_page));
        shown.drawn.back()["body"] = stated.name;
        shown.drawn.back()["trial"] = number;
        shown.bodies += body != last ? 1 : 0;
        last = body;
    }
    return shown;
}

ShownTrials shown_trials(CampaignSpec const& spec, Plan const& plan, std::span<TellingTrial const> telling,
                         store::ResultsReader const& file) {
    auto const farthest = farthest_trials(spec, plan, file);
    auto shown = histories_of(spec, plan, chosen(spec, plan, telling, farthest));
    for (std::size_t b = 0; b < farthest.basis.size(); ++b) {
        if (farthest.basis[b].judged && !farthest.basis[b].moved) {
            shown.at_rest_at_design_basis.push_back(spec.bodies[b].name);
        }
    }
    return shown;
}

}  // namespace overturn::cli

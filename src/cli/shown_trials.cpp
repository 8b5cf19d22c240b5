#include "cli/shown_trials.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/trial.hpp"
#include "cli/json_values.hpp"
#include "cli/trial_history.hpp"
#include "output/trial_text.hpp"
#include "response/registry.hpp"
#include "results/stored_names.hpp"

namespace overturn::cli {
namespace {

// Histories on a page: each takes about 60 kB of it.
constexpr std::size_t fewest_at_most = 12;
constexpr std::size_t most_shown = 24;

// How the trials of a file ended, read once.
struct StoredEnds {
    std::vector<Verdict> verdicts;
    std::vector<double> peak_rotation_ratios;
};

// The highest peak that stood on compliant points, of each body.
std::vector<std::optional<std::int64_t>> nearest_misses(CampaignSpec const& spec, Plan const& plan,
                                                        store::ResultsReader const& file, StoredEnds const& stored) {
    std::vector<std::optional<std::int64_t>> nearest(spec.bodies.size());
    std::vector<double> highest(spec.bodies.size(), 0);
    auto const& [ends, peaks] = stored;
    auto const effects =
        file.has("trials/effects") ? file.integers("trials/effects") : std::vector<std::int64_t>(ends.size());
    for (std::size_t t = 0; t < ends.size(); ++t) {
        auto const& end = entry_of(ends[t]);
        auto const body = static_cast<std::size_t>(plan.trial(t).body);
        bool const on_points = has(static_cast<EffectMask>(effects[t]), Effect::contact);
        if (on_points && end.moved && end.decided && !end.fell && peaks[t] > highest[body]) {
            highest[body] = peaks[t];
            nearest[body] = static_cast<std::int64_t>(t);
        }
    }
    return nearest;
}

// What a body did at the design basis.
struct AtDesignBasis {
    bool judged = false;                   ///< trials of it are there
    bool moved = false;                    ///< in any of them
    std::optional<std::int64_t> farthest;  ///< one that fell, else by tilt, else by slip; none: no decided one moved
};

std::vector<AtDesignBasis> at_design_basis(CampaignSpec const& spec, Plan const& plan, store::ResultsReader const& file,
                                           StoredEnds const& stored) {
    std::vector<AtDesignBasis> bodies(spec.bodies.size());
    std::vector<std::tuple<bool, double, double>> reached(spec.bodies.size());
    auto const& [ends, tilts] = stored;
    auto const slips = reals_or_unknown(file, "trials/peak_slip", ends.size());
    for (std::size_t t = 0; t < ends.size(); ++t) {
        auto const trial = plan.trial(t);
        if (spec.levels.levels.at(trial.level).purpose != LevelClass::design_basis) {
            continue;
        }
        auto& body = bodies[trial.body];
        auto const& end = entry_of(ends[t]);
        std::tuple const here{end.fell, tilts[t], slips[t]};
        body.judged = true;
        body.moved = body.moved || end.moved;
        if (end.moved && end.decided && here > reached[trial.body]) {
            reached[trial.body] = here;
            body.farthest = static_cast<std::int64_t>(t);
        }
    }
    return bodies;
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
                                store::ResultsReader const& file, StoredEnds const& stored,
                                std::span<AtDesignBasis const> basis) {
    std::vector<TellingTrial> by_kind(telling.begin(), telling.end());
    std::ranges::stable_sort(by_kind, {}, &TellingTrial::kind);
    std::vector<std::vector<ChosenTrial>> offered(spec.bodies.size());
    for (std::size_t b = 0; b < basis.size(); ++b) {
        if (auto const& trial = basis[b].farthest) {
            add(offered[b], *trial, "farthest at the design basis");
        }
    }
    for (auto const& t : by_kind) {
        add(offered.at(t.body), t.trial, std::string(telling_kinds.at(static_cast<std::size_t>(t.kind))));
    }
    for (auto const& trial : nearest_misses(spec, plan, file, stored)) {
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
    auto const ends = stored_verdicts(file);
    StoredEnds const stored{ends, reals_or_unknown(file, "trials/peak_rotation_ratio", ends.size())};
    auto const basis = at_design_basis(spec, plan, file, stored);
    auto shown = histories_of(spec, plan, chosen(spec, plan, telling, file, stored, basis));
    for (std::size_t b = 0; b < basis.size(); ++b) {
        if (basis[b].judged && !basis[b].moved) {
            shown.at_rest_at_design_basis.push_back(spec.bodies[b].name);
        }
    }
    return shown;
}

}  // namespace overturn::cli

#include "cli/shown_trials.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/trial.hpp"
#include "cli/trial_history.hpp"
#include "response/registry.hpp"

namespace overturn::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_shown = 12;

// The highest peak that stood on compliant points, of each body.
std::vector<std::optional<std::int64_t>> nearest_misses(CampaignSpec const& spec, Plan const& plan,
                                                        store::ResultsReader const& file) {
    std::vector<std::optional<std::int64_t>> nearest(spec.bodies.size());
    std::vector<double> highest(spec.bodies.size(), 0);
    auto const ends = file.integers("trials/verdict");
    auto const peaks = file.reals("trials/peak_rotation_ratio");
    auto const effects = file.integers("trials/effects");
    for (std::size_t t = 0; t < ends.size(); ++t) {
        auto const& end = entry_of(static_cast<Verdict>(ends[t]));
        auto const body = static_cast<std::size_t>(plan.trial(static_cast<std::int64_t>(t)).body);
        bool const on_points = has(static_cast<EffectMask>(effects[t]), Effect::contact);
        if (on_points && end.moved && end.decided && !end.fell && peaks[t] > highest[body]) {
            highest[body] = peaks[t];
            nearest[body] = static_cast<std::int64_t>(t);
        }
    }
    return nearest;
}

// Trials with the words for what makes each worth a look, in the order of their bodies.
class Chosen {
  public:
    // One that is there already only gets a further word.
    void add(std::int64_t body, std::int64_t trial, std::string const& word) {
        auto const known = std::ranges::find(all_, trial, &One::trial);
        if (known != all_.end()) {
            known->words += ", " + word;
        } else {
            all_.push_back({body, trial, word});
        }
    }
    [[nodiscard]] std::size_t size() const { return all_.size(); }
    [[nodiscard]] bool holds(std::int64_t trial) const {
        return std::ranges::find(all_, trial, &One::trial) != all_.end();
    }

    struct One {
        std::int64_t body, trial;
        std::string words;
    };
    [[nodiscard]] std::vector<One> by_body() && {
        std::ranges::stable_sort(all_, {}, &One::body);
        return std::move(all_);
    }

  private:
    std::vector<One> all_;
};

std::vector<Chosen::One> chosen(CampaignSpec const& spec, Plan const& plan, std::span<TellingTrial const> telling,
                                store::ResultsReader const& file) {
    std::vector<TellingTrial> by_kind(telling.begin(), telling.end());
    std::ranges::stable_sort(by_kind, {}, &TellingTrial::kind);
    Chosen chosen;
    for (auto const& t : by_kind) {
        if (chosen.size() < most_shown || chosen.holds(t.trial)) {
            chosen.add(t.body, t.trial, std::string(telling_kinds.at(static_cast<std::size_t>(t.kind))));
        }
    }
    for (auto const& trial : nearest_misses(spec, plan, file)) {
        if (trial && !chosen.holds(*trial) && chosen.size() < most_shown) {
            chosen.add(plan.trial(*trial).body, *trial, "nearest-miss on points");
        }
    }
    return std::move(chosen).by_body();
}

}  // namespace

Json shown_trials(CampaignSpec const& spec, Plan const& plan, std::span<TellingTrial const> telling,
                  store::ResultsReader const& file) {
    auto shown = Json::array();
    for (auto const& [body, number, words] : chosen(spec, plan, telling, file)) {
        auto const [wave, of, level] = plan.trial(number);
        PhaseSeconds ignored;
        KeptHistory kept;
        auto const prepared = prepare_wave(spec, plan, wave, ignored);
        auto const trial = run_trial(spec, prepared, of, level, &kept);
        if (kept.empty()) {
            continue;
        }
        auto const& row = trial.rows.front();
        auto const& stated = spec.bodies[static_cast<std::size_t>(body)];
        auto const title = fmt::format("{}, trial {} ({}): wave {} at {}, {}", stated.name, number, words, wave,
                                       spec.levels.text(row.amplitude), entry_of(row.verdict).name);
        std::optional<MeasureSpec> const measures = spec.measures.energy ? std::optional(spec.measures) : std::nullopt;
        shown.push_back(history_data(
            kept,
            {title, stated, prepared.bodies[static_cast<std::size_t>(body)].body, prepared.motion, row.scale, measures},
            for_a_page));
        shown.back()["body"] = stated.name;
        shown.back()["trial"] = number;
    }
    return shown;
}

}  // namespace overturn::cli

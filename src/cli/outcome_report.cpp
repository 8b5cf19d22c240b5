#include "cli/outcome_report.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"
#include "cli/named_files.hpp"
#include "cli/outcome_csv.hpp"
#include "cli/shown_trials.hpp"
#include "core/print_note.hpp"
#include "model/verdict.hpp"
#include "output/page_text.hpp"
#include "results/stored_names.hpp"
#include "results/telling_trials.hpp"

namespace overturn::cli {
namespace {

constexpr std::size_t most_histories = 12;

// How the file's trials ended, by their numbers.
struct Ends {
    std::vector<Verdict> verdicts;
    std::vector<double> peaks;
};

// Trials of a specimen with a body of its own that stood though it fell, the highest peak rotation first: numbers of
// rows.
std::vector<std::int64_t> false_safe_trials(Specimen const& specimen, std::size_t level, Plan const& plan,
                                            Ends const& ends) {
    std::vector<std::int64_t> wrong;
    if (specimen.bodies.size() != 1) {
        return wrong;  // none of them is the specimen
    }
    auto const first =
        static_cast<std::int64_t>(specimen.bodies.front()) * plan.level_count() + static_cast<std::int64_t>(level);
    for (std::size_t w = 0; w < specimen.outcomes.size(); ++w) {
        auto const trial = static_cast<std::int64_t>(w) * plan.trials_per_wave() + first;
        if (static_cast<std::size_t>(trial) >= ends.verdicts.size()) {
            break;  // it ended early
        }
        auto const& end = entry_of(ends.verdicts[trial]);
        if (specimen.outcomes[w] == Outcome::fell && end.decided && !end.fell) {
            wrong.push_back(trial);
        }
    }
    std::ranges::stable_sort(wrong, std::ranges::greater{}, [&](std::int64_t trial) { return ends.peaks[trial]; });
    return wrong;
}

// Histories of them, shared fairly among the specimens, and in words which.
void add_histories(Json& json, Outcomes const& outcomes, CampaignSpec const& spec, Plan const& plan,
                   store::ResultsReader const& file) {
    auto const verdicts = stored_verdicts(file);
    Ends const ends{verdicts, reals_or_unknown(file, "trials/peak_rotation_ratio", verdicts.size())};
    std::vector<std::vector<std::int64_t>> wrong;
    std::vector<std::size_t> counts;
    for (auto const& specimen : outcomes.specimens) {
        wrong.push_back(false_safe_trials(specimen, outcomes.level, plan, ends));
        counts.push_back(wrong.back().size());
    }
    auto const gets = share_fairly(counts, most_histories);
    std::vector<ChosenTrial> shown;
    for (std::size_t s = 0; s < wrong.size(); ++s) {
        for (std::size_t n = 0; n < gets[s]; ++n) {
            shown.push_back({wrong[s][n], "fell in its test"});
        }
    }
    auto const all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    json["histories"] = histories_of(spec, plan, shown).drawn;
    json["histories_of"] = output::false_safe_histories_text(json["histories"].size(), all);
}

Json outcomes_json(Outcomes const& outcomes, CampaignSpec const& spec, Plan const& plan) {
    Json json;
    json["level"] = outcomes.level;
    json["levels"] = plan.level_count();
    json["motions"] = outcomes.motions;
    json["names"] = outcomes.records;
    json["specimens"] = Json::array();
    for (auto const& specimen : outcomes.specimens) {
        auto bodies = Json::array();
        for (auto const b : specimen.bodies) {
            bodies.push_back(spec.bodies[b].name);
        }
        auto ended = Json::array();
        for (auto const outcome : specimen.outcomes) {
            ended.push_back(static_cast<int>(outcome));
        }
        json["specimens"].push_back({{"name", specimen.name}, {"bodies", bodies}, {"outcomes", ended}});
    }
    return json;
}

}  // namespace

Json outcomes_data(std::string const& path, CampaignSpec const& spec, Plan const& plan,
                   store::ResultsReader const& file) {
    if (path.empty()) {
        return nullptr;
    }
    auto const outcomes = parse_outcomes(read_named(path), path, spec, plan);
    for (auto const& line : outcomes.unread) {
        print_note("{}: not understood, {}\n", path, line);
    }
    auto json = outcomes_json(outcomes, spec, plan);
    json["radius_unit"] = spec.measures.radius_unit == RadiusUnit::centimetre ? "cm" : "m";
    add_histories(json, outcomes, spec, plan, file);
    return json;
}

}  // namespace overturn::cli

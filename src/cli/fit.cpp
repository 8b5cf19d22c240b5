#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "cli/verbs.hpp"

namespace overturn::cli {
namespace {

using Json = nlohmann::ordered_json;

Json confusion_json(std::vector<Confusion> const& levels) {
    Confusion sum;
    for (auto const& c : levels) {
        sum.false_safe += c.false_safe;
        sum.false_alarm += c.false_alarm;
        sum.true_safe += c.true_safe;
        sum.true_overturn += c.true_overturn;
    }
    return {{"false_safe", sum.false_safe},
            {"false_alarm", sum.false_alarm},
            {"true_safe", sum.true_safe},
            {"true_overturn", sum.true_overturn}};
}

Json fit_json(CampaignSpec const& spec, Statistics const& statistics) {
    Json json;
    json["stripes"] = Json::array();
    json["criterion"] = Json::array();
    for (auto const& body : statistics.bodies()) {
        for (std::size_t l = 0; l < body.stripes.size(); ++l) {
            auto const& s = body.stripes[l];
            auto const interval = s.interval(spec.confidence);
            json["stripes"].push_back({{"body", body.body},
                                       {"level", l},
                                       {"amplitude", s.amplitude},
                                       {"trials", s.trials},
                                       {"overturned", s.overturned},
                                       {"failed", s.failed},
                                       {"probability", s.probability()},
                                       {"lower", interval.lower},
                                       {"upper", interval.upper}});
        }
        for (auto const& [measure, levels] : {std::pair{"v_wes", &body.v_wes}, std::pair{"ou_v_e", &body.ou_v_e}}) {
            auto entry = Json{{"body", body.body}, {"measure", measure}};
            entry.update(confusion_json(*levels));
            json["criterion"].push_back(entry);
        }
    }
    return json;
}

int fit(std::string const& path, bool as_json) {
    store::ResultsReader const file(path);
    auto const spec = parse_campaign(input_of(file));
    auto const statistics = recount(file, spec);
    fmt::print("{}", as_json ? fit_json(spec, statistics).dump(2) + "\n" : stripe_table(spec, statistics));
    return done;
}

}  // namespace

void add_fit(CLI::App& app, Action& action) {
    struct Options {
        std::string file;
        bool json = false;
    };
    auto* verb = app.add_subcommand("fit", "recompute the statistics of a results file");
    auto options = std::make_shared<Options>();
    verb->add_option("file", options->file, "results file")->required();
    verb->add_flag("--json", options->json, "as JSON");
    verb->callback([options, &action] { action = [options] { return fit(options->file, options->json); }; });
}

}  // namespace overturn::cli

#include "campaign/results.hpp"

namespace overturn {

namespace {

void require(bool sound, std::string const& what) {
    validate(sound, "results file: {} (it is damaged, or not of this program). Run the campaign again", what);
}

}  // namespace

CampaignInput input_of(store::ResultsReader const& file) {
    CampaignInput input{file.text("campaign_name"), file.text("campaign"), {}, {}};
    auto const settings = file.text("settings");
    for (std::size_t begin = 0; begin < settings.size();) {
        auto const end = std::min(settings.find('\n', begin), settings.size());
        input.settings.push_back(settings.substr(begin, end - begin));
        begin = end + 1;
    }
    for (auto const& place : file.members("inputs")) {
        input.files.emplace(file.note("inputs/" + place, "description"), file.content("inputs/" + place));
    }
    require(file.integer("complete") == 1, "it is not marked as complete");
    require(file.text("input_sha256") == input.sha256(), "its campaign is not the one it was made from");
    return input;
}

namespace {

// All waves of the campaign, or fewer where it asks to end once it is precise enough.
std::int64_t waves_done(store::ResultsReader const& file, CampaignSpec const& spec, Plan const& plan) {
    auto const done = static_cast<std::int64_t>(file.integers("waves/id").size());
    require(done == plan.waves() || (spec.target.asks() && done > 0 && done < plan.waves()),
            fmt::format("waves/id has {} rows, the campaign {}", done, plan.waves()));
    return done;
}

/// Columns of one table, each as long as there are rows to have.
class Columns {
  public:
    Columns(store::ResultsReader const& file, std::string table, std::int64_t rows)
        : file_(file), table_(std::move(table)), rows_(rows) {}

    [[nodiscard]] std::vector<std::int64_t> integers(std::string const& name) const {
        return whole(name, file_.integers(table_ + name));
    }
    [[nodiscard]] std::vector<double> reals(std::string const& name) const {
        return whole(name, file_.reals(table_ + name));
    }
    /// Integers from 0 to below `count`.
    [[nodiscard]] std::vector<std::int64_t> indices(std::string const& name, std::size_t count) const {
        auto values = integers(name);
        for (auto const value : values) {
            require(value >= 0 && static_cast<std::size_t>(value) < count,
                    fmt::format("{}{} holds {}, which names nothing", table_, name, value));
        }
        return values;
    }

  private:
    template <class Value>
    [[nodiscard]] std::vector<Value> whole(std::string const& name, std::vector<Value> values) const {
        require(static_cast<std::int64_t>(values.size()) == rows_,
                fmt::format("{}{} has {} rows, the campaign {}", table_, name, values.size(), rows_));
        return values;
    }

    store::ResultsReader const& file_;
    std::string table_;
    std::int64_t rows_;
};

// What the rows say now is what they said when the file was made.
void require_stored(store::ResultsReader const& file, BodyStatistics const& counted) {
    Columns const stripes(file, "stripes/" + counted.body + "/", static_cast<std::int64_t>(counted.stripes.size()));
    auto const trials = stripes.integers("trials");
    auto const overturned = stripes.integers("overturned");
    auto const failed = stripes.integers("failed");
    for (std::size_t l = 0; l < counted.stripes.size(); ++l) {
        auto const& stripe = counted.stripes[l];
        require(trials[l] == stripe.trials && overturned[l] == stripe.overturned && failed[l] == stripe.failed,
                fmt::format("stripes/{} does not agree with its trials", counted.body));
    }
}

// What the statistics ask of /waves/<body>, body by body for each wave.
std::vector<MeasureRow> stored_measures(store::ResultsReader const& file, CampaignSpec const& spec,
                                        std::int64_t waves) {
    auto const bodies = spec.bodies.size();
    std::vector<MeasureRow> rows(static_cast<std::size_t>(waves) * bodies);
    for (std::size_t b = 0; spec.measures.both_radius_units && b < bodies; ++b) {
        Columns const columns(file, "waves/" + spec.bodies[b].name + "/", waves);
        auto const v_wes = columns.reals("v_wes_other_unit");
        auto const ou_v_e = columns.reals("ou_v_e_other_unit");
        for (std::size_t i = 0; i < v_wes.size(); ++i) {
            rows[i * bodies + b].other_unit_v_wes_max_mps = v_wes[i];
            rows[i * bodies + b].other_unit_ou_v_e_mps = ou_v_e[i];
        }
    }
    return rows;
}

}  // namespace

Statistics recount(store::ResultsReader const& file, CampaignSpec const& spec) {
    Statistics statistics(spec);
    Plan const plan(spec);
    auto const done = waves_done(file, spec, plan);
    Columns const waves(file, "waves/", done);
    Columns const trials(file, "trials/", done * plan.trials_per_wave());
    auto const failed = waves.integers("failed");
    auto const accepted = waves.integers("accepted");
    auto const id = waves.integers("id");
    auto const pga = waves.reals("pga");
    auto const pgv = waves.reals("pgv");
    auto const matched = waves.integers("matched");
    auto const iterations = waves.integers("match_iterations");
    auto const measures = stored_measures(file, spec, done);
    for (std::size_t i = 0; i < failed.size(); ++i) {
        WaveRow row;
        row.id = id[i];
        row.pga_mps2 = pga[i];
        row.pgv_mps = pgv[i];
        row.failed = failed[i];
        row.accepted = accepted[i];
        row.matched = matched[i];
        row.match_iterations = iterations[i];
        statistics.add(row, std::span(measures).subspan(i * spec.bodies.size(), spec.bodies.size()));
    }
    auto const wave = trials.integers("wave");
    auto const amplitude = trials.reals("amplitude");
    auto const scale = trials.reals("scale");
    auto const v_wes = trials.reals("v_wes");
    auto const ou_v_e = trials.reals("ou_v_e");
    auto const v_ereq = trials.reals("v_ereq");
    auto const v_resp = trials.reals("v_resp");
    auto const peak_slip = trials.reals("peak_slip");
    auto const body = trials.indices("body", spec.bodies.size());
    auto const level = trials.indices("level", spec.levels.levels.size());
    auto const verdict = trials.indices("verdict", verdict_names().size());
    auto const v_wes_safe = trials.integers("v_wes_safe");
    auto const ou_v_e_safe = trials.integers("ou_v_e_safe");
    auto const called = trials.integers("effects_called");
    auto const rung = trials.indices("rung", rung_count);
    for (std::size_t i = 0; i < body.size(); ++i) {
        TrialRow row;
        row.wave = wave[i];
        row.amplitude = amplitude[i];
        row.scale = scale[i];
        row.v_wes_mps = v_wes[i];
        row.ou_v_e_mps = ou_v_e[i];
        row.v_ereq_mps = v_ereq[i];
        row.v_resp_mps = v_resp[i];
        row.peak_slip_m = peak_slip[i];
        row.body = body[i];
        row.level = level[i];
        row.verdict = verdict[i];
        row.v_wes_safe = v_wes_safe[i];
        row.ou_v_e_safe = ou_v_e_safe[i];
        row.effects_called = called[i];
        row.rung = rung[i];
        statistics.add(row);
    }
    for (auto const& counted : statistics.bodies()) {
        require_stored(file, counted);
    }
    return statistics;
}

}  // namespace overturn

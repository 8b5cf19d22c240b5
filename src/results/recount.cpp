#include "results/recount.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "campaign/withheld_inputs.hpp"
#include "response/registry.hpp"
#include "results/detail/limit_results.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"

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
        try {
            input.files.emplace(file.text_attribute("inputs/" + place, "description"), file.content("inputs/" + place));
        } catch (SystemError const&) {
            require(false, "inputs/" + place + " cannot be read");
        }
    }
    require(file.integer("complete") == 1, "it is not marked as complete");
    require(!file.is_sealed() || has_withheld(input) || file.text("input_sha256") == input.sha256(),
            "its campaign is not the one it was made from");
    return input;
}

namespace {

// All waves of the campaign, or fewer where it asks to end once it is precise enough.
std::int64_t waves_done(store::ResultsReader const& file, CampaignSpec const& spec, Plan const& plan) {
    auto const done = static_cast<std::int64_t>(file.integers("waves/id").size());
    require(done == plan.waves() || (spec.has_target() && done > 0 && done < plan.waves()),
            fmt::format("waves/id has {} rows, the campaign {}", done, plan.waves()));
    return done;
}

// Calls `take` with each row of a table, some at a time: a file may hold more than memory does.
template <class Row, class Take>
void each_row(store::ResultsReader const& file, store::TableSpec const& table, std::int64_t length, Take take) {
    constexpr std::int64_t at_once = 1 << 14U;
    std::vector<Row> rows;
    for (std::int64_t first = 0; first < length; first += at_once) {
        rows.assign(static_cast<std::size_t>(std::min(at_once, length - first)), {});
        file.rows(table, length, first, std::as_writable_bytes(std::span(rows)));
        for (auto const& row : rows) {
            take(row);
        }
    }
}

// The trials' records of what models have to say of their own, one after the other, some at a time; all empty where
// nobody asks.
class OwnRecords {
  public:
    OwnRecords(store::ResultsReader const& file, Ladder const& ladder, std::int64_t length)
        : file_(file), tables_(own_tables(ladder)), each_(ladder.own_bytes()), length_(length) {}

    [[nodiscard]] std::span<std::byte const> next() {
        if (length_ == 0 || each_ == 0) {
            return {};
        }
        auto const place = static_cast<std::size_t>(next_++ - first_) * each_;
        if (place < records_.size()) {
            return std::span(records_).subspan(place, each_);
        }
        constexpr std::int64_t at_once = 1 << 14U;
        first_ = next_ - 1;
        records_.assign(static_cast<std::size_t>(std::min(at_once, length_ - first_)) * each_, {});
        for (auto const& table : tables_) {
            file_.rows(table, length_, first_, records_);
        }
        return std::span(records_).first(each_);
    }

  private:
    store::ResultsReader const& file_;
    std::vector<store::TableSpec> tables_;
    std::size_t each_;
    std::int64_t length_, first_ = 0, next_ = 0;
    std::vector<std::byte> records_;
};

// What the rows say now is what they said when the file was made.
void require_stored(store::ResultsReader const& file, BodyStatistics const& counted) {
    auto const column = [&](std::string const& name) {
        auto const place = fmt::format("stripes/{}/{}", counted.body, name);
        auto values = file.integers(place);
        require(values.size() == counted.stripes.size(),
                fmt::format("{} has {} rows, the campaign {}", place, values.size(), counted.stripes.size()));
        return values;
    };
    bool same = file.integers(fmt::format("stripes/{}/rung_trials", counted.body)) == counted.rungs;
    auto const trials = column("trials");
    for (std::size_t l = 0; l < counted.stripes.size(); ++l) {
        same = same && trials[l] == counted.stripes[l].trials;
    }
    for (std::size_t v = 0; v < verdicts().size(); ++v) {
        same = same && column(column_of(verdicts()[v])) == counted.ends[v];
    }
    require(same, fmt::format("stripes/{} does not agree with its trials", counted.body));
}

// Nothing is counted of the targets' deviations, of which files of earlier programs tell fewer.
store::TableSpec counted_waves(CampaignSpec const& spec) {
    auto table = wave_table(spec);
    std::erase_if(table.columns, [](Field const& column) { return column.name.starts_with("epsilon_"); });
    return table;
}

// /waves/<body> of all bodies, body by body for each wave.
std::vector<MeasureRow> stored_measures(store::ResultsReader const& file, CampaignSpec const& spec,
                                        std::int64_t waves) {
    auto const bodies = spec.bodies.size();
    std::vector<MeasureRow> rows(static_cast<std::size_t>(waves) * bodies);
    for (std::size_t b = 0; b < bodies && !rows.empty(); ++b) {
        auto const table = measure_table(spec, b);
        file.rows(table, waves, 0, std::as_writable_bytes(std::span(rows)));
    }
    return rows;
}

}  // namespace

Statistics recount(store::ResultsReader const& file, CampaignSpec const& spec) {
    Statistics statistics(spec);
    Plan const plan(spec);
    auto const done = waves_done(file, spec, plan);
    auto const measures = stored_measures(file, spec, done);
    auto const bodies = spec.bodies.size();
    std::size_t wave = 0;
    each_row<WaveRow>(file, counted_waves(spec), done, [&](WaveRow const& row) {
        statistics.add(row, std::span(measures).subspan(bodies * wave++, bodies));
    });
    auto const levels = static_cast<std::int64_t>(spec.levels.levels.size());
    Ladder const ladder(spec.effects, spec.accuracy);
    OwnRecords own(file, ladder, statistics.reads_own() ? done * plan.trials_per_wave() : 0);
    each_row<TrialRow>(file, trial_table(spec), done * plan.trials_per_wave(), [&](TrialRow const& row) {
        require(row.level >= 0 && row.level < levels,
                fmt::format("trials/level holds {}, which names nothing", row.level));
        statistics.add(row, own.next());
    });
    for (auto const& counted : file.is_sealed() ? statistics.bodies() : std::vector<BodyStatistics>{}) {
        require_stored(file, counted);
        require_stored_limits(file, spec, counted);
    }
    return statistics;
}

TrialRows read_trial(store::ResultsReader const& file, CampaignSpec const& spec, std::int64_t number) {
    Ladder const ladder(spec.effects, spec.accuracy);
    TrialRows trial{{TrialRow{}}, std::vector<std::byte>(ladder.own_bytes())};
    auto const rows = static_cast<std::int64_t>(file.integers("trials/verdict").size());
    file.rows(trial_table(spec), rows, number, std::as_writable_bytes(std::span(trial.rows)));
    for (auto const& table : own_tables(ladder)) {
        file.rows(table, rows, number, trial.own);
    }
    return trial;
}

std::vector<std::string> differing_columns(CampaignSpec const& spec, TrialRows const& a, TrialRows const& b) {
    auto names = differing(a.rows.at(0), b.rows.at(0));
    Ladder const ladder(spec.effects, spec.accuracy);
    for (auto const& [traits, offset] : ladder.own_parts()) {
        auto const part = [&, offset = offset, bytes = traits->nothing.size()](TrialRows const& trial) {
            return std::span(trial.own).subspan(offset, bytes);
        };
        for (auto const& name : differing(traits->fields, part(a), part(b))) {
            names.push_back(fmt::format("{}/{}", traits->name, name));
        }
    }
    return names;
}

}  // namespace overturn

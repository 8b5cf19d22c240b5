#include "results/recount.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "campaign/withheld_inputs.hpp"
#include "response/registry.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"
#include "results/stored_names.hpp"
#include "results/stored_rows.hpp"

namespace overturn {

namespace {

void require(bool sound, std::string const& what) {
    validate(sound,
             "results file: {} (it was edited or damaged, or another program wrote it). Restore it, or run the "
             "campaign again",
             what);
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
    constexpr std::int64_t format_5 = 5;
    input.before_format_5 = file.integer("format_version") < format_5;
    require(file.integer("complete") == 1, "it is not marked as complete");
    require(!file.is_sealed() || has_withheld(input) || file.text("input_sha256") == input.sha256(),
            "its campaign is not the one it was made from");
    return input;
}

namespace {

// All waves of the campaign, or fewer where it asks to end once it is precise enough or fewer meet its rule.
void check_waves(std::int64_t done, CampaignSpec const& spec, std::int64_t asked) {
    bool const may_be_fewer = spec.has_target() || spec.source->about().acceptance.refuses();
    require(done == asked || (may_be_fewer && done > 0 && done < asked),
            fmt::format("waves/id has {} rows, the campaign {}", done, asked));
}

// The rows of tables that lie in one record, in their order, some at a time: a file may hold more than memory does. All
// are empty where their record is, or there are none.
template <class Value> class RowsAhead {
  public:
    /// \param each values of a row's record \param unknown what a record holds of columns that the file does not have
    RowsAhead(store::ResultsReader const& file, std::vector<store::TableSpec> tables, std::int64_t length,
              std::int64_t each, std::int64_t at_once = 1 << 14U, Value const& unknown = {})
        : file_(file), tables_(std::move(tables)), length_(length), each_(each), at_once_(at_once), unknown_(unknown) {}

    [[nodiscard]] std::span<Value const> next() {
        if (length_ == 0 || each_ == 0) {
            return {};
        }
        auto const place = next_ % at_once_;
        if (place == 0) {
            values_.assign(std::min(at_once_, length_ - next_) * each_, unknown_);
            for (auto const& table : tables_) {
                file_.rows(table, length_, next_, std::as_writable_bytes(std::span(values_)));
            }
        }
        ++next_;
        return std::span(values_).subspan(place * each_, each_);
    }

  private:
    store::ResultsReader const& file_;
    std::vector<store::TableSpec> tables_;
    std::int64_t length_, each_, at_once_, next_ = 0;
    Value unknown_;
    std::vector<Value> values_;
};

// Calls `take` with each row of a table.
template <class Row, class Take>
void each_row(store::ResultsReader const& file, store::TableSpec const& table, std::int64_t length, Take take,
              Row const& unknown = {}) {
    RowsAhead<Row> rows(file, {table}, length, 1, 1 << 14U, unknown);
    for (std::int64_t row = 0; row < length; ++row) {
        take(rows.next().front());
    }
}

// Is a column of /trials one that statistics count by, without those that they hold for curves?
bool is_counted(std::string_view column, std::span<LimitState const> limits) {
    constexpr std::array counted{"wave",          "body",         "level",       "verdict",    "effects_called",
                                 "effects",       "reason",       "rung",        "v_wes_safe", "ou_v_e_safe",
                                 "overturn_time", "time_of_peak", "first_uplift"};
    return std::ranges::find(counted, column) != counted.end()
           || std::ranges::any_of(limits, [&](LimitState const& limit) { return limit.quantity.name == column; });
}

// Counts by level; of a column that the file does not have zeros.
std::vector<std::int64_t> stored_counts(store::ResultsReader const& file, std::string const& place,
                                        std::size_t levels) {
    if (!file.has(place)) {
        return std::vector<std::int64_t>(levels);
    }
    auto values = file.integers(place);
    require(values.size() == levels, fmt::format("{} has {} rows, the campaign {}", place, values.size(), levels));
    return values;
}

// Trials per model, in the order of model_categories(); those of models that this program does not know are left out.
std::vector<std::int64_t> stored_models(store::ResultsReader const& file, std::string const& body) {
    std::vector<std::int64_t> trials(model_categories().size());
    bool const now = file.has("models/" + body);  // up to format 4 beside the stripes
    auto const names = now ? fmt::format("models/{}/model", body) : fmt::format("stripes/{}/rung", body);
    auto const counts = now ? fmt::format("models/{}/trials", body) : fmt::format("stripes/{}/rung_trials", body);
    auto const numbers = file.named(names, model_categories());
    auto const stored = file.integers(counts);
    require(numbers.size() == stored.size(), fmt::format("{} and {} differ in length", names, counts));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != unknown_category) {
            trials[model_place(numbers[i])] += stored[i];
        }
    }
    return trials;
}

// Do the stored counts of a column, which every file has, say the same as `count` of each stripe?
bool same_counts(store::ResultsReader const& file, std::string const& place, std::vector<Stripe> const& stripes,
                 std::int64_t Stripe::*count) {
    require(file.has(place), "has no " + place);
    return std::ranges::equal(stored_counts(file, place, stripes.size()), stripes, {}, {}, count);
}

// The rows give now what they gave when the file was made.
void require_stored(store::ResultsReader const& file, BodyStatistics const& counted) {
    auto const group = group_of("stripes", counted.body, overturning_limit);
    auto const levels = counted.stripes.size();
    bool same = stored_models(file, counted.body) == counted.models
                && same_counts(file, group + "/trials", counted.stripes, &Stripe::trials);
    auto const in_file = verdicts_in(file);
    for (std::size_t v = 0; v < verdicts().size(); ++v) {
        std::vector<std::int64_t> ends(levels);
        for (auto const& [value, name] : in_file) {
            if (value == static_cast<std::int64_t>(verdicts()[v].value)) {
                auto const more = stored_counts(file, group + "/" + column_of(name), levels);
                std::ranges::transform(ends, more, ends.begin(), std::plus<>());
            }
        }
        same = same && ends == counted.ends[v];
    }
    require(same, group + " does not agree with its trials");
}

void require_stored_limits(store::ResultsReader const& file, CampaignSpec const& spec, BodyStatistics const& counted) {
    for (std::size_t l = 1; l < spec.limits.size(); ++l) {
        auto const group = group_of("stripes", counted.body, spec.limits[l].name);
        auto const& stripes = counted.stripes_of(l);
        require(same_counts(file, group + "/trials", stripes, &Stripe::trials)
                    && same_counts(file, group + "/exceeded", stripes, &Stripe::overturned)
                    && same_counts(file, group + "/undecided", stripes, &Stripe::undecided),
                group + " does not agree with its trials");
    }
}

}  // namespace

Plan plan_in(store::ResultsReader const& file, CampaignSpec const& spec) {
    Plan const drawn(spec);
    auto numbers = file.integers("waves/id");
    check_waves(numbers.size(), spec, drawn.asked());
    std::ranges::transform(numbers, numbers.begin(), [&](std::int64_t id) { return drawn.number_of(id); });
    bool const rising = std::ranges::adjacent_find(numbers, std::greater_equal<>()) == numbers.end();
    require(rising && (numbers.empty() || (numbers.front() >= 0 && numbers.back() < drawn.waves())),
            "waves/id names waves that the campaign cannot have drawn");
    auto const each = std::ssize(numbers) / drawn.groups();
    return drawn.chosen(std::move(numbers), each);
}

Statistics recount(store::ResultsReader const& file, CampaignSpec const& spec, TrialsHeld held) {
    Statistics statistics(spec, held);
    auto const plan = plan_in(file, spec);
    auto const done = plan.waves();
    bool const all = held == TrialsHeld::all;
    RowsAhead<MeasureRow> measures(file, measure_tables(spec), done, std::ssize(spec.bodies), 1 << 12U);
    each_row<WaveRow>(file, wave_table(spec), done, [&](WaveRow const& row) {
        statistics.add(row, all ? measures.next() : std::span<MeasureRow const>());
    });
    if (auto const refused = refused_wave_table(spec); file.has(refused.group + "/id")) {
        auto const rows = std::ssize(file.integers(refused.group + "/id"));
        each_row<WaveRow>(file, refused, rows, [&](WaveRow const& row) { statistics.add_refused(row); });
    }
    std::int64_t const levels = spec.levels.levels.size();
    ModelSelector const selector(spec.effects, spec.accuracy);
    RowsAhead<std::byte> extra(file, extra_tables(selector),
                               statistics.reads_extra() ? done * plan.trials_per_wave() : 0,
                               static_cast<std::int64_t>(selector.extra_bytes()));
    auto table = stored_trial_table(file, spec);
    if (!all) {
        std::erase_if(table.columns, [&](Field const& column) { return !is_counted(column.name, spec.limits); });
    }
    each_row<TrialRow>(file, table, done * plan.trials_per_wave(), [&](TrialRow const& row) {
        require(row.level >= 0 && row.level < levels,
                fmt::format("trials/level holds {}, which is no level", row.level));
        statistics.add(row, extra.next());
    });
    for (auto const& counted : file.is_sealed() ? statistics.bodies() : std::vector<BodyStatistics>{}) {
        require_stored(file, counted);
        require_stored_limits(file, spec, counted);
    }
    return statistics;
}

void each_trial(store::ResultsReader const& file, CampaignSpec const& spec, std::span<std::string_view const> columns,
                TrialRow const& unknown, std::function<void(std::int64_t, TrialRow const&)> const& take) {
    auto table = held_in(file, stored_trial_table(file, spec));
    std::erase_if(table.columns,
                  [&](Field const& column) { return std::ranges::find(columns, column.name) == columns.end(); });
    std::int64_t number = 0;
    each_row<TrialRow>(
        file, table, file.length("trials/verdict"), [&](TrialRow const& row) { take(number++, row); }, unknown);
}

void each_failed(store::ResultsReader const& file, CampaignSpec const& spec,
                 std::function<void(std::int64_t, FailureReason)> const& take) {
    constexpr std::array<std::string_view, 2> columns{"verdict", "failure"};
    each_trial(file, spec, columns, {}, [&](std::int64_t number, TrialRow const& row) {
        if (row.verdict == Verdict::failed) {
            take(number, row.failure);
        }
    });
}

TrialRows read_trial(store::ResultsReader const& file, CampaignSpec const& spec, std::int64_t number) {
    return StoredRows(file, spec).trials(number, 1);
}

std::vector<std::string> differing_columns(store::ResultsReader const& file, CampaignSpec const& spec,
                                           TrialRows const& a, TrialRows const& b) {
    auto names = differing(held_in(file, trial_table(spec)).columns, bytes_of(a.rows.at(0)), bytes_of(b.rows.at(0)));
    for (auto const& table : extra_tables(ModelSelector(spec.effects, spec.accuracy))) {
        auto const model = table.group.substr(table.group.rfind('/') + 1);
        for (auto const& name : differing(held_in(file, table).columns, a.extra, b.extra)) {
            names.push_back(fmt::format("{}/{}", model, name));
        }
    }
    return names;
}

}  // namespace overturn

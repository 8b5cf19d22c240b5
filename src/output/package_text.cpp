#include "output/package_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/typed_units.hpp"
#include "core/error.hpp"
#include "core/outward.hpp"
#include "output/verified_text.hpp"
#include "results/few_waves.hpp"

namespace overturn::output {
namespace {

// "the body cask", "any of the bodies type-a and type-b"
std::string bodies_text(CampaignSpec const& spec, char const* of_several) {
    constexpr std::size_t most = 3;
    auto const& bodies = spec.bodies;
    if (bodies.size() > most) {
        return fmt::format("{} of {} bodies", of_several, bodies.size());
    }
    auto text = bodies.size() == 1 ? std::string("the body ") : fmt::format("{} of the bodies ", of_several);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        text += (b == 0 ? "" : b + 1 == bodies.size() ? " and " : ", ") + bodies[b].name;
    }
    return text;
}

std::string levels_text(LevelSpec const& levels) {
    auto const& all = levels.levels;
    if (auto const* const basis = levels.design_basis()) {
        return fmt::format("at the design basis ({} {}) and beyond", levels.measure_label(), levels.text(basis->value));
    }
    return fmt::format("at {} from {} to {}", levels.measure_label(), levels.text(all.front().value),
                       levels.text(all.back().value));
}

std::string other_limits(CampaignSpec const& spec) {
    return spec.limits.size() < 2 ? "" : ", or to pass another limit state,";
}

std::string text_at(Json const& record, char const* key) {
    auto const found = record.find(key);
    return found != record.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::int64_t count_at(Json const& record, char const* key) { return record.at(key).get<std::int64_t>(); }

// "overturn 1.0.0 (...), x86-64, 2026-11-27"
std::string circumstances(Json const& record, std::string const& maker) {
    auto text = "overturn " + text_at(record, "program");
    if (text != maker) {
        text += " (not the program of the results)";
    }
    for (auto const* key : {"machine", "date"}) {
        if (auto const value = text_at(record, key); !value.empty()) {
            text += ", " + value;
        }
    }
    return text;
}

CheckRow verification(Json const& record, std::string const& maker) {
    bool const passed = record.at("passed").get<bool>();
    auto const rows = [&](char const* key) {
        return share_of(count_at(record, key),
                        record.value(std::string("stored_") + key, std::int64_t{0}));  // not in older records
    };
    auto result = fmt::format("{} trials and {} waves recomputed", rows("trials"), rows("waves"));
    result += count_at(record, "rare") > 0 ? fmt::format(", {} rows of rare events", rows("rare")) : "";
    result += record.at("sample").is_null() ? "" : ", drawn at random";
    result += passed ? ": all bit-equal"
                     : fmt::format(": {} trials and {} waves DIFFER, first {}", count_at(record, "differing_trials"),
                                   count_at(record, "differing_waves"), text_at(record, "first"));
    return {{}, result, circumstances(record, maker), !passed};
}

CheckRow qualification(Json const& record, std::string const& maker) {
    return {
        {}, record.at("summary").get<std::string>(), circumstances(record, maker), !record.at("passed").get<bool>()};
}

std::string sample_text(Json const& study) {
    return fmt::format("{}: {} of {} waves", text_at(study, "title"), count_at(study, "waves"),
                       count_at(study, "campaign_waves"));
}

CheckRow convergence(Json const& record, std::string const& /*maker*/) {
    auto const& study = record.at("study").at(0);
    return {{},
            fmt::format("half the step changes {} of {} verdicts. {}", count_at(study, "step_flips"),
                        count_at(study, "step_trials"), text_at(study, "sentence")),
            sample_text(study),
            false};
}

CheckRow sensitivity(Json const& record, std::string const& /*maker*/) {
    std::string largest;
    double change = 0;
    bool coarse = false;
    bool identified = false;
    for (auto const& row : record.at("rows")) {
        coarse = coarse || row.value("levels_too_coarse", false);
        auto const& ratio = row.at("median_ratio");
        identified = identified || ratio.is_number();
        if (ratio.is_number() && row.at("resolved").get<bool>()
            && std::abs(ratio.get<double>() - 1) > std::abs(change)) {
            change = ratio.get<double>() - 1;
            largest =
                fmt::format("{} = {} moves the median of {} by {:+.1f} %", row.at("keys").at(0).get<std::string>(),
                            text_at(row, "moved_to"), text_at(row, "body"), 100 * change);
        }
    }
    std::vector<std::string> found;
    if (record.at("rows").empty()) {
        found.emplace_back("no assumed value was changed");
    } else if (!largest.empty()) {
        found.push_back("largest: " + largest);
    } else if (identified) {
        found.emplace_back("no resolved change of a median");
    } else if (!coarse) {
        found.emplace_back("not known: these waves identify no median");
    }
    if (coarse) {
        found.emplace_back("NOT RESOLVED for some values: levels are coarse, state more");
    }
    std::vector<std::string> not_changed;
    for (auto const& input : record.value("not_moved", Json::array())) {
        not_changed.push_back(text_at(input, "key"));
    }
    if (!not_changed.empty()) {
        found.push_back(fmt::format("not changed: {}", fmt::join(not_changed, ", ")));
    }
    return {{}, fmt::format("{}", fmt::join(found, "; ")), sample_text(record.at("study").at(0)), false};
}

// What each kind of record compares, the verb that writes it, fields by which it is known, and its row without a name;
// in the order of RecordKind.
struct KnownCheck {
    char const* check;
    char const* verb;
    std::array<char const*, 2> marks;
    CheckRow (*row)(Json const& record, std::string const& maker);
    bool of_file = false;  // of a results file
};
constexpr std::array known_checks{
    KnownCheck{
        "stored rows against a second computation", "verify", {"differing_trials", "passed"}, &verification, true},
    KnownCheck{"installation against known answers", "qualify", {"summary", "published"}, &qualification},
    KnownCheck{"program against published results", "qualify --published", {"summary", "published"}, &qualification},
    KnownCheck{"error of the settings against their cost", "cost CAMPAIGN", {"knobs", "study"}, &convergence},
    KnownCheck{"effect of each assumed value", "cost CAMPAIGN --sensitivity", {"unmoved", "study"}, &sensitivity}};

KnownCheck const& known_as(RecordKind kind) { return known_checks.at(static_cast<std::size_t>(kind)); }

}  // namespace

std::string question_text(CampaignSpec const& spec) {
    if (!spec.cover.question.empty()) {
        return spec.cover.question;
    }
    return spec.is_grid()
               ? fmt::format("At which amplitudes and frequencies does {} overturn?", bodies_text(spec, "each"))
           : no_sample(spec, spec.wave_count)
               ? fmt::format("Which of these recorded motions overturn {}{} {}?", bodies_text(spec, "any"),
                             spec.limits.size() < 2 ? "" : ", or pass another limit state,", levels_text(spec.levels))
               : fmt::format("How likely is {} to overturn{} {}?", bodies_text(spec, "each"), other_limits(spec),
                             levels_text(spec.levels));
}

std::vector<std::string> method_lines(CampaignSpec const& spec) {
    std::vector<std::string> lines{
        "Each trial follows one rigid body through one wave at one level, by time steps: uplift, impacts, overturning. "
        "Slip, a compliant pad and motion in space are simulated where a trial requires them."};
    if (!no_sample(spec, spec.wave_count)) {
        lines.emplace_back(
            "P at a level is the share of trials that overturn. Its interval is exact for independent waves (Clopper "
            "and Pearson 1934).");
        lines.emplace_back(
            "A fragility curve is lognormal, fitted to all levels by maximum likelihood. Its intervals resample whole "
            "waves.");
    }
    lines.emplace_back(
        "Not computed: the motion of soil and structure under the pad, bodies that deform, and contact between "
        "bodies.");
    return lines;
}

namespace {

// An amplitude that the body withstands, rounded down.
std::string withstood_text(LevelSpec const& levels, double value) {
    constexpr int capacity_digits = 4;
    return fmt::format("{:.{}g} {}", rounded_down(levels.shown(value), capacity_digits), capacity_digits,
                       levels.shown_units());
}

}  // namespace

std::vector<std::string> hand_check_lines(CampaignSpec const& spec, std::span<HandCheck const> checks) {
    std::vector<std::string> lines;
    if (checks.empty()) {
        return lines;
    }
    lines.push_back(
        fmt::format("energy balance under the {} spectrum of the first {} (of two horizontal components the vector)",
                    checks.front().fractile < 1 ? "84th-percentile" : "highest",
                    checks.front().waves == 1 ? std::string("wave") : fmt::format("{} waves", checks.front().waves)));
    if (!checks.front().left_out.empty()) {
        lines.push_back(fmt::format(
            "overturning leaves the waves' {} component out, which is unsafe; sliding counts it: mu (1 - 0.4 A_v/g)",
            checks.front().left_out));
    }
    auto const slip = typed_units(spec).slip;
    for (auto const& check : checks) {
        auto const level = withstood_text(spec.levels, check.overturning_level);
        auto text = fmt::format(
            "{}: {}overturns above {} {} (the spectrum at {:.3g} Hz, {:.3g} % damping; tilt {:.2f} alpha)", check.body,
            check.is_unsafe() ? fmt::format("unsafe, do not quote (half overturn at {} by simulation): ",
                                            withstood_text(spec.levels, *check.simulated_median))
                              : std::string(),
            spec.levels.measure_label(), level, check.rocking.frequency_hz, 100 * check.rocking.damping,
            check.rocking.rotation_rad / spec.bodies[&check - checks.data()].body.alpha_rad());
        if (check.sliding_m) {
            text += std::isinf(*check.sliding_m)
                        ? std::string("; vertical motion takes all of its friction at the design basis")
                    : *check.sliding_m > 0
                        ? fmt::format("; slides {} at the design basis",
                                      IntensityUnit{slip.symbol}.text(rounded_up(*check.sliding_m / slip.si, 2)))
                        : std::string("; does not slide at the design basis");
        }
        lines.push_back(text);
    }
    return lines;
}

std::vector<std::pair<std::string, std::string>> signatures(CoverText const& cover) {
    return {{"prepared", cover.prepared}, {"checked", cover.checked}, {"approved", cover.approved}};
}

RecordKind kind_of_record(Json const& record, std::string const& name) {
    auto const* const found = std::ranges::find_if(known_checks, [&](KnownCheck const& known) {
        return std::ranges::all_of(known.marks,
                                   [&](char const* mark) { return record.is_object() && record.contains(mark); });
    });
    validate(found != known_checks.end(),
             "{}: no record of a check (of verify, qualify or cost). Write one: overturn verify FILE.h5 --json > "
             "RECORD.json",
             name);
    auto const kind = static_cast<RecordKind>(found - known_checks.begin());
    return kind == RecordKind::qualify && record.at("published").get<bool>() ? RecordKind::published : kind;
}

CheckRow check_row(RecordKind kind, Json const& record, std::string const& maker) {
    auto row = known_as(kind).row(record, maker);
    row.check = known_as(kind).check;
    return row;
}

CheckRow missing_check(RecordKind kind, std::string const& file) {
    auto const& known = known_as(kind);
    return {known.check, "not run", fmt::format("overturn {}{} --json", known.verb, known.of_file ? " " + file : ""),
            false};
}

Table check_table(std::span<CheckRow const> rows) {
    TableOf<CheckRow> table({.name = "checks"}, rows);
    table.add("check", "1", "what was compared", [](CheckRow const& row) { return row.check; })
        .add("result", "1", "what was found", [](CheckRow const& row) { return row.result; })
        .add("record", "1", "program, machine and date of the record; without one the command that writes it",
             [](CheckRow const& row) { return row.record; })
        .add("failed", "1", "1: the check failed", [](CheckRow const& row) { return row.failed; });
    return table.take();
}

}  // namespace overturn::output

#include "output/records_table.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "campaign/limit_state.hpp"
#include "campaign/typed_units.hpp"
#include "campaign/verdict_text.hpp"
#include "core/outward.hpp"
#include "core/text_width.hpp"
#include "core/wrapped.hpp"
#include "output/answer.hpp"
#include "output/detail/columns_text.hpp"
#include "output/detail/level_unit.hpp"
#include "response/registry.hpp"

namespace overturn::output {
namespace {

constexpr double degrees_per_rad = 180 / pi;

// "0.0213", "12.5", "1070": three digits, and all of them before the point.
std::string number_text(double value) {
    constexpr double hundred = 100;
    return std::abs(value) < hundred ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

std::string number_or_dash(double value) { return std::isnan(value) ? std::string("-") : number_text(value); }

// A signed response says how far it is from its limit: its nearness is the exponential of the metres beyond.
std::string nearness_text(LimitState const& limit, double nearness, IntensityUnit const& unit) {
    if (!limit.quantity.is_signed) {
        return fmt::format("{:.3g} of", nearness);
    }
    auto const beyond = unit.of(std::log(nearness));
    return fmt::format("{} {} {}", number_text(std::abs(beyond)), unit.symbol, beyond > 0 ? "beyond" : "to");
}

// "1.3 of slides", "398 mm to touches": the limit that the response came nearest to. Of limits that only some models'
// own columns tell nothing is known here. What fell passed them all, but those that leave it out.
std::string nearest_limit(CampaignSpec const& spec, LimitJudge const& judge, TrialRow const& row) {
    if (entry_of(row.verdict).fell) {
        return "fell";
    }
    auto const slip = typed_units(spec).slip;
    double most = -1;
    std::size_t which = 0;
    for (std::size_t limit = 1; limit < spec.limits.size(); ++limit) {
        double const near = judge.nearness(limit, row, {});
        if (near > most) {
            most = near;
            which = limit;
        }
    }
    return which == 0 ? std::string("-")
                      : fmt::format("{} {}", nearness_text(spec.limits[which], most, slip),
                                    full_name(spec.limits[which], spec.limits));
}

std::string model_name(TrialRow const& row) {
    return row.model == unknown_category ? "unknown" : model_categories()[model_place(row.model)].name;
}

// "at-rest: slid less than 1 mm, ...; rocked: ..." of the bodies that stand.
std::string standing_verdicts_text(CampaignSpec const& spec, std::span<TrialRow const> trials) {
    std::string text;
    for (auto const& entry : verdicts()) {
        bool const stands = entry.decided && !entry.fell;
        if (stands && std::ranges::find(trials, entry.value, [](TrialRow const& row) {
                          return row.verdict;
                      }) != trials.end()) {
            text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", entry.name,
                                verdict_text(entry, spec.measures.movement, typed_units(spec).slip));
        }
    }
    return text;
}

// The campaign's names of records; the files' own where these differ from each other.
std::vector<std::string> short_names(CampaignSpec const& spec) {
    std::vector<std::string> whole;
    std::vector<std::string> files;
    for (auto const& measured : spec.source->about().measured) {
        whole.push_back(measured.name);
        files.push_back(std::filesystem::path(measured.name).filename().string());
    }
    return std::set<std::string>(files.begin(), files.end()).size() == files.size() ? files : whole;
}

std::vector<TrialRow> at_answer_levels(CampaignSpec const& spec, std::span<TrialRow const> trials) {
    auto const levels = answer_levels(spec.levels);
    std::vector<TrialRow> rows;
    std::ranges::copy_if(trials, std::back_inserter(rows), [&](TrialRow const& row) {
        return std::ranges::find(levels, static_cast<std::size_t>(row.level)) != levels.end();
    });
    return rows;
}

}  // namespace

RecordSheet record_sheet(CampaignSpec const& spec, std::span<TrialRow const> trials) {
    auto const slip = typed_units(spec).slip;
    RecordSheet sheet{{"record", "body", spec.levels.measure_label(), "verdict", fmt::format("slip [{}]", slip.symbol),
                       "tilt [deg]", "tilt / alpha", "model"},
                      {},
                      {}};
    bool const limits = spec.limits.size() > 1;
    if (limits) {
        sheet.head.emplace_back("nearest limit");
    }
    LimitJudge const judge(spec.limits, ModelSelector(spec.effects, spec.accuracy));
    auto const rows = at_answer_levels(spec, trials);
    auto const names = short_names(spec);
    sheet.note = standing_verdicts_text(spec, rows);
    for (auto const& row : rows) {
        auto const& of = spec.bodies[row.body];
        auto const& end = entry_of(row.verdict);
        sheet.rows.push_back({names.at(static_cast<std::size_t>(row.wave)), of.name, spec.levels.text(row.amplitude),
                              std::string(end.name),
                              !of.friction ? "-"
                              : end.fell   ? "fell"
                                           : number_or_dash(slip.of(row.peak_slip_m)),
                              end.fell ? "fell" : number_or_dash(degrees_per_rad * row.peak_rotation_rad),
                              end.fell ? "fell" : number_or_dash(rounded_up(row.peak_rotation_ratio)),
                              model_name(row)});
        if (limits) {
            sheet.rows.back().push_back(nearest_limit(spec, judge, row));
        }
    }
    return sheet;
}

std::string records_text(CampaignSpec const& spec, std::span<TrialRow const> trials) {
    auto const sheet = record_sheet(spec, trials);
    if (sheet.rows.empty()) {
        return {};
    }
    // What a line does not hold stands below, again behind record, body and level.
    constexpr std::size_t names = 3;
    constexpr std::size_t gap = 2;
    std::vector<TextGroup> groups;
    TextColumn trial{"", {}, TextColumn::Side::left};
    std::vector<std::size_t> wide(names, 0);
    for (std::size_t c = 0; c < names; ++c) {
        wide[c] = text_width(sheet.head[c]);
        for (auto const& row : sheet.rows) {
            wide[c] = std::max(wide[c], text_width(row[c]));
        }
    }
    auto const named = [&](std::vector<std::string> const& row) {
        std::string text;
        for (std::size_t c = 0; c < names; ++c) {
            text += fmt::format("{:<{}}", row[c], wide[c] + (c + 1 < names ? gap : 0));
        }
        return text;
    };
    trial.head = named(sheet.head);
    std::ranges::transform(sheet.rows, std::back_inserter(trial.cells), named);
    groups.push_back({std::move(trial)});
    for (std::size_t c = names; c < sheet.head.size(); ++c) {
        bool const is_number = sheet.head[c].ends_with(']') || sheet.head[c].ends_with("alpha");
        TextColumn column{sheet.head[c], {}, is_number ? TextColumn::Side::right : TextColumn::Side::left};
        for (auto const& row : sheet.rows) {
            column.cells.push_back(row[c]);
        }
        groups.push_back({std::move(column)});
    }
    return columns_text(groups) + (sheet.note.empty() ? std::string() : wrapped(sheet.note, 4));
}

Table records_table(CampaignSpec const& spec, std::span<TrialRow const> trials) {
    auto const rows = at_answer_levels(spec, trials);
    TableOf<TrialRow> table({.name = "records", .constants = {{"units", spec.levels.units()}}}, rows);
    table.add("record", "1", "the recorded motion", [&](TrialRow const& row) { return spec.source->name(row.wave); })
        .add("body", "1", "the body", [&](TrialRow const& row) { return spec.bodies[row.body].name; })
        .add("amplitude", level_unit(spec.levels), "value of the level",
             [](TrialRow const& row) { return row.amplitude; })
        .add("verdict", "1", "how the trial ended",
             [](TrialRow const& row) { return std::string(entry_of(row.verdict).name); })
        .add("peak_slip", Unit("m").as(typed_units(spec).slip),
             "largest slip, up to the fall where it fell; NaN: not simulated",
             [&](TrialRow const& row) { return spec.bodies[row.body].friction ? row.peak_slip_m : never; })
        .add("peak_rotation", Unit("rad").as(shown_unit(spec, "rad")), "largest rotation, up to the fall where it fell",
             [](TrialRow const& row) { return row.peak_rotation_rad; })
        .add("peak_rotation_ratio", "1", "the same over alpha: response over limit of overturning",
             [](TrialRow const& row) { return row.peak_rotation_ratio; })
        .add("model", "1", "the model that gave the result", [](TrialRow const& row) { return model_name(row); });
    return table.take();
}

}  // namespace overturn::output

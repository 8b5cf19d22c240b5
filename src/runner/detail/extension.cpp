#include "runner/detail/extension.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "campaign/version.hpp"
#include "core/error.hpp"
#include "results/recount.hpp"
#include "results/schema.hpp"

namespace overturn {
namespace {

using Json = nlohmann::json;

// A limit on what only some models know has these run in every trial.
void add_effects_apart(std::vector<std::string>& bars, CampaignInput const& before, CampaignInput const& now) {
    auto const there = parse_campaign(before);
    auto const here = parse_campaign(now);
    auto const more = here.effects.include & ~there.effects.include;
    auto const less = there.effects.include & ~here.effects.include;
    for (auto const& [limits, mask, why] : {std::tuple{&here.limits, more, "which its rows were computed without"},
                                            std::tuple{&there.limits, less, "and is gone"}}) {
        auto const calls = std::ranges::find_if(*limits, [mask = mask](LimitState const& limit) {
            return !limit.quantity.of_every_model && (limit.quantity.needs & mask) != 0;
        });
        if (mask != 0 && calls != limits->end()) {
            bars.push_back(
                fmt::format("limits.{} calls for {} in every trial, {}", calls->name, names_of_effects(mask), why));
        }
    }
}

std::vector<std::string> bars_between(CampaignInput const& before, CampaignInput const& now) {
    auto bars = before.differences_of_rows(now);
    if (bars.empty()) {
        add_effects_apart(bars, before, now);
    }
    return bars;
}

void refuse_barred(std::string const& place, std::vector<std::string> const& bars) {
    validate(bars.empty(), "{}: its rows are of another campaign ({}). Undo the change, or start anew with another -o",
             place, fmt::join(bars, "; "));
}

std::vector<std::string> parts_of_list(std::string const& list) {
    std::vector<std::string> parts;
    constexpr std::string_view comma = ", ";
    for (std::size_t begin = 0; begin <= list.size();) {
        auto const end = std::min(list.find(comma, begin), list.size());
        parts.push_back(list.substr(begin, end - begin));
        begin = end + comma.size();
    }
    return parts;
}

// Of two lists of libraries those that only the first has.
std::string libraries_apart(std::string const& list, std::string const& other) {
    auto parts = parts_of_list(list);
    auto const others = parts_of_list(other);
    std::erase_if(parts, [&](std::string const& part) { return std::ranges::find(others, part) != others.end(); });
    return parts.empty() ? "none of these" : fmt::format("{}", fmt::join(parts, ", "));
}

// By which a finished file's program is another one than this.
std::vector<std::string> differences_of_program(store::ResultsReader const& file) {
    std::vector<std::string> found;
    auto const add = [&](std::string_view what, std::string const& there, std::string const& here) {
        if (there != here) {
            found.push_back(fmt::format("{}{}, this is {}", what, there.empty() ? "not named" : there, here));
        }
    };
    constexpr std::size_t digits = 12;
    auto const libraries = file.text("library_versions");
    add("overturn ", file.text("program_version"), program_version());
    add("sources ", file.text("sources_sha256").substr(0, digits), sources_sha256().substr(0, digits));
    if (libraries != library_versions()) {
        found.push_back(fmt::format("with {}, this has {}", libraries_apart(libraries, library_versions()),
                                    libraries_apart(library_versions(), libraries)));
    }
    return found;
}

// What a key decides that nobody thought of would show here.
void check_against(BlockRows const& stored, std::string const& place, CampaignSpec const& spec, Plan const& plan,
                   std::int64_t block) {
    PhaseSeconds seconds;
    auto const wave = prepare_wave(spec, plan, plan.waves_of_block(block).first, seconds);
    TrialRows trials;
    (void)append_trials(spec, plan, std::span(&wave, 1), trials, seconds);
    auto const columns = trial_table(spec).columns;
    for (std::size_t t = 0; t < trials.rows.size(); ++t) {
        auto const differ = differing(columns, bytes_of(stored.trials.rows[t]), bytes_of(trials.rows[t]));
        validate(differ.empty(),
                 "{}: wave {} has other rows in this campaign, in {} (another program's, or edited). Start anew with "
                 "another -o",
                 place, wave.row.id, fmt::join(differ, ", "));
    }
}

// Computed rows of a campaign: how many waves of a group, and levels of how many.
struct Held {
    std::int64_t waves = 0;
    std::set<std::int64_t> groups;   ///< that have some
    std::set<std::int64_t> records;  ///< of them, where waves are records
};

// By the names of the blocks; where a rule refuses waves those that it accepts count, as they do in a finished file.
Held held_by(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards,
             std::vector<std::int64_t> const& blocks) {
    Held held;
    auto const& acceptance = spec.source->about().acceptance;
    std::map<std::int64_t, std::int64_t> accepted;
    for (auto const block : blocks) {
        auto const [first, count] = plan.waves_of_block(block);
        auto const rows = acceptance.refuses() ? BlockRows::unpack(shards.read(block), plan, count) : BlockRows{};
        for (auto wave = first; wave < first + count; ++wave) {
            auto const group = plan.group_of(wave);
            held.groups.insert(group);
            if (spec.source->about().available) {
                held.records.insert(wave);
            }
            auto& of_group = accepted[group];
            of_group = !acceptance.refuses()                            ? wave % plan.drawn_per_group() + 1
                       : is_tried(acceptance, rows.waves[wave - first]) ? of_group + 1
                                                                        : of_group;
            held.waves = std::max(held.waves, of_group);
        }
    }
    return held;
}

// Of a folder's own campaign.
Held held_in(store::ShardFolder const& shards, CampaignInput const& begun) {
    auto const spec = parse_campaign(begun);
    Plan const plan(spec);
    std::vector<std::string> notes;
    auto const size = [&](std::int64_t block) { return BlockRows::packed_size(plan, block); };
    store::BlockRange const all{0, plan.blocks()};
    bool const read = spec.source->about().acceptance.refuses();
    return held_by(spec, plan, shards, read ? shards.committed(all, notes, size) : shards.listed(all));
}

// Blocks that were set aside for a campaign whose rows can be used.
Json usable_aside(store::ShardFolder const& shards, CampaignInput const& input) {
    auto found = Json::array();
    for (auto const& output : shards.aside()) {
        auto const record = store::ShardFolder(output, "").begun_with();
        if (record.empty()) {
            continue;
        }
        auto const begun = CampaignInput::deserialise(record);
        if (!begun.differences_of_program(input).empty() || !bars_between(begun, input).empty()) {
            continue;
        }
        std::vector<std::string> notes;
        Plan const plan(parse_campaign(begun));
        auto const blocks =
            store::ShardFolder(output, begun.block_key()).committed({0, plan.blocks()}, notes, [&](std::int64_t block) {
                return BlockRows::packed_size(plan, block);
            });
        if (!blocks.empty()) {
            found.push_back({{"output", output.string()}, {"blocks", blocks}});
        }
    }
    return found;
}

// Records that one campaign holds rows of and another has no more, or not among those that count.
std::vector<std::string> lost_records(Held const& held, CampaignInput const& before, CampaignInput const& now,
                                      std::int64_t count) {
    auto const there = before.record_identities();
    auto const here = now.record_identities();
    std::vector<std::string> lost;
    for (auto const wave : held.records) {
        auto const& record = there.at(wave);
        auto const found = std::ranges::find(here, record);
        if (found == here.end() || found - here.begin() >= count) {
            lost.push_back(fmt::format("record {}", record.name));
        }
    }
    return lost;
}

// What is held of one campaign and another does not ask for.
std::vector<std::string> lost_rows(Held const& held, CampaignInput const& begun, CampaignInput const& input) {
    auto const before = parse_campaign(begun);
    auto const now = parse_campaign(input);
    if (held.groups.empty()) {
        return {};
    }
    auto const is_recorded = !begun.record_identities().empty();
    auto lost = is_recorded ? lost_records(held, begun, input, now.wave_count) : std::vector<std::string>{};
    if (!is_recorded && held.waves > now.wave_count) {
        lost.push_back(fmt::format("waves.count is {}, {} waves are there", now.wave_count, held.waves));
    }
    auto const& levels = before.levels.levels;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        bool const has_rows = !before.levels.independent_waves || held.groups.contains(static_cast<std::int64_t>(i));
        if (has_rows
            && std::ranges::find(now.levels.levels, levels[i].value, &Level::value) == now.levels.levels.end()) {
            lost.push_back(fmt::format("level {}", before.levels.text(levels[i].value)));
        }
    }
    for (auto const& body : before.bodies) {
        if (std::ranges::find(now.bodies, body.name, &BodySpec::name) == now.bodies.end()) {
            lost.push_back(fmt::format("body {}", body.name));
        }
    }
    return lost;
}

Held held_in(store::ResultsReader const& file, CampaignSpec const& spec) {
    auto const plan = plan_in(file, spec);
    Held held;
    held.waves = plan.chosen_per_group();
    for (std::int64_t group = 0; group < plan.groups(); ++group) {
        held.groups.insert(group);
    }
    if (spec.source->about().available) {
        auto const ids = file.integers("waves/id");
        held.records.insert(ids.begin(), ids.end());
    }
    return held;
}

void refuse_lost(std::string const& place, std::vector<std::string> const& lost) {
    validate(lost.empty(),
             "{}: finished rows would be lost ({}). Undo that, or run with --shrink if they are not wanted any more",
             place, fmt::join(lost, "; "));
}

}  // namespace

bool can_be_extended(std::filesystem::path const& output, CampaignInput const& input, bool may_shrink) {
    if (!std::filesystem::exists(output)) {
        return false;
    }
    store::ResultsReader const file(output);
    auto const others = differences_of_program(file);
    validate(others.empty(),
             "{}: made by another program ({}; their rows are not mixed). Extend it with that program, or start anew "
             "with another -o",
             output.string(), fmt::join(others, "; "));
    auto const before = input_of(file);
    refuse_barred(output.string(), bars_between(before, input));
    if (!may_shrink) {
        refuse_lost(output.string(), lost_rows(held_in(file, parse_campaign(before)), before, input));
    }
    return true;
}

bool can_take_over(store::ShardFolder const& shards, CampaignInput const& begun, CampaignInput const& input,
                   bool may_shrink) {
    if (begun.differences(input).empty()) {
        return false;
    }
    auto const others = begun.differences_of_program(input);
    validate(others.empty(),
             "{}: {} (rows of two programs are not mixed). Finish it with that one, or start anew with "
             "another -o",
             shards.folder().string(), fmt::join(others, "; "));
    refuse_barred(shards.folder().string(), bars_between(begun, input));
    validate(!parse_campaign(begun).rare && !parse_campaign(input).rare,
             "{}: another campaign with [rare] ({}; its stages need all waves). Undo the change, or start anew with "
             "another -o",
             shards.folder().string(), fmt::join(begun.differences(input), "; "));
    if (!may_shrink) {
        refuse_lost(shards.folder().string(), lost_rows(held_in(shards, begun), begun, input));
        for (auto const& output : shards.aside()) {
            auto const aside = CampaignInput::deserialise(store::ShardFolder(output, "").begun_with());
            refuse_lost(output.string(),
                        lost_rows(held_in(store::ShardFolder(output, aside.block_key()), aside), aside, input));
        }
    }
    return true;
}

void refuse_lost_waves(std::int64_t held, Plan const& chosen, std::string const& place) {
    if (chosen.chosen_per_group() < held) {
        refuse_lost(place, {fmt::format("the target is met by {} waves, {} waves are there", chosen.chosen_per_group(),
                                        std::min(held, chosen.count()))});
    }
}

std::int64_t waves_held(std::filesystem::path const& output, store::ShardFolder const& shards,
                        CampaignInput const& input) {
    std::int64_t held = 0;
    if (std::filesystem::exists(output)) {
        store::ResultsReader const file(output, store::Trust::unverified);
        held = held_in(file, parse_campaign(input_of(file))).waves;
    }
    for (auto const& each : usable_aside(shards, input)) {
        std::filesystem::path const aside = each.at("output").get<std::string>();
        auto const begun = CampaignInput::deserialise(store::ShardFolder(aside, "").begun_with());
        held = std::max(held, held_in(store::ShardFolder(aside, begun.block_key()), begun).waves);
    }
    return held;
}

KeptPlaces find_known_blocks(std::filesystem::path const& output, CampaignInput const& input, CampaignSpec const& spec,
                             Plan const& plan, store::ShardFolder const& shards) {
    bool const finished = std::filesystem::exists(output);
    validate(!spec.rare || !finished,
             "--extend of a campaign with [rare] (its stages need all waves). Start anew with another -o");
    KeptPlaces kept;
    auto const aside = usable_aside(shards, input);
    if (!finished && aside.empty()) {
        return kept;
    }
    kept.text = Json{{"file", finished ? output.string() : ""}, {"aside", aside}}.dump();
    auto const rows = kept_rows(kept.text, input, spec, plan);
    std::set<std::string> checked;
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        kept.rows.add(rows->count(block));
        if (!rows->has_all(block)) {
            kept.in_part += rows->has_some(block) ? 1 : 0;
            continue;
        }
        ++kept.blocks;
        if (checked.insert(rows->origin(block)).second) {
            check_against(rows->block(block), rows->origin(block), spec, plan, block);
        }
    }
    return kept;
}

std::unique_ptr<KeptRows> kept_rows(std::string const& text, CampaignInput const& input, CampaignSpec const& spec,
                                    Plan const& plan) {
    if (text.empty()) {
        return nullptr;
    }
    auto const places = Json::parse(text);
    std::vector<std::unique_ptr<EarlierRows>> earlier;
    if (auto const file = places.at("file").get<std::string>(); !file.empty()) {
        earlier.push_back(std::make_unique<FinishedRows>(file));
    }
    for (auto const& each : places.at("aside")) {
        std::filesystem::path const output = each.at("output").get<std::string>();
        auto const begun = CampaignInput::deserialise(store::ShardFolder(output, "").begun_with());
        earlier.push_back(std::make_unique<UnfinishedRows>(store::ShardFolder(output, begun.block_key()), begun,
                                                           each.at("blocks").get<std::vector<std::int64_t>>()));
    }
    return std::make_unique<KeptRows>(spec, plan, input.record_identities(), std::move(earlier));
}

}  // namespace overturn

#include "campaign/campaign_spec.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "campaign/detail/campaign_keys.hpp"
#include "campaign/detail/limit_spec.hpp"
#include "campaign/detail/measure_spec.hpp"
#include "campaign/detail/placement_spec.hpp"
#include "campaign/rows.hpp"
#include "campaign/typed_units.hpp"
#include "campaign/wave_check.hpp"
#include "campaign/withheld_inputs.hpp"
#include "config/faults.hpp"

namespace overturn {
namespace {

using config::Table;

constexpr std::int64_t most_trials = 1'000'000'000'000;

EffectRequest read_effects(Table const& table) {
    if (!table.has("include")) {
        auto const mode = table.text(effect_keys["mode"]);
        return table.located("mode", [&] { return parse_effect_mode(mode); });
    }
    if (table.has("mode")) {
        table.fail("include", "stated beside mode (the list already forces its effects). Keep one of them");
    }
    return table.located("include", [&] { return parse_effect_list(table.texts(effect_keys["include"])); });
}

Sampling read_sampling(Table const& table) {
    auto const sampling = table.choice<Sampling>(scatter_keys["sampling"], samplings);
    table.finish();
    return sampling;
}

void check_name(Table const& entry, std::string const& name, std::set<std::string>& names) {
    // Columns of /waves are beside the bodies' groups; these two kinds are named by the campaign's periods.
    bool taken = name == "." || name == ".." || name.starts_with("epsilon_") || name.starts_with("sa_");
    for (auto const& column : fields_of<WaveRow>()) {
        taken = taken || name == column.name;
    }
    if (name.empty() || taken || name.find('/') != std::string::npos) {
        entry.fail("name", fmt::format("'{}' (names a group of the results file beside /waves' own columns). Choose "
                                       "another, without '/'",
                                       name));
    }
    if (!names.insert(name).second) {
        entry.fail("name", fmt::format("'{}' twice (names of bodies must differ). Rename one", name));
    }
}

std::vector<BodySpec> read_bodies(Table const& root, InputFiles& files) {
    std::vector<BodySpec> bodies;
    std::set<std::string> names;
    config::FaultGatherer faults;
    for (auto const& entry : root.children(campaign_keys["bodies"])) {
        faults.run([&] {
            bodies.push_back(read_body(entry, files));
            check_name(entry, bodies.back().name, names);
        });
    }
    faults.tell();
    if (bodies.empty()) {
        root.fail("bodies", "empty (nothing to shake). Add [[bodies]]");
    }
    constexpr std::size_t most_bodies = 10000;  // their names are those of the column trials/body
    if (bodies.size() > most_bodies) {
        root.fail("bodies", fmt::format("{} of them (more than {}). Split the campaign", bodies.size(), most_bodies));
    }
    return bodies;
}

// PGV and PGD of a record whose baseline drifts are not the ground's.
void check_drift(Table const& levels, CampaignSpec const& campaign) {
    auto const& spec = campaign.levels;
    auto const& source = *campaign.source;
    if (!spec.measure->drifts) {
        return;
    }
    // What this takes to know, a calibration of noise, only PGD is worth.
    if (auto const why = spec.measure == measure_named("pgd") ? source.pgd_drift() : ""; !why.empty()) {
        levels.fail("measure", fmt::format("pgd of waves that drift ({}). Scale by pga or pgv", why));
    }
    auto const waves = source.about().available ? campaign.wave_count : 0;
    for (std::int64_t wave = 0; wave < waves; ++wave) {
        auto const drift = source.drift(wave);
        if (!drift) {
            return;
        }
        if (drift->excessive()) {
            levels.fail("measure",
                        fmt::format("{} of wave {} (which {}: that is its baseline's, not the ground's). "
                                    "State a baseline in [waves], for example baseline = {{high_pass = "
                                    "\"0.05 Hz\"}}, or scale by pga",
                                    spec.measure_name(), wave, drift->text(motion_units(typed_units(campaign)))));
        }
    }
}

// Waves and how many of them.
void read_source(Table const& root, Table const& waves, InputFiles& files, CampaignSpec& spec) {
    spec.source = make_wave_source(waves, files);
    auto const available = spec.source->about().available;
    spec.wave_count = waves.integer(
        wave_count_key, {.otherwise = available ? std::optional(static_cast<std::int64_t>(*available)) : std::nullopt});
    if (available && spec.wave_count > static_cast<std::int64_t>(*available)) {
        waves.fail("count",
                   fmt::format("{} (the source has {} waves). Lower it or leave it out", spec.wave_count, *available));
    }
    if (available && spec.levels.independent_waves) {
        root.child("levels").fail("waves", "independent (this source has the same waves for every level). Use shared");
    }
}

// Effects that are forced need what they speak of.
void check_forced_effects(Table const& effects, CampaignSpec const& spec) {
    auto const selector = effects.located("include", [&] { return std::make_unique<ModelSelector>(spec.effects); });
    for (auto const& body : spec.bodies) {
        bool const in_plane = has(spec.effects.include, Effect::contact) && !has(spec.effects.include, Effect::spatial);
        if (in_plane && body.footing.base.shape == BaseShape::polygon) {
            effects.fail("include", fmt::format("contact without spatial on '{}' (no plane holds its polygon). Add "
                                                "spatial",
                                                body.name));
        }
        if (has(spec.effects.include, Effect::sliding) && !body.friction) {
            effects.fail("include", fmt::format("sliding forced on '{}', which states no friction (slip needs a "
                                                "coefficient). Add friction to the body",
                                                body.name));
        }
        auto const unable = selector->impossible({body.body, body.friction, body.footing, body.axes});
        if (unable != 0 && body.planar_key() == nullptr) {
            effects.fail("include", fmt::format("{} forced on '{}' (no model can simulate it of this body: the usual "
                                                "pad does not hold it upright). State its base or pad",
                                                names_of_effects(unable), body.name));
        }
    }
}

void check_quality(Table const& root, CampaignSpec const& spec) {
    if (!spec.measures.wave_quality && spec.source->about().acceptance.asked()) {
        root.child("measures")
            .fail("wave_quality",
                  "false beside waves.acceptance (a rule judges the quality of every "
                  "wave). Leave one of them out");
    }
}

void check_pulses(Table const& root, CampaignSpec const& spec) {
    if (spec.rare && spec.rare->method == rare::Method::pulse_mixture && spec.limits.size() > 1) {
        root.child("rare").fail("method", fmt::format("pulse-mixture beside limit state '{}' (its pulses are of waves "
                                                      "that overturn). Use auto or subset",
                                                      spec.limits[1].name));
    }
}

}  // namespace

void refuse_drifting_levels(CampaignInput const& input, CampaignSpec const& spec) {
    auto const root = Table::parse(input.text, input.name, input.settings);
    check_drift(root.child("levels"), spec);
}

bool CampaignSpec::has_target() const {
    return std::ranges::any_of(limits, [](LimitState const& limit) { return limit.target.enabled(); });
}

std::vector<double> CampaignSpec::grid_periods_s() const {
    auto periods = source->about().grid_periods_s;
    periods.resize(std::min(periods.size(), static_cast<std::size_t>(wave_count)));
    return periods;
}

constinit config::KeyTable const campaign_table{.meaning = "the campaign itself", .keys = campaign_keys.all};

namespace {

// Tables that need nothing of the others; each reports its own faults.
void read_apart(Table const& root, InputFiles& files, CampaignSpec& spec) {
    config::FaultGatherer faults;
    faults.run([&] {
        spec.title = root.text(campaign_keys["title"]);
        spec.cover = {.question = root.text(campaign_keys["question"]),
                      .prepared = root.text(campaign_keys["prepared"]),
                      .checked = root.text(campaign_keys["checked"]),
                      .approved = root.text(campaign_keys["approved"]),
                      .revision = root.text(campaign_keys["revision"])};
    });
    faults.run([&] { (void)keeps_hashes_only(root); });
    faults.run([&] { spec.seed = root.integer(campaign_keys["seed"]); });
    faults.run([&] { spec.bodies = read_bodies(root, files); });
    faults.run([&] { spec.sampling = read_sampling(root.child_or_empty(campaign_keys["scatter"])); });
    faults.run([&] { spec.levels = read_levels(root.child(campaign_keys["levels"])); });
    faults.run([&] { spec.site = root.has("site") ? read_site(root.child(campaign_keys["site"])) : Site{}; });
    faults.run([&] {
        auto const waves = root.child(campaign_keys["waves"]);
        read_source(root, waves, files, spec);
        waves.finish();
    });
    faults.run([&] {
        auto const effects = root.child_or_empty(campaign_keys["effects"]);
        spec.effects = read_effects(effects);
        effects.finish();
    });
    faults.run([&] {
        auto const accuracy = root.child_or_empty(campaign_keys["accuracy"]);
        spec.accuracy = read_accuracy(accuracy);
        spec.measures = read_measures(root.child_or_empty(campaign_keys["measures"]));
        spec.measures.panel_phase_rad = accuracy.number(accuracy_keys["panel_phase"]);
        accuracy.finish();
    });
    faults.tell();
}

void read_neighbour(Table const& root, CampaignSpec& spec) {
    if (!root.has("site")) {
        return;
    }
    auto const site = root.child(campaign_keys["site"]);
    spec.site.cask_body = read_cask_body(site, spec.bodies);
    if (spec.site.cask_body && spec.rare) {
        site.fail(
            "cask_body",
            "beside [rare] (rare events follow one body at a time). Leave it out: the other cask is then like the "
            "body itself");
    }
}

// Its file is kept among those of the input (stated_hazard); it decides no row.
void keep_hazard(Table const& root, InputFiles& files, CampaignSpec const& spec) {
    auto const name = root.text(campaign_keys["hazard"]);
    if (name.empty()) {
        return;
    }
    if (spec.is_grid()) {
        root.fail("hazard",
                  "of waves on a grid of frequencies (no random sample: no annual frequency follows). Leave it out");
    }
    root.located("hazard", [&] { (void)files.read(name); });
}

CampaignSpec read_campaign(Table const& root, CampaignInput const& input, InputFiles& files) {
    CampaignSpec spec;
    read_apart(root, files, spec);
    auto const waves = root.child(campaign_keys["waves"]);
    auto const effects = root.child_or_empty(campaign_keys["effects"]);
    check_forced_effects(effects, spec);
    check_planar(effects, waves, spec);
    measure_levels(root, spec.levels, spec.measures);
    spec.measures.movement.by_model = input.before_format_5;
    check_quality(root, spec);
    waves.located("acceptance", [&] { validate_bands(*spec.source, spec.bodies, spec.measures.radius_unit); });
    spec.rare = read_rare(root, spec.levels, *spec.source);
    read_neighbour(root, spec);
    keep_hazard(root, files, spec);
    auto const statistics = root.child_or_empty(campaign_keys["statistics"]);
    spec.confidence = statistics.number(statistics_keys["confidence"]);
    spec.beta_u = statistics.maybe_number(statistics_keys["beta_u"]).value_or(0);
    spec.limits = read_limits(root, statistics,
                              spec.is_grid()                  ? WavesOfLevels::grid
                              : spec.levels.independent_waves ? WavesOfLevels::independent
                                                              : WavesOfLevels::shared,
                              !input.before_format_5, spec.site, spec.effects);
    check_reachable(root, spec.limits, spec.bodies);
    check_planar_limits(root, spec);
    check_pulses(root, spec);
    statistics.finish();
    root.finish();
    double const trials = static_cast<double>(spec.wave_count) * static_cast<double>(spec.bodies.size())
                          * static_cast<double>(spec.levels.levels.size());
    if (trials > static_cast<double>(most_trials)) {
        waves.fail("count", fmt::format("{:.3g} trials in all (more than {}). Lower it", trials, most_trials));
    }
    spec.inputs = root.inputs();
    for (auto& body : spec.bodies) {
        body.units = typed_units(spec);
    }
    return spec;
}

}  // namespace

CampaignSpec parse_campaign(CampaignInput const& input, InputFiles& files) {
    auto const root = Table::parse(input.text, input.name, input.settings);
    validate(!root.has("base_width") || root.has("waves"),
             "{}: a body's file (it states base_width, and no waves). Name it in a campaign, as file of [[bodies]]",
             input.name);
    root.described_by(campaign_table);
    root.may_have(campaign_table);
    auto spec = config::with_all_faults(root, [&] { return read_campaign(root, input, files); });
    // Whatever is reported beside a mistake must be one: whatever readers take is as described.
    OVERTURN_ENSURE(input.before_format_5 || root.faults().empty());
    return spec;
}

CampaignSpec parse_campaign(CampaignInput const& input) {
    InputFiles files(input.files);
    files.read_as_before_format_5(input.before_format_5);
    return parse_campaign(input, files);
}

}  // namespace overturn

#include "cost/knob.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "campaign/moves_in_space.hpp"
#include "config/table.hpp"
#include "generators/spectrum_compatible.hpp"
#include "response/registry.hpp"

namespace overturn::cost {
namespace {

constexpr char const* peak_error = "peak rotation, relative, of trials that rock in both";

// Puts the campaign's own value among those to try, keeping `settings` in the order of `precedes`.
template <class Value, class Make>
void fill(Knob& knob, std::vector<Value> values, Value own, bool rising, Make&& make) {
    if (std::find(values.begin(), values.end(), own) == values.end()) {
        values.push_back(own);
    }
    std::sort(values.begin(), values.end());
    if (!rising) {
        std::reverse(values.begin(), values.end());
    }
    for (auto const& value : values) {
        if (value == own) {
            knob.here = knob.settings.size();
        }
        knob.settings.push_back(make(value));
    }
}

Setting one_key(std::string const& key, double value, std::string const& unit = "") {
    // The shortest digits that bring back the very same number.
    auto const stated = unit.empty() ? fmt::format("{}", value) : fmt::format("\"{} {}\"", value, unit);
    return {fmt::format("{:g}{}{}", value, unit.empty() ? "" : " ", unit), {key + "=" + stated}, value};
}

Knob real_knob(std::string name, std::string title, std::string const& key, std::vector<double> const& values,
               double own) {
    Knob knob{std::move(name), std::move(title), peak_error, "trial", Acts::trials, {}, {}};
    fill(knob, values, own, false, [&](double value) { return one_key(key, value); });
    return knob;
}

Knob panel_knob(std::string name, std::string title, Acts acts, double own) {
    Knob knob{
        std::move(name), std::move(title), "relative; changed: predictions of the criterion", "wave", acts, {}, {}};
    fill(knob, {40.0, 35.0, 30.0, 25.0, 20.0, 15.0, 10.0}, own, false,
         [](double value) { return one_key("accuracy.panel_phase", value, "rad"); });
    return knob;
}

Setting effects_setting(EffectRequest const& request) {
    if (request.mode != EffectMode::forced) {
        return {text_of(request), {fmt::format("effects={{mode=\"{}\"}}", text_of(request))}, 0};
    }
    std::string list;
    for (auto const& effect : effects()) {
        if (has(request.include, effect.value)) {
            list += fmt::format("{}\"{}\"", list.empty() ? "" : ",", effect.name);
        }
    }
    return {text_of(request), {fmt::format("effects={{include=[{}]}}", list)}, 0};
}

/// What a campaign's scenes hold for effects to act on.
// Limit states may need effects that a setting leaves out, and change no trial otherwise.
void leave_limits_out(std::vector<std::string>& settings, CampaignSpec const& spec) {
    if (spec.limits.size() > 1) {
        settings.insert(settings.begin(), "limits=[]");
    }
}

struct Scenes {
    bool vertical = false, transverse = false;  ///< components of the waves
    bool friction = true;                       ///< of every body
    bool some_friction = false;                 ///< of some body
    bool footing = false;                       ///< some base or pad is stated
    bool polygon = false;                       ///< some base has no plane

    /// Models beyond the rigid one may matter.
    [[nodiscard]] bool yields() const { return footing || transverse; }
    /// All that can be simulated can be forced on every body.
    [[nodiscard]] bool with_one_friction() const { return friction || !some_friction; }
    /// All that can act in the plane, on points, and in space.
    [[nodiscard]] EffectMask rigid() const {
        return (vertical ? mask_of(Effect::vertical) : 0) | (friction ? mask_of(Effect::sliding) : 0);
    }
    [[nodiscard]] EffectMask on_points() const { return rigid() | mask_of(Effect::contact); }
    [[nodiscard]] EffectMask in_space() const { return on_points() | mask_of(Effect::spatial); }
    [[nodiscard]] EffectMask all() const { return transverse ? in_space() : footing ? on_points() : rigid(); }
};

Scenes scenes_of(CampaignSpec const& spec) {
    Scenes scenes;
    try {
        auto const motion = spec.source->make(spec.seed, 0).motion;
        scenes.vertical = !motion.vertical_mps2.empty();
        scenes.transverse = !motion.transverse_mps2.empty();
    } catch (InputError const&) {
        // a wave that cannot be made is the campaign's to report, row by row
    }
    for (auto const& body : spec.bodies) {
        scenes.friction = scenes.friction && body.friction.has_value();
        scenes.some_friction = scenes.some_friction || body.friction.has_value();
        scenes.polygon = scenes.polygon || body.footing.base.shape == BaseShape::polygon;
        scenes.footing = scenes.footing || body.footing.stated;
        scenes.transverse = scenes.transverse || body.footing.base.shape == BaseShape::polygon;
    }
    return scenes;
}

Knob effects_knob(CampaignSpec const& spec, Scenes const& scenes) {
    Knob knob{"effects",
              scenes.yields() && scenes.with_one_friction()
                  ? "effects, model by model, against all that can be simulated"
                  : "effects, model by model",
              peak_error,
              "trial",
              Acts::trials,
              {},
              {}};
    std::vector<EffectMask> forced;
    if (scenes.vertical) {
        forced.push_back(mask_of(Effect::vertical));
    }
    if (scenes.friction) {
        forced.push_back(mask_of(Effect::sliding));
    }
    if (scenes.vertical && scenes.friction) {
        forced.push_back(scenes.rigid());
    }
    if (scenes.yields() && scenes.with_one_friction() && !scenes.polygon) {
        forced.push_back(scenes.on_points());
    }
    if (scenes.transverse && scenes.with_one_friction()) {
        forced.push_back(scenes.in_space());
    }
    std::vector<EffectRequest> requests{{EffectMode::none, 0}};
    for (auto const mask : forced) {
        requests.push_back({EffectMode::forced, mask});
    }
    requests.push_back({EffectMode::automatic, 0});
    auto const own = text_of(spec.effects);
    auto const known = [&](EffectRequest const& request) { return text_of(request) == own; };
    if (std::none_of(requests.begin(), requests.end(), known)) {
        requests.push_back(spec.effects);
    }
    for (auto const& request : requests) {
        if (known(request)) {
            knob.here = knob.settings.size();
        }
        knob.settings.push_back(effects_setting(request));
        if (!known(request)) {
            leave_limits_out(knob.settings.back().settings, spec);
        }
    }
    return knob;
}

// Whether the campaign understands a key: whatever it refuses, a user could not write either.
bool takes(CampaignInput const& input, std::string const& setting) {
    try {
        (void)parse_campaign(with(input, {setting}));
        return true;
    } catch (InputError const&) {
        return false;
    }
}

void add_match_knobs(std::vector<Knob>& knobs, CampaignInput const& input) {
    if (!takes(input, "waves.match_tolerance=0.05")) {
        return;  // records, pulses, and waves that are left as drawn
    }
    auto const waves = config::Table::parse(input.text, input.name, input.settings).child("waves");
    constexpr char const* misfit = "mean misfit to the target, 300 periods a decade; verdicts against the last setting";
    Knob tolerance{"match_tolerance", "misfit at which matching stops", misfit, "wave", Acts::waves, {}, {}};
    double const own = waves.number(*spectrum_compatible_table.find("match_tolerance"));
    fill(tolerance, {0.2, 0.1, 0.05, 0.03, 0.02}, own, false,
         [](double value) { return one_key("waves.match_tolerance", value); });
    knobs.push_back(std::move(tolerance));
    Knob iterations{
        "match_iterations", "largest number of iterations of matching", misfit, "wave", Acts::waves, {}, {}};
    auto const most = waves.integer(*spectrum_compatible_table.find("match_iterations"));
    fill(iterations, {1.0, 2.0, 4.0, 8.0, 16.0, 100.0}, static_cast<double>(most), true, [](double value) {
        return Setting{fmt::format("{:g}", value), {fmt::format("waves.match_iterations={:.0f}", value)}, value};
    });
    knobs.push_back(std::move(iterations));
}

std::string stated_rim(BasePlan const& /*base*/) { return R"(shape="round")"; }
std::string stated_bed(BasePlan const& base) {
    return fmt::format(R"(shape="square",bedding={})",
                       base.corner_share ? fmt::format("{}", *base.corner_share) : R"("flat")");
}

/// Bases that stand on points, and what a file states of them.
struct PointedBases {
    char const *name, *title;
    std::vector<int> counts;  // to try; the most is the reference
    bool (*holds)(BasePlan const& base);
    std::string (*stated)(BasePlan const& base);  // but for its points
    std::optional<int> most_in_space = {};

    /// "bodies.0.base={...}" for every such base.
    [[nodiscard]] std::vector<std::string> settings(CampaignSpec const& spec, int points) const {
        std::vector<std::string> settings;
        for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
            if (auto const& base = spec.bodies[i].stated_footing.base; holds(base)) {
                settings.push_back(fmt::format("bodies.{}.base={{{},points={}}}", i, stated(base), points));
            }
        }
        return settings;
    }
};

PointedBases beds() {
    return {"points",
            "points of a bed from corner to corner",
            {5, 7, 9, 11, 15, 21, 31, 41},
            [](BasePlan const& base) { return base.is_bed(); },
            &stated_bed,
            BasePlan::most_across_in_space};
}

PointedBases rims() {
    return {"rim_points",
            "points round a rim",
            {16, 32, 64, 128, 256},
            [](BasePlan const& base) { return base.is_rim_of_points(); },
            &stated_rim};
}

// None where such bases differ: no one position is the campaign's.
void add_points_knob(std::vector<Knob>& knobs, CampaignInput const& input, CampaignSpec const& spec,
                     PointedBases const& bases) {
    std::set<int> own;
    std::set<std::int64_t> bodies;
    bool in_space = false;
    for (std::int64_t i = 0; i < std::ssize(spec.bodies); ++i) {
        auto const& body = spec.bodies[i];
        if (auto const& base = body.stated_footing.base; bases.holds(base)) {
            own.insert(base.points);
            bodies.insert(i);
            in_space = in_space || may_move_in_space(spec, body);
        }
    }
    auto const refused = [&](int points) {
        return !std::ranges::all_of(bases.settings(spec, points),
                                    [&](auto const& setting) { return takes(input, setting); });
    };
    auto points = bases.counts;
    if (in_space && bases.most_in_space) {  // finer ones count as this
        std::erase_if(points, [&](int count) { return count > *bases.most_in_space; });
        points.push_back(*bases.most_in_space);
    }
    std::erase_if(points, refused);
    if (own.size() != 1 || points.empty()) {
        return;
    }
    Knob knob{bases.name, bases.title, peak_error, "trial", Acts::trials, {}, {}};
    auto const most = std::max(points.back(), *own.begin());
    fill(knob, points, *own.begin(), true, [&](int count) {
        return Setting{fmt::format("{}", count), bases.settings(spec, count), static_cast<double>(count)};
    });
    knob.bodies = std::move(bodies);
    knob.reference = reference_settings();
    std::ranges::copy(bases.settings(spec, most), std::back_inserter(knob.reference));
    knobs.push_back(std::move(knob));
}

Knob periods_knob() {
    Knob knob{"spectrum_periods",
              "periods per decade of a response spectrum",
              "ordinates read between the periods, relative, mean of a wave",
              "wave",
              Acts::spectra,
              {},
              {}};
    for (double const count : {10, 20, 40, 75, 100, 150, 300}) {
        knob.settings.push_back({fmt::format("{:g}", count), {}, count});
    }
    return knob;
}

}  // namespace

std::vector<Knob> knobs_of(CampaignInput const& input, CampaignSpec const& spec) {
    auto const scenes = scenes_of(spec);
    std::vector<Knob> knobs;
    if (scenes.yields()) {
        knobs.push_back(real_knob(contact_step, "step on compliant points, times the vertical mode's frequency",
                                  "accuracy.contact_step", {1.0, 0.6, 0.3, 0.15, 0.075},
                                  spec.accuracy.contact.step_ratio));
        knobs.back().reference = contact_reference_settings();
    }
    add_points_knob(knobs, input, spec, beds());
    add_points_knob(knobs, input, spec, rims());
    knobs.push_back(effects_knob(spec, scenes));
    auto const of_effects = effects_reference_settings(spec);
    bool const same = spec.effects.mode == EffectMode::automatic && of_effects.back() == automatic_effects;
    knobs.back().reference = same ? reference_settings() : of_effects;
    if (spec.measures.energy) {
        auto const own = spec.measures.panel_phase_rad;
        knobs.push_back(panel_knob("ou_v_e", "phase per panel of 16 nodes, ouV_E alone", Acts::ou_v_e, own));
        knobs.push_back(panel_knob("v_wes", "phase per panel of 16 nodes, V_WES and ouV_E", Acts::v_wes, own));
    }
    add_match_knobs(knobs, input);
    knobs.push_back(periods_knob());
    return knobs;
}

std::vector<std::string> reference_settings() {
    return {"accuracy.taylor_order=12", "accuracy.substeps=16", "accuracy.step_tolerance=1e-15",
            "accuracy.settle=1e-8"};
}

std::vector<std::string> second_reference_settings() {
    auto settings = reference_settings();
    settings.emplace_back("accuracy.substeps=12");
    return settings;
}

std::vector<std::string> contact_reference_settings() {
    auto settings = reference_settings();
    settings.emplace_back("accuracy.contact_step=0.03");
    return settings;
}

std::vector<std::string> effects_reference_settings(CampaignSpec const& spec) {
    auto settings = reference_settings();
    leave_limits_out(settings, spec);
    auto const scenes = scenes_of(spec);
    EffectRequest const all{scenes.yields() && scenes.with_one_friction() ? EffectMode::forced : EffectMode::automatic,
                            scenes.all()};
    settings.push_back(effects_setting(all).settings.front());
    return settings;
}

CampaignInput with(CampaignInput const& input, std::vector<std::string> const& settings) {
    auto varied = input;
    varied.settings.insert(varied.settings.end(), settings.begin(), settings.end());
    return varied;
}

}  // namespace overturn::cost

// Requirement R-506: effects that no model holds together are refused where they are stated, and reported where auto
// meets them; so is friction that stated effects ignore.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "campaign/model_assumptions.hpp"
#include "campaign/trial.hpp"
#include "campaign/warnings.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::campaign_from;

// A made-up model that every body calls for and that holds no bed.
constexpr Effect tied{16};

class TiedModel : public Model {
  public:
    static ModelTraits const& entry() {
        static constexpr std::array effects{EffectEntry{tied, "tied", "made up"}};
        static ModelTraits const traits{.name = "tied",
                                        .number = 9,
                                        .holds = mask_of(tied) | mask_of(Effect::vertical) | mask_of(Effect::sliding),
                                        .always = mask_of(tied),
                                        .effects = effects};
        return traits;
    }
    [[nodiscard]] ModelTraits const& traits() const override { return entry(); }
    [[nodiscard]] Requirement required_of(Trial const& /*trial*/, Outcome const* /*said*/) const override {
        return {mask_of(tied)};
    }
    std::unique_ptr<Checkpoints> run(Batch const& /*batch*/) const override { return nullptr; }
};

bool told(std::vector<std::string> const& lines, std::string const& part) {
    return std::ranges::any_of(lines, [&](auto const& line) { return line.find(part) != std::string::npos; });
}

std::string campaign_with(std::string const& body_keys, std::string const& effects) {
    return testing::quick_waves + testing::type_b + body_keys + testing::levels("values=[6]\n") + effects;
}

TEST(StatedEffects, EffectsThatAutoLeavesOutAreReportedBeforeARun) {
    static std::array const with_ties{
        models()[0], models()[1],
        ModelEntry{TiedModel::entry,
                   [](Accuracy const&) -> std::unique_ptr<Model> { return std::make_unique<TiedModel>(); }},
        models()[2]};
    auto const warnings = [](std::string const& body_keys, std::span<ModelEntry const> entries) {
        auto const spec = campaign_from(campaign_with(body_keys, ""));
        PhaseSeconds seconds;
        return warnings_of_effects(spec, prepare_wave(spec, Plan(spec), 0, seconds),
                                   ModelSelector(spec.effects, {}, entries));
    };
    std::string const flat = "base={bedding='flat'}\npad={match_restitution=false}\n";
    EXPECT_TRUE(told(warnings(flat, with_ties), "type-b requires contact, but no model supports it together"));
    EXPECT_TRUE(warnings("", with_ties).empty()) << "its corners call for no bed";
    EXPECT_TRUE(warnings(flat, models()).empty());
}

TEST(StatedEffects, FrictionThatTheyIgnoreIsReported) {
    auto const warnings = [](std::string const& body_keys, std::string const& effects) {
        return warnings_of(campaign_from(campaign_with(body_keys, effects)));
    };
    char const* const stuck = "type-b: it does not slip";
    EXPECT_TRUE(told(warnings("friction=0.5\n", "[effects]\ninclude=['contact']\n"),
                     "type-b: it does not slip, its points grip without limit: what its slip says is their spring (its "
                     "friction is stated, but effects (contact) leave sliding out). Add sliding if it should count"));
    EXPECT_TRUE(told(warnings("friction=0.5\n", "[effects]\ninclude=['vertical']\n"), stuck));
    EXPECT_FALSE(told(warnings("friction=0.5\n", "[effects]\ninclude=['contact', 'sliding']\n"), stuck));
    EXPECT_FALSE(told(warnings("friction=0.5\n", ""), stuck));
    EXPECT_FALSE(told(warnings("", "[effects]\ninclude=['contact']\n"), stuck)) << "it states none";
    EXPECT_TRUE(told(warnings("friction=0.5\n", "[effects]\nmode='none'\n"), stuck));
    char const* const grips = "type-b: its points grip without limit, because no friction is stated";
    EXPECT_TRUE(told(warnings("", "[effects]\ninclude=['contact']\n"), grips));
    EXPECT_FALSE(told(warnings("friction=0.5\n", "[effects]\ninclude=['contact']\n"), grips)) << "said otherwise";
    EXPECT_FALSE(told(warnings("", "[effects]\nmode='none'\n"), grips)) << "it has no points";
}

// Points grip by the kinetic coefficient: where the static one alone is above tan(alpha), 0.431, a body slides that
// would rock.
TEST(StatedEffects, StaticFrictionThatPointsDoNotHaveIsReported) {
    auto const warned_of = [](std::string const& body_keys, std::string const& effects = "") {
        return told(warnings_of(campaign_from(campaign_with(body_keys, effects))),
                    "it slides where it would rock first");
    };
    std::string const apart = "friction={static=0.6, kinetic=0.4}\n";
    std::string const flat = "base={bedding='flat'}\n";
    EXPECT_TRUE(warned_of(apart + flat));
    EXPECT_TRUE(warned_of(apart + "base={shape='round'}\n"));
    EXPECT_FALSE(warned_of(apart)) << "two rigid corners hold by the static one";
    EXPECT_FALSE(warned_of(apart + flat, "[effects]\nmode='none'\n")) << "no points";
    EXPECT_FALSE(warned_of("friction={static=0.6, kinetic=0.45}\n" + flat)) << "it rocks by either";
    EXPECT_FALSE(warned_of("friction={static=0.42, kinetic=0.4}\n" + flat)) << "it slides by either";
    EXPECT_FALSE(warned_of("friction=0.6\n" + flat));
}

// A limit to what the model of a body does not compute would decide nothing: it is said before the run.
TEST(StatedEffects, LimitsToWhatNoTrialHasAreReported) {
    auto const warned = [](std::string const& quantity, std::string const& waves, std::string const& body) {
        auto const text = testing::quick_waves + waves + testing::type_b + body + testing::levels("values=[6]\n")
                          + "[[limits]]\nname='far'\nquantity='" + quantity + "'\nabove=0.5\n";
        return told(warnings_of(campaign_from(text)), "have no " + quantity + ", so they have no verdict unless");
    };
    char const* const across = "[waves.transverse]\nratio=1\n";
    for (auto const* const quantity : {"friction_demand", "friction_work", "rotation_at_peak"}) {
        EXPECT_TRUE(warned(quantity, across, "friction=0.5\n")) << quantity;
        EXPECT_TRUE(warned(quantity, "", "friction=0.5\nbase={bedding='flat'}\n")) << quantity;
        EXPECT_FALSE(warned(quantity, "", "friction=0.5\n")) << quantity;
    }
    for (auto const* const quantity : {"peak_rotation", "peak_slip", "peak_top", "residual_x"}) {
        EXPECT_FALSE(warned(quantity, across, "friction=0.5\n")) << quantity;
        EXPECT_FALSE(warned(quantity, "", "friction=0.5\nbase={bedding='flat'}\n")) << quantity;
    }
    EXPECT_TRUE(warned("rotation_most", across, "friction=0.5\n"));
    for (auto const* const quantity : {"yaw", "slip_path"}) {  // such a limit calls the model in space
        EXPECT_FALSE(warned(quantity, "", "friction=0.5\nbase={shape='round'}\n")) << quantity;
    }
}

TEST(StatedEffects, BasesAndComponentsThatTheyLeaveOutAreReported) {
    auto const bears = [](CampaignSpec const& spec, std::string_view name) {
        auto const all = model_assumptions();
        return std::ranges::find(all, name, &ModelAssumption::name)->bears(spec);
    };
    auto const warned_of = [&](std::string const& included, std::string const& part) {
        auto const spec = campaign_from(campaign_with("friction=0.5\nbase={bedding='flat'}\npad={strength='3 MPa'}\n",
                                                      "[effects]\n" + included + "\n"));
        bool const on_bed = !told(warnings_of(spec), "it turns about two rigid corners (its base or pad is stated");
        EXPECT_EQ(bears(spec, "corner-contact") == Bears::yes, !on_bed) << included;
        EXPECT_EQ(bears(spec, "elastic-pad") == Bears::yes, !on_bed) << included;
        return told(warnings_of(spec), part);
    };
    EXPECT_TRUE(warned_of("include=['sliding']", "but effects (sliding) leave contact out"));
    EXPECT_TRUE(warned_of("mode='none'", "effects (none) leave contact out"));
    EXPECT_FALSE(warned_of("include=['contact', 'sliding']", "leave contact out"));
    EXPECT_FALSE(warned_of("include=['spatial']", "leave contact out")) << "motion in space is on a bed";
    EXPECT_FALSE(warned_of("mode='auto'", "out). Add"));

    auto const spec = campaign_from(campaign_with("", ""));
    auto body = spec.bodies.front();
    std::vector<double> const wave(100, 0.1);
    GroundMotion const motion{
        .time_step_s = 0.01, .horizontal_mps2 = wave, .transverse_mps2 = wave, .vertical_mps2 = wave};
    body.axes = 3;
    auto const lines = warnings_of_stated_effects(body, motion, parse_effects("none"));
    EXPECT_TRUE(told(lines, "it moves in one plane (the wave has a second component"));
    EXPECT_TRUE(told(lines, "does not move vertically (the wave has a vertical component, but effects (none)"));
    auto const in_space = warnings_of_stated_effects(body, motion, parse_effects("vertical,spatial"));
    EXPECT_EQ(in_space.size(), 1U);
    EXPECT_TRUE(told(in_space, "its points grip without limit, because no friction is stated"));
    body.axes = 1;
    EXPECT_TRUE(warnings_of_stated_effects(body, motion, parse_effects("none")).empty()) << "shaken along one axis";
    EXPECT_TRUE(told(warnings_of_stated_effects(body, motion, parse_effects("vertical")), "vertically (axes = 1)"));
    body.axes = 3;
    GroundMotion const level{.time_step_s = 0.01, .horizontal_mps2 = wave, .transverse_mps2 = {}, .vertical_mps2 = {}};
    EXPECT_TRUE(told(warnings_of_stated_effects(body, level, parse_effects("vertical")), "no vertical component"));
}

TEST(StatedEffects, ThatABodyCannotHaveAreRefusedWithTheirPlace) {
    std::string const reed =
        "[[bodies]]\nname='reed'\nmass='1 t'\nbase_width='0.02 m'\ncentre_height='2 m'\ninertia='uniform-block'\n";
    auto const reads = [&](std::string const& keys, std::string const& included) {
        return [=] {
            (void)campaign_from(testing::quick_waves + reed + keys + testing::levels("values=[6]\n")
                                + "[effects]\ninclude=" + included + "\n");
        };
    };
    testing::expect_input_error(reads("", "['contact']"), "effects.include", "contact forced on 'reed'");
    testing::expect_input_error(reads("", "['sliding']"), "effects.include", "states no friction");
    EXPECT_NO_THROW(reads("pad={vertical_frequency='900 Hz', match_restitution=false}\n", "['contact']")());
}

}  // namespace
}  // namespace overturn

// Requirement: a limit that no trial can pass, or that every trial passes, is refused; one that is hardly
// meant is a line; what is usual of any quantity is neither.
#include "campaign/detail/limit_range.hpp"

#include <algorithm>

#include "campaign/detail/unsound.hpp"
#include "campaign/warnings.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

void judge(std::string const& text) {
    auto const input = testing::input_from(text);
    refuse_unsound(input, parse_campaign(input));
}

bool told(std::vector<std::string> const& lines, std::string const& what) {
    return std::ranges::any_of(lines, [&](std::string const& line) { return line.find(what) != std::string::npos; });
}

std::string limited(std::string const& quantity, std::string const& rule) {
    return testing::quick_waves + testing::type_b + "friction=0.5\npad={strength='30 MPa'}\n"
           + testing::levels("values=[3]\n")
           + fmt::format("[[limits]]\nname='tips'\nquantity='{}'\n{}\n", quantity, rule);
}

TEST(LimitRange, LimitThatNoStandingBodyCanPass) {
    auto const refuse = [](std::string const& quantity, std::string const& rule, std::string const& part) {
        testing::expect_input_error([&] { judge(limited(quantity, rule)); }, "limits[0]." + rule.substr(0, 5), part);
    };
    refuse("peak_rotation", "above=10", "Write \"10 deg\"");
    refuse("peak_rotation", "above='95 deg'", "95 deg of peak_rotation (it is at most 90 deg: no trial passes");
    refuse("peak_rotation_ratio", "above=50", "at most 3.8");
    refuse("min_contact_force_ratio", "above=1", "at most 1: no trial passes that but by falling). Lower it");
    refuse("peak_contact_force_ratio", "below=0.9", "at least 1, of a body at rest too: no trial passes");
    for (auto const* sound : {"above='10 deg'", "above='89 deg'"}) {
        EXPECT_NO_THROW(judge(limited("peak_rotation", sound))) << sound;
    }
    EXPECT_NO_THROW(judge(limited("peak_rotation_ratio", "above=0.5")));
    EXPECT_NO_THROW(judge(limited("min_contact_force_ratio", "below=1")));
}

TEST(LimitRange, LimitThatEveryTrialPasses) {
    auto const refuse = [](std::string const& quantity, std::string const& rule, std::string const& part) {
        testing::expect_input_error([&] { judge(limited(quantity, rule)); }, "limits[0]." + rule.substr(0, 5), part);
    };
    refuse("min_contact_force_ratio", "below=1.1", "1.1 of min_contact_force_ratio (it is at most 1: every trial");
    refuse("peak_rotation", "below='2 rad'",
           "2 rad = 114.6 deg of peak_rotation (it is at most 1.571 rad: every trial");
    refuse("peak_contact_force_ratio", "above=0.9", "at least 1, of a body at rest too: every trial passes that");
    refuse("friction_demand", "above=0", "never 0: every trial passes that). Raise it");
    refuse("edge_x_most", "above='0.4 m'", "at least 0.45 m, of a body at rest too: every trial passes that");
    refuse("peak_slip", "above=-1", "");
    EXPECT_NO_THROW(judge(limited("peak_contact_force_ratio", "above=1.2")));
    EXPECT_NO_THROW(judge(limited("edge_x_most", "above='0.8 m'")));
    EXPECT_NO_THROW(judge(limited("impacts", "above=0")));
}

// Of two bodies a limit may be one's alone: then it stands, and the other is named.
TEST(LimitRange, LimitThatOneBodyCanPassStands) {
    auto const text = testing::quick_waves + testing::type_a + testing::type_b + testing::levels("values=[3]\n")
                      + "[[limits]]\nname='far'\nquantity='peak_rotation_ratio'\nabove=3\n";
    EXPECT_NO_THROW(judge(text));
    auto const lines = warnings_of(testing::campaign_from(text));
    EXPECT_TRUE(told(lines, "limit 'far': no trial of type-a passes peak_rotation_ratio above 3 but by falling"));
    EXPECT_FALSE(told(lines, "no trial of type-b"));
}

// Every quantity has a range: what no body reaches, or any shaking passes, is a line, what is usual none.
TEST(LimitRange, LimitsThatAreHardlyMeantGetALine) {
    auto const line = [](std::string const& quantity, std::string const& rule) {
        std::string found;
        for (auto const& said : warnings_of(testing::campaign_from(limited(quantity, rule)))) {
            found += said.find("limit 'tips'") == std::string::npos ? "" : said;
        }
        return found;
    };
    for (auto const& [quantity, rule] :
         std::vector<std::pair<std::string, std::string>>{{"peak_slip", "above=300"},
                                                          {"peak_slip", "above=0"},
                                                          {"residual_slip", "above='20 m'"},
                                                          {"peak_slip", "below='0.3 m'"},
                                                          {"peak_rotation", "above='30 deg'"},
                                                          {"peak_rotation", "above='1e-4 deg'"},
                                                          {"peak_rotation_ratio", "above=1"},
                                                          {"peak_energy_ratio", "above=2"},
                                                          {"v_resp", "above='3 m/s'"},
                                                          {"friction_demand", "above=0.5"},
                                                          {"min_contact_force_ratio", "above=0.2"},
                                                          {"peak_contact_force_ratio", "above=1"},
                                                          {"peak_contact_force_ratio", "above=2000"},
                                                          {"impacts", "above=100000"},
                                                          {"peak_impact_velocity", "above=50"},
                                                          {"landing_spin", "above=50"},
                                                          {"landing_velocity", "above='100 m/s'"},
                                                          {"landing_energy", "above=5000"},
                                                          {"friction_work", "above=5000"},
                                                          {"peak_yaw", "above=10"},
                                                          {"peak_crush", "above=30"},
                                                          {"peak_rise", "above=100"},
                                                          {"peak_top", "above=400"},
                                                          {"edge_x_most", "above=11"}}) {
        EXPECT_NE(line(quantity, rule), "") << quantity << ' ' << rule;
    }
    for (auto const& [quantity, rule] :
         std::vector<std::pair<std::string, std::string>>{{"peak_slip", "above='30 cm'"},
                                                          {"peak_rotation", "above='10 deg'"},
                                                          {"peak_rotation_ratio", "above=0.5"},
                                                          {"peak_energy_ratio", "above=0.3"},
                                                          {"v_resp", "above='0.5 m/s'"},
                                                          {"friction_demand", "above=0.4"},
                                                          {"min_contact_force_ratio", "below=0.2"},
                                                          {"peak_contact_force_ratio", "above=5"},
                                                          {"impacts", "above=0"},
                                                          {"peak_impact_velocity", "above='10 kine'"},
                                                          {"landing_spin", "above=2"},
                                                          {"landing_velocity", "above='3 m/s'"},
                                                          {"friction_work", "above=5"},
                                                          {"peak_yaw", "above='30 deg'"},
                                                          {"peak_top", "above='0.5 m'"},
                                                          {"edge_y_least", "above='0.9 m'"}}) {
        EXPECT_EQ(line(quantity, rule), "") << quantity << ' ' << rule;
    }
    EXPECT_NE(line("peak_rotation", "above='30 deg'").find("above 30 deg (beyond its critical angle"),
              std::string::npos);
}

// A threshold comes back in the unit it was written in, an angle in degrees beside others.
TEST(LimitRange, ThresholdsComeBackAsWritten) {
    auto const text = [](std::string const& quantity, std::string const& rule) {
        return testing::campaign_from(limited(quantity, rule)).limits.at(1).threshold_text();
    };
    EXPECT_EQ(text("peak_rotation", "above='20 deg'"), "20 deg");
    EXPECT_EQ(text("peak_rotation", "above='0.349 rad'"), "0.349 rad = 20 deg");
    EXPECT_EQ(text("peak_rotation", "above=0.349"), "0.349 rad = 20 deg");
    EXPECT_EQ(text("peak_slip", "above='12 in'"), "12 in");
    EXPECT_EQ(text("peak_slip", "above=0.3"), "0.3 m");
    EXPECT_EQ(text("peak_rotation_ratio", "above=0.3"), "0.3");
}

}  // namespace
}  // namespace overturn

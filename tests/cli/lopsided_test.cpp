// Requirement R-407: bodies off the middle, on a slope or tilted run as all others do: the same bytes on any ranks,
// replayed bit for bit; what would call for a model that knows nothing of them is refused in one line.
#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

std::string const placed = "mass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n";

// In place of the small campaign's bodies.
std::string campaign_of(std::string const& bodies) {
    auto campaign = small_campaign("shared", 6);
    auto const from = campaign.find("[[bodies]]");
    return campaign.replace(from, campaign.find("[levels]") - from, bodies);
}

class Lopsided : public ::testing::Test {
  protected:
    Lopsided() { folder.write("target.csv", target_csv); }
    void expect_refused(std::string const& campaign, std::string const& part) const {
        folder.write("r.toml", campaign);
        auto const ended = overturn(folder, {"run", "r.toml"});
        EXPECT_EQ(ended.code, 2);
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    }

    Folder folder;
};

// R-1001, R-1005.
TEST_F(Lopsided, SameBytesOnAnyRanksAndReplayed) {
    folder.write("c.toml", campaign_of("[[bodies]]\nname='off'\noffset='6 cm'\nfriction=0.7\n" + placed
                                       + "[[bodies]]\nname='slope'\nslope='-1 deg'\nfriction=0.65\n" + placed
                                       + "[[bodies]]\nname='tilt'\ninitial_tilt='4 deg'\n" + placed));

    auto const alone = overturn(folder, {"run", "c.toml", "-o", "1.h5"});
    ASSERT_EQ(alone.code, 0) << alone.err;
    for (int const ranks : {2, 3}) {
        auto const* const name = ranks == 2 ? "2.h5" : "3.h5";
        ASSERT_EQ(execute(folder, mpirun(ranks, {"run", "c.toml", "-o", name})).code, 0);
        EXPECT_TRUE(folder.read("1.h5") == folder.read(name)) << ranks;
    }
    auto const verified = overturn(folder, {"verify", "1.h5"});
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
    for (auto const* const trial : {"2", "5", "8", "17"}) {
        auto const replayed = overturn(folder, {"replay", "1.h5", "--trial", trial});
        EXPECT_EQ(replayed.code, 0) << replayed.err;
        EXPECT_NE(replayed.out.find("bit-equal"), std::string::npos) << replayed.out;
    }
}

TEST_F(Lopsided, PlanReportsTheWeakerSide) {
    folder.write("c.toml", campaign_of("[[bodies]]\nslope='1 deg'\ninitial_tilt='-2 deg'\n" + placed));

    auto const plan = planned(folder, {"c.toml"});

    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_NE(plan.out.find("towards +x alpha 32.05 deg"), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find("towards -x alpha 34.05 deg"), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find("those of the weaker side, +x; let go at a tilt of -2 deg"), std::string::npos) << plan.out;
}

TEST_F(Lopsided, ModelsThatKnowNothingOfItAreRefused) {
    std::string const body = "[[bodies]]\nname='a'\nslope='1 deg'\nfriction=0.7\n" + placed;
    expect_refused(campaign_of(body) + "[effects]\ninclude=['contact']\n",
                   "contact beside slope of 'a' (only rocking and sliding");
    expect_refused(campaign_of(body) + "[effects]\ninclude=['spatial', 'contact']\n", "spatial beside slope of 'a'");
    expect_refused(campaign_of(body) + "[[limits]]\nname='crushed'\nquantity='peak_contact_force_ratio'\nabove=2\n",
                   "beside slope of 'a'");
    auto across = campaign_of(body);
    across.insert(across.find("[waves.vertical]"), "[waves.transverse]\nratio=0.8\n");
    expect_refused(across, "a transverse component beside slope of 'a'");
    across.insert(across.find("name='a'"), "axes=1\n");
    folder.write("c.toml", across);
    EXPECT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
}

}  // namespace
}  // namespace overturn::testing

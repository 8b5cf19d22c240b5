// Requirement R-903: spectra of all of a campaign's waves stand in one picture, V_E in kine, beside what they were
// drawn for.
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

std::string const bodies =
    "[[bodies]]\nname='b'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\n[levels]\nmeasure='pga'\nvalues=['600 gal']\n";

class Spectra : public ::testing::Test {
  protected:
    // Blows: a triangle of two steps of 0.01 s, so that the ground's velocity changes by its height times 0.01 s.
    void write_blows() {
        for (double const height : {1.0, 1.5, 2.0, 3.0, 4.0}) {
            std::string text = "time_s,acc (m/s2)\n";
            for (int i = 0; i <= 400; ++i) {
                text += fmt::format("{:.2f},{}\n", 0.01 * i,
                                    i == 1     ? height
                                    : i == 201 ? 2.5e-3 * height * height
                                    : i == 200 ? -2.5e-3 * height * height
                                               : 0);
            }
            folder.write(fmt::format("blow{}.csv", height), text);
        }
        folder.write(
            "c.toml",
            "seed=1\n[waves]\nsource='records'\nfiles=['blow1.csv','blow1.5.csv','blow2.csv','blow3.csv','blow4.csv']\n"
                + bodies);
    }
    json spectra(std::string const& file, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"spectra", file, "--json"});
        auto const ended = overturn(folder, options);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    }
    Folder folder;
};

// Closed form: a blow gives an undamped oscillator of long period its change of velocity, V_E = dV.
TEST_F(Spectra, BlowGivesItsVelocity) {
    write_blows();
    auto const told = spectra("c.toml", {"--damping", "0"});
    ASSERT_EQ(told["each"].size(), 5U);
    auto const last = told["period_s"].size() - 1;
    EXPECT_NEAR(told["period_s"][last].get<double>(), 20, 1e-9);
    for (auto const& [wave, height] : {std::pair{0, 1.0}, {1, 1.5}, {2, 2.0}, {3, 3.0}, {4, 4.0}}) {
        EXPECT_NEAR(told["each"][wave]["v_e_mps"][last].get<double>(), 0.01 * height, 1e-6 * height);
    }
    EXPECT_NEAR(told["v_e_mps"]["p50"][last].get<double>(), 0.02, 1e-6);
    EXPECT_NEAR(told["v_e_mps"]["highest"][last].get<double>(), 0.04, 1e-6);
    EXPECT_NEAR(told["v_e_mps"]["lowest"][last].get<double>(), 0.01, 1e-6);
    EXPECT_TRUE(told["v_e_mps"]["p84"][last].is_null()) << "of five, none is expected beyond it";
    EXPECT_TRUE(told["target"].is_null());
    auto const two = spectra("c.toml", {"--waves", "2", "--damping", "0"});
    EXPECT_EQ(two["each"].size(), 2U);
    EXPECT_TRUE(two["v_e_mps"]["p50"][last].is_null()) << "two motions have no median";
    EXPECT_NEAR(two["v_e_mps"]["highest"][last].get<double>(), 0.015, 1e-6);
}

// Tables say it in the unit that was asked for; JSON stays SI.
TEST_F(Spectra, VelocitiesInKine) {
    write_blows();
    auto const metres = overturn(folder, {"spectra", "c.toml", "--damping", "0"});
    auto const kine = overturn(folder, {"spectra", "c.toml", "--damping", "0", "--velocities", "kine"});
    EXPECT_NE(metres.out.find("V_E m/s"), std::string::npos) << metres.out;
    EXPECT_NE(kine.out.find("V_E kine"), std::string::npos) << kine.out;
    EXPECT_NE(metres.out.find("     0.02 "), std::string::npos) << metres.out;
    EXPECT_NE(kine.out.find("         2 "), std::string::npos) << kine.out;
    EXPECT_EQ(spectra("c.toml", {"--velocities", "kine"}), spectra("c.toml"));
    auto const refused = overturn(folder, {"spectra", "c.toml", "--velocities", "furlong"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("--velocities: unit 'furlong' (not a unit of velocity). Use one of"), std::string::npos)
        << refused.err;
    auto const one = overturn(folder, {"spectrum", "--wave", "blow4.csv", "--velocities", "kine"});
    EXPECT_NE(one.out.find("PGV 4 kine"), std::string::npos) << one.out;
}

// a line of a target's table that is not understood is a remark where the input is described, and no part of the
// target's name.
TEST_F(Spectra, LinesThatAreNotUnderstoodAreRemarks) {
    folder.write("t.csv", "Smith 2001\nT (s),Sa (g)\n0.05,0.5\n0.5,0.6\n5,0.1\n");
    folder.write("w.toml",
                 "seed=3\n[waves]\nsource='spectrum-compatible'\ncount=2\nduration='20.48 s'\ntime_step='0.02 s'\n"
                 "[waves.target]\nfile='t.csv'\nkind='acceleration'\n[waves.envelope]\nshape='jennings'\nrise='4 "
                 "s'\nlevel_end='10 s'\n"
                 "end='18 s'\n"
                     + bodies);
    std::string const remark = "t.csv (not understood: line 1: 'Smith 2001')";
    EXPECT_NE(planned(folder, {"w.toml"}).out.find("remark    " + remark), std::string::npos);
    auto const shown = overturn(folder, {"spectra", "w.toml"});
    EXPECT_NE(shown.out.find("Remark: " + remark), std::string::npos) << shown.out;
    auto const told = spectra("w.toml");
    EXPECT_EQ(told["remarks"], json({remark}));
    EXPECT_EQ(told["target"]["name"], "t.csv");
    auto const plan = json::parse(overturn(folder, {"plan", "w.toml", "--json"}).out);
    EXPECT_EQ(plan["wave_remarks"], json({remark}));
    EXPECT_EQ(plan["wave_source"].get<std::string>().find("not understood"), std::string::npos) << plan["wave_source"];
    auto const run = overturn(folder, {"run", "w.toml", "-o", "w.h5"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("remark: " + remark), std::string::npos) << run.err;
}

// Beside every curve stands by what its waves differ: in plan, run's table, JSON and the file.
TEST_F(Spectra, CurvesSayByWhatTheirWavesDiffer) {
    std::string const waves =
        "seed=3\n[waves]\nsource='spectrum-compatible'\ncount=2\nduration='20.48 s'\ntime_step='0.02 s'\n";
    std::string const target =
        "[waves.target]\nspectrum='mlit-ch1'\n[waves.envelope]\nshape='jennings'\nrise='4 s'\nlevel_end='10 s'\n"
        "end='18 s'\n";
    for (auto const& [keys, words] : std::vector<std::pair<std::string, std::string>>{
             {"match='each'\n" + target, "random phases only; every wave is matched to the same target spectrum"},
             {"match='ensemble'\n" + target,
              "random noise about one median spectrum; event, path and site do not vary"},
             {"match='none'\n" + target, "random noise about one spectrum, which is not centred on the target"},
             {target + "[waves.variability]\nsigma=0.6\ncorrelation='full'\n",
              "every wave is matched to a drawn target spectrum (ln Sa with sigma 0.6, correlated by full); "}}) {
        folder.write("w.toml", waves + keys + bodies);
        EXPECT_NE(planned(folder, {"w.toml"}).out.find("variation " + words), std::string::npos) << words;
        auto const run = overturn(folder, {"run", "w.toml", "-o", "w.h5", "--full"});
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_NE(unwrapped(run.out).find("variability of waves: " + words), std::string::npos) << run.out;
        auto const fit = json::parse(overturn(folder, {"fit", "w.h5", "--json"}).out);
        EXPECT_TRUE(fit["variability"].get<std::string>().starts_with(words)) << fit["variability"];
        bool const drawn = words.find("drawn") != std::string::npos;
        EXPECT_EQ(fit["sigma"].empty(), !drawn);
        EXPECT_EQ(run.out.find("achieved sd of ln (stated of Sa), over 2 targets: pga ") != std::string::npos, drawn);
        EXPECT_EQ(drawn ? fit["sigma"][0]["stated"] : json(0.6), 0.6);
        std::filesystem::remove(folder / "w.h5");
    }
}

// Waves whose targets vary: both bands are there, sigma apart, and the waves follow their own targets.
TEST_F(Spectra, TargetsThatVary) {
    folder.write("v.toml",
                 "seed=3\n[waves]\nsource='spectrum-compatible'\ncount=60\nduration='40.96 s'\ntime_step='0.02 s'\n"
                 "[waves.target]\nspectrum='mlit-ch1'\n[waves.variability]\nsigma=0.6\n"
                 "correlation='baker-jayaram-2008'\n[waves.envelope]\nshape='jennings'\nrise='4 s'\nlevel_end='20 s'\n"
                 "end='38 s'\n"
                     + bodies);
    auto const told = spectra("v.toml");
    auto const& drawn = told["target"]["drawn_psa_mps2"];
    std::size_t compared = 0;
    double spread = 0;
    for (std::size_t i = 0; i < told["period_s"].size(); ++i) {
        double const period = told["period_s"][i].get<double>();
        if (period < 1 || period > 4) {
            continue;
        }
        ++compared;
        auto const ratio = [&](json const& a, json const& b) {
            return std::log(a[i].get<double>() / b[i].get<double>());
        };
        spread += ratio(drawn["p84"], drawn["p16"]) / 2;
        EXPECT_NEAR(ratio(drawn["p50"], told["target"]["psa_mps2"]), 0, 4 * 1.25 * 0.6 / std::sqrt(60.0)) << period;
        for (char const* const part : {"p16", "p50", "p84"}) {
            EXPECT_NEAR(ratio(told["psa_mps2"][part], drawn[part]), 0, 0.15) << part << " at " << period;
        }
    }
    ASSERT_GT(compared, 10U);
    EXPECT_NEAR(spread / static_cast<double>(compared), 0.6, 0.18);  // three standard errors of 60 targets
}

// Curves over Sa, and levels by it, have their place in a report, named by their period.
TEST_F(Spectra, ReportOfSa) {
    write_blows();
    auto const run = overturn(folder, {"run", "c.toml", "-o", "sa.h5", "--set", "levels.measure=\"sa\"", "--set",
                                       "levels.period=\"2 s\"", "--set", "measures.sa_periods=[\"1 s\"]"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const page = overturn(folder, {"report", "sa.h5", "-o", "sa.html", "--figures", "f"});
    ASSERT_EQ(page.code, 0) << page.err;
    EXPECT_NE(read_text(folder / "f/fragility.csv").find("sa_1"), std::string::npos);
    auto const told = json::parse(overturn(folder, {"fit", "sa.h5", "--json"}).out);
    EXPECT_EQ(told["fragility"][0]["label"], "sa(2 s)");
}

// The report shows the same picture of a campaign's waves.
TEST_F(Spectra, FigureAndReport) {
    write_blows();
    auto const drawn = overturn(folder, {"spectra", "c.toml", "--plot", "s.svg", "--velocities", "kine"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_GT(std::filesystem::file_size(folder / "s.svg"), 10000U);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "c.h5"}).code, 0);
    auto const page = overturn(folder, {"report", "c.h5", "-o", "c.html", "--figures", "f", "--velocities", "kine"});
    ASSERT_EQ(page.code, 0) << page.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "f/spectra.svg"));
    EXPECT_NE(read_text(folder / "c.html").find("V_Ereq [kine]"), std::string::npos);
}

}  // namespace
}  // namespace overturn::testing

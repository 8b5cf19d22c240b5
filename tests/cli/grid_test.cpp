// Requirement R-704: waves that are a grid of frequencies are no sample: no curve, no probability and no quantile is
// reported for them, but the least level that lifts a body off and overturns it, frequency by frequency, the same in
// every answer.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "store/results_file.hpp"
#include "support/command.hpp"
#include "support/tolerance.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

constexpr double gravity = 9.80665;
constexpr double alpha = 0.1;

/// A slender uniform block of R = 1 m with the linearised equation under single sines of 2 and 4 times its frequency
/// parameter, at multiples of the acceleration that uplifts it; e = 0.9.
std::string campaign(std::string const& more = "") {
    double const p = std::sqrt(3 * gravity / 4);
    std::string values;
    for (double const multiple : {0.98, 1.05, 1.20, 1.25, 1.78, 1.82, 2.33, 5.0}) {
        values += fmt::format("{:.12g}, ", multiple * alpha * gravity);
    }
    return fmt::format(
        "title='grid'\nseed=1\n[waves]\nsource='pulse'\nshape='one-sine'\namplitude='1 m/s2'\n"
        "periods=[{:.12g}, {:.12g}]\nquiet_after='8 s'\n"
        "[[bodies]]\nname='block'\nmass='1 t'\nbase_width={:.12g}\ncentre_height={:.12g}\ninertia='uniform-block'\n"
        "restitution=0.9\n[levels]\nmeasure='pga'\nvalues=[{}]\n[measures]\nrocked_from=0\n[accuracy]\nrestoring='"
        "linear'\n{}",
        2 * std::numbers::pi / (2 * p), 2 * std::numbers::pi / (4 * p), 2 * std::sin(alpha), std::cos(alpha), values,
        more);
}

class Grid : public ::testing::Test {
  protected:
    void run(std::string const& more = "") {
        folder.write("c.toml", campaign(more));
        ran = overturn(folder, {"run", "c.toml", "-o", "c.h5"});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }
    [[nodiscard]] json fitted() { return json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out); }

    Folder folder;
    Ended ran;
};

// Linearised block: a single sine lifts it off from 1 alpha g; it overturns with one impact from 1.22518
// (w = 2) and 1.79544 (w = 4), and stands again between 2.31440 and 2.34990, and between 4.85011 and 5.23896 (DESIGN,
// closed forms of Zhang & Makris 2001).
TEST_F(Grid, MapMeetsClosedForms) {
    run();
    EXPECT_EQ(overturn(folder, {"fit", "c.h5", "--section", "criterion"}).out.find("[lower, upper]"), std::string::npos)
        << "a grid is no sample: its shares have no interval";
    auto const fit = fitted();
    auto const& lines = fit.at("grid");
    ASSERT_EQ(lines.size(), 2U);
    auto const multiple = [&](int line, char const* of) {
        return lines[line].at(of).get<double>() / (alpha * gravity);
    };
    EXPECT_NEAR(multiple(0, "uplift"), 1.05, 1e-9);
    EXPECT_NEAR(multiple(0, "overturning"), 1.25, 1e-9);
    EXPECT_NEAR(multiple(0, "standing"), 2.33, 1e-9);
    EXPECT_NEAR(multiple(1, "uplift"), 1.05, 1e-9);
    EXPECT_NEAR(multiple(1, "overturning"), 1.82, 1e-9);
    EXPECT_NEAR(multiple(1, "standing"), 5.0, 1e-9);
    auto const ends_of = [&](std::int64_t wave) {
        auto ends = json::array();
        for (auto const& row : fit.at("grid_by_level")) {
            if (row.at("wave") == wave) {
                ends.push_back(row.at("verdict"));
            }
        }
        return ends;
    };
    double const p = std::sqrt(3 * gravity / 4);
    EXPECT_NEAR(lines[0].at("frequency_hz").get<double>(), 2 * p / (2 * std::numbers::pi), 1e-9);
    EXPECT_EQ(ends_of(0),
              json({"at-rest", "rocked", "rocked", "overturned", "overturned", "overturned", "rocked", "overturned"}));
    EXPECT_EQ(ends_of(1),
              json({"at-rest", "rocked", "rocked", "rocked", "rocked", "overturned", "overturned", "rocked"}));
}

TEST_F(Grid, GivesNoCurveAndNoProbability) {
    run("[[limits]]\nname='far'\nquantity='peak_rotation_ratio'\nabove=0.5\n");
    auto const text = overturn(folder, {"fit", "c.h5"}).out;
    for (auto const& answer : {ran.out, text}) {
        EXPECT_NE(answer.find("block: a grid of 2 frequencies is no sample: no curve\n"), std::string::npos) << answer;
        for (auto const* never : {"HCLPF", "beta", "median", "interval", "curves from", "P at"}) {
            EXPECT_EQ(answer.find(never), std::string::npos) << never << " in " << answer;
        }
    }
    auto const fit = fitted();
    EXPECT_FALSE(fit.at("fragility").empty());
    for (auto const& curve : fit.at("fragility")) {
        EXPECT_EQ(curve.at("state"), "grid");
        for (auto const* number : {"median", "beta", "hclpf", "median_lower", "rank_area", "isotonic_median_lower",
                                   "penalised_median", "bound_from", "one_percent_point", "lowest"}) {
            EXPECT_TRUE(curve.at(number).is_null()) << number << curve;
        }
    }
    EXPECT_EQ(fit.at("warnings").size(), fit.at("fragility").size());
    for (auto const& warning : fit.at("warnings")) {
        EXPECT_EQ(warning.at("text"), "a grid of 2 frequencies is no sample: no curve");
    }
    for (auto const& stripe : fit.at("stripes")) {
        EXPECT_EQ(stripe.at("trials"), 2);
        for (auto const* number : {"probability", "lower", "upper"}) {
            EXPECT_TRUE(stripe.at(number).is_null()) << number;
        }
    }
    EXPECT_TRUE(fit.at("quantiles").empty());
    for (auto const& criterion : fit.at("criterion")) {
        EXPECT_TRUE(criterion.at("false_alarm_share_upper").is_null());
        EXPECT_GT(criterion.at("false_alarm_share_of"), 0);
    }
    // The limit state of one's own is part of the map: here it is passed where the body swings far, so no later than
    // where it overturns.
    for (auto const& line : fit.at("grid")) {
        EXPECT_LE(line.at("limit_far").get<double>(), line.at("overturning").get<double>());
    }
}

TEST_F(Grid, FileHoldsTheMapAndNoNumberOfACurve) {
    run("[[limits]]\nname='far'\nquantity='peak_rotation_ratio'\nabove=0.5\n");
    store::ResultsReader const file(folder / "c.h5");
    for (std::string const place : {"fragility/block", "limits/far/fragility/block"}) {
        for (auto const* column : {"median", "beta", "hclpf", "beta_r", "median_upper", "bootstrap_median_lower",
                                   "penalised_median", "isotonic_median_lower", "rank_area"}) {
            for (double const value : file.reals(place + "/" + column)) {
                EXPECT_TRUE(std::isnan(value)) << place << column;
            }
        }
        for (auto const identifiable : file.integers(place + "/identifiable")) {
            EXPECT_EQ(identifiable, 0);
        }
    }
    for (std::string const place : {"stripes/block", "limits/far/stripes/block"}) {
        for (auto const* column : {"probability", "lower", "upper"}) {
            for (double const value : file.reals(place + "/" + column)) {
                EXPECT_TRUE(std::isnan(value)) << place << column;
            }
        }
    }
    auto const lines = fitted().at("grid");
    for (std::size_t line = 0; line < 2; ++line) {
        for (auto const& [column, key] : {std::pair{"uplift", "uplift"},
                                          {"overturning", "overturning"},
                                          {"standing", "standing"},
                                          {"frequency", "frequency_hz"}}) {
            EXPECT_EQ(file.reals(std::string("grid/block/") + column).at(line), lines[line].at(key).get<double>());
        }
        EXPECT_EQ(file.reals("grid/block/limit_far").at(line), lines[line].at("limit_far").get<double>());
    }
}

// What was not reached is null, not the highest level.
TEST_F(Grid, ReportsWhereNothingOverturned) {
    folder.write("c.toml", campaign());
    auto const levels = fmt::format("levels.values=[{}, {}]", 0.5 * alpha * gravity, 1.1 * alpha * gravity);
    auto const text = overturn(folder, {"run", "c.toml", "-o", "c.h5", "--set", levels}).out;
    auto const fit = fitted();
    for (auto const& line : fit.at("grid")) {
        EXPECT_TRUE(line.at("overturning").is_null());
        EXPECT_NEAR(line.at("uplift").get<double>(), 1.1 * alpha * gravity, 1e-12);
    }
    EXPECT_NE(text.find("> 1.079"), std::string::npos) << text;
}

TEST_F(Grid, RefusesToEndOncePrecise) {
    folder.write("c.toml", campaign("[statistics]\ntarget_half_width=0.1\n"));
    auto const refused = overturn(folder, {"run", "c.toml", "-o", "c.h5"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("of a grid of frequencies (it is no sample"), std::string::npos) << refused.err;
    EXPECT_TRUE(is_one_error_line(refused.err.substr(refused.err.find("overturn: "))));
}

// What accuracy costs is reported without an interval of P(overturn).
TEST_F(Grid, HasNoCostOfSampling) {
    folder.write("c.toml", campaign());
    auto const text = overturn(folder, {"cost", "c.toml", "--waves", "2", "-o", "cost.h5"}).out;
    EXPECT_NE(text.find("grid of 2 frequencies is no sample, so no P(overturn) is estimated"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("Clopper-Pearson"), std::string::npos) << text;
    auto const study = json::parse(overturn(folder, {"cost", "c.toml", "--waves", "1", "--json"}).out);
    EXPECT_TRUE(study.at("waves").empty());
    EXPECT_TRUE(study.at("study").at(0).at("sampling").is_null());
    EXPECT_FALSE(study.at("study").at(0).at("numerical").is_null());
}

// Records are a sample, however few: nothing is taken from them.
TEST_F(Grid, IsNoneOfDrawnWaves) {
    folder.write(
        "n.toml",
        "seed=1\n[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms='1 m/s2'\ncount=8\nduration='10 s'\n"
        "[waves.envelope]\nshape='constant'\n"
        "[[bodies]]\nname='block'\nmass='1 t'\nbase_width=0.4\ncentre_height=1\ninertia='uniform-block'\n"
        "[levels]\nmeasure='pga'\nvalues=['3 m/s2', '6 m/s2']\n");
    ASSERT_EQ(overturn(folder, {"run", "n.toml", "-o", "c.h5"}).code, 0);
    auto const fit = fitted();
    EXPECT_TRUE(fit.at("grid").empty());
    EXPECT_FALSE(fit.at("stripes")[0].at("probability").is_null());
    EXPECT_FALSE(store::ResultsReader(folder / "c.h5").has("grid/block/frequency"));
}

}  // namespace
}  // namespace overturn::testing

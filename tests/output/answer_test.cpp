// Requirement R-916: the answer first, within a screen, and the rest by name.
#include "output/answer.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/outward.hpp"
#include "core/wrapped.hpp"
#include "output/detail/answer_cells.hpp"
#include "output/detail/interval_text.hpp"
#include "output/json.hpp"
#include "output/sections.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using output::answer_levels;
using output::probability_text;

std::string body_named(std::string const& name) {
    return "[[bodies]]\nname='" + name
           + "'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\nfriction=0.5\n";
}

std::string forty_waves() {
    auto waves = testing::quick_waves;
    std::string const three = "count=3";
    return waves.replace(waves.find(three), three.size(), "count=40");
}

// A campaign whose trials are made up: at each level so many of 40 overturned.
struct Made {
    CampaignSpec spec;
    Statistics statistics;
    std::vector<BodyAnalysis> analysis;

    // \param model of results files, that all trials were computed by
    // \param limited trials of each level that pass every further limit state
    Made(std::string const& bodies, std::string const& more, std::vector<int> const& overturned, std::int64_t model = 1,
         std::int64_t limited = 0)
        : spec(testing::campaign_from(forty_waves() + bodies
                                      + testing::levels("values=['300 gal','600 gal','900 gal','1200 gal']\n" + more))),
          statistics(spec) {
        for (std::int64_t wave = 0; wave < 40; ++wave) {
            WaveRow row;
            row.id = wave;
            row.pga_mps2 = 3;
            statistics.add(row, std::vector<MeasureRow>(spec.bodies.size()));
            for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
                for (std::size_t l = 0; l < spec.levels.levels.size(); ++l) {
                    TrialRow trial;
                    trial.wave = wave;
                    trial.body = static_cast<std::int64_t>(b);
                    trial.level = static_cast<std::int64_t>(l);
                    trial.model = model;
                    trial.amplitude = spec.levels.levels[l].value;
                    bool const fell = wave < overturned.at(l);
                    trial.verdict = fell ? Verdict::overturned : Verdict::slid;
                    trial.peak_slip_m = 0.001 * static_cast<double>(wave);
                    trial.peak_rotation_ratio = 0.01;
                    trial.peak_slip_m = limited > 0 ? (wave < limited ? 1 : 0) : trial.peak_slip_m;
                    statistics.add(trial);
                }
            }
        }
        analysis = analyse(spec, statistics, {});
    }
    [[nodiscard]] std::string text(std::span<BodyFrequency const> frequencies = {},
                                   std::span<RareBody const> rare = {}) const {
        return output::answer_text(
            {.spec = spec, .statistics = statistics, .analysis = analysis, .frequencies = frequencies, .rare = rare});
    }
    // One for each body and limit state.
    [[nodiscard]] std::vector<BodyFrequency> frequencies() const {
        std::vector<BodyFrequency> all;
        for (auto const& body : analysis) {
            for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
                BodyFrequency one;
                one.body = body.body;
                one.limit = spec.limits[limit].name;
                one.seen = one.interval = {1.2301e-5, 4.5601e-4};
                if (body.curves_of(limit).front().fit.identifiable()) {
                    one.mean.emplace();
                    one.lacks_beta_u = true;
                    one.interval.upper = std::numeric_limits<double>::infinity();
                }
                all.push_back(one);
            }
        }
        return all;
    }
};

std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

// one body; then so many that rows have to go: never more than 15 lines before what the numbers depend on, nor
// 100 columns.
TEST(Answer, FitsAScreen) {
    for (int const bodies : {1, 2, 3, 5, 13, 40}) {
        std::string text;
        for (int b = 0; b < bodies; ++b) {
            text += body_named("cask of a rather long name " + std::to_string(b));
        }
        Made const made(text,
                        "design_basis='600 gal'\n[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='20 mm'\n",
                        {0, 0, 5, 20});
        auto const frequencies = made.frequencies();
        for (auto const& answer : {made.text(), made.text(frequencies)}) {
            auto const lines = lines_of(answer);
            auto const end = std::ranges::find_if(lines, [](auto const& line) { return line.starts_with("Waves: "); });
            ASSERT_NE(end, lines.end());
            EXPECT_LE(end - lines.begin(), 15) << answer;
            for (auto const& line : lines) {
                EXPECT_LE(line.size(), 100) << line;
            }
            EXPECT_EQ(answer.find("slip, tilt: median") != std::string::npos,
                      answer.find(" slip [mm]") != std::string::npos)
                << "a heading only of rows that follow\n"
                << answer;
        }
        EXPECT_EQ(made.text().find("more bodies, with lower P") != std::string::npos, bodies > 12) << made.text();
    }
}

std::string limits_named(std::vector<std::string> const& names) {
    std::string text;
    for (auto const& name : names) {
        text += "[[limits]]\nname='" + name + "'\nquantity='peak_slip'\nabove='20 mm'\n";
    }
    return text;
}

// two bodies, six limit states and a hazard curve: the room is used, the weightiest rows first, and only what
// does not fit is named below, by what it is.
TEST(Answer, UsesTheRoomForTheWeightiestRows) {
    Made const made(body_named("cask-that-slides") + body_named("cask-that-rocks"),
                    "design_basis='600 gal'\n"
                        + limits_named({"touches", "leaves-the-pad", "hits-the-wall", "tips-against", "drifts"}),
                    {0, 0, 5, 20});
    auto const frequencies = made.frequencies();
    auto const lines = lines_of(made.text(frequencies));
    auto const end = std::ranges::find_if(lines, [](auto const& line) { return line.starts_with("Waves: "); });
    EXPECT_EQ(end - lines.begin(), 15) << made.text(frequencies);
    std::vector<std::string> const order{"P(overturn)", "slip [mm]",  "tilt [deg]",
                                         "HCLPF",       "P(touches)", "P(leaves-the-pad)"};
    for (std::size_t body = 0; body < 2; ++body) {
        for (std::size_t row = 0; row < order.size(); ++row) {
            auto const& line = lines.at(2 + body * order.size() + row);
            EXPECT_TRUE(line.substr(17).starts_with(order[row])) << line;
        }
    }
    EXPECT_NE(lines.at(5).find("; "), std::string::npos) << "the frequency stands behind HCLPF: " << lines.at(5);
    EXPECT_EQ(lines.at(14), "P of 3 limit states, HCLPF of 5 limit states: --section stripes, curves, frequency");
}

// what is left out is named, and nothing where all fits.
TEST(Answer, NamesWhatItLeavesOut) {
    auto const note_of = [](int bodies, std::vector<std::string> const& limits) {
        std::string text;
        for (int b = 0; b < bodies; ++b) {
            text += body_named("cask " + std::to_string(b));
        }
        auto const all = Made(text, "design_basis='600 gal'\n" + limits_named(limits), {0, 0, 5, 20}).text();
        auto const at = all.find(": --section ");
        auto const begin = at == std::string::npos ? at : all.rfind('\n', at) + 1;
        return at == std::string::npos ? std::string() : all.substr(begin, all.find('\n', at) - begin);
    };
    EXPECT_EQ(note_of(1, {"a"}), "");
    EXPECT_EQ(note_of(2, {"a"}), "");
    EXPECT_EQ(note_of(1, {"a", "b", "c", "d", "e"}), "HCLPF of 2 limit states: --section curves");
    EXPECT_EQ(note_of(3, {"a"}), "P(a), HCLPF of 1 limit state: --section stripes, curves");
    EXPECT_EQ(note_of(4, {}), "HCLPF: --section curves");
    EXPECT_EQ(note_of(6, {}), "tilt, HCLPF: --section responses, curves");
    EXPECT_EQ(note_of(6, {"a", "b", "c", "d"}),
              "tilt, HCLPF, P(a), P(b), P(c), P(d), HCLPF of 4 limit states: --section stripes, responses, curves");
}

// a limit state without a row is not silent: how high its P may be, of all bodies and levels of the table.
TEST(Answer, StatesTheHighestPOfLimitStatesWithoutARow) {
    auto const text_of = [](int bodies) {
        std::string all;
        for (int b = 0; b < bodies; ++b) {
            all += body_named("cask " + std::to_string(b));
        }
        auto text = Made(all, "design_basis='600 gal'\n" + limits_named({"a"}), {0, 0, 5, 20}, 1, 8).text();
        std::ranges::replace(text, '\n', ' ');
        return text;
    };
    // 8 of 40 waves pass the limit, and who overturned: 20 at 1200 gal, at most 0.662 (Clopper and Pearson).
    EXPECT_NE(text_of(3).find("Not in the table: P(a) <= 0.662 (cask 0, 1200 gal)."), std::string::npos) << text_of(3);
    EXPECT_EQ(text_of(2).find("Not in the table"), std::string::npos) << text_of(2);
}

// an angle is in degrees unless each wave has an alpha of its own.
TEST(Answer, TiltIsAnAngleUnlessAlphaIsDrawn) {
    auto const with = [](std::string const& height, std::string const& more) {
        return Made(
                   "[[bodies]]\nname='cask'\nmass='12.6 t'\nbase_width='0.9 m'\ninertia='uniform-block'\ncentre_height="
                       + height + "\n" + more,
                   "design_basis='600 gal'\n", {0, 0, 0, 0})
            .text();
    };
    EXPECT_NE(with("'1 m'", "restitution={distribution='uniform',low=0.7,high=0.9}\n").find("tilt [deg]"),
              std::string::npos);
    EXPECT_NE(with("{distribution='uniform',low='1 m',high='1.1 m'}", "").find("tilt / alpha"), std::string::npos);
}

// JSON has no infinity; a percentile that is a body which overturned is named, not left as if it were unknown.
TEST(Answer, NamesThePercentilesOfBodiesThatOverturned) {
    Made const made(body_named("cask"), "design_basis='600 gal'\n", {0, 0, 5, 39});
    auto const rows = output::json_of(
        output::answer_table({.spec = made.spec, .statistics = made.statistics, .analysis = made.analysis}));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].at("overturned_at"), output::Json::array());
    EXPECT_FALSE(rows[0].at("peak_slip_p95_m").is_null());
    EXPECT_EQ(rows[1].at("overturned_at"), (output::Json{"p95", "p95_upper"}));  // 5 of 40
    EXPECT_TRUE(rows[1].at("peak_slip_p95_m").is_null());
    EXPECT_EQ(rows[2].at("overturned_at"), (output::Json{"median", "p95", "p95_upper"}));
}

// columns stand below their levels, and a limit state's name is whole where the line has room.
TEST(Answer, KeepsColumnsAndWholeNames) {
    Made const made(body_named("cask-that-slides"), "design_basis='600 gal'\n" + limits_named({"leaves-the-pad"}),
                    {0, 0, 5, 20});
    auto const lines = lines_of(made.text());
    auto const head = std::ranges::find_if(lines, [](auto const& line) { return line.starts_with("pga"); });
    ASSERT_NE(head, lines.end());
    std::vector<std::size_t> const levels{head->find("600 gal"), head->find("900 gal"), head->find("1200 gal")};
    int rows = 0;
    for (auto line = head + 1; line != lines.end() && !line->starts_with("Waves: "); ++line) {
        if (line->find("HCLPF") == std::string::npos) {
            ++rows;
            for (auto const at : levels) {
                EXPECT_EQ(line->at(at - 1), ' ') << *line;
                EXPECT_NE(line->at(at), ' ') << *line;
            }
        }
    }
    EXPECT_EQ(rows, 4);
    EXPECT_NE(made.text().find("P(leaves-the-pad) "), std::string::npos) << made.text();
}

// an estimate of rare events stands in place of a count; where it is but a bound, the closer of the two.
TEST(Answer, HoldsTheEstimateOfRareEvents) {
    Made const made(body_named("cask"), "design_basis='600 gal'\n", {0, 0, 5, 20});
    std::vector<rare::Estimate> estimates(made.spec.levels.levels.size());
    for (auto& estimate : estimates) {
        estimate.interval_95 = {0, 0.9};
    }
    estimates[1].interval_95 = {0, 1.2301e-4};
    estimates[2].probability = 1.3561e-2;
    estimates[2].interval_95 = {0.01204, 0.01526};
    std::vector<RareBody> rare{{0, 0, estimates, {}}};
    auto const text = made.text({}, rare);
    EXPECT_NE(text.find("P(overturn) < 0.000124 "), std::string::npos) << text;
    EXPECT_NE(text.find(" 0.0136 [0.012, 0.0153] "), std::string::npos) << text;
    EXPECT_NE(text.find(" 0.5 [0.338, 0.662]\n"), std::string::npos) << "plain trials show more\n" << text;
    EXPECT_NE(text.find("P by [rare] (95 %)"), std::string::npos) << text;
    EXPECT_EQ(made.text().find("[rare]"), std::string::npos);

    auto const json = output::json_of(std::vector{output::answer_table(
        {.spec = made.spec, .statistics = made.statistics, .analysis = made.analysis, .rare = rare})})["answer"];
    ASSERT_EQ(json.size(), 3U);
    EXPECT_EQ(json[0]["probability_by"], "rare");
    EXPECT_TRUE(json[0]["probability"].is_null());
    EXPECT_EQ(json[0]["upper"], 1.2301e-4);
    EXPECT_EQ(json[1]["probability"], 1.3561e-2);
    EXPECT_EQ(json[1]["lower"], 0.01204);
    EXPECT_EQ(json[2]["probability_by"], "counts");
    EXPECT_EQ(json[2]["probability"], 0.5);
    EXPECT_EQ(json[2]["exceeded"], 20);

    rare.front().body = 1;
    EXPECT_EQ(made.text({}, rare).find("[rare]"), std::string::npos) << "of another body";
}

// what the numbers rest on takes three lines, and names what is assumed.
TEST(Answer, NamesWhatIsAssumed) {
    auto const text = Made(body_named("one") + "basis={mass='assumed', friction='assumed: none measured'}\n"
                               + body_named("two") + "basis={friction='assumed'}\n",
                           "design_basis='600 gal'\n", {0, 0, 5, 40})
                          .text();
    auto const at = text.find("Waves: ");
    ASSERT_NE(at, std::string::npos);
    auto const tail = text.substr(at);
    EXPECT_LE(std::ranges::count(tail, '\n'), 3) << tail;
    EXPECT_NE(tail.find("inputs are assumed (bodies.mass, bodies.friction)"), std::string::npos) << tail;
}

// what was found stands there, with the exact interval of 0 of 40 and of 5 of 40 (Clopper and Pearson 1934).
TEST(Answer, HoldsTheNumbers) {
    Made const made(body_named("cask"),
                    "design_basis='600 gal'\n[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='20 mm'\n",
                    {0, 0, 5, 40});
    auto const text = made.text();
    for (auto const* const part :
         {"600 gal = design", "900 gal = 1.5 x", "1200 gal = 2 x", "< 0.0881 (0 of 40)", "0.125 [0.0418, 0.269]",
          "> 0.911 (40 of 40)", "P(touches)", "19.5 / 37.1 (open)", "fell / fell", "HCLPF"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    EXPECT_EQ(text.find("300 gal"), std::string::npos) << text;
}

// with a hazard curve a row says how often a year, of overturning and of each limit state, its interval
// rounded outwards, whole beside a long name; where rows are too many it stands behind HCLPF.
TEST(Answer, HasARowForTheAnnualFrequency) {
    auto const limit = "design_basis='600 gal'\n[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='20 mm'\n";
    Made const one(body_named("cask of a rather long name"), limit, {0, 0, 5, 40});
    auto const frequencies = one.frequencies();
    auto const lines = lines_of(one.text(frequencies));
    auto const rows = [&](std::string const& row) {
        return std::ranges::count_if(lines, [&](auto const& line) { return line == std::string(19, ' ') + row; });
    };
    EXPECT_EQ(rows("annual frequency 1.23e-05 to 0.000457 a year"), 1) << one.text(frequencies);
    EXPECT_EQ(rows("annual frequency touches > 1.23e-05 a year"), 1) << "beta_U is not known\n"
                                                                     << one.text(frequencies);
    EXPECT_EQ(one.text().find("a year"), std::string::npos);

    Made const two(body_named("one") + body_named("two"), limit, {0, 0, 5, 40});
    auto const merged = two.text(two.frequencies());
    EXPECT_EQ(merged.find("annual frequency "), std::string::npos) << merged;
    EXPECT_NE(merged.find("; > 1.23e-05 a year\n"), std::string::npos) << merged;
    auto known = one.frequencies();
    for (auto& f : known) {
        f.lacks_beta_u = false;
        f.interval.upper = 4.5601e-4;
        f.fractiles = BodyFrequency::Fractiles{1e-6, 2e-5, 1e-4, 3.2101e-4};
    }
    auto two_known = two.frequencies();
    for (auto& f : two_known) {
        f.lacks_beta_u = false;
        f.fractiles = BodyFrequency::Fractiles{1e-6, 2e-5, 1e-4, 3.2101e-4};
    }
    EXPECT_NE(two.text(two_known).find("; <= 0.000322 a year\n"), std::string::npos) << two.text(two_known);
    EXPECT_NE(one.text(known).find(" 1.23e-05 to 0.000457 a year; at 95 % confidence <= 0.000322\n"), std::string::npos)
        << "rounded up\n"
        << one.text(known);
    EXPECT_NE(merged.find("slip [mm]"), std::string::npos) << merged;
}

// trials on points and rims are chaotic: the answer says so and names the command that measures it, or has what
// it found, rounded up.
TEST(Answer, StatesWhatTheTimeStepMayChange) {
    auto const basis = "design_basis='600 gal'\n";
    constexpr std::int64_t rocking = 2;
    constexpr std::int64_t contact = 3;
    constexpr std::int64_t spatial = 4;
    std::string const found = "160 of 160 trials used the contact model (points or a rim)";
    auto const unwrapped = [](std::string text) {
        std::ranges::replace(text, '\n', ' ');
        return text;
    };
    for (auto const model : {contact, spatial}) {
        auto const text = unwrapped(Made(body_named("cask"), basis, {0, 0, 5, 40}, model).text());
        EXPECT_NE(text.find(found), std::string::npos) << text;
        EXPECT_NE(text.find("overturn cost CAMPAIGN.toml"), std::string::npos) << text;
    }
    EXPECT_EQ(unwrapped(Made(body_named("cask"), basis, {0, 0, 5, 40}, rocking).text()).find("overturn cost"),
              std::string::npos);

    Made const made(body_named("cask"), basis, {0, 0, 5, 40}, spatial);
    auto const text = unwrapped(output::answer_text({.spec = made.spec,
                                                     .statistics = made.statistics,
                                                     .analysis = made.analysis,
                                                     .numerical = output::NumericalError{0.0701, false, 64}}));
    EXPECT_NE(text.find("numerical error of P 0.071, mean over levels (overturn cost, 64 trials)"), std::string::npos)
        << text;
    EXPECT_EQ(text.find(found), std::string::npos) << text;
}

// the design basis and named levels first; else the ends and the middle.
TEST(Answer, IsGivenAtTheLevelsThatMatter) {
    using Places = std::vector<std::size_t>;
    auto const levels = [](std::vector<LevelClass> const& purposes) {
        LevelSpec spec;
        for (auto const purpose : purposes) {
            spec.levels.push_back({1 + static_cast<double>(spec.levels.size()), purpose});
        }
        return spec;
    };
    constexpr auto other = LevelClass::ordinary;
    constexpr auto design = LevelClass::design_basis;
    constexpr auto beyond = LevelClass::beyond_design;
    EXPECT_EQ(answer_levels(levels({other})), Places({0}));
    EXPECT_EQ(answer_levels(levels({other, other, other, other, other})), Places({0, 2, 4}));
    EXPECT_EQ(answer_levels(levels({other, design, other, other, other})), Places({1, 2, 4}));
    EXPECT_EQ(answer_levels(levels({other, design, beyond, other, other, beyond})), Places({1, 2, 5}));
    EXPECT_EQ(answer_levels(levels({other, other, other, design})), Places({3}));
    EXPECT_EQ(answer_levels(levels({other, design, beyond, beyond, other, beyond, beyond})), Places({1, 2, 3, 5, 6}))
        << "no named level is left out";
}

// more named levels than stand beside each other stand below, within the same 15 lines.
TEST(Answer, HoldsEveryNamedLevel) {
    Made const made(
        body_named("cask"),
        "design_basis='300 gal'\nbeyond_design=['600 gal','900 gal','1200 gal']\n[[limits]]\nname='touches'\n"
        "quantity='peak_slip'\nabove='20 mm'\n",
        {0, 0, 5, 20});
    auto const text = made.text();
    auto const lines = lines_of(text.substr(0, text.find("\nWaves: ")));
    EXPECT_LE(lines.size(), 15U) << text;
    for (auto const* const part : {"300 gal = design", "600 gal = 2 x", "900 gal = 3 x", "1200 gal = 4 x",
                                   "0.125 [0.0418, 0.269]", "0.5 [0.338, 0.662]", "slip [mm]", "HCLPF touches"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    EXPECT_EQ(text.find("HCLPF "), text.rfind("HCLPF", text.find("HCLPF touches") - 1)) << "once:\n" << text;
    for (auto const& line : lines) {
        EXPECT_LE(line.size(), 100U) << line;
    }
}

// What most trials leave open has no percentile: those that are known may be the few that fell.
TEST(Answer, APercentileOfFewKnownTrialsIsNotKnown) {
    SampleQuantile fell;
    fell.value = 10;
    LevelQuantiles at;
    at.trials = at.overturned = 1;
    at.unknown = 29;
    at.fallen = 10;
    at.quantiles = {fell, fell, fell};
    EXPECT_EQ(output::percentiles_text(&at, 1e-3, 0.1), "not known (29 of 30)");
    at.trials = 29;
    at.unknown = 1;
    EXPECT_EQ(output::percentiles_text(&at, 1e-3, 0.1), "fell / fell");
    EXPECT_EQ(output::percentiles_text(nullptr, 1e-3, 0.1), "not simulated");
    at.unknown = 0;
    SampleQuantile small;
    small.value = 5e-5;
    at.quantiles = {small, small, small};
    EXPECT_EQ(output::percentiles_text(&at, 0.0254, 1e-4 / 0.0254), "<0.004 (open)") << "0.00394 in, rounded up";
}

// few waves have no percentile, and what was seen is printed in its place: from the median, or of fewer than
// five from the lowest value, to the highest.
TEST(Answer, FewWavesHaveNoPercentile) {
    LevelQuantiles at;
    at.trials = 7;
    at.fallen = 10;
    at.least = 0.001;
    at.most = 0.0301;
    SampleQuantile none;
    none.value = std::numeric_limits<double>::quiet_NaN();
    SampleQuantile median;
    median.value = 0.012;
    at.quantiles = {median, none, none};
    EXPECT_EQ(output::percentiles_text(&at, 1e-3, 0.1), "1.00 to 30.1");
    at.quantiles = {none, none, none};
    EXPECT_EQ(output::percentiles_text(&at, 1e-3, 0.1), "1.00 to 30.1");
    at.most = 10;
    at.unknown = 1;
    EXPECT_EQ(output::percentiles_text(&at, 1e-3, 0.1), "1.00 to fell, 1 not known");
}

// ends of intervals are rounded outwards; 1 - 0.025^(1/40) = 0.08810.
TEST(Answer, RoundsToTheSafeSide) {
    EXPECT_EQ(probability_text({.trials = 40}, 0.95), "< 0.0881 (0 of 40)");
    EXPECT_EQ(probability_text({.trials = 200}, 0.95), "< 0.0183 (0 of 200)");
    EXPECT_EQ(probability_text({.trials = 400}, 0.95), "< 0.00918 (0 of 400)");  // 0.0091798
    EXPECT_EQ(probability_text({.trials = 40, .overturned = 40}, 0.95), "> 0.911 (40 of 40)");
    EXPECT_EQ(probability_text({.trials = 40, .failed = 40}, 0.95), "not known");
    EXPECT_EQ(probability_text({.trials = 40, .undecided = 4}, 0.95), "< 0.237 (4 undecided)");  // as of 4 of 40
    EXPECT_EQ(rounded_up(0.12301), 0.124);
    EXPECT_EQ(rounded_up(0.123), 0.123);
    EXPECT_EQ(rounded_down(0.12399), 0.123);
    EXPECT_EQ(rounded_up(1234), 1240);
    EXPECT_EQ(rounded_up(-0.12399), -0.123);
    EXPECT_EQ(rounded_up(0), 0);
    EXPECT_EQ(output::interval_text({0.041799, 0.2687024}), "[0.0417, 0.269]");
    EXPECT_EQ(output::interval_text({0, 0.0182752}), "[0, 0.0183]");
    EXPECT_EQ(output::interval_text({2.691e-6, 2.401e-3}), "[2.69e-06, 0.00241]");
    EXPECT_EQ(output::interval_text({0, 3.7e-7}), "[0, 3.7e-07]");  // none of ten million
    EXPECT_EQ(output::interval_text({0.25, 0.7500001}), "[0.25, 0.751]");
}

// a limit that a fall does not pass says so in every line of the answer, whole where a long name is shortened.
TEST(Answer, StatesWithoutOverturning) {
    std::string const limits =
        "design_basis='600 gal'\n[[limits]]\nname='{}'\nquantity='peak_slip'\nabove='20 mm'\n"
        "overturned='excluded'\n";
    auto const text = [&](std::string const& body, std::string const& name) {
        auto stated = limits;
        return Made(body_named(body), stated.replace(stated.find("{}"), 2, name), {0, 0, 5, 40}).text();
    };
    EXPECT_NE(text("cask", "touches").find("P(touches without overturning) "), std::string::npos)
        << text("cask", "touches");
    auto const shortened = text("cask of a rather long name", "touches the wall of the building");
    EXPECT_NE(shortened.find(" without overturning) "), std::string::npos) << shortened;
    EXPECT_NE(shortened.find("P(t"), std::string::npos) << shortened;
    for (auto const& line : lines_of(shortened)) {
        EXPECT_LE(line.size(), 100U) << line;
    }
    EXPECT_NE(shortened.find("1200 gal = 2 x"), std::string::npos) << "levels that do not fit stand below";
}

// names beyond ASCII keep their columns, and are shortened between characters.
TEST(Answer, KeepsItsColumnsWithWideNames) {
    auto const first_row = [](std::string const& name) {
        Made const made(body_named(name) + body_named("two"), "design_basis='600 gal'\n", {0, 0, 5, 40});
        for (auto const& line : lines_of(made.text())) {
            if (line.find("P(overturn)") != std::string::npos) {
                return line;
            }
        }
        return std::string();
    };
    auto const behind = [](std::string const& line) { return line.substr(line.find(" P(overturn)")); };
    EXPECT_EQ(first_row("Beh\u00e4lter A"), "Beh\u00e4lter A" + behind(first_row("Behalter A")));
    EXPECT_EQ(first_row("\u5bb9\u5668"), "\u5bb9\u5668" + behind(first_row("cask")));
    // Ten wide characters in 18 columns: four, two dots, four.
    EXPECT_TRUE(first_row("\u4e00\u4e8c\u4e09\u56db\u4e94\u516d\u4e03\u516b\u4e5d\u5341")
                    .starts_with("\u4e00\u4e8c\u4e09\u56db..\u4e03\u516b\u4e5d\u5341 P(overturn)"));
}

// lines end between words, and a long word stands alone.
TEST(Answer, WrapsBetweenWords) {
    EXPECT_EQ(wrapped("one two three", 2, 7), "one two\n  three\n");
    EXPECT_EQ(wrapped("one", 2, 7), "one\n");
    EXPECT_EQ(wrapped("incomprehensible x", 0, 7), "incomprehensible\nx\n");
    EXPECT_EQ(wrapped("one two", 4, 7, "  a "), "  a one\n    two\n");
    std::string const short_line(100, 'x');
    std::string const word(60, 'y');
    EXPECT_EQ(narrowed(short_line + "\n\n  " + word + ' ' + word + '\n'),
              short_line + "\n\n  " + word + "\n      " + word + '\n');
    std::string const command = ": overturn run c.toml --resume --set title=" + std::string(40, 'z');
    EXPECT_EQ(narrowed("go on with" + command + '\n'), "go on with" + command + '\n');
    EXPECT_EQ(narrowed(word + ". Go on with" + command + '\n'), word + ". Go on with:\n    " + command.substr(2) + '\n')
        << "a command stays whole";
    EXPECT_EQ(narrowed(word + ' ' + word + ": overturn merge c.h5\n"),
              word + "\n    " + word + ": overturn merge c.h5\n");
    EXPECT_EQ(wrapped("\u00e4\u00e4 \u00e4\u00e4 x", 0, 5), "\u00e4\u00e4 \u00e4\u00e4\nx\n");
    EXPECT_EQ(wrapped("of 95 % x", 0, 7), "of 95 %\nx\n");
}

// a row for each body, limit state and level, in SI, under the names of the other tables.
TEST(Answer, IsATableToo) {
    Made const made(body_named("one") + body_named("two"), "design_basis='600 gal'\n", {0, 0, 5, 20});
    auto const table =
        output::answer_table({.spec = made.spec, .statistics = made.statistics, .analysis = made.analysis});
    ASSERT_EQ(table.rows.size(), 2 * 3);
    auto const& row = table.rows.at(1);
    EXPECT_EQ(std::get<std::string>(row.at(table.place_of("body"))), "one");
    EXPECT_EQ(std::get<double>(row.at(table.place_of("amplitude"))), 9.0);
    EXPECT_EQ(std::get<std::int64_t>(row.at(table.place_of("exceeded"))), 5);
    EXPECT_EQ(std::get<double>(row.at(table.place_of("probability"))), 0.125);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(row.at(table.place_of("hclpf"))));
}

// sections by name; another name is refused with all that there are.
TEST(Sections, AreChosenByName) {
    EXPECT_EQ(output::read_sections("curves,stripes"), (std::vector<std::string>{"curves", "stripes"}));
    EXPECT_TRUE(output::read_sections("").empty());
    testing::expect_input_error([] { (void)output::read_sections("curve"); },
                                "'curve' (no such section). There are records, stripes");

    Made const made(body_named("cask"), "design_basis='600 gal'\n", {0, 0, 5, 20});
    output::Printed const printed{
        .answered = {.spec = made.spec, .statistics = made.statistics, .analysis = made.analysis}, .file = "c.h5"};
    auto const short_one = output::results_text(printed, {});
    EXPECT_EQ(short_one.find("\n== "), std::string::npos);
    EXPECT_NE(short_one.find("more: overturn fit c.h5 --full"), std::string::npos) << short_one;
    auto const curves = output::results_text(printed, {.sections = {"curves"}});
    EXPECT_NE(curves.find("\n== curves\n"), std::string::npos);
    EXPECT_EQ(curves.find("\n== stripes\n"), std::string::npos);
    EXPECT_NE(output::results_text(printed, {.sections = {"rare"}}).find("\n== rare\nno estimate of rare events"),
              std::string::npos);
    auto const full = output::results_text(printed, {.full = true});
    EXPECT_NE(full.find("\n== curves\n"), std::string::npos);
    EXPECT_NE(full.find("\n== stripes\n"), std::string::npos);
    EXPECT_EQ(full.find("more: "), std::string::npos);
}

}  // namespace
}  // namespace overturn

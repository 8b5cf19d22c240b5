// Requirement R-1005: of records that may not be passed on a results file holds names and hashes alone; who has the
// file can read and fit it, who has the records too can compute it again, and no other record is taken for one of them.
#include <cmath>
#include <filesystem>
#include <regex>
#include <string>

#include <fmt/format.h>

#include "cli/python.hpp"
#include "core/units.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

namespace fs = std::filesystem;

std::string record(double amplitude_gal) {
    std::string text = "time_s,acc (gal)\n";
    for (int i = 0; i <= 1000; ++i) {
        double const t = 0.01 * i;
        text +=
            fmt::format("{:.2f},{:.6f}\n", t, amplitude_gal * std::sin(6.3 * t) * std::pow(std::sin(0.3141 * t), 2));
    }
    return text;
}

class Withheld : public ::testing::Test {
  protected:
    Withheld() {
        folder.write("one.csv", record(600));
        folder.write("two.csv", record(700));
        folder.write("body.toml",
                     "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n");
        folder.write("c.toml", campaign("hash-only"));
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "away/c.h5"}).code, 2) << "no such folder yet";
        fs::create_directory(folder / "away");
        auto const ended = overturn(folder, {"run", "c.toml", "-o", "away/c.h5"});
        EXPECT_EQ(ended.code, 0) << ended.err;
    }

    static std::string campaign(std::string const& inputs) {
        return "seed=1\ninputs='" + inputs
               + "'\n[waves]\nsource='records'\nrecords=[{horizontal='one.csv', baseline='mean'}, "
                 "{horizontal='one.csv', transverse='two.csv', axes='principal'}]\n"
                 "[[bodies]]\nfile='body.toml'\n[levels]\nmeasure='factor'\nvalues=[0.5,1,2]\n";
    }
    [[nodiscard]] Ended there(std::vector<std::string> arguments) const {
        auto line = "cd away && exec " OVERTURN_PROGRAM + std::string();
        for (auto const& argument : arguments) {
            line += " " + argument;
        }
        return execute(folder, {"/bin/sh", "-c", line});
    }

    Folder folder;
};

// Without the records it is not known whether they drift.
std::string without_cautions(std::string const& text) {
    return std::regex_replace(text, std::regex("caution: [^\n]*(\n    [^\n]*)*\n?"), "");
}

TEST_F(Withheld, TheFileHoldsNamesAndHashesAlone) {
    auto const bytes = folder.read("away/c.h5");
    EXPECT_NE(bytes.find("one.csv"), std::string::npos);
    EXPECT_EQ(bytes.find("acc (gal)"), std::string::npos);
    folder.write("whole.toml", campaign("stored"));
    ASSERT_EQ(overturn(folder, {"run", "whole.toml"}).code, 0);

    EXPECT_EQ(there({"status", "c.h5"}).code, 0);
    auto const fit = there({"fit", "c.h5"});
    EXPECT_EQ(fit.code, 0) << fit.err;
    auto const whole = without_cautions(overturn(folder, {"fit", "whole.h5"}).out);
    EXPECT_NE(fit.out.find("caution: whether records drift or are scaled by more than 5 is not known here"),
              std::string::npos)
        << fit.out;
    auto const stripes = without_cautions(fit.out.substr(0, fit.out.find("hand")));
    EXPECT_FALSE(stripes.empty());
    EXPECT_EQ(whole.substr(0, whole.find("hand")).substr(0, 500), stripes.substr(0, 500));
}

// R-1107: who has the records extends the file, whether it is to hold them or not; another record is named.
TEST_F(Withheld, TheFileIsExtended) {
    auto const more = [](std::string text) { return text.replace(text.find("0.5,1,2"), 7, "0.5,1,1.5,2"); };
    auto const extend = [&](std::string const& text) {
        folder.write("c.toml", text);
        return overturn(folder, {"run", "c.toml", "-o", "away/c.h5", "--extend"});
    };
    for (auto const& text : {more(campaign("hash-only")), more(campaign("stored")), more(campaign("hash-only"))}) {
        auto const ended = extend(text);
        ASSERT_EQ(ended.code, 0) << ended.err;
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "once.h5"}).code, 0);
        EXPECT_TRUE(folder.read("away/c.h5") == folder.read("once.h5"));
        fs::remove(folder / "once.h5");
    }
    folder.write("two.csv", record(701));
    auto const refused = extend(more(campaign("hash-only")));
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("file two.csv changed"), std::string::npos) << refused.err;
}

// who has no record counts recordings as who has them.
TEST_F(Withheld, ComponentsOfOneStationAreOneSampleStill) {
    auto const peer = [](int component, int station) {
        std::string text = fmt::format(
            "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 5/19/1940, Station {}, {:03}\n"
            "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  400, DT=   .0100 SEC\n",
            station, component);
        for (int i = 0; i < 400; ++i) {
            text += fmt::format("{:.6f}{}",
                                0.1 * std::sin(0.05 * (station + 0.01 * component) * i) * std::sin(pi * i / 400),
                                i % 5 == 4 ? "\n" : " ");
        }
        return text;
    };
    std::string files;
    for (int station = 1; station <= 5; ++station) {
        for (int const component : {0, 90}) {
            auto const name = fmt::format("r{}{}.at2", station, component == 0 ? "a" : "b");
            folder.write(name, peer(component, station));
            files += fmt::format("'{}',", name);
        }
    }
    folder.write("peer.toml",
                 "seed=1\ninputs='hash-only'\n[waves]\nsource='records'\nbaseline='mean'\nfiles=[" + files
                     + "]\n[[bodies]]\nfile='body.toml'\n[levels]\nmeasure='pga'\nvalues=['0.3 g', '0.6 g']\n");
    auto const run = overturn(folder, {"run", "peer.toml", "-o", "away/peer.h5"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const answer = without_cautions(run.out.substr(0, run.out.find("\nWaves: ")));
    EXPECT_NE(answer.find("(0 of 10)"), std::string::npos) << answer;
    EXPECT_NE(answer.find("< 0.522"), std::string::npos) << "of five: 1 - 0.025^(1/5)\n" << answer;
    auto const fit = there({"fit", "peer.h5"});
    EXPECT_EQ(fit.code, 0) << fit.err;
    EXPECT_NE(without_cautions(fit.out).find(answer), std::string::npos) << fit.out;
    EXPECT_EQ(folder.read("away/peer.h5").find("Station 3"), std::string::npos) << "a hash of it alone";
}

// an annual frequency needs no record: a withheld one may have any component.
TEST_F(Withheld, AnnualFrequenciesAreFoundWithoutTheRecords) {
    folder.write("pga.toml",
                 "seed=1\ninputs='hash-only'\n[waves]\nsource='records'\nfiles=['one.csv']\nbaseline='mean'\n"
                 "[[bodies]]\nfile='body.toml'\n[levels]\nmeasure='pga'\nvalues=['0.3 g', '0.6 g']\n");
    ASSERT_EQ(overturn(folder, {"run", "pga.toml", "-o", "away/pga.h5"}).code, 0);
    folder.write("away/h.csv", "pga [g], annual_exceedance\n0.1,1e-2\n5,1e-7\n");
    auto const fit = there({"fit", "pga.h5", "--hazard", "h.csv"});
    EXPECT_EQ(fit.code, 0) << fit.err;
    EXPECT_NE(fit.out.find("needs 5 records or more (1 here)"), std::string::npos) << fit.out;
}

TEST_F(Withheld, WhoComputesNeedsTheRecords) {
    auto const refused = [&](std::vector<std::string> const& arguments, std::string const& why) {
        auto const ended = there(arguments);
        EXPECT_EQ(ended.code, 2) << arguments[0];
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    };
    std::string const missing = "c.h5: input one.csv (its campaign keeps hashes of records alone";
    refused({"replay", "c.h5", "--trial", "3"}, missing);
    refused({"verify", "c.h5"}, missing);
    refused({"report", "c.h5", "-o", "page.html"}, missing);
    folder.write("away/one.csv", record(601));
    refused({"replay", "c.h5", "--trial", "3"}, "is another file than the one it was made from");
    folder.write("away/one.csv", record(600));
    refused({"verify", "c.h5"}, "c.h5: input two.csv (its campaign");
    folder.write("away/two.csv", record(700));

    EXPECT_EQ(there({"replay", "c.h5", "--trial", "3"}).code, 0);
    auto const verified = there({"verify", "c.h5"});
    EXPECT_EQ(verified.code, 0) << verified.err << verified.out;
    EXPECT_NE(overturn(folder, {"run", "c.toml", "-o", "away/c.h5", "--resume"}).out.find("complete already"),
              std::string::npos);
}

TEST_F(Withheld, OtherWavesKeepTheirFiles) {
    folder.write("pulse.toml",
                 "seed=1\ninputs='hash-only'\n[waves]\nsource='pulse'\namplitude=3\nperiod=1\nshape='one-sine'\n"
                 "[[bodies]]\nfile='body.toml'\n[levels]\nmeasure='factor'\nvalues=[1]\n");
    auto const ended = planned(folder, {"pulse.toml"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("pulse.toml:2:8: inputs: hash-only (for source = \"records\""), std::string::npos)
        << ended.err;
}

}  // namespace
}  // namespace overturn::testing

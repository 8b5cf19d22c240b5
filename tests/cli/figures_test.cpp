// Requirement R-905: waves are drawn and written as files; a figure needs nothing but Python, says what to install
// where something is missing, and has the same bytes for the same data.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "core/units.hpp"
#include "motion/record.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"
#include "support/read_record.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Figures : public ::testing::Test {
  protected:
    Figures() {
        ::unsetenv("OVERTURN_PYTHON");
        ::setenv("TMPDIR", folder.path().c_str(), 1);
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("shared", 2));
        folder.write("body.toml",
                     "name='b'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n");
    }
    ~Figures() override {
        ::unsetenv("OVERTURN_PYTHON");
        ::unsetenv("TMPDIR");
    }

    Ended done(std::vector<std::string> const& arguments) {
        auto ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended;
    }

    /// Lets `script` stand where the interpreter would: called with -IB, draw.py, the script, the data and
    /// the figure's place.
    void use_interpreter(std::string const& script) {
        folder.write("interpreter", "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(folder / "interpreter", std::filesystem::perms::owner_all);
        ::setenv("OVERTURN_PYTHON", (folder / "interpreter").c_str(), 1);
    }

    void skip_without_matplotlib() {
        if (execute(folder, {OVERTURN_PYTHON, "-c", "import matplotlib"}).code != 0) {
            GTEST_SKIP() << "no matplotlib to draw with (install python3-matplotlib)";
        }
    }

    struct Row {
        double amplitude, v_wes, v_ereq, v_resp, rotation;
    };
    [[nodiscard]] Row rows(std::string const& name, int trial) const {
        store::ResultsReader const file(folder / name);
        auto const at = [&](char const* column) {
            return file.reals(std::string("trials/") + column).at(static_cast<std::size_t>(trial));
        };
        return {at("amplitude"), at("v_wes"), at("v_ereq"), at("v_resp"), at("peak_rotation")};
    }

    Folder folder;
};

TEST_F(Figures, SameDataSameBytes) {
    skip_without_matplotlib();
    if (IsSkipped()) {
        return;
    }
    done({"wave", "c.toml", "--wave", "1", "--plot", "a.svg"});
    done({"wave", "c.toml", "--wave", "1", "--plot", "b.svg"});
    done({"wave", "c.toml", "--wave", "0", "--plot", "c.svg"});
    done({"wave", "c.toml", "--wave", "0", "--plot", "c.png"});

    auto const svg = folder.read("a.svg");
    EXPECT_TRUE(svg.starts_with("<?xml")) << svg.substr(0, 100);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_EQ(svg.find("<dc:date>"), std::string::npos);
    EXPECT_EQ(svg, folder.read("b.svg"));
    EXPECT_NE(svg, folder.read("c.svg"));
    EXPECT_TRUE(folder.read("c.png").starts_with("\x89PNG"));
    for (auto const& entry : std::filesystem::directory_iterator(folder.path())) {
        EXPECT_FALSE(entry.path().filename().string().starts_with("overturn-figure-")) << entry.path();  // left over
    }
}

// The figure shows what the numbers say.
TEST_F(Figures, DrawWhatIsMeasured) {
    use_interpreter("cp \"$4\" \"$5\"");
    done({"wave", "c.toml", "--wave", "1", "--plot", "a.svg"});
    done({"wave", "c.toml", "--wave", "1", "-o", "w.csv"});
    std::vector<std::string> const record{"spectrum", "--wave", "w.csv", "--unit", "m/s2", "--body", "body.toml"};
    done(joined(record, {"--plot", "b.svg"}));
    auto const measured = json::parse(done(joined(record, {"--json"})).out);
    auto const wave = json::parse(folder.read("a.svg"));
    auto const drawn = json::parse(folder.read("b.svg"));

    EXPECT_EQ(drawn["pgv_mps"], measured["pgv_mps"]);
    auto const& body = drawn["bodies"][0];
    EXPECT_EQ(body["v_ereq_mps"], measured["energy"]["v_ereq_mps"]);
    EXPECT_EQ(*std::max_element(body["v_wes_mps"].begin(), body["v_wes_mps"].end()), measured["energy"]["v_wes_mps"]);
    EXPECT_FALSE(drawn.contains("target"));

    EXPECT_EQ(wave["bodies"].size(), 2U);
    EXPECT_EQ(wave["title"], "small");
    EXPECT_EQ(wave["target"]["name"], "target.csv");
    EXPECT_NEAR(wave["target"]["psa_mps2"][0].get<double>(), 2.5, 1e-12);
    EXPECT_TRUE(wave["target"]["bands"].empty());  // the campaign asks for no rule
    ASSERT_EQ(wave["further"].size(), 1U);
    EXPECT_EQ(wave["further"][0]["name"], "vertical");
    EXPECT_EQ(wave["further"][0]["acceleration_mps2"].size(), wave["acceleration_mps2"].size());
    EXPECT_EQ(wave["further"][0]["psa_mps2"].size(), wave["period_s"].size());
    EXPECT_LT(wave["target"]["period_s"].back().get<double>(), 10.0 + 1e-9);
}

// a trial's history is drawn from what the trial was: the wave as scaled, the rotation to its peak,
// V_resp(t) up to the stored V_resp, V_WES(t) up to the stored V_WES.
TEST_F(Figures, HistoriesDrawWhatTheTrialWas) {
    done({"run", "c.toml", "-o", "c.h5"});
    use_interpreter("cp \"$4\" \"$5\"");
    auto const peak = [](json const& values) {
        double highest = 0;
        for (auto const& value : values) {
            highest = std::max(highest, value.is_null() ? 0 : std::abs(value.get<double>()));
        }
        return highest;
    };
    for (int trial = 0; trial < 12; ++trial) {
        auto const number = std::to_string(trial);
        auto const said = done({"replay", "c.h5", "--trial", number, "--plot", "a.svg", "--history", "h.csv"}).out;
        EXPECT_NE(said.find("bit-equal to the stored row"), std::string::npos) << said;
        auto const drawn = json::parse(folder.read("a.svg"));
        auto const row = rows("c.h5", trial);
        auto const& channels = drawn["channels"];
        EXPECT_NEAR(peak(drawn["wave"][0]["values"]), row.amplitude, 1e-9 * row.amplitude) << trial;
        EXPECT_NEAR(peak(drawn["v_wes"]["values"]), row.v_wes, 1e-9 * row.v_wes) << trial;
        EXPECT_EQ(drawn["v_ereq_mps"], row.v_ereq) << trial;
        // Instants are up to a sample of 0.02 s apart: the peak between them is a little higher, of small rotations by
        // what the body turns from rest within half a sample, at p^2 (tan(alpha) + a / g) or less. What falls is
        // followed beyond the critical angle, how far is stored of none.
        constexpr double between = 0.98;
        constexpr double p2 = 7;  // of these bodies at most
        double const turn = 0.5 * 0.01 * 0.01 * p2 * (1 + row.amplitude / g0);
        auto const tilt = channels.contains("rotation_rad") ? "rotation_rad" : "tilt_rad";
        EXPECT_LE(peak(channels["v_resp_mps"]), row.v_resp * (1 + 1e-12)) << trial;
        EXPECT_GE(peak(channels["v_resp_mps"]), between * row.v_resp) << trial;
        if (row.rotation > 1.5) {
            EXPECT_GT(peak(channels[tilt]), drawn["alpha"]) << trial;
        } else {
            EXPECT_LE(peak(channels[tilt]), row.rotation * (1 + 1e-12)) << trial;
            EXPECT_GE(peak(channels[tilt]), std::min(between * row.rotation, row.rotation - turn)) << trial;
        }
        EXPECT_EQ(channels[tilt].size(), channels["time_s"].size());
        EXPECT_TRUE(folder.has("h.csv"));
    }
}

// slip and contact force are drawn of every model that has them, up to the stored peak.
TEST_F(Figures, HistoriesShowSlipAndContactForce) {
    done({"wave", "c.toml", "--wave", "1", "-o", "w.csv"});
    folder.write("slides.toml", folder.read("body.toml") + "friction=0.3\n");
    use_interpreter("cp \"$4\" \"$5\"");
    for (std::string const effects : {"sliding", "contact,sliding"}) {
        auto const told = json::parse(done({"rock", "--body", "slides.toml", "--wave", "w.csv", "--unit", "m/s2",
                                            "--scale", "1.5", "--effects", effects, "--plot", "a.svg", "--json"})
                                          .out);
        auto const channels = json::parse(folder.read("a.svg"))["channels"];
        double farthest = 0;
        for (auto const& slip : channels.at("slip_m")) {
            farthest = std::max(farthest, std::abs(slip.get<double>()));
        }
        double const stored = told.at("peak_slip_m");
        EXPECT_GT(stored, 0.01) << effects;
        EXPECT_LE(farthest, stored * (1 + 1e-9)) << effects;
        EXPECT_GE(farthest, 0.98 * stored) << effects;
        EXPECT_EQ(channels.at("contact_force_over_weight").size(), channels.at("slip_m").size());
    }
}

TEST_F(Figures, HistoriesAreDrawn) {
    skip_without_matplotlib();
    if (IsSkipped()) {
        return;
    }
    done({"wave", "c.toml", "--wave", "1", "-o", "w.csv"});
    folder.write("slides.toml", folder.read("body.toml") + "friction=0.3\n");
    folder.write("round.toml", folder.read("body.toml") + "friction=0.6\nbase={shape='round', points=16}\n");
    for (std::string const body : {"body", "slides", "round"}) {
        std::vector<std::string> const rock{"rock",   "--body", body + ".toml", "--wave", "w.csv",
                                            "--unit", "m/s2",   "--scale",      "1.5",    "--plot"};
        done(joined(rock, {"a.svg"}));
        done(joined(rock, {"b.svg"}));
        EXPECT_NE(folder.read("a.svg").find("</svg>"), std::string::npos) << body;
        EXPECT_EQ(folder.read("a.svg"), folder.read("b.svg")) << body;
        std::filesystem::remove(folder / "a.svg");
    }
}

TEST_F(Figures, MissingPiecesAreNamed) {
    auto const fails = [&](std::string const& part) {
        auto const ended = overturn(folder, {"wave", "c.toml", "--wave", "1", "--plot", "a.svg"});
        EXPECT_EQ(ended.code, 1) << part;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        EXPECT_FALSE(folder.has("a.svg"));
    };
    ::setenv("OVERTURN_PYTHON", "/nonexistent/python", 1);
    fails("/nonexistent/python missing");
    use_interpreter("exec " OVERTURN_PYTHON " -S \"$@\"");  // without anybody's packages
    fails("apt-get install python3-numpy python3-matplotlib");
    use_interpreter("echo 'Traceback' >&2; echo 'ValueError: broken' >&2; exit 1");
    fails("Python: ValueError: broken");
}

TEST_F(Figures, BadNamesAreRefusedBeforeAnyWork) {
    auto const refused = [&](std::vector<std::string> const& arguments, std::string const& part) {
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 2) << part;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    };
    refused({"wave", "c.toml", "--wave", "1", "--plot", "a.jpg"}, "End it in .svg, .png or .pdf");
    refused({"wave", "c.toml", "--wave", "1", "-o", "a.txt"}, "End it in .csv or .at2");
    refused({"spectrum", "--wave", "none.csv", "--plot", "a"}, "End it in .svg");
    refused({"rock", "--body", "none", "--wave", "none", "--plot", "a.jpg"}, "End it in .svg");
    refused({"replay", "none.h5", "--trial", "0", "--plot", "a.jpg"}, "End it in .svg");
    refused({"replay", "none.h5", "--trial", "0", "--rare", "b", "--plot", "a.svg"}, "--plot beside --rare");
    use_interpreter("cp \"$4\" \"$5\"");
    refused({"wave", "c.toml", "--wave", "1", "--plot", "no/folder/a.svg"}, "no/folder/a.svg: cannot be written");
}

//
TEST_F(Figures, At2FilesHoldTheWavesComponents) {
    done({"wave", "c.toml", "--wave", "1", "-o", "w.AT2"});
    done({"wave", "c.toml", "--wave", "1", "-o", "w.csv"});

    auto const csv = testing::read_record(folder.read("w.csv"), {.unit_mps2 = 1});
    auto const horizontal = testing::read_record(folder.read("w-H1.AT2"), {});
    auto const vertical = testing::read_record(folder.read("w-UP.AT2"), {});

    EXPECT_FALSE(folder.has("w-H2.AT2"));
    ASSERT_EQ(horizontal.samples(), csv.samples());
    constexpr double eight_digits = 5e-8;
    for (std::size_t i = 0; i < csv.samples(); ++i) {
        ASSERT_NEAR(horizontal.horizontal_mps2[i], csv.horizontal_mps2[i],
                    eight_digits * std::abs(csv.horizontal_mps2[i]));
        ASSERT_NEAR(vertical.horizontal_mps2[i], csv.vertical_mps2[i], eight_digits * std::abs(csv.vertical_mps2[i]));
    }
}

}  // namespace
}  // namespace overturn::testing

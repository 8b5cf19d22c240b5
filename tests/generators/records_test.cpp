// Requirement R-108: record n is wave n, untouched, and a damaged or missing file is named where the campaign names it.
#include "generators/detail/records.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/units.hpp"
#include "generators/wave_quality.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using testing::source_of;

std::map<std::string, std::string> const files{{"a.csv", "0,0\n0.01,10\n0.02,-20\n0.03,0\n"},
                                               {"b.csv", "0,0\n0.01,1\n0.02,2\n"},
                                               {"slow.csv", "0,0\n0.02,1\n0.04,2\n"},
                                               {"bad.csv", "0,0\n0.01,x\n"}};

TEST(Records, FilesAreWavesInTheirOrder) {
    auto const source = source_of("source='records'\nfiles=['a.csv','b.csv']\nunit='gal'\n", files);

    EXPECT_EQ(source->about().available, 2U);
    auto const first = source->make(1, 0);
    EXPECT_EQ(first.label, "a.csv");
    ASSERT_EQ(first.motion.samples(), 4U);
    EXPECT_NEAR(first.motion.time_step_s, 0.01, 1e-15);
    EXPECT_DOUBLE_EQ(first.motion.horizontal_mps2[2], -0.2);
    EXPECT_EQ(source->make(99, 0).motion.horizontal_mps2, first.motion.horizontal_mps2);
    expect_input_error([&] { (void)source->make(1, 2); }, "wave 2 of 2");
}

// components of one station and event are one sample, by what their files say or, where these say nothing, by
// the directions in their names.
TEST(Records, ComponentsOfOneRecordingAreNoTwoSamples) {
    auto named = [](std::initializer_list<char const*> names) {
        std::map<std::string, std::string> contents;
        std::string list;
        int peak = 0;
        for (std::string const name : names) {
            ++peak;
            contents[name] = fmt::format("0,0\n0.01,{}\n0.02,-20\n0.03,{}\n", peak, 3 * peak);
            list += fmt::format("'{}',", name);
        }
        return source_of(fmt::format("source='records'\nfiles=[{}]\nunit='gal'\n", list), contents)->about();
    };
    using Numbers = std::vector<std::int64_t>;
    using Names = std::initializer_list<char const*>;
    auto const about = named({"kobe_NS.csv", "taft.csv", "kobe_EW.csv"});
    EXPECT_EQ(about.shared.of, (Numbers{0, 1, 0}));
    EXPECT_EQ(about.shared.most, 2);
    EXPECT_EQ(about.shared.among(3), 2);
    EXPECT_EQ(about.shared.among(2), 2);
    EXPECT_EQ(about.variability, "3 recorded motions of 2 recordings, as chosen");
    EXPECT_EQ(named({"a/NS.csv", "a/EW.csv", "b/NS.csv", "b/EW.csv"}).shared.of, (Numbers{0, 0, 1, 1}));
    EXPECT_EQ(named({"tokachi.NS", "tokachi.EW"}).shared.most, 2);
    EXPECT_EQ(named({"NS/kobe.csv", "EW/kobe.csv"}).shared.most, 2);
    EXPECT_EQ(
        named({"RSN1106_KJM000.csv", "RSN1106_KJM090.csv", "TCU068N.csv", "TCU068E.csv", "kobeNS.csv", "kobeEW.csv"})
            .shared.of,
        (Numbers{0, 0, 1, 1, 2, 2}));
    EXPECT_EQ(
        named({"hachinohe_000.csv", "hachinohe_090.csv", "a_H1.csv", "a_H2.csv", "b (NS).csv", "b (EW).csv"}).shared.of,
        (Numbers{0, 0, 1, 1, 2, 2}));
    for (auto const& two : {Names{"hx_1.csv", "hy_1.csv", "hx_2.csv"},
                            {"sx-1.csv", "sy-1.csv", "sx-2.csv"},
                            {"x_1.csv", "y_1.csv", "x_2.csv"},
                            {"wave1x.csv", "wave1y.csv", "wave2x.csv"},
                            {"kobe_NS_1.csv", "kobe_EW_1.csv", "kobe_NS_2.csv"}}) {
        EXPECT_EQ(named(two).shared.of, (Numbers{0, 0, 1})) << *two.begin();
    }
    // Three directions, small letters, a number or a word behind, numbers of components.
    for (auto const& names : {Names{"q_x.csv", "q_y.csv", "q_z.csv"},
                              {"q_NS.csv", "q_EW.csv", "q_UD.csv"},
                              {"q_000.csv", "q_090.csv", "q_UP.csv"},
                              {"q_000.csv", "q_045.csv", "q_090.csv"},
                              {"q_EW.csv", "q_UD.csv"},
                              {"q_x.csv", "q_z.csv"},
                              {"q_N.csv", "q_E.csv", "q_Z.csv"},
                              {"q_FN.csv", "q_FP.csv", "q_UP.csv"},
                              {"q1x.csv", "q1y.csv", "q1z.csv"},
                              {"q_ns.csv", "q_ew.csv"},
                              {"q1ns.csv", "q1ew.csv", "q1ud.csv"},
                              {"NS.csv", "EW.csv", "UD.csv"},
                              {"q.NS1", "q.EW1", "q.UD1", "q.NS2", "q.EW2", "q.UD2"},
                              {"q.NS1", "q.EW1", "q.NS2"},
                              {"q_NS_acc.csv", "q_EW_acc.csv"},
                              {"q_NS_rock.csv", "q_EW_rock.csv"},
                              {"NS_rock.csv", "EW_rock.csv"},
                              {"q_000_filt.csv", "q_090_filt.csv"},
                              {"q_000_rock.csv", "q_090_rock.csv"},
                              {"q_x_acc.csv", "q_y_acc.csv", "q_z_acc.csv"},
                              {"q1NS_acc.csv", "q1EW_acc.csv"},
                              {"q_North_corr.csv", "q_East_corr.csv"},
                              {"q comp 1.csv", "q comp 2.csv"},
                              {"q_Component_1.csv", "q_Component_2.csv"},
                              {"q Horizontal 1.csv", "q Horizontal 2.csv"},
                              {"q_dir1.csv", "q_dir2.csv"},
                              {"q_ch1.csv", "q_ch2.csv", "q_ch3.csv"},
                              {"q_Rad.csv", "q_Trn.csv"}}) {
        EXPECT_EQ(named(names).shared.of, Numbers(names.size(), 0)) << *names.begin();
    }
    EXPECT_EQ(named({"q_NS1.csv", "q_EW1.csv", "q_NS2.csv", "q_EW2.csv"}).shared.of, (Numbers{0, 0, 1, 1}));
    EXPECT_EQ(named({"a_x.csv", "b_x.csv", "a_y.csv", "b_z.csv", "a_z.csv", "b_y.csv"}).shared.of,
              (Numbers{0, 1, 0, 1, 0, 1}));
    // Numbers count motions, letters are names, a word amid others says what it is of, and east is no pair of west.
    for (auto const& names : {Names{"m-1.csv", "m-2.csv"},
                              {"x.csv", "y.csv"},
                              {"kobe.csv", "taft.csv"},
                              {"H1.csv", "H2.csv"},
                              {"event_L.csv", "event_N.csv", "event_R.csv", "event_S.csv", "event_T.csv"},
                              {"site_east.csv", "site_west.csv"},
                              {"run_x.csv", "run_y.csv", "run_a.csv"},
                              {"San.csv", "San_E.csv", "San_N.csv", "San_S.csv", "San_W.csv"},
                              {"wave.csv", "wave_h.csv"},
                              {"d_H1_run1.csv", "d_H2_run1.csv"},
                              {"event_L.csv", "event_N.csv", "event_Z.csv"},
                              {"event_E.csv", "event_N.csv", "event_S.csv"},
                              {"event_D.csv", "event_E.csv", "event_N.csv"},
                              {"event_N.csv", "event_U.csv"},
                              {"q_010.csv", "q_050.csv", "q_100.csv"},
                              {"q_000.csv", "q_045.csv", "q_090.csv", "q_135.csv"},
                              {"q_x.csv", "q_y.csv", "q_z.csv", "q_v.csv"},
                              {"x.csv", "y.csv", "z.csv"},
                              {"q.NS1", "q.NS2"},
                              {"comp 1.csv", "comp 2.csv"},
                              {"q_ch1.csv", "q_ch2.csv", "q_ch4.csv"},
                              {"run_North_Bohemia.csv", "run_East_Bohemia.csv"},
                              {"q_x_rock.csv", "q_y_rock.csv"},
                              {"q_H1_rock.csv", "q_H2_rock.csv"},
                              {"East_Bohemia_2008.csv", "West_Bohemia_2008.csv"}}) {
        auto const different = named(names);
        EXPECT_EQ(different.shared.most, 1) << *names.begin();
        EXPECT_TRUE(different.shared.of.empty());
        EXPECT_EQ(different.shared.among(2), 2);
        EXPECT_EQ(different.variability, fmt::format("{} recorded motions, as chosen", names.size()));
    }
}

// two rows of one file of several components, and files whose heads state one station.
TEST(Records, ComponentsOfOneStationAreFoundByTheHeads) {
    auto const several =
        std::map<std::string, std::string>{{"s.csv", "time [s],NS [gal],EW [gal]\n0,0,0\n0.01,1,3\n0.02,-20,1\n"},
                                           {"o.csv", "0,0\n0.01,10\n0.02,-20\n0.03,0\n"}};
    auto const rows = source_of(
        "source='records'\n[[records]]\nhorizontal='s.csv'\ncomponent='NS'\n[[records]]\nhorizontal='s.csv'\n"
        "component='EW'\n[[records]]\nhorizontal='o.csv'\nunit='gal'\n",
        several);
    EXPECT_EQ(rows->about().shared.of, (std::vector<std::int64_t>{0, 0, 1}));
    auto const peer = [](char const* component, int value) {
        return fmt::format(
            "PEER NGA STRONG MOTION DATABASE RECORD\nHole 01, 5/19/1940, El Centro Array #9, {}\n"
            "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   4, DT=   .0100 SEC,\n"
            " .0{} -.02 .01 0.0\n",
            component, value);
    };
    auto const of_peer = source_of("source='records'\nfiles=['one.at2','two.at2']\n",
                                   {{"one.at2", peer("180", 1)}, {"two.at2", peer("270", 3)}});
    EXPECT_EQ(of_peer->about().shared.most, 2);
}

// intervals count by the effect of uneven clusters (Kish 1965): (2^2 + 3 1^2) / 5 of a pair among five rows.
TEST(Records, OnePairAmongManyWidensLittle) {
    SharedDraws shared{2, {0, 0, 1, 2, 3}};
    EXPECT_DOUBLE_EQ(shared.effect(), 1.4);
    EXPECT_EQ(shared.among(5), 4);
    EXPECT_EQ((SharedDraws{3, {}}).effect(), 3);
}

// how records are read is each record's own where each has a table.
TEST(Records, KeysBesideTablesAreRefused) {
    expect_input_error(
        [] {
            (void)source_of("source='records'\nbaseline='mean'\n[[records]]\nhorizontal='a.csv'\nunit='gal'\n", files);
        },
        "baseline: beside [[waves.records]]");
}

TEST(Records, TablesPlaceComponents) {
    auto const source =
        source_of("source='records'\n[[records]]\nhorizontal='a.csv'\nvertical='b.csv'\nunit='m/s2'\n", files);

    auto const made = source->make(1, 0);

    EXPECT_EQ(made.motion.vertical_mps2, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(made.motion.samples(), 3U);
    EXPECT_EQ(made.label, "a.csv, vertical b.csv (components cut to 3 samples)");
    EXPECT_TRUE(made.motion.transverse_mps2.empty());
}

// a record may be scaled, all components by one factor, and the run says so.
TEST(Records, ScaleIsForAllComponents) {
    auto const one = source_of(
        "source='records'\n[[records]]\nhorizontal='a.csv'\nvertical='b.csv'\nunit='m/s2'\nscale=1.5\n", files);
    auto const made = one->make(1, 0);
    EXPECT_EQ(made.motion.horizontal_mps2, (std::vector<double>{0, 15, -30}));
    EXPECT_EQ(made.motion.vertical_mps2, (std::vector<double>{0, 1.5, 3}));
    EXPECT_EQ(made.label, "a.csv, vertical b.csv (components cut to 3 samples), times 1.5");

    auto const list = source_of("source='records'\nfiles=['a.csv','b.csv']\nunit='gal'\nscale=2\n", files);
    EXPECT_DOUBLE_EQ(list->make(1, 0).motion.horizontal_mps2[2], -0.4);
    EXPECT_EQ(list->make(1, 1).label, "b.csv, times 2");
}

// a record is brought to a model's time: accelerations stay, velocities go with the root of length.
TEST(Records, TimeOfAModel) {
    auto const scaled =
        source_of("source='records'\nfiles=['a.csv','slow.csv']\nunit='gal'\ntime_scale=0.632\n", files);
    auto const made = scaled->make(1, 0);
    auto const plain = source_of("source='records'\nfiles=['a.csv','slow.csv']\nunit='gal'\n", files);
    EXPECT_EQ(made.motion.horizontal_mps2, plain->make(1, 0).motion.horizontal_mps2);
    EXPECT_DOUBLE_EQ(made.motion.time_step_s, 0.632 * plain->make(1, 0).motion.time_step_s);
    EXPECT_EQ(made.label, "a.csv, time times 0.632");
    EXPECT_NEAR(scaled->drift(1)->end_velocity_mps, 0.632 * plain->drift(1)->end_velocity_mps, 1e-15);
    EXPECT_NE(plain->drift(1)->end_velocity_mps, 0);
    expect_input_error([] { (void)source_of("source='records'\nfiles=['a.csv']\nunit='gal'\ntime_scale=0\n", files); },
                       "time_scale");
}

// records lie in a folder of the user's, for all lists and components.
TEST(Records, FolderOfTheUsers) {
    std::map<std::string, std::string> const there{{"mine/a.csv", files.at("a.csv")},
                                                   {"mine/b.csv", files.at("b.csv")}};
    auto const list = source_of("source='records'\nfolder='mine'\nfiles=['a.csv']\nunit='gal'\n", there);
    EXPECT_EQ(list->make(1, 0).motion.samples(), 4U);
    auto const tables = source_of(
        "source='records'\nfolder='mine'\n[[records]]\nhorizontal='a.csv'\nvertical='b.csv'\nunit='gal'\n", there);
    EXPECT_EQ(tables->make(1, 0).motion.vertical_mps2.size(), 3U);
    expect_input_error([&] { (void)source_of("source='records'\nfiles=['a.csv']\nunit='gal'\n", there); },
                       "file 'a.csv'");
}

// two horizontal components may be turned to their principal axes, and the row says by how much.
TEST(Records, AxesMayBeTurned) {
    // Of strength 3 along 30 deg and 1 across, in time with nothing: x = 3 c p - s q, y = 3 s p + c q.
    std::string csv = "time_s,ax_mps2,ay_mps2\n";
    double const c = std::cos(pi / 6);
    double const s = std::sin(pi / 6);
    for (int i = 0; i <= 1000; ++i) {
        double const p = std::sin(2 * pi * i / 100.0);
        double const q = std::cos(2 * pi * i / 100.0) * (i < 1000 ? 1 : 0);
        csv += fmt::format("{},{:.17g},{:.17g}\n", i / 100.0, 3 * c * p - s * q, 3 * s * p + c * q);
    }
    std::map<std::string, std::string> const both{{"two.csv", csv}, {"a.csv", files.at("a.csv")}};
    std::string const keys = "source='records'\nfiles=['two.csv']\n";
    auto const turned = source_of(keys + "axes='principal'\n", both)->make(1, 0);
    EXPECT_NEAR(turned.turned_rad, pi / 6, 1e-3);  // the last sample's q is missing
    EXPECT_NEAR(correlation_of(turned.motion.horizontal_mps2, turned.motion.transverse_mps2), 0, 1e-12);
    EXPECT_NEAR(peak_of(turned.motion.horizontal_mps2), 3, 1e-3);
    EXPECT_NE(turned.label.find("turned by 30.0 deg to its principal axes"), std::string::npos) << turned.label;
    auto const recorded = source_of(keys, both)->make(1, 0);
    EXPECT_EQ(recorded.turned_rad, 0);
    auto const back = source_of(keys + "axes='30 deg'\n", both)->make(1, 0);
    for (std::size_t i = 0; i < recorded.motion.samples(); i += 50) {
        double const x = recorded.motion.horizontal_mps2[i];
        double const y = recorded.motion.transverse_mps2[i];
        EXPECT_NEAR(back.motion.horizontal_mps2[i], c * x + s * y, 1e-14);
        EXPECT_NEAR(back.motion.transverse_mps2[i], c * y - s * x, 1e-14);
    }
    expect_input_error(
        [&] { (void)source_of("source='records'\nfiles=['a.csv']\nunit='gal'\naxes='principal'\n", both); }, "axes",
        "nothing to turn");
}

//
TEST(Records, RefusesWhatItCannotRead) {
    auto const refuse = [](std::string const& keys, char const* where, char const* part) {
        expect_input_error([&] { (void)source_of("source='records'\n" + keys, files); }, where, part);
    };
    refuse("files=['no.csv']\nunit='gal'\n", "c.toml:2:", "'no.csv'");
    refuse("files=['bad.csv']\nunit='gal'\n", "bad.csv:2", "x");
    refuse("files=['a.csv']\nunit='kine'\n", "c.toml:3:", "not a unit of acceleration");
    refuse("files=['a.csv']\n", "a.csv", "State unit = \"gal\", \"g\" or \"m/s2\"");
    refuse("files=[]\nunit='gal'\n", "c.toml:2:", "empty");
    refuse("unit='gal'\n", "c.toml:1:", "either files or records");
    refuse("[[records]]\nhorizontal='a.csv'\nvertical='slow.csv'\nunit='gal'\n", "c.toml:4:", "time step 0.02 s");
    refuse("[[records]]\nhorizontal='a.csv'\nunit='gal'\nfilter=2\n", "c.toml:5:", "unknown key");
    refuse("files=['a.csv']\nunit='gal'\nscale=0\n", "c.toml:4:", "scale");
    refuse("files=['a.csv']\nunit='gal'\nscale='2 gal'\n", "c.toml:4:", "scale");
    refuse("files=['a.csv']\nunit='gal'\ntime_step='0.02 s'\n", "c.toml:2:", "resample = \"coarser\"");
    refuse("files=['a.csv']\nunit='gal'\ncomponents='sation'\n", "c.toml:4:", "Did you mean 'station'?");
    refuse("files=['a.csv']\nunit='gal'\ncomponents='station'\n", "a.csv", "station or direction not stated");
}

std::string at2(std::string const& component, std::string const& value) {
    return "PEER\nSomewhere, 1/16/1995, A-B, " + component + "\nACCELERATION TIME SERIES IN UNITS OF G\n"
           + "NPTS= 2, DT= .02 SEC\n 0.0 " + value + "\n";
}

// the run says which files it used.
TEST(Records, StationBringsItsOtherComponents) {
    std::map<std::string, std::string> const folder{
        {"r/a-000.AT2", at2("0", ".1")}, {"r/a-090.AT2", at2("90", ".2")}, {"r/a-DWN.AT2", at2("DWN", ".05")}};
    auto const alone = source_of("source='records'\nfiles=['r/a-000.AT2']\n", folder);
    auto const station = source_of("source='records'\nfiles=['r/a-000.AT2']\ncomponents='station'\n", folder);

    EXPECT_TRUE(alone->make(1, 0).motion.vertical_mps2.empty());
    EXPECT_EQ(alone->about().text, "1 record: r/a-000.AT2");
    auto const made = station->make(1, 0);
    EXPECT_DOUBLE_EQ(made.motion.vertical_mps2[1], -0.05 * g0);
    EXPECT_DOUBLE_EQ(made.motion.transverse_mps2[1], 0.2 * g0);
    EXPECT_EQ(station->about().text,
              "1 record: r/a-000.AT2, transverse r/a-090.AT2, vertical r/a-DWN.AT2 with its sign turned");
}

//
TEST(Records, NamedComponentsMustPointWhereTheyArePut) {
    std::map<std::string, std::string> const folder{
        {"0", at2("0", ".1")}, {"90", at2("90", ".2")}, {"D", at2("DWN", ".05")}};
    auto const source = [&](std::string const& keys) {
        return source_of("source='records'\n[[records]]\nhorizontal='0'\n" + keys, folder);
    };

    auto const made = source("transverse='90'\nvertical='D'\n")->make(1, 0);

    EXPECT_EQ(made.label, "0, transverse 90, vertical D with its sign turned");
    EXPECT_DOUBLE_EQ(made.motion.vertical_mps2[1], -0.05 * g0);
    expect_input_error([&] { (void)source("vertical='90'\n"); }, "c.toml:4:", "recorded horizontally");
    expect_input_error([&] { (void)source("transverse='D'\n"); }, "c.toml:4:", "recorded vertically");
    expect_input_error([&] { (void)source("vertical='D'\ncomponents='station'\n"); }, "c.toml:4:", "Keep one");
}

// what was recorded vertically is never the horizontal shaking, whichever key names it.
TEST(Records, VerticalRecordIsNoHorizontalShaking) {
    std::map<std::string, std::string> const folder{{"0", at2("0", ".1")},
                                                    {"U", at2("UP", ".1")},
                                                    {"D", at2("DWN", ".05")},
                                                    {"v.csv", "t,a_vertical\n0,1\n0.01,2\n"}};
    auto const refuse = [&](std::string const& keys, char const* where, char const* file) {
        expect_input_error([&] { (void)source_of("source='records'\n" + keys, folder); }, where, file,
                           "recorded vertically", "Name a horizontal record");
    };
    refuse("files=['0','U']\n", "c.toml:2:", "U: ");
    refuse("files=['D']\n", "c.toml:2:", "D: ");
    refuse("[[records]]\nhorizontal='U'\n", "c.toml:3:", "U: ");
    refuse("[[records]]\nhorizontal='U'\ntime_step='0.01 s'\n", "c.toml:3:", "U: ");
    refuse("files=['v.csv']\nunit='gal'\n", "c.toml:2:", "v.csv: ");
    EXPECT_EQ(source_of("source='records'\n[[records]]\nhorizontal='0'\nvertical='U'\n", folder)->make(1, 0).label,
              "0, vertical U");
}

// a step that no record has is said where it is read, also of one that is resampled.
TEST(Records, AnUnusualStepIsReported) {
    std::map<std::string, std::string> const slow{{"s.csv", "time,acc (gal)\n0,1\n10,-2\n20,3\n30,-1\n"},
                                                  {"m.csv", "time (ms),acc (gal)\n0,1\n10,-2\n20,3\n30,-1\n"}};
    auto const label = [&](std::string const& file) {
        return source_of("source='records'\nfiles=['" + file + "']\ntime_step='0.01 s'\n", slow)->make(1, 0).label;
    };
    EXPECT_TRUE(
        label("s.csv").starts_with("s.csv, check its unit: time step of 10 s (nothing above 0.05 Hz is in it), "
                                   "10 s read at 0.01 s"))
        << label("s.csv");
    EXPECT_EQ(label("m.csv"), "m.csv");
}

// another time step than the record's resamples it, and says so.
TEST(Records, AreResampledToAStatedStep) {
    auto const finer = source_of("source='records'\nfiles=['a.csv']\nunit='gal'\ntime_step='0.005 s'\n", files);
    auto const coarser =
        source_of("source='records'\nfiles=['a.csv']\nunit='gal'\ntime_step='0.02 s'\nresample='coarser'\n", files);

    EXPECT_EQ(finer->make(1, 0).label, "a.csv, 0.01 s read at 0.005 s along straight lines, PGA kept");
    EXPECT_EQ(finer->make(1, 0).motion.samples(), 7U);
    EXPECT_DOUBLE_EQ(finer->make(1, 0).motion.horizontal_mps2[3], -0.05);
    EXPECT_EQ(coarser->make(1, 0).motion.samples(), 2U);
    EXPECT_TRUE(
        coarser->make(1, 0).label.starts_with("a.csv, 0.01 s read at 0.02 s behind a low-pass (zero phase, up to 20 Hz "
                                              "kept, 80 dB off from 25 Hz on), PGA -"))
        << coarser->make(1, 0).label;
    EXPECT_NE(coarser->make(1, 0).label.find(", Sa from 0.3 to 10 s by "), std::string::npos);
    auto const same = source_of("source='records'\nfiles=['a.csv']\nunit='gal'\ntime_step='0.01 s'\n", files);
    EXPECT_EQ(same->make(1, 0).label, "a.csv");
}

// one motion under two names, or twice under one, is one motion; a file of before is read as it was.
TEST(Records, OneMotionTwiceIsRefused) {
    auto twice = files;
    twice["copy.csv"] = files.at("a.csv");
    for (char const* list : {"['a.csv','b.csv','a.csv']", "['a.csv','b.csv','copy.csv']"}) {
        expect_input_error(
            [&] { (void)source_of(fmt::format("source='records'\nfiles={}\nunit='gal'\n", list), twice); },
            "records 1 and 3 are one motion");
    }
    // Scaled or set later it is the same motion still.
    auto const refuse = [&](std::string const& second, char const* part) {
        expect_input_error(
            [&] {
                (void)source_of("source='records'\n[[records]]\nhorizontal='a.csv'\nunit='gal'\n[[records]]\n" + second,
                                twice);
            },
            part);
    };
    refuse("horizontal='a.csv'\nunit='gal'\nscale=2\n", "records 1 and 2 are one motion times 2 (");
    refuse("horizontal='copy.csv'\nunit='gal'\nscale=0.5\n", "records 1 and 2 are one motion times 0.5 (");
    twice["later.csv"] = "0,0\n0.01,0\n0.02,0\n0.03,10\n0.04,-20\n0.05,0\n";
    twice["early.csv"] = "0,0\n0.01,5.0001\n0.02,-10\n";
    twice["other.csv"] = "0,0\n0.01,10\n0.02,-20\n0.03,1\n";
    auto const pair = [&](char const* one, char const* other) {
        return source_of(fmt::format("source='records'\nfiles=['{}','{}']\nunit='gal'\n", one, other), twice)
            ->about()
            .available;
    };
    expect_input_error([&] { (void)pair("later.csv", "early.csv"); }, "one motion times 0.5 ");
    EXPECT_EQ(pair("later.csv", "other.csv"), 2U);
    EXPECT_EQ(pair("other.csv", "early.csv"), 2U);
}

}  // namespace
}  // namespace overturn

// Requirement R-107: the other components of a station are found by what the files say, only when asked for, and every
// file used is named; whatever is not certain is refused.
#include "motion/station.hpp"

#include "support/expect_input_error.hpp"
#include "support/temporary_folder.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

/// 100 counts of 2 gal with one peak of `peak` counts.
std::string knet(std::string const& direction, int peak, std::string const& station = "XXX008",
                 std::string const& rate = "100Hz", int samples = 100, std::string const& duration = "1") {
    std::string text = "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\n"
                       "Depth. (km)       30\nMag.              6.2\nStation Code      "
                       + station
                       + "\nStation Lat.      41.0840\nStation Long.     141.2552\nStation Height(m) 17\n"
                         "Record Time       2018/01/24 19:51:36\nSampling Freq(Hz) "
                       + rate + "\nDuration Time(s)  " + duration + "\nDir.              " + direction
                       + "\nScale Factor      2000(gal)/1000\nMax. Acc. (gal)   " + std::to_string(2 * peak)
                       + ".0\nLast Correction   2018/01/24 19:51:36\nMemo.             \n";
    for (int i = 0; i < samples; ++i) {
        text += fmt::format("{:8d} ", i == 40 ? peak : i == 41 ? -peak : 0) + (i % 8 == 7 ? "\n" : "");
    }
    return text;
}

using Contents = std::map<std::string, std::string>;

Contents const three{{"r/x.EW", knet("E-W", 10)}, {"r/x.NS", knet("N-S", 20)}, {"r/x.UD", knet("U-D", 5)}};

PlacedRecord read(Contents const& contents, std::string const& name = "r/x.NS",
                  ComponentChoice choice = ComponentChoice::station) {
    InputFiles files(contents);
    return StationFiles(files).read(name, {.components = choice});
}

Contents with(Contents contents, std::string const& name, std::string const& content) {
    contents[name] = content;
    return contents;
}

TEST(Station, NothingIsPickedUpUnasked) {
    auto const placed = read(three, "r/x.NS", ComponentChoice::file);

    EXPECT_EQ(placed.says, "r/x.NS");
    EXPECT_TRUE(placed.motion.vertical_mps2.empty());
    EXPECT_TRUE(placed.motion.transverse_mps2.empty());
}

TEST(Station, OtherComponentsAreFoundByTheirHeaders) {
    auto contents = with(three, "r/another.NS", knet("N-S", 7, "XXX009"));
    contents["q/x.UD"] = knet("U-D", 9);  // another folder
    contents["r/notes.txt"] = "notes";

    auto const placed = read(contents);

    EXPECT_EQ(placed.says, "r/x.NS, transverse r/x.EW, vertical r/x.UD");
    EXPECT_DOUBLE_EQ(placed.motion.horizontal_mps2[40], 0.4);
    EXPECT_DOUBLE_EQ(placed.motion.transverse_mps2[40], 0.2);
    EXPECT_DOUBLE_EQ(placed.motion.vertical_mps2[40], 0.1);
    EXPECT_EQ(read(contents, "r/x.EW").says, "r/x.EW, transverse r/x.NS, vertical r/x.UD");
}

TEST(Station, KiknetDepthsStayApart) {
    Contents const six{{"x.NS1", knet("1", 1)}, {"x.EW1", knet("2", 2)}, {"x.UD1", knet("3", 3)},
                       {"x.NS2", knet("4", 4)}, {"x.EW2", knet("5", 5)}, {"x.UD2", knet("6", 6)}};
    EXPECT_EQ(read(six, "x.NS2").says, "x.NS2, transverse x.EW2, vertical x.UD2");
    EXPECT_EQ(read(six, "x.NS1").says, "x.NS1, transverse x.EW1, vertical x.UD1");
}

TEST(Station, CutsAndGapsAreReported) {
    auto const shorter = with(three, "r/x.UD", knet("U-D", 5, "XXX008", "100Hz", 96, "0.96"));
    EXPECT_EQ(read(shorter).says, "r/x.NS, transverse r/x.EW, vertical r/x.UD, cut to 96 samples");
    EXPECT_EQ(read(shorter).motion.samples(), 96U);
    auto const two = Contents{{"r/x.EW", three.at("r/x.EW")}, {"r/x.NS", three.at("r/x.NS")}};
    EXPECT_EQ(read(two).says, "r/x.NS, transverse r/x.EW, no vertical found");
}

TEST(Station, WhatIsNotCertainIsRefused) {
    expect_input_error([] { (void)read(with(three, "r/copy.UD", three.at("r/x.UD"))); }, "'r/copy.UD' and 'r/x.UD'",
                       "one vertical component");
    expect_input_error([] { (void)read(with(three, "r/x.UD", knet("U-D", 5, "XXX008", "50Hz", 50))); },
                       "r/x.UD: ", "components must agree");
    expect_input_error([] { (void)read(three, "r/x.UD"); }, "r/x.UD: ", "Name a horizontal one");
    expect_input_error([] { (void)read({{"r/x.NS", three.at("r/x.NS")}}); }, "r/x.NS: ", "no other file of station");
    auto damaged = three;
    damaged["r/x.UD"].resize(800);
    expect_input_error([&] { (void)read(damaged); }, "r/x.UD:", "cut short");
}

TEST(Station, OnDiskOnlyTheUsedFilesAreRemembered) {
    testing::TemporaryFolder const folder;
    std::filesystem::create_directory(folder / "r");
    for (auto const& [name, content] : with(three, "r/another.UD", knet("U-D", 7, "XXX009"))) {
        testing::spill(folder / name, content);
    }
    InputFiles files(folder.path());

    auto const placed = StationFiles(files).read("r/x.NS", {.components = ComponentChoice::station});

    EXPECT_EQ(placed.says, "r/x.NS, transverse r/x.EW, vertical r/x.UD");
    EXPECT_EQ(files.contents().size(), 3U);
    EXPECT_EQ(read(files.contents()).motion.vertical_mps2, placed.motion.vertical_mps2);  // as a replay does
}

}  // namespace
}  // namespace overturn

// Requirement R-107: records as their providers publish them are read, with the peaks that are known of them. The files
// may not be redistributed: the tests look for a folder of them and skip without it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

std::optional<std::filesystem::path> records_folder() {
    if (char const* stated = std::getenv("OVERTURN_RECORDS")) {
        return stated;
    }
    if (char const* source = std::getenv("OVERTURN_SOURCE_DIR")) {
        if (auto const beside = std::filesystem::path(source) / "../shared/records"; is_directory(beside)) {
            return beside;
        }
    }
    return std::nullopt;
}

std::string bytes_of(std::string const& path) {
    std::ifstream file(*records_folder() / path, std::ios::binary);
    EXPECT_TRUE(file) << path << " is not in the folder of records";
    return {std::istreambuf_iterator<char>(file), {}};
}

PlacedRecord placed(std::string const& path, RecordRequest request = {}) {
    request.name = path;
    return read_placed(bytes_of(path), request);
}

GroundMotion read(std::string const& path, RecordRequest const& request = {}) { return placed(path, request).motion; }

double peak_gal(GroundMotion const& motion) { return peak_of(motion.horizontal_mps2) / gal; }

class RealRecords : public ::testing::Test {
    void SetUp() override {
        if (!records_folder()) {
            GTEST_SKIP() << "no folder of records: set OVERTURN_RECORDS to one";
        }
    }
};

TEST_F(RealRecords, PeerPeaks) {
    EXPECT_NEAR(peak_gal(read("peer_at2/Kobe1995_KJMA_000.AT2")), 818.1, 0.05);
    EXPECT_NEAR(peak_gal(read("peer_at2/Kobe1995_KJMA_090.AT2")), 617.5, 0.05);
    EXPECT_NEAR(peak_gal(read("peer_at2/Kobe1995_KJMA_UP.AT2")), 332.4, 0.05);
    EXPECT_NEAR(peak_gal(read("peer_at2/Kobe1995_NishiAkashi_090.AT2")), 493.0, 0.05);
    EXPECT_NEAR(peak_gal(read("peer_at2_old/ImperialValley1940_ElCentro9_180.AT2")), 306.8, 0.05);
}

TEST_F(RealRecords, PeerStepsAndCounts) {
    auto const lazio = read("peer_at2_old/LazioAbruzzo1984_GCN_WE.AT2");
    EXPECT_EQ(lazio.time_step_s, 0.00244);
    EXPECT_EQ(lazio.samples(), 8192U);
    EXPECT_EQ(read("peer_at2_old/BorahPeak1983_ANL767_196.AT2").samples(), 1451U);
    EXPECT_EQ(read("peer_at2/Kobe1995_NishiAkashi_090.AT2").time_step_s, 0.01);
}

TEST_F(RealRecords, ProseHeadersAndTrailersAgree) {
    auto const four = read("at2_odd/ImperialValley1940_ElCentro_Peknold_4lines.AT2");
    auto const seven = read("at2_odd/ImperialValley1940_ElCentro_Peknold_7lines_trailer.at2");
    EXPECT_NEAR(peak_gal(four), 312.7, 0.05);
    EXPECT_EQ(four.horizontal_mps2, seven.horizontal_mps2);
}

TEST_F(RealRecords, LineEndTwinsAreBitEqual) {
    EXPECT_EQ(read("peer_at2_old/Northridge1994_Arleta_360_CRCRLF.at2").horizontal_mps2,
              read("peer_at2_old/Northridge1994_Arleta_360_LF.at2").horizontal_mps2);
}

TEST_F(RealRecords, MistakenFilesAreRefused) {
    expect_input_error([] { (void)read("peer_at2/Kobe1995_KJMA_NS_wrongheader.AT2"); }, "10102", "2567");
    expect_input_error([] { (void)read("peer_at2/Kobe1995_KJMA_000.VT2"); }, ".VT2:3: ", "velocity");
}

TEST_F(RealRecords, KnetPeaksAreTheHeadersToTheLastDigit) {
    auto const printed = [](GroundMotion const& motion) { return fmt::format("{:.3f}", peak_gal(motion)); };
    EXPECT_EQ(printed(read("knet_ascii/AomoriOff2018_AOM008_NS.NS")), "36.185");
    EXPECT_EQ(printed(read("knet_ascii/AomoriOff2018_AOM008_EW.EW")), "30.248");
    for (char const* path : {"knet_ascii/AomoriOff2018_AOM008_UD.UD", "kiknet_ascii/Kushiro2000_ABSH01_EW2.EW2"}) {
        auto const bytes = bytes_of(path);
        auto const line = bytes.substr(bytes.find("Max. Acc. (gal)") + 18);
        EXPECT_EQ(fmt::format("{:.3f}", peak_gal(read(path))),
                  fmt::format("{:.3f}", std::strtod(line.c_str(), nullptr)))
            << path;
    }
    EXPECT_EQ(read("kiknet_ascii/Kushiro2000_ABSH01_EW2.EW2").time_step_s, 0.005);
}

TEST_F(RealRecords, JmaHoldsThreeComponents) {
    auto const otemachi = placed("jma_csv/Tohoku2011_TokyoOtemachi.csv");

    EXPECT_EQ(otemachi.says, "NS, transverse EW, vertical UD");
    EXPECT_EQ(otemachi.motion.time_step_s, 0.01);
    EXPECT_EQ(otemachi.motion.samples(), 36000U);
    EXPECT_NEAR(peak_of(otemachi.motion.horizontal_mps2) / gal, 224.7, 0.05);
    EXPECT_NEAR(peak_of(otemachi.motion.transverse_mps2) / gal, 258.6, 0.05);
    EXPECT_NEAR(peak_of(otemachi.motion.vertical_mps2) / gal, 72.9, 0.05);
    EXPECT_EQ(peak_gal(read("jma_csv/Tohoku2011_TokyoOtemachi.csv", {.component = "EW"})),
              peak_of(otemachi.motion.transverse_mps2) / gal);
}

TEST_F(RealRecords, CsmipChannelsHaveTheirPrintedPeaks) {
    auto const parkfield = placed("csmip_v2/Coalinga1983_ParkfieldFZ14.V2");

    EXPECT_EQ(parkfield.says, "90 DEG, transverse 0 DEG, vertical UP, cut to 3250 samples");
    EXPECT_EQ(parkfield.motion.time_step_s, 0.02);
    EXPECT_NEAR(peak_of(parkfield.motion.horizontal_mps2) / gal, 267.957, 1e-9);
    EXPECT_NEAR(peak_of(parkfield.motion.transverse_mps2) / gal, 256.231, 1e-9);
    EXPECT_NEAR(peak_of(parkfield.motion.vertical_mps2) / gal, 94.805, 1e-9);
}

TEST_F(RealRecords, OthersHaveTheirPrintedPeaks) {
    EXPECT_EQ(placed("itaca_acc/LAquila2009_16839_H1.cor.acc").read_as(),
              "itaca-acc, NS, m/s2, 0.005 s, 23709 samples, 118.54 s");
    EXPECT_NEAR(peak_gal(read("itaca_acc/LAquila2009_16839_H1.cor.acc")), 67.694, 1e-6);
    auto const shafter = placed("smc/LomaPrieta1989_SF1295Shafter_270.smc");
    EXPECT_EQ(shafter.read_as(), "smc, 270, gal, 0.005 s, 6004 samples, 30.015 s");
    EXPECT_NEAR(peak_gal(shafter.motion), 70.437, 1e-3);
    auto const guangfu = placed("cwa_dat/Hualien2018_EGF.dat");
    EXPECT_EQ(guangfu.says, "N, transverse E, vertical U");
    EXPECT_NEAR(peak_of(guangfu.motion.vertical_mps2) / gal, 7.118, 1e-9);
    auto const concord = placed("csmip_v2/CE58667_newer_layout.V2");
    EXPECT_EQ(concord.says, "H1, transverse H2, vertical Up");
    EXPECT_NEAR(peak_gal(concord.motion), 27.114, 1e-3);
    expect_input_error([] { (void)read("itaca_acc/LAquila2009_16839_H1.cor.acc", {.unit_mps2 = gal}); },
                       "unit m/s2 in the file, gal stated");
}

// Every file of the folder is read, or refused for the reason that is known of it.
TEST_F(RealRecords, NoFileIsLeftUndecided) {
    std::map<std::string, std::string> const refused{{"Kobe1995_KJMA_NS_wrongheader.AT2", "2567 values where NPTS"},
                                                     {"Kobe1995_KJMA_000.VT2", "a velocity series"}};
    int seen = 0;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(*records_folder())) {
        if (!entry.is_regular_file() || entry.path().extension() == ".md") {
            continue;
        }
        ++seen;
        auto const path = relative(entry.path(), *records_folder()).string();
        bool const columns = path.starts_with("csv_two_column");
        RecordRequest request;
        request.unit_mps2 = columns ? std::optional(path.find("ChiChi") != std::string::npos ? g0 : gal) : std::nullopt;
        auto const why = refused.find(entry.path().filename().string());
        if (why != refused.end()) {
            expect_input_error([&] { (void)read(path, request); }, path + ":", why->second);
            continue;
        }
        auto const motion = read(path, request);
        EXPECT_GT(motion.samples(), 1000U) << path;
        EXPECT_GT(peak_gal(motion), 0.1) << path;
        EXPECT_LT(peak_gal(motion), 1000) << path;
    }
    EXPECT_GE(seen, 19);
}

TEST_F(RealRecords, TwoColumnPeaksInTheStatedUnit) {
    auto const el_centro = read("csv_two_column/ImperialValley1940_ElCentro_NS.csv", {.unit_mps2 = gal});
    EXPECT_NEAR(peak_gal(el_centro), 341.7, 0.05);
    EXPECT_NEAR(el_centro.time_step_s, 0.02, 1e-15);
    EXPECT_NEAR(peak_gal(read("csv_two_column/ChiChi1999_TCU068_090.csv", {.unit_mps2 = g0})), 555, 0.5);
    EXPECT_NEAR(peak_gal(read("csv_two_column/ChiChi1999_TCU068_090.csv")), 555, 0.5);  // line 2 states g
}

}  // namespace
}  // namespace overturn

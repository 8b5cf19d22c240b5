// Requirement: records as their providers publish them are read, with the peaks that are known of them. The files may
// not be redistributed: the tests look for a folder of them and skip without it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"

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

GroundMotion read(std::string const& path, RecordRequest request = {}) {
    std::ifstream file(*records_folder() / path, std::ios::binary);
    EXPECT_TRUE(file) << path << " is not in the folder of records";
    request.name = path;
    return read_record(std::string(std::istreambuf_iterator<char>(file), {}), request);
}

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

TEST_F(RealRecords, KnetPeaksAreTheHeaders) {
    EXPECT_NEAR(peak_gal(read("knet_ascii/AomoriOff2018_AOM008_NS.NS")), 36.185, 0.0005);
    EXPECT_NO_THROW((void)read("knet_ascii/AomoriOff2018_AOM008_EW.EW"));
    EXPECT_NO_THROW((void)read("knet_ascii/AomoriOff2018_AOM008_UD.UD"));
    EXPECT_EQ(read("kiknet_ascii/Kushiro2000_ABSH01_EW2.EW2").time_step_s, 0.005);
}

TEST_F(RealRecords, TwoColumnPeaksInTheStatedUnit) {
    auto const el_centro = read("csv_two_column/ImperialValley1940_ElCentro_NS.csv", {.unit_mps2 = gal});
    EXPECT_NEAR(peak_gal(el_centro), 341.7, 0.05);
    EXPECT_NEAR(el_centro.time_step_s, 0.02, 1e-15);
    EXPECT_NEAR(peak_gal(read("csv_two_column/ChiChi1999_TCU068_090.csv", {.unit_mps2 = g0})), 555, 0.5);
    expect_input_error([] { (void)read("csv_two_column/ChiChi1999_TCU068_090.csv"); }, "unit missing");
}

}  // namespace
}  // namespace overturn

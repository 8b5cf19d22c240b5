// Requirement R-107: files as networks and programs of many countries write them: each is recognised, and read with its
// own unit, step, components and peak, or refused with the reason that is its own.
#include <string>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/read_record.hpp"
#include "support/record_forms.hpp"

namespace overturn {
namespace {

constexpr double gal = 0.01;
using testing::expect_contradictions;
using testing::expect_read;
using testing::Form;
using testing::refuse;

std::string volume_two(std::string const& peak = "-3.00000") {
    return "CORRECTED ACCELEROGRAM  IIAB001  94.610.0 COMP N08W   FILE   0  CORRESPONDING T\n"
           "     4  INSTRUMENT AND BASELINE CORRECTED DATA\nPEAK ACCELERATION =  "
           + peak
           + "  CMS/SEC/SEC AT    0.040   SEC.\n    0    2\n     4 POINTS OF ACC DATA EQUALLY SPACED AT   .020 SEC.  IN "
             "UNITS CM/SEC/SEC\n     1.000     2.000    -3.000      .500\n     4 POINTS OF VEL DATA EQUALLY SPACED AT   "
             ".020 SEC.  IN UNITS CM/SEC\n     1.000     2.000    -3.000      .500\n     4 POINTS OF DIS DATA EQUALLY "
             "SPACED AT   .020 SEC.  IN UNITS CM\n     1.000     2.000    -3.000      .500\n";
}

std::string nsmn(int count = 3, std::string const& peak = "3.5") {
    return fmt::format(
        "STRONG GROUND MOTION RECORDS OF TURKIYE\r\nPLACE                   : STATION A\xDDX\r\n"
        "STATION ID              : 0000\r\nNUMBER OF DATA          : {}\r\n"
        "SAMPLING INTERVAL (sec) : 0.01\r\nRAW PGA VALUES (gal)    : (N-S) {} (E-W) 2.5 (U-D) 9.0\r\n"
        "       N-S          E-W          U-D\r\n    1.0      -1.8    -0.7\r\n    -3.5      -1.7    9.0\r\n"
        "    3.0      2.5    0.1\r\n",
        count, peak);
}

std::string csmnc(std::string const& unit = "CM/SEC/SEC") {
    return "000AAA000000000000\n0000000000000 2012-01-01 00:00:00 BTM\nMAGNITUDE  4.0(Ms)\nCOMP. EW\n"
           "UNCORRECTED ACCELERATION          UNIT: "
           + unit
           + "\nNO. OF POINTS:  9  EQUALLY SPACED INTERVALS OF:  0.005  SEC\nPEAK VALUE:    5.000   AT   0.02 SEC    "
             "DURATION:  20 SEC\nCSMNC\n\n-1.0E+00  2.0E+00-3.0E+00 4.0E+00 5.0E+00 1.0E+00 2.0E+00 1.0E+00\n 1.0E+00\n";
}

std::string bbp(std::string const& unit) {
    return "# Sim stat=a\n#    time(sec)      N-S(" + unit + ")      E-W(" + unit + ")      U-D(" + unit
           + ")\n0.0e+00   -2.0e+00   -1.8e+01   2.5e+01\n5.0e-03   4.0e+00   -2.1e+01   3.6e+01\n"
             "1.0e-02   -5.0e+00   2.4e+01   4.7e+01\n";
}

std::string list_of(std::string const& unit) {
    return "TIMESERIES XX_STA__HNN_R, 7 samples, 200 sps, 2020-01-01T00:00:00.000000, SLIST, FLOAT, " + unit
           + "\n+1.0e+00\t-2.0e+00\t-4.0e+00\t1.0e+00\t2.0e+00\t3.0e+00\n+1.0e-00\n";
}

std::string pairs_of(std::string const& unit) {
    std::string text = "TIMESERIES XX_STA__HNN_R, 4 samples, 200 sps, 2020-01-31T23:59:59.990000, TSPAIR, FLOAT, "
                       + unit + "\n2020-01-31T23:59:59.990000  +1.0e+00\n2020-01-31T23:59:59.995000  -2.0e+00\n";
    return text + "2020-02-01T00:00:00.000000  +3.0e+00\n2020-02-01T00:00:00.005000  -4.0e+00\n";
}

/// \param name of the component \param rest velocity and displacement of a corrected file
std::string geonet(bool corrected, std::string const& name, std::string const& peak = "-4.0") {
    std::string text = (corrected ? "Corrected" : "Uncorrected") + std::string(" accelerogram A GNS Science\n");
    for (int i = 2; i <= 10; ++i) {
        text += "text\n";
    }
    text += corrected ? "Instrument corrected data at 0.020 sec intervals\n"
                      : "Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s\n";
    text += "filter\nComponent " + name + "  of some axis\nAcceleration:  Peak " + peak
            + " mm/s/s at  0.02 s     RMS   1.0 mm/s/s\nVelocity\nDisplacement\n";
    for (int i = 0; i < 100; ++i) {
        text += fmt::format("{:>8}{}",
                            i == 30 || (corrected && i >= 33 && i <= 35) ? "3"
                            : i == 64                                    ? "0.0050"
                            : i == 65                                    ? "0.0200"
                                                                         : "0.0",
                            i % 10 == 9 ? "\n" : "");
    }
    std::string const values = "     1.0    -4.0     3.0\n";
    return text + values + (corrected ? values + values : "");
}

std::string numbers_of_volume_one() {
    std::string text;
    for (int i = 0; i < 14; ++i) {
        text += "    0    0\n";
    }
    return text;
}

std::string bhrc(std::string const& name, std::string const& unit = "G/10") {
    return "* VOL1DS FILE:  0000/01\nInst Type\nOrigin Time\n\n" + name + "\n\nCOMP " + name
           + "1\nA Place  Station\nEpicenter\nINSTR PERIOD =  .019 SEC\nNO. OF POINTS =      3      DURATION =    "
             "0.015\nUNITS ARE SECONDS AND "
           + unit + "\n\n" + numbers_of_volume_one() + "  .100000E+01 -.400000E+01  .300000E+01\n/&\n";
}

std::string renadic(std::string const& name, std::string const& peak = "-0.400") {
    return "UNCORRECTED ACCELEROGRAM DATA\nX\nX\nX\nSTATION NO.\nPLACE S/N 1\nCHAN  1: " + name
           + "       (STA CHN:  1)\nUNIVERSIDAD DE CHILE - RENADIC\nHYPOCENTER:\nINSTR PERIOD = 0.0390 SEC\n"
             "NO. OF POINTS =      3  RECORD LENGTH =  0.030 SEC\nUNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  = "
           + peak + " G, AT   0.010 SEC\nRMS\n" + numbers_of_volume_one()
           + "  0.000  1.000  0.010 -4.000  0.020  3.000\n/&  ----------  END OF DATA FOR CHANNEL 1  ----------\n";
}

std::string asa2(std::string const& count = "3", std::string const& peaks = "/9.0/-4.0/5.0") {
    return "******\n   INSTITUTO\nARCHIVO ESTANDAR DE ACELERACION:\nNUMERO DE CANALES                      : 3\n"
           "ORIENTACION C1-C6 (rumbo;orientacion)  : /V/N00E/N90E\nESC. COMPLETA DE SENSORES, C1-C6, (g)  : /4/4/4\n"
           "INTERVALO DE MUESTREO, C1-C6 (s)       : /0.005/0.005/0.005\nNUM. TOTAL DE MUESTRAS, C1-C6          : /"
           + count + "/" + count + "/" + count + "\nACEL. MAX.(Gal), C1-C6                 : " + peaks
           + "\nUNIDADES DE LOS DATOS                  : Gal (cm/s/s)\nDATOS DE ACELERACION:\n---------+---------\n"
             "   CANAL-1   CANAL-2   CANAL-3\n         V      N00E      N90E\n---------+---------\n"
             "    9.0000    1.0000    5.0000\n    1.0000   -4.0000    1.0000\n   -2.0000    3.0000    2.0000\n";
}

std::string const rows = "0.000  -2.0\n0.005  4.0\n0.010  -3.0\n";

// In the order in which a reader may look them up.
std::vector<Form> forms() {
    return {
        {"NSMN/AFAD", nsmn(), "nsmn", 3.5 * gal, gal, 0.01, {"N-S", "E-W", "U-D"}},
        {"CSMNC", csmnc(), "csmnc", 5 * gal, gal, 0.005, {"EW"}},
        {"USC Vol. II", volume_two(), "csmip-v2", 3 * gal, gal, 0.02, {"N08W"}},
        {"BBP", bbp("cm/s/s"), "bbp", 5 * gal, gal, 0.005, {"N-S(cm/s/s)", "E-W(cm/s/s)", "U-D(cm/s/s)"}},
        {"GeoNet V1A", geonet(false, "Up") + geonet(false, "N28W"), "geonet", 4e-3, 1e-3, 0.005, {"N28W", "Up"}},
        {"GeoNet V2A",
         geonet(true, "S62W") + geonet(true, "N28W") + geonet(true, "Up"),
         "geonet",
         4e-3,
         1e-3,
         0.02,
         {"S62W", "N28W", "Up"}},
        {"BHRC", bhrc("V") + bhrc("T") + bhrc("L"), "vol1", 4 * 0.1 * g0, 0.1 * g0, 0.005, {"T", "L", "V"}},
        {"RENADIC", renadic("EW") + renadic("V"), "vol1", 4 * 0.1 * g0, 0.1 * g0, 0.01, {"EW", "V"}},
        {"ASA 2.0", asa2(), "asa2", 4 * gal, gal, 0.005, {"N00E", "N90E", "V"}},
        {"EarthScope SLIST", list_of("M/S**2"), "earthscope", 4, 1, 0.005, {"HNN"}},
        {"EarthScope TSPAIR", pairs_of("M/S^2"), "earthscope", 4, 1, 0.005, {"HNN"}},
        {"keys in another order",
         "type of record: accelerogram\nsampling frequency: 200.0 Hz\nnpts: 3\nunits: cm/s^2\n-----****-----\n"
         "      components: E N Z\n-----****-----\n\n -4.0  1.0  3.0\n  2.0  3.0  1.0\n 1.0  2.0 -1.0\n",
         "columns",
         4 * gal,
         gal,
         0.005,
         {"E", "N", "Z"}},
        {"SeismoSignal",
         "Time [sec]    Acceleration [g]    Velocity [cm/sec]    Displacement [cm]    \n0.000    -0.2    1    0\n"
         "0.005    0.4    90    0\n0.010    -0.5    -90    0\n",
         "columns",
         0.5 * g0,
         g0,
         0.005,
         {"Acceleration [g]"}},
        {"names parted by blanks",
         "Time [sec]     Acceleration [gal]\n" + rows,
         "columns",
         4 * gal,
         gal,
         0.005,
         {"Acceleration [gal]"}},
        {"OpenSees, prose above",
         "Record of somewhere\nprocessed by somebody\nTime[s] Accel[g]\n" + rows,
         "columns",
         4 * g0,
         g0,
         0.005,
         {"Accel[g]"}},
        {"SEED channels",
         "time,HNZ (gal),HNN (gal),HNE (gal)\n0,9,1,-3\n0.01,-8,2,3\n0.02,7,-4,5\n",
         "columns",
         4 * gal,
         gal,
         0.01,
         {"HNN (gal)", "HNE (gal)", "HNZ (gal)"}},
        {"pandas index",
         ",time,acc (gal)\n0,0.000,-2\n1,0.005,4\n2,0.010,-3\n",
         "columns",
         4 * gal,
         gal,
         0.005,
         {"acc (gal)"}},
        {"a step above values",
         "Acceleration (gal)\nTime Step: 0.005\n-2\n4\n-3\n",
         "columns",
         4 * gal,
         gal,
         0.005,
         {""}},
        {"eqsig: count and step above values",
         "test-motion in m/s2\n3 0.0100\n-2\n4\n-3.\n",
         "columns",
         4,
         1,
         0.01,
         {""}},
        {"SIMQKE: step and count above values",
         "test (g)\n0.0100 3\n-.2\n.4\n-.3\n",
         "columns",
         0.4 * g0,
         g0,
         0.01,
         {""}},
        {"step and count above values in rows",
         "test (g)\n0.0100 10\n-.2 .4 -.3 .1 0\n.1 -.1 .2 -.2 0\n",
         "columns",
         0.4 * g0,
         g0,
         0.01,
         {""}},
        {"step and count above times and values",
         "test (g)\n0.0100 4\n0.00 -0.2\n0.01 0.4\n0.02 -0.3\n0.03 0.1\n",
         "columns",
         0.4 * g0,
         g0,
         0.01,
         {""}},
    };
}

TEST(TableFormats, AreReadByTheirText) { expect_read(forms()); }

// a unit or a step that differs from what the file states is an error in each of them.
TEST(TableFormats, NothingStatedOverridesThem) { expect_contradictions(forms()); }

TEST(TableFormats, OtherQuantitiesAndDamageAreRefused) {
    RecordRequest const stated{.name = "f", .unit_mps2 = 1, .time_step_s = 0.005};
    refuse(bbp("cm/s"), "a velocity", stated);
    refuse(bbp("cm"), "time", {.name = "f"});
    refuse(list_of("M/S"), "velocities", stated);
    refuse(list_of("Counts"), "counts", stated);
    refuse(pairs_of("M/S"), "velocities", stated);
    refuse(nsmn(4), "4 samples stated, 3 found");
    refuse(csmnc("CM/SEC"), "velocities");
    refuse(volume_two("-30.0000"), "peak of 3 gal where the header says 30");
    refuse(geonet(true, "Up", "-40.0"), "where the header says 4");
    refuse(geonet(true, "Up").substr(0, geonet(true, "Up").size() - 12), "a finite number");
    refuse(bhrc("L", "G"), "another unit than G/10");
    refuse(renadic("L", "-0.040"), "where the header says 39");
    refuse(asa2("4"), "3 rows where the header promises 4");
    refuse(asa2("3", "/9.0/-4.5/5.0"), "where the header says 4.5");
    refuse("a name\n4 0.0100\n-2\n4\n-3\n", "a count and a time step stand there", stated);
    refuse("Time Step: 0.005\n-2\n4\n-3\n", "contradict", {.name = "f", .unit_mps2 = 1, .time_step_s = 0.01});
}

// GeoNet's step stands in its numbers and in its text: in either alone, and the same in both.
TEST(TableFormats, GeoNetStatesItsStepTwice) {
    auto const without = [](std::string text, char const* number) {
        return text.replace(text.find(number), std::string(number).size(), "0.0000");
    };
    EXPECT_EQ(read_placed(without(geonet(true, "N28W"), "0.0200"), {.name = "f"}).motion.time_step_s, 0.02);
    EXPECT_EQ(read_placed(without(geonet(false, "N28W"), "0.0050"), {.name = "f"}).motion.time_step_s, 0.005);
    auto other = geonet(true, "N28W");
    other.replace(other.find("0.020 sec"), 5, "0.010");
    refuse(other, "f:11: time step of 0.01 s, 0.02 s in the numbers");
    auto neither = without(geonet(true, "N28W"), "0.0200");
    neither.replace(neither.find(" at 0.020 sec intervals"), 23, "");
    refuse(neither, "3 samples of 0 s (both must be above 0)");
}

// the channel of a series says whether it is vertical, and several series are not one motion.
TEST(TableFormats, EarthScopeNamesItsChannel) {
    auto vertical = list_of("M/S**2");
    vertical.replace(vertical.find("HNN"), 3, "HNZ");
    EXPECT_EQ(read_placed(vertical, {.name = "f"}).direction, Direction::up);
    EXPECT_EQ(read_placed(list_of("M/S**2"), {.name = "f"}).direction, Direction::horizontal);
    refuse(vertical + list_of("M/S**2"), "f:4: a second series");
}

// the last word of a series' line is its unit, and no stated unit overrides it.
TEST(TableFormats, EarthScopeStatesItsUnit) {
    RecordRequest const stated{.name = "f", .unit_mps2 = 1};
    for (auto const& [unit, si] : {std::pair{"M/S**2", 1.0}, {"CM/S**2", gal}, {"NM/S**2", 1e-9}, {"UM/S**2", 1e-6}}) {
        EXPECT_DOUBLE_EQ(read_recording(list_of(unit), {.name = "f"}).unit_mps2, si) << unit;
        EXPECT_DOUBLE_EQ(read_recording(pairs_of(unit), {.name = "f"}).unit_mps2, si) << unit;
    }
    refuse(list_of("CM/S**2"), "unit gal in the file, m/s2 stated", stated);
    for (std::string const unit : {"M", "CM", "RAD/S**2", "RAD/S", "V", "PA", "DEGC", "M/S", "NM/S", "KM/S**2"}) {
        refuse(list_of(unit), ("f:1: unit '" + unit + "' of the series").c_str(), stated);
        refuse(pairs_of(unit), ("f:1: unit '" + unit + "' of the series").c_str(), stated);
    }
    EXPECT_EQ(read_recording(list_of(""), stated).unit_mps2, 1);
    refuse(list_of(""), "unit missing");
}

// a count and a step in either order are distinguished, and neither is taken for a value.
TEST(TableFormats, AStepAndACountThatFitNothingAreRefused) {
    RecordRequest const stated{.name = "f", .unit_mps2 = 1, .time_step_s = 0.01};
    refuse("a name\n0.0100 4\n-2\n4\n-3\n", "f:2: 4 and 0.01 above 3 values", stated);
    refuse("0.0200 4\n0.00 -0.2\n0.01 0.4\n0.02 -0.3\n0.03 0.1\n", "time step 0.02 s where the times rise by 0.01 s",
           {.name = "f", .unit_mps2 = 1});
}

// rows behind the promised ones are left out, and listed.
TEST(TableFormats, RowsTooManyAreListed) {
    auto const placed = read_placed(asa2("2"), {.name = "f"});
    EXPECT_EQ(placed.motion.samples(), 2U);
    EXPECT_EQ(placed.unread, std::vector<std::string>{"line 18: 1 rows more than the header promises, left out"});
}

}  // namespace
}  // namespace overturn

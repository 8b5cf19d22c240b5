// Requirement R-107: the European and Italian archives' files (DYNA .ASC and .acc) are read by their headers' keys, and
// what a header does not say is asked for.
#include <string>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string dyna(std::string const& from = "", std::string const& to = "", std::string const& values = "") {
    std::string header =
        "EVENT_NAME: SOMEWHERE: NEAR\nEVENT_ID: TEST-0001\nEVENT_DATE_YYYYMMDD: 2010/11/14\n"
        "NETWORK: TK\nSTATION_CODE: 1001\nSTATION_ELEVATION_M: \n"
        "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20000823_134250.000\nSAMPLING_INTERVAL_S: 0.005000\n"
        "NDATA: 6\nDURATION_S: 0.025\nSTREAM: HNE\nUNITS: cm/s^2\nPGA_CM/S^2: -50.000000\n"
        "TIME_PGA_S: 0.020000\nHEADER_FORMAT: DYNA 1.2\nDATA_TYPE: ACCELERATION\nUSER5: \n";
    if (!from.empty()) {
        header.replace(header.find(from), from.size(), to);
    }
    return header + (values.empty() ? "10.0\n-20.0\n+30.0\n.0\n-5.D+01\n 40.000000 \n" : values);
}

std::vector<double> const six{10 * 0.01, -20 * 0.01, 30 * 0.01, 0.0, -50 * 0.01, 40 * 0.01};

GroundMotion read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.ASC";
    return testing::read_record(content, request);
}

TEST(EsmDyna, KeysThenValues) {
    EXPECT_EQ(read(dyna()).horizontal_mps2, six);
    EXPECT_EQ(read(dyna()).time_step_s, 0.005);
    EXPECT_EQ(read(dyna("cm/s^2", "m/s2")  // and then the printed peak is wrong
                       .replace(dyna("cm/s^2", "m/s2").find("PGA_CM/S^2"), 10, "PGA_OTHER_"))
                  .horizontal_mps2[0],
              10);
    auto const recording = read_recording(dyna("HNE", "HNZ"), {});
    EXPECT_EQ(recording.components[0].direction, Direction::up);
    EXPECT_EQ(station_of_record(dyna()), station_of_record(dyna("HNE", "HNZ")));
    EXPECT_NE(station_of_record(dyna()), station_of_record(dyna("1001", "1002")));
}

TEST(EsmDyna, DamageIsRefusedWithItsLine) {
    expect_input_error([] { (void)read(dyna("NDATA: 6", "NDATA: 7")); }, "a.ASC:23: ", "6 values where NDATA");
    expect_input_error([] { (void)read(dyna("ACCELERATION", "VELOCITY")); }, "a.ASC:16: ", "'VELOCITY'");
    expect_input_error([] { (void)read(dyna("cm/s^2", "cm/s")); }, "a.ASC:12: ", "acceleration file");
    expect_input_error([] { (void)read(dyna("0.005000", "0")); }, "a.ASC:8: ", "above 0");
    expect_input_error([] { (void)read(dyna("0.005000", "nan")); }, "a.ASC:8: ", "not a finite number");
    expect_input_error([] { (void)read(dyna("0.005000", "")); }, "SAMPLING_INTERVAL_S: missing");
    expect_input_error([] { (void)read(dyna("-50.000000", "-51.000000")); }, "a.ASC:13: ", "51");
    expect_input_error([] { (void)read(dyna("", "", "10.0\n-20.0\ninf\n0\n-50\n40\n")); }, "a.ASC:20: ", "'inf'");
    expect_input_error([] { (void)read(dyna(), {.unit_mps2 = 1}); }, "a.ASC:12: ", "contradict");
}

std::string itaca(std::string const& from = "", std::string const& to = "") {
    std::string text =
        "Event : SOMEWHERE\nDate : 06/04/2009\nStation : ABC\nComponent : WE\nUnit : m/s2\n"
        "Sampling rate (Hz) : 200\nNumber of samples : 6\nFilter : 0.1-30 Hz\nProcessing : manual\n"
        "Remarks : none\n"
        " 1.2456000E-06-5.9452000E-06 3.0000000E-01 0.0000000E+00-5.0000000E-01\n 4.0000000E-01\n";
    if (!from.empty()) {
        text.replace(text.find(from), from.size(), to);
    }
    return text;
}

TEST(ItacaAcc, PackedValuesInMetres) {
    auto const motion = read(itaca());
    EXPECT_EQ(motion.horizontal_mps2, (std::vector{1.2456e-6, -5.9452e-6, 0.3, 0.0, -0.5, 0.4}));
    EXPECT_EQ(motion.time_step_s, 0.005);
    EXPECT_EQ(read(itaca("Sampling rate (Hz) : 200", "Sampling interval : 0.01 s")).time_step_s, 0.01);
}

// the archive's files as they are in the wild, whose tenth line is prose and whose words are others.
TEST(ItacaAcc, ProseMayEndTheHeader) {
    std::string const wild =
        "Event Date & Time             : 2009-04-06 01:32:39\nStation Code / Name           : 3620 / Somewhere\n"
        "Network                       : DPC\nOrientation                   : NS\nProcessing Info               : "
        "none\n"
        "Filter Cut-off Frequency (Hz) : 0.050 - 65.000\nTime Increment (s)            : 0.005\n"
        "Number of Data                : 6\nPGA (m/s/s)                   : 5.0000000E-01\n"
        "Accelaration time series in m/s/s\n"
        " 1.2456000E-06-5.9452000E-06 3.0000000E-01 0.0000000E+00-5.0000000E-01\n 4.0000000E-01\n";
    auto const recording = read_recording(wild, {.name = "a.acc"});
    EXPECT_EQ(recording.format, "itaca-acc");
    EXPECT_EQ(recording.time_step_s, 0.005);
    EXPECT_EQ(recording.components[0].name, "NS");
    EXPECT_EQ(recording.components[0].direction, Direction::horizontal);
    EXPECT_EQ(recording.components[0].acceleration_mps2[4], -0.5);
    auto columns = wild.substr(0, wild.find(" 1.2456"));
    columns += "0 1\n0.005 2\n0.01 3\n0.015 4\n0.02 5\n";
    expect_input_error([&] { (void)read_recording(columns, {.name = "a.acc"}); }, "a.acc");
    auto other = wild;
    other.replace(other.find("5.0000000E-01"), 13, "6.0000000E-01");
    expect_input_error([&] { (void)read_recording(other, {.name = "a.acc"}); },
                       "a.acc:9: ", "where the header says 60");
    expect_input_error([&] { (void)read_recording(wild, {.name = "a.acc", .unit_mps2 = 0.01}); },
                       "unit m/s2 in the file, gal stated");
    expect_input_error([&] { (void)read_recording(wild, {.name = "a.acc", .time_step_s = 0.02}); }, "contradict");
}

/// With such a line of the peak, and such a last one.
std::string itaca_wild(std::string const& peak, std::string const& last) {
    return "Event Date & Time : 2009-04-06\nStation Code / Name : 1 / Somewhere\nNetwork : X\nOrientation : NS\n"
           "Processing Info : sensor of m/s/s\nFilter Cut-off Frequency (Hz) : 0.050 - 65.000\n"
           "Time Increment (s) : 0.005\nNumber of Data : 6\n"
           + peak + "\n" + last
           + "\n 1.2456000E-02-5.9452000E-02 3.0000000E-01 0.0000000E+00-5.0000000E-01\n 4.0000000E-01\n";
}

// the line that calls the values something states their unit, a peak is compared in its own.
TEST(ItacaAcc, OneLineStatesTheUnit) {
    auto const unit = [](std::string const& peak, std::string const& last) {
        return read_recording(itaca_wild(peak, last), {.name = "a.acc"}).unit_mps2;
    };
    std::string const metres = "Accelaration time series in m/s/s";
    EXPECT_EQ(unit("PGA (g) : 5.0000000E-01", "Accelaration time series in g"), 9.80665);
    EXPECT_EQ(unit("PGA (cm/s^2) : 0.5", "Acceleration time series in cm/s/s"), 0.01);
    EXPECT_EQ(unit("PGA (m/s/s) : 0.5", metres), 1);
    EXPECT_EQ(unit("PGA : 0.50 m/s2", metres), 1);
    EXPECT_EQ(unit("PGA (gal) : 0.5", "Final data"), 0.01);
    EXPECT_EQ(unit("Quality : good", metres), 1);
    auto const refused = [](std::string const& peak, std::string const& last, std::string const& why) {
        for (auto const stated : {std::optional<double>(), std::optional(1.0)}) {
            expect_input_error(
                [&] { (void)read_recording(itaca_wild(peak, last), {.name = "a.acc", .unit_mps2 = stated}); }, why);
        }
    };
    refused("Quality : good", "Velocity time series in m/s", "a.acc:10: velocities");
    refused("Quality : good", "Displacement time series in m", "a.acc:10: displacements");
    refused("PGV (m/s) : 5.0000000E-01", "Final data", "a.acc:9: velocities");
    refused("PGV (m/s) : 5.0000000E-01", metres, "a.acc:9: velocities");
    refused("PGD (m) : 5.0000000E-01", "Final data", "a.acc:9: displacements");
    refused("PGA (m/s) : 5.0000000E-01", metres, "a.acc:9: ");
    refused("PGA (m/s/s) : 5.0000000E-01", "Accelaration time series in cm/s/s", "a.acc:10: unit gal");
    refused("PGA (m/s/s) : 6.0000000E-01", metres, "a.acc:9: peak of 50 gal where the header says 60");
    expect_input_error([&] { (void)unit("Quality : good", "Final data"); }, "unit missing");
    expect_input_error([&] { (void)unit("PGA (m/s/s) : 0.5", "Accelaration time series in cm/s/s"); },
                       "a.acc:10: unit gal, line 9 says 'PGA (m/s/s) : 0.5'");
}

// what stands behind a number or in its key's brackets is its unit, and never passed over.
TEST(ItacaAcc, AnotherUnitOfTheStepIsRefused) {
    std::string const rate = "Sampling rate (Hz) : 200";
    for (char const* step :
         {"Sampling interval (s) : 0.005", "Sampling interval (s):5.0E-03", "Sampling interval [s] : 0.005 s",
          "Time step : .005sec", "Sampling rate : 200 Hz", "Sampling frequency : 200"}) {
        EXPECT_EQ(read(itaca(rate, step)).time_step_s, 0.005) << step;
    }
    for (char const* step : {"Sampling interval (s) : 5 ms", "Sampling interval (ms) : 5", "Sampling interval : 5ms",
                             "Sampling interval (s) : 0.005 0.005", "Sampling interval (s) : 0,005",
                             "Sampling rate (kHz) : 0.2", "Sampling rate (Hz) : 200 s", "Sampling rate : 0.2 kHz"}) {
        expect_input_error([&] { (void)read(itaca(rate, step)); }, "a.ASC:6: ", "Mend the header");
    }
    expect_input_error([] { (void)read(itaca("samples : 6", "samples : 6 thousand")); }, "a.ASC:7: ", "'thousand'",
                       "a number alone");
}

TEST(ItacaAcc, WhatTheHeaderDoesNotSayIsAskedFor) {
    expect_input_error([] { (void)read(itaca("Unit : m/s2", "Quality : good")); }, "a.ASC:10: ", "unit missing");
    expect_input_error([] { (void)read(itaca("Sampling rate (Hz) : 200", "Quality : good")); },
                       "a.ASC:10: ", "time step missing");
    EXPECT_EQ(read(itaca("Unit : m/s2", "Quality : good"), {.unit_mps2 = 0.01}).horizontal_mps2[4], -0.5 * 0.01);
    expect_input_error([] { (void)read(itaca("samples : 6", "samples : 60")); }, "a.ASC:12: ", "promises 60");
    expect_input_error([] { (void)read(itaca("(Hz) : 200", "(Hz) : 0")); }, "time step missing");
    expect_input_error([] { (void)read(itaca(), {.unit_mps2 = 0.01}); }, "contradict");
}

}  // namespace
}  // namespace overturn

// Requirement R-107: further files as networks and programs write them, read with their own unit, step and components,
// or refused by their name with what to do instead.
#include <string>
#include <vector>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/read_record.hpp"
#include "support/record_forms.hpp"

namespace overturn {
namespace {

using testing::expect_contradictions;
using testing::expect_read;
using testing::Form;
using testing::refuse;

constexpr double gal = 0.01;

/// \param peak of the second channel
std::string bri(std::string const& peak = "   -4.000", std::string const& end = "") {
    return "2001/02/03 04:05:06   3 200     9 XYZ: A building, ground floor\r\n"
           "063-GL        4.000         2     0.000     1.000\r\n"
           "     1.000     4.000    -3.000     0.000     0.000     0.000     0.000     0.000\r\n     1.000\r\n"
           "153-GL    "
           + peak
           + "         1     0.000     1.000\r\n"
             "    -4.000     1.000    -3.000     0.000     0.000     0.000     0.000     0.000\r\n     1.000\r\n"
             "UP-GL         2.500         3     0.000     1.000\r\n"
             "     1.000     1.000     2.500     0.000     0.000     0.000     0.000     0.000\r\n     1.000\r\n"
           + end;
}

std::vector<Form> forms() {
    return {
        {"BRI .ac", bri(), "bri-ac", 4 * gal, gal, 0.005, {"063-GL", "153-GL", "UP-GL"}},
        {"DEEPSOIL: count and step above times and values",
         "test (g)\n4 0.0100\n0.00 -0.2\n0.01 0.4\n0.02 -0.3\n0.03 0.1\n",
         "columns",
         0.4 * g0,
         g0,
         0.01,
         {""}},
        {"GeoCSV",
         "# sample_rate_hz: 100\n# scale_units: M/S**2\n# field_unit: UTC, M/S**2\nTime, Sample\n"
         "2020-01-01T00:00:00.000000Z, -2\n2020-01-01T00:00:00.010000Z, 4\n2020-01-01T00:00:00.020000Z, -3\n",
         "columns",
         4,
         1,
         0.01,
         {"Sample"}},
        {"KiK-net's names",
         "time,UD2 (gal),NS2 (gal),EW2 (gal)\n0,9,1,-3\n0.01,-8,2,3\n0.02,7,-4,5\n",
         "columns",
         4 * gal,
         gal,
         0.01,
         {"NS2 (gal)", "EW2 (gal)", "UD2 (gal)"}},
        {"Spanish keys",
         "# Tasa de muestreo: 100 Hz\n# Numero de muestras: 3\n# Unidades: cm/s2\n-2\n4\n-3\n",
         "columns",
         4 * gal,
         gal,
         0.01,
         {""}},
    };
}

TEST(MoreFormats, AreReadByTheirText) { expect_read(forms()); }

// a unit or a step that differs from what the file states is an error in each of them.
TEST(MoreFormats, NothingStatedOverridesThem) { expect_contradictions(forms()); }

// what is damaged, of another quantity, or of a format without a reader.
TEST(MoreFormats, DamageAndOthersAreRefused) {
    RecordRequest const stated{.name = "f", .unit_mps2 = 1, .time_step_s = 0.005};
    refuse(bri("   -4.100"), "where the header says 4.1");
    refuse(bri("      abc"), "the name of a channel and its peak");
    refuse(bri("   -4.000", "more\r\n"), "behind the last of 3 channels");
    refuse(bri().substr(0, bri().size() - 10), "finite number");
    refuse("# scale_units: M/S**2\n# field_unit: UTC, COUNTS\nTime, Sample\n0, -2\n0.01, 4\n0.02, -3\n", "counts",
           stated);
    refuse("4 0.0200\n0.00 -0.2\n0.01 0.4\n0.02 -0.3\n0.03 0.1\n", "time step 0.02 s where the times rise by 0.01 s",
           {.name = "f", .unit_mps2 = 1});
    refuse("      0.01  -12345.00  -12345.00\n  -12345.00  -12345.00  -12345.00\n1 2 3\n", "SAC, alphanumeric", stated);
    refuse(
        "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:    VOL1\nA\nUNITS ARE SEC AND G/10\n  0.0 1.0 .01 "
        "2.0\n",
        "USC Vol. I", stated);
    refuse(
        "Response and Fourier amplitude spectra (78 periods, .04 - 6.0 sec)\nCorrected accelerogram   Chan  1: 360 "
        "Deg\n",
        "f:1: response spectra", stated);
    refuse(
        "UNCORRECTED ACCELEROGRAM DATA    PROCESSED\n 4 POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)\n"
        " -.000116 -.000116 -.000116 -.000116\n",
        "CSMIP V1", stated);
    refuse("WID2 2010/02/27 06:45:00.000 ANMO  HNZ      CM6       64  100.000000\nDAT2\n", "GSE 2", stated);
}

}  // namespace
}  // namespace overturn

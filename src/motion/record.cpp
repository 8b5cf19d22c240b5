#include "motion/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/packed_files.hpp"
#include "motion/detail/record_readers.hpp"

namespace overturn {
namespace {

// A new format: one file beside this one, one line here.
// One that is a table under a head of its own is a TableFormat in a file beside this one, and a line here.
constexpr std::array formats{
    config::Entry<RecordFormat>{
        "miniseed",
        "miniSEED 2 (libmseed): one station's channels; the unit must be stated, of counts with "
        "a number: \"2.4e-6 m/s2\"",
        {&recognises_miniseed, &read_miniseed}},
    config::Entry<RecordFormat>{"peer-at2",
                                "PEER strong-motion AT2, new and old: NPTS and DT in the header, accelerations in g",
                                {&recognises_peer_at2, &read_peer_at2, &station_of_peer_at2}},
    config::Entry<RecordFormat>{"knet",
                                "K-NET and KiK-net ASCII: 17 header lines, counts with a scale factor",
                                {&recognises_knet, &read_knet, &station_of_knet}},
    config::Entry<RecordFormat>{"jma-csv",
                                "JMA csv: 7 header lines in Shift_JIS, columns NS,EW,UD in gal",
                                {&recognises_jma_csv, &read_jma_csv}},
    config::Entry<RecordFormat>{"cosmos",
                                "COSMOS v1.20 V1 and V2: headers that state their own layout; counts (V0) are refused",
                                {&recognises_cosmos, &read_cosmos, &station_of_cosmos}},
    config::Entry<RecordFormat>{
        "csmip-v2", "CSMIP/CDMG corrected data, all channels of a file", {&recognises_csmip_v2, &read_csmip_v2}},
    config::Entry<RecordFormat>{"esm-dyna",
                                "ESM/ITACA DYNA .ASC: KEY: value lines, then one value a line",
                                {&recognises_esm_dyna, &read_esm_dyna, &station_of_esm_dyna}},
    config::Entry<RecordFormat>{
        "itaca-acc", "ITACA .acc: 10 lines Key : value, then packed values", {&recognises_itaca_acc, &read_itaca_acc}},
    config::Entry<RecordFormat>{"smc",
                                "SMC (USGS): integer and real headers, then values in cm/s2",
                                {&recognises_smc, &read_smc, &station_of_smc}},
    config::Entry<RecordFormat>{
        "cwa", "CWA (Taiwan): lines #Key: value, then time and three components in gal", {&recognises_cwa, &read_cwa}},
    config::Entry<RecordFormat>{
        "nsmn", "NSMN/AFAD (Turkey): text, then N-S, E-W and U-D in gal", {nullptr, nullptr, nullptr, &nsmn_table}},
    config::Entry<RecordFormat>{"csmnc",
                                "CSMNC (China): text with unit, count and step, then one component",
                                {nullptr, nullptr, nullptr, &csmnc_table}},
    config::Entry<RecordFormat>{
        "bbp", "SCEC Broadband Platform .acc.bbp: time, N-S, E-W, U-D", {nullptr, nullptr, nullptr, &bbp_table}},
    config::Entry<RecordFormat>{"earthscope",
                                "EarthScope SLIST and TSPAIR ASCII of accelerations; counts and velocities are refused",
                                {&recognises_earthscope, &read_earthscope}},
    config::Entry<RecordFormat>{"geonet",
                                "GeoNet V1A and V2A (New Zealand): text, 100 numbers, then values in mm/s2",
                                {&recognises_geonet, &read_geonet}},
    config::Entry<RecordFormat>{"vol1",
                                "BHRC (Iran) and RENADIC (Chile) V1: uncorrected values in G/10, three channels",
                                {&recognises_vol1, &read_vol1}},
    config::Entry<RecordFormat>{
        "asa2", "ASA 2.0 (UNAM, Mexico): KEY : value lines, then columns in gal", {&recognises_asa2, &read_asa2}},
    config::Entry<RecordFormat>{"bri-ac",
                                "BRI .ac (Building Research Institute, Japan): date, channels, rate and samples, then "
                                "each channel in gal",
                                {&recognises_bri_ac, &read_bri_ac}},
    config::Entry<RecordFormat>{"refused",
                                "CSMIP V1 and V3, SAC as text, GSE: known, refused with what to do instead",
                                {&recognises_unread, &refuse_unread}},
    config::Entry<RecordFormat>{"columns",
                                "columns under names, parted by commas, semicolons, blanks or tabs: a time and one to "
                                "three components; or values alone, one or at least five to a line; unit and step as "
                                "names and text say, or as stated",
                                {&recognises_columns, &read_columns}},
    config::Entry<RecordFormat>{"components",
                                "columns of components without a time, only where stated",
                                {&recognises_components, &read_components}},
    config::Entry<RecordFormat>{
        "list", "values in reading order, any number to a line, only where stated", {&recognises_list, &read_list}},
};

config::Entry<RecordFormat> const& format_of(std::string_view content, RecordRequest const& request) {
    if (request.format != "auto") {
        return config::find_entry(record_formats(), request.format, "record format");
    }
    for (auto const& format : formats) {
        bool const table = format.value.table != nullptr;
        if (table ? has_marks(content, *format.value.table) : format.value.recognises(content)) {
            return format;
        }
    }
    std::string known;
    for (auto const& format : formats) {
        known += known.empty() ? "" : ", ";
        known += format.name;
    }
    throw InputError({request.name},
                     fmt::format("format not recognised (the content looks like none of: {}). Convert the record, for "
                                 "example to columns time,a_horizontal",
                                 known));
}

}  // namespace

std::span<config::Entry<RecordFormat> const> record_formats() { return formats; }

void state_unit(RecordRequest& request, std::string_view text) {
    auto const plain = trimmed(text);
    request.unit_has_number = plain.find_first_of("0123456789.") == 0;
    if (!request.unit_has_number) {
        request.unit_mps2 = unit_factor(plain, Dimension::acceleration);
        return;
    }
    double number = 0;
    validate(!parse_number(plain, number), "{} (a number without its unit). Write \"{} m/s2\"", plain, plain);
    request.unit_mps2 = parse_quantity(plain, Dimension::acceleration);
    validate(*request.unit_mps2 > 0 && std::isfinite(*request.unit_mps2), "{} (must be above 0). Mend it", plain);
}

/// \throws InputError at a record about 1 g: of a sensor that reads the weight too, and which way is not stated
void check_without_gravity(RecordComponent const& component, Location const& where) {
    constexpr double near = 0.2;  // tilted, or off its calibration; the mean of no complete motion comes near
    double sum = 0;
    for (double const value : component.acceleration_mps2) {
        sum += value;
    }
    double const mean_g = sum / static_cast<double>(component.acceleration_mps2.size()) / g0;
    if (std::abs(std::abs(mean_g) - 1) < near) {
        throw InputError(where,
                         fmt::format("component '{}' about {:+.3g} g (its sensor reads gravity too, or the unit is "
                                     "wrong). Take the mean off, then give it with its direction",
                                     component.name, mean_g));
    }
}

Recording read_recording(std::string_view content, RecordRequest const& request) {
    Location const file{request.name};
    if (trimmed(content).empty()) {
        throw InputError(file, "empty (no record in it). Fetch the file anew");
    }
    bool const packed_records = recognises_miniseed(content);
    if (auto const packed = packed_file(content); !packed.name.empty()) {
        throw InputError(file, fmt::format("{} ({}). {}", packed.name, packed.why, packed.advice));
    }
    if (!packed_records && content.find('\0') != std::string_view::npos) {
        throw InputError(file, "zero bytes in it (a binary or UTF-16 file). Save it as plain text");
    }
    if (request.time_step_s && !(*request.time_step_s > 0 && std::isfinite(*request.time_step_s))) {
        throw InputError(file, fmt::format("time step {} s stated (must be positive and finite). State the step of "
                                           "the samples",
                                           *request.time_step_s));
    }
    OVERTURN_EXPECT(!request.unit_mps2 || *request.unit_mps2 > 0);
    auto const& format = format_of(content, request);
    auto const* const table = format.value.table;
    auto recording = table != nullptr ? read_described(content, request, *table) : format.value.read(content, request);
    recording.format = format.name;
    for (auto const& component : recording.components) {
        check_believable_peak(component.acceleration_mps2, file);
        check_without_gravity(component, file);
    }
    return recording;
}

std::string station_of_record(std::string_view head) {
    for (auto const& format : formats) {
        if (format.value.station == nullptr || !format.value.recognises(head)) {
            continue;
        }
        try {
            auto const station = format.value.station(head);
            return station.empty() ? station : fmt::format("{}: {}", format.name, station);
        } catch (InputError const&) {
            return {};  // a velocity file, or a damaged one: of no known station
        }
    }
    return {};
}

void refuse_without_unit(Location const& where, std::string_view why, RecordRequest const& request) {
    throw InputError(where, fmt::format("unit missing ({}). State {}", why, request.unit_key));
}

void check_stated_unit(RecordRequest const& request, double file_unit_mps2, Location const& where) {
    constexpr double same = 1e-9;
    if (request.unit_mps2 && std::abs(*request.unit_mps2 - file_unit_mps2) > same * file_unit_mps2) {
        throw InputError(where, fmt::format("unit {} in the file, {} stated (they contradict each other). {}",
                                            name_of_acceleration_unit(file_unit_mps2),
                                            name_of_acceleration_unit(*request.unit_mps2), request.unit_conflict));
    }
}

void check_stated_time_step(RecordRequest const& request, double file_time_step_s, Location const& where) {
    constexpr double printed_rounding = 1e-3;
    if (request.time_step_s && !request.may_be_resampled
        && std::abs(*request.time_step_s - file_time_step_s) > printed_rounding * file_time_step_s) {
        throw InputError(where,
                         fmt::format("time step of {:.9g} s in the file, {:.9g} s stated (they contradict each other). "
                                     "Leave the stated step out",
                                     file_time_step_s, *request.time_step_s));
    }
}

void check_stated_peak(double peak_mps2, double stated_mps2, double tolerance_mps2, Location const& where) {
    constexpr double rounding = 1e-9;
    if (!(std::abs(peak_mps2 - std::abs(stated_mps2)) <= tolerance_mps2 + rounding * std::abs(stated_mps2))) {
        throw InputError(where, fmt::format("peak of {:.7g} gal where the header says {:.7g} (the file is damaged or "
                                            "cut short). Fetch it anew",
                                            peak_mps2 / gal_mps2, std::abs(stated_mps2) / gal_mps2));
    }
}

void check_last_value_is_whole(std::string_view content, Location const& where) {
    constexpr std::string_view separators = " \t,\r\n";
    auto const last_of = [&](std::string_view text) {
        auto const end = text.find_last_not_of(separators) + 1;
        text = text.substr(0, end);
        return text.substr(text.find_last_of(separators) + 1);
    };
    auto const decimals = [](std::string_view text) { return text.size() - std::min(text.rfind('.'), text.size()); };
    if (content.find_last_of(separators) + 1 == content.size()) {
        return;
    }
    auto const last = last_of(content);
    auto const before = last_of(content.substr(0, content.size() - last.size()));
    if (decimals(last) < decimals(before)) {
        throw InputError(where, fmt::format("'{}' at the end of the file (shorter than the values before it, without a "
                                            "line end: the file is cut short). Fetch it anew",
                                            last));
    }
}

void check_believable_peak(std::span<double const> acceleration_mps2, Location const& where) {
    constexpr double implausible_mps2 = 10 * g0;  // the strongest records known stay below 5 g
    if (double const peak = peak_of(acceleration_mps2); peak > implausible_mps2) {
        throw InputError(where, fmt::format("peak of {:.4g} g (no ground has shaken so: the values are hardly in the "
                                            "unit that is stated). State the right unit; where the file itself is "
                                            "wrong, convert it to columns",
                                            peak / g0));
    }
}

}  // namespace overturn

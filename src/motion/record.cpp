#include "motion/record.hpp"

#include <array>
#include <cmath>

#include "core/units.hpp"
#include "motion/record_readers.hpp"

namespace overturn {
namespace {

// A new format: one file beside this one, one line here.
constexpr std::array formats{
    config::Entry<RecordFormat>{"peer-at2",
                                "PEER strong-motion AT2: NPTS and DT in the header, accelerations in g",
                                {&recognises_peer_at2, &read_peer_at2}},
    config::Entry<RecordFormat>{
        "knet", "K-NET and KiK-net ASCII: 17 header lines, counts with a scale factor", {&recognises_knet, &read_knet}},
    config::Entry<RecordFormat>{"columns",
                                "columns [time,] a_horizontal [, a_vertical] parted by commas, blanks or tabs, with a "
                                "stated unit",
                                {&recognises_columns, &read_columns}},
};

config::Entry<RecordFormat> const& format_of(std::string_view content, RecordRequest const& request) {
    if (request.format != "auto") {
        return config::find_entry(record_formats(), request.format, "record format");
    }
    for (auto const& format : formats) {
        if (format.value.recognises(content)) {
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

GroundMotion read_record(std::string_view content, RecordRequest const& request) {
    Location const file{request.name};
    if (trimmed(content).empty()) {
        throw InputError(file, "empty (no record in it). Fetch the file anew");
    }
    if (content.find('\0') != std::string_view::npos) {
        throw InputError(file, "zero bytes in it (a binary or UTF-16 file). Save it as plain text");
    }
    if (request.time_step_s && !(*request.time_step_s > 0 && std::isfinite(*request.time_step_s))) {
        throw InputError(file, fmt::format("time step {} s stated (must be positive and finite). State the step of "
                                           "the samples",
                                           *request.time_step_s));
    }
    OVERTURN_EXPECT(!request.unit_mps2 || *request.unit_mps2 > 0);
    auto motion = format_of(content, request).value.read(content, request);
    validate_motion(motion);
    return motion;
}

void check_stated_unit(RecordRequest const& request, double file_unit_mps2, Location const& where) {
    constexpr double same = 1e-9;
    if (request.unit_mps2 && std::abs(*request.unit_mps2 - file_unit_mps2) > same * file_unit_mps2) {
        throw InputError(where, fmt::format("unit of {} m/s2 in the file, {} m/s2 stated (they contradict each "
                                            "other). Leave the stated unit out",
                                            file_unit_mps2, *request.unit_mps2));
    }
}

void check_stated_time_step(RecordRequest const& request, double file_time_step_s, Location const& where) {
    constexpr double printed_rounding = 1e-3;
    if (request.time_step_s
        && std::abs(*request.time_step_s - file_time_step_s) > printed_rounding * file_time_step_s) {
        throw InputError(where, fmt::format("time step of {} s in the file, {} s stated (they contradict each other). "
                                            "Leave the stated step out",
                                            file_time_step_s, *request.time_step_s));
    }
}

}  // namespace overturn

#include <array>
#include <string>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// A known format without a reader: what stands in one of its first lines, and what to do instead.
struct UnreadFormat {
    std::string_view words;  // lower case; they begin the line
    std::string_view name;
    std::string_view advice;
    bool anywhere = false;  // in the line
};

constexpr std::array unread{
    UnreadFormat{"uncorrected accelerogram data of volume i", "uncorrected accelerogram, unevenly sampled (USC Vol. I",
                 "Take the corrected Vol. II file of the same record", true},
    UnreadFormat{"response and fourier", "response spectra (CSMIP V3; no motion is in them",
                 "Take the V2 file of the same record"},
    UnreadFormat{"uncorrected accelerogram", "uncorrected accelerogram (CSMIP V1",
                 "Take the corrected V2 file of the same record"},
    UnreadFormat{"corrected accelerogram", "corrected accelerogram of a layout that is not known",
                 "Convert one component to columns and state the unit"},
    UnreadFormat{"response spectra", "response spectra (CSMIP V3; no motion is in them",
                 "Take the V2 file of the same record"},
    UnreadFormat{"* vol", "BHRC of a volume other than 1, or in another unit than G/10",
                 "Convert one component to columns and state the unit"},
    UnreadFormat{"-12345.0", "SAC, alphanumeric (-12345 stands for what is not known",
                 "Convert it to columns time,a_horizontal in m/s2, for example with ObsPy"},
    UnreadFormat{"wid2 ", "GSE 2 or IMS 1.0 waveforms, packed counts of an instrument",
                 "Convert it to columns time,a_horizontal in m/s2, for example with ObsPy"},
    UnreadFormat{"wid1 ", "GSE 1 waveforms, packed counts of an instrument",
                 "Convert it to columns time,a_horizontal in m/s2, for example with ObsPy"},
    UnreadFormat{"#data:", "columns of CWA's layout without its rate (time, U, N, E",
                 "Bring the columns into the order time,a_horizontal,a_transverse,a_vertical without this line"},
};

struct Found {
    UnreadFormat const* format = nullptr;
    int line = 0;
};

bool is_of(std::string_view lower, UnreadFormat const& format) {
    return format.anywhere ? lower.find(format.words) != std::string_view::npos : lower.starts_with(format.words);
}

Found find_unread(std::string_view content) {
    constexpr int lines_at_most = 40;
    TextLines lines(content);
    while (lines.number() < lines_at_most) {
        auto const line = lines.next();
        if (!line) {
            break;
        }
        auto const lower = lowered(trimmed(*line));
        for (auto const& format : unread) {
            if (is_of(lower, format)) {
                return {&format, lines.number()};
            }
        }
    }
    return {};
}

}  // namespace

bool recognises_unread(std::string_view content) { return find_unread(content).format != nullptr; }

Recording refuse_unread(std::string_view content, RecordRequest const& request) {
    auto const found = find_unread(content);
    if (found.format == nullptr) {
        throw InputError({request.name}, "of none of the refused formats (this one is for refusing). State another");
    }
    throw InputError({request.name, found.line},
                     fmt::format("{}; there is no reader for it). {}", found.format->name, found.format->advice));
}

}  // namespace overturn

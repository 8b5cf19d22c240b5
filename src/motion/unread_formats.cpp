#include <array>
#include <string>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// A known format without a reader: how one of its first lines begins, and what to do instead.
struct UnreadFormat {
    std::string_view beginning;  // lower case
    std::string_view name;
    std::string_view advice;
};

constexpr std::array unread{
    UnreadFormat{"uncorrected accelerogram", "uncorrected accelerogram (CSMIP V1 or GeoNet V1A",
                 "Take the corrected V2 file of the same record"},
    UnreadFormat{"corrected accelerogram", "corrected accelerogram of another layout than CSMIP V2's (GeoNet V2A",
                 "Convert one component to columns and state the unit"},
    UnreadFormat{"* vol1ds file", "BHRC V1 (uncorrected pairs in G/10",
                 "Take corrected data, or convert one component to columns and state the unit"},
    UnreadFormat{"#data:", "columns of CWA's layout without its rate (time, U, N, E",
                 "Bring the columns into the order time,a_horizontal,a_transverse,a_vertical without this line"},
};

struct Found {
    UnreadFormat const* format = nullptr;
    int line = 0;
};

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
            if (lower.starts_with(format.beginning)) {
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

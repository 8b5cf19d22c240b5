#include "motion/detail/packed_files.hpp"

#include <algorithm>
#include <array>

#include "core/digit.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text unpack = "Unpack it and name the record inside";
constexpr Text no_unit = "no line of it says the unit of its numbers";
constexpr Text convert = "Convert it to text, for example with ObsPy to columns time,a_horizontal in m/s2";

struct Beginning {
    Text bytes;
    PackedFile file;
};
constexpr std::array beginnings{Beginning{Text("\x1f\x8b", 2), {"a gzip file (.gz, .tar.gz)", unpack}},
                                Beginning{Text("PK\x03\x04", 4), {"a zip archive (or an .xlsx)", unpack}},
                                Beginning{Text("BZh", 3), {"a bzip2 file (.bz2)", unpack}},
                                Beginning{Text("\xfd\x37zXZ", 5), {"an xz file (.xz)", unpack}},
                                Beginning{Text("7z\xbc\xaf", 4), {"a 7z archive", unpack}},
                                Beginning{Text("\x1f\x9d", 2), {"a compress file (.Z)", unpack}},
                                Beginning{Text("MS\x03", 3), {"miniSEED 3", convert, no_unit}},
                                Beginning{Text("\x89HDF", 4), {"an HDF5 file", convert}},
                                Beginning{Text("%PDF", 4), {"a PDF", "Fetch the record itself"}}};

bool is_tar(Text content) {
    constexpr std::size_t magic_at = 257;
    return content.size() > magic_at && content.substr(magic_at).starts_with("ustar");
}

/// SAC's header has its version, 6 or 7, as a whole number at byte 304, in either order of bytes.
bool is_sac(Text content) {
    constexpr std::size_t version_at = 304;
    constexpr std::size_t header_bytes = 632;
    if (content.size() <= header_bytes) {
        return false;
    }
    auto const version = content.substr(version_at, 4);
    return version == Text("\6\0\0\0", 4) || version == Text("\0\0\0\6", 4) || version == Text("\7\0\0\0", 4)
           || version == Text("\0\0\0\7", 4);
}

}  // namespace

// Six digits, a quality letter and a blank, and bytes that no text has.
bool is_miniseed(std::string_view content) {
    constexpr std::size_t digits = 6;
    return content.size() > digits + 2 && std::all_of(content.begin(), content.begin() + digits, is_digit)
           && Text("DRQM").find(content[digits]) != Text::npos
           && (content[digits + 1] == ' ' || content[digits + 1] == 0) && content.find('\0') != Text::npos;
}

PackedFile packed_file(std::string_view content) {
    for (auto const& beginning : beginnings) {
        if (content.starts_with(beginning.bytes)) {
            return beginning.file;
        }
    }
    if (is_tar(content)) {
        return {"a tar archive", unpack};
    }
    if (is_sac(content)) {
        return {"SAC, binary", convert, no_unit};
    }
    return {};
}

}  // namespace overturn

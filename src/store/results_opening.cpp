#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/regular_file.hpp"
#include "store/detail/apart.hpp"
#include "store/detail/objects.hpp"
#include "store/detail/opened_file.hpp"
#include "store/format_versions.hpp"
#include "store/kept_blocks.hpp"
#include "store/sha256.hpp"

namespace overturn::store {
namespace {

bool is_ours(File const& file, std::string_view format) {
    if (H5Aexists(file.id(), "format") <= 0 || H5Aexists(file.id(), "format_version") <= 0) {
        return false;
    }
    try {
        return read_text_attribute(file.id(), "format") == format;
    } catch (SystemError const&) {
        return false;  // no text, so somebody else's
    }
}

std::int64_t version_of(File const& file) {
    try {
        return read_integer_attribute(file.id(), "format_version");
    } catch (SystemError const&) {
        return 0;
    }
}

constexpr char stated_by_itself = '!';  // before a message that needs nothing added

// Distinguished from damage: no right to read, and a file being written. A file system without locks hinders nobody.
void require_readable(std::filesystem::path const& path) {
    int const fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    validate(fd >= 0, "{}: cannot be read ({}). Make it readable", path.string(), std::strerror(errno));
    bool const written = ::flock(fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(fd);
    validate(!written, "{}: another program has it open for writing (h5py?). Close it there", path.string());
}

// Of a file that holds no results of ours.
void require_results(bool holds, std::filesystem::path const& path, std::string_view problem, std::string_view advice) {
    if (!holds) {
        throw InputError(fmt::format("{}: {}. {}", path.string(), problem, advice_beside_blocks(path, advice)));
    }
}

std::string damaged(std::filesystem::path const& path, std::string const& why) {
    return fmt::format("{}: damaged or edited ({}). {}; to read it as it is, add --unverified", path.string(), why,
                       advice_beside_blocks(path, "Restore it or run the campaign again"));
}

}  // namespace

ResultsReader::ResultsReader(std::filesystem::path const& path, Trust trust, std::string_view format)
    : path_(path), trust_(trust), opened_(std::make_unique<Opened>()) {
    auto const parts = path.string() + ".parts";
    validate(std::filesystem::exists(path) || !std::filesystem::is_directory(parts),
             "{}: not there yet (the run is unfinished; {} holds the finished blocks). See overturn status {} or "
             "overturn fit --interim {}; go on with overturn run --resume",
             path.string(), parts, path.string(), path.string());
    validate(std::filesystem::exists(path), "{}: no such file (nothing to read). Check the name", path.string());
    auto const no_file = what_is_no_file(path);
    require_results(no_file.empty(), path, fmt::format("not an HDF5 file (nor any file: {})", no_file),
                    "Give a results file of overturn run");
    require_readable(path);
    require_memory_for_hdf5();
    if (auto const seal = trust == Trust::sealed ? seal_of(path) : Seal::intact; seal != Seal::intact) {
        refuse(seal, format);
    }
    open(format);
    // An editor can make a new seal; then the digests inside still show the change.
    if (auto const faults = trust == Trust::sealed ? digest_faults() : std::string(); !faults.empty()) {
        throw InputError(damaged(path_, faults));
    }
}

ResultsReader::~ResultsReader() = default;

void ResultsReader::open(std::string_view format) {
    PropertyList const access(checked(H5Pcreate(H5P_FILE_ACCESS), "make file properties"));
    checked(H5Pset_file_locking(access.id(), false, true), "leave locks out");
    checked(H5PLset_loading_state(0), "leave plugins out");
    auto const id = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access.id());
    auto const path = path_.string();
    require_results(id >= 0, path_, "not an HDF5 file (or damaged)", "Give a results file of overturn run");
    opened_->file = File(id);
    require_results(is_ours(opened_->file, format), path_,
                    fmt::format("not a results file (its format is not '{}')", format), "Give a file of overturn run");
    auto const version = version_of(opened_->file);
    require_results(version >= 1, path_, "damaged (no format version)", "Give a whole file of overturn run");
    validate(format != format_name || version <= format_version,
             "{}: format version {} (this program knows up to {}). Use a newer overturn", path, version,
             format_version);
    if (format == format_name && version < oldest_format_read) {
        throw InputError(
            fmt::format("{}: format version {} (this program reads {} to {}). Read it with overturn {}, revision {}.{}",
                        path, version, oldest_format_read, format_version, text_or("program_version"),
                        text_or("git_revision"), known_errors_of(version)));
    }
    try {
        each_object(opened_->file, [](std::string const&, Object const&) {});
    } catch (InputError const& error) {
        throw InputError(fmt::format("{}: {}", path, error.what()));
    }
}

std::string ResultsReader::text_or(std::string const& name) const {
    try {
        return text(name);
    } catch (SystemError const&) {
        return "unknown";
    }
}

// A file with a broken seal is one of ours, whatever it says of itself now; one without may be of an older version.
void ResultsReader::refuse(Seal seal, std::string_view format) {
    auto const why = looked_at_apart([&]() -> std::string {
        try {
            open(format);
        } catch (InputError const& error) {
            if (seal == Seal::missing) {
                return std::string(1, stated_by_itself) + error.what();
            }
            return "what it says of itself changed";
        }
        return what_changed();
    });
    if (why && why->starts_with(stated_by_itself)) {
        throw InputError(why->substr(1));
    }
    throw InputError(damaged(path_, why.value_or("so that HDF5 cannot read it")));
}

std::string ResultsReader::what_changed() const {
    auto const faults = digest_faults();
    return faults.empty() ? "no value changed, but bytes between them did, or another program wrote to it" : faults;
}

// What does not fit the digests that the file holds of its objects; empty where all do.
std::string ResultsReader::digest_faults() const {
    auto const list = fmt::format("{}/{}", digest_group, digest_list);
    if (!has(list)) {
        return fmt::format("/{} is gone", list);
    }
    try {
        auto const listed = content(list);
        if (text(digest_of_all) != sha256(listed)) {
            return fmt::format("/{} is not as it was written", list);
        }
        Object const at(checked(H5Oopen(opened_->file.id(), list.c_str(), H5P_DEFAULT), "open " + list));
        bool const stretched = H5Aexists(at.id(), digest_stretch) > 0;
        return differences(listed, digests_of(opened_->file, stretched ? ContentHash::stretches : ContentHash::whole));
    } catch (SystemError const&) {
        return fmt::format("/{} or what it lists cannot be read", list);
    }
}

bool ResultsReader::is_as_written() const {
    return trust_ == Trust::sealed || (seal_of(path_) == Seal::intact && digest_faults().empty());
}

}  // namespace overturn::store

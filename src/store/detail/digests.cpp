#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5_hl.h>

#include "core/error.hpp"
#include "store/detail/objects.hpp"
#include "store/sha256.hpp"

namespace overturn::store {
namespace {

// What a type means, apart from how this version of HDF5 encodes it.
std::string text_of_type(hid_t type) {
    auto const size = H5Tget_size(type);
    switch (H5Tget_class(type)) {
        case H5T_INTEGER:
            return fmt::format("int{} sign {} order {}", size, static_cast<int>(H5Tget_sign(type)),
                               static_cast<int>(H5Tget_order(type)));
        case H5T_FLOAT:
            return fmt::format("float{} order {}", size, static_cast<int>(H5Tget_order(type)));
        case H5T_STRING:
            return fmt::format("text{} characters {}", H5Tis_variable_str(type) > 0 ? 0 : size,
                               static_cast<int>(H5Tget_cset(type)));
        case H5T_ENUM: {
            std::string text = fmt::format("enum{}", size);
            auto const members = H5Tget_nmembers(type);
            for (int i = 0; i < members; ++i) {
                std::vector<unsigned char> value(size);
                checked(H5Tget_member_value(type, i, value.data()), "read an enumeration");
                char* const name = H5Tget_member_name(type, i);
                text += fmt::format(" {}={}", name == nullptr ? "" : name, fmt::join(value, "."));
                H5free_memory(name);
            }
            return text;
        }
        default:
            return fmt::format("class {} of {}", static_cast<int>(H5Tget_class(type)), size);
    }
}

// Values that lie elsewhere in the file: HDF5's own for axes, which are listed by name instead.
bool points_elsewhere(hid_t type) {
    return H5Tdetect_class(type, H5T_VLEN) > 0 || H5Tdetect_class(type, H5T_REFERENCE) > 0;
}

void add_shape(Sha256& hash, Dataspace const& space) {
    std::vector<hsize_t> sizes(std::max(0, H5Sget_simple_extent_ndims(space.id())));
    H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
    hash.add_text(fmt::format("{}", fmt::join(sizes, " ")));
}

std::vector<std::string> attributes_of(hid_t object) {
    std::vector<std::string> names;
    auto const add = [](hid_t, char const* name, H5A_info_t const*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    checked(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "list attributes");
    std::sort(names.begin(), names.end());
    return names;
}

void add_attribute(Sha256& hash, hid_t object, std::string const& name) {
    Attribute const attribute(checked(H5Aopen(object, name.c_str(), H5P_DEFAULT), "open attribute " + name));
    Datatype const type(checked(H5Aget_type(attribute.id()), "read the type of attribute " + name));
    Dataspace const space(checked(H5Aget_space(attribute.id()), "read a dataspace"));
    hash.add_text(name);
    hash.add_text(text_of_type(type.id()));
    add_shape(hash, space);
    auto const count = H5Sget_simple_extent_npoints(space.id());
    if (H5Tis_variable_str(type.id()) > 0 && count == 1) {
        hash.add_text(read_text_attribute(object, name));
    } else if (!points_elsewhere(type.id()) && count > 0) {
        std::vector<std::byte> bytes(count * H5Tget_size(type.id()));
        checked(H5Aread(attribute.id(), type.id(), bytes.data()), "read attribute " + name);
        hash.add(bytes);
    }
}

using Places = std::map<haddr_t, std::string>;

void add_axes(Sha256& hash, hid_t dataset, Places const& places) {
    struct Found {
        Places const& places;
        std::string names;
    } found{places, {}};
    auto const add = [](hid_t, unsigned, hid_t scale, void* list) -> herr_t {
        H5O_info_t info{};
        auto& [known, names] = *static_cast<Found*>(list);
        if (H5Oget_info2(scale, &info, H5O_INFO_BASIC) >= 0 && known.contains(info.addr)) {
            names += known.at(info.addr) + "\n";
        }
        return 0;
    };
    if (H5DSis_scale(dataset) <= 0 && H5Aexists(dataset, "DIMENSION_LIST") > 0) {
        checked(H5DSiterate_scales(dataset, 0, nullptr, add, &found), "list axes");
    }
    hash.add_text(found.names);
}

// Where the content goes: into the object's digest, or by stretches into digests of their own.
class ContentDigest {
  public:
    ContentDigest(Sha256& whole, std::uint64_t stretch_bytes) : whole_(whole), stretch_bytes_(stretch_bytes) {}

    /// \param part ends where a stretch does, or before
    void add(std::span<std::byte const> part) {
        if (stretch_bytes_ == 0) {
            whole_.add(part);
            return;
        }
        if (!stretch_) {
            stretch_.emplace();
        }
        stretch_->add(part);
        in_stretch_ += part.size();
        if (in_stretch_ == stretch_bytes_) {
            close();
        }
    }
    void finish() {
        if (in_stretch_ > 0) {
            close();
        }
    }

  private:
    void close() {
        auto const digits = stretch_->digits();
        whole_.add(std::as_bytes(std::span(digits)));
        stretch_.reset();
        in_stretch_ = 0;
    }

    Sha256& whole_;
    std::uint64_t stretch_bytes_, in_stretch_ = 0;
    std::optional<Sha256> stretch_;
};

void add_content(Sha256& hash, hid_t dataset, hid_t type, Dataspace const& space, ContentHash how) {
    constexpr hsize_t at_once = 1 << 20;
    auto const each = H5Tget_size(type);
    if (points_elsewhere(type) || H5Sget_simple_extent_ndims(space.id()) != 1 || each == 0 || each > at_once) {
        return;  // no column of ours
    }
    auto const count = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space.id()));
    hsize_t const stretch = column_stretch / each * each;
    ContentDigest content(hash, how == ContentHash::stretches && count * each > stretch ? stretch : 0);
    hsize_t const most = std::min(at_once, stretch) / each;
    std::vector<std::byte> part(std::min(count, most) * each);
    for (hsize_t first = 0; first < count;) {
        hsize_t const before_end = stretch / each - first % (stretch / each);
        hsize_t const size = std::min({count - first, most, before_end});
        Dataspace const memory(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
        checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &size, nullptr), "select rows");
        checked(H5Dread(dataset, type, memory.id(), space.id(), H5P_DEFAULT, part.data()), "read back");
        content.add(std::span(part).first(size * each));
        first += size;
    }
    content.finish();
}

// \param stretches digests of the content's, or null
std::string digest_of(Object const& object, Places const& places, ContentHash how,
                      std::vector<std::string> const* stretches) {
    Sha256 hash;
    auto const kind = H5Iget_type(object.id());
    hash.add_text(kind == H5I_GROUP ? "group" : kind == H5I_DATASET ? "dataset" : "type");
    for (auto const& name : attributes_of(object.id())) {
        if (name != digest_of_all) {
            add_attribute(hash, object.id(), name);
        }
    }
    if (kind == H5I_DATATYPE) {
        hash.add_text(text_of_type(object.id()));
    } else if (kind == H5I_DATASET) {
        Datatype const type(checked(H5Dget_type(object.id()), "read a type"));
        Dataspace const space(checked(H5Dget_space(object.id()), "read a dataspace"));
        add_axes(hash, object.id(), places);
        hash.add_text(text_of_type(type.id()));
        add_shape(hash, space);
        if (stretches == nullptr) {
            add_content(hash, object.id(), type.id(), space, how);
        } else {
            auto const joined = fmt::format("{}", fmt::join(*stretches, ""));
            hash.add(std::as_bytes(std::span(joined)));
        }
    }
    return hash.digits();
}

bool is_digest(std::string_view path) {
    static auto const own = fmt::format("/{}", digest_group);
    return path == own || path.starts_with(own + "/");
}

}  // namespace

std::map<std::string, std::string> digests_of(File const& file, ContentHash how, HashedColumns const& hashed) {
    Places places;
    each_object(file, [&](std::string const& path, Object const& object) {
        H5O_info_t info{};
        checked(H5Oget_info2(object.id(), &info, H5O_INFO_BASIC), "look at " + path);
        places.emplace(info.addr, path);
    });
    std::map<std::string, std::string> digests;
    each_object(file, [&](std::string const& path, Object const& object) {
        if (is_digest(path)) {
            return;
        }
        try {
            auto const known = hashed.find(path);
            digests[path] = digest_of(object, places, how, known == hashed.end() ? nullptr : &known->second);
        } catch (SystemError const&) {
            digests[path] = "";
        }
    });
    return digests;
}

std::string text_of(std::map<std::string, std::string> const& digests) {
    std::string text;
    for (auto const& [path, digest] : digests) {
        auto line = path;
        std::replace(line.begin(), line.end(), '\n', ' ');
        text += fmt::format("{}  {}\n", digest, line);
    }
    return text;
}

std::string differences(std::string const& stated, std::map<std::string, std::string> const& found) {
    auto const read = [](std::string const& text) {
        std::map<std::string, std::string> digests;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            if (auto const gap = line.find("  "); gap != std::string::npos) {
                digests[line.substr(gap + 2)] = line.substr(0, gap);
            }
        }
        return digests;
    };
    auto const before = read(stated);
    auto const now = read(text_of(found));
    std::vector<std::string> names;
    for (auto const& [path, digest] : before) {
        auto const there = now.find(path);
        if (there == now.end()) {
            names.push_back(path + " is gone");
        } else if (there->second != digest) {
            names.push_back(path + " changed");
        }
    }
    for (auto const& [path, digest] : now) {
        if (!before.contains(path)) {
            names.push_back(path + " is new");
        }
    }
    constexpr std::size_t most_named = 3;
    auto const more = names.size() > most_named ? names.size() - most_named : 0;
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace overturn::store

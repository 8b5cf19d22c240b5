/// Every object of an HDF5 file, and what each one is and holds as one digest.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "store/detail/h5.hpp"
#include "store/stretches.hpp"

namespace overturn::store {

using Object = Handle<H5Oclose>;

/// Calls `visit` with each object's path ("/", "/trials/verdict"). Only hard links to what lies inside the file are
/// followed. \throws InputError, beginning with the path of what is none: a link to elsewhere, a group that is reached
/// twice, a column that is stored elsewhere or through a filter that HDF5 does not bring along
void each_object(File const& file, std::function<void(std::string const&, Object const&)> const& visit);

/// How the content of a column is hashed.
enum class ContentHash {
    whole,     ///< as one, as in files before columns were hashed in stretches
    stretches  ///< a column longer than column_stretch as the digests of its stretches, joined
};

/// Digests of the stretches of long columns, by path, where somebody has them already.
using HashedColumns = std::map<std::string, std::vector<std::string>>;

/// By path: SHA-256 over type, shape, attributes (and which axes it lies along) and content. Empty where it cannot be
/// read. Without what `is_digest` names.
[[nodiscard]] std::map<std::string, std::string> digests_of(File const& file, ContentHash how,
                                                            HashedColumns const& hashed = {});

/// Place of the digests of all objects, kept as text; and the digest of that text, an attribute of the root.
inline constexpr char const* digest_group = "digests";
inline constexpr char const* digest_list = "objects";
inline constexpr char const* digest_of_all = "content_sha256";
/// Attribute of the list: the length of a column's stretches [bytes]; missing where columns are hashed whole.
inline constexpr char const* digest_stretch = "stretch_bytes";

/// "<digest>  <path>" line by line, as sha256sum writes them.
[[nodiscard]] std::string text_of(std::map<std::string, std::string> const& digests);

/// "/trials/v_wes changed, /trials/x is gone": objects that differ from those in a text_of; empty if none does.
[[nodiscard]] std::string differences(std::string const& stated, std::map<std::string, std::string> const& found);

}  // namespace overturn::store

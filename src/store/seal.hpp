/// The seal of a finished file: one line of text after all that HDF5 knows of, with the SHA-256 of every byte before
/// it; of a file above 64 MiB that of the digests of its stretches of 64 MiB, joined. HDF5 and all who read through it
/// end where their own bytes end; who writes through it cuts the line off.
#pragma once

#include <filesystem>
#include <string>

#include "store/stretches.hpp"

namespace overturn::store {

enum class Seal {
    intact,  ///< every byte is as it was written
    broken,  ///< there is one, and a byte is not
    missing  ///< never sealed, written to by another program, or cut
};

/// Appends the line. \param known digests of some of the file's stretches \throws SystemError
void seal(std::filesystem::path const& path, HashStretches const& hash = hash_stretches, StretchDigests known = {});

/// Reads the whole file: 1.3 GB a second where the processor knows SHA-256. \throws SystemError if it cannot be read
[[nodiscard]] Seal seal_of(std::filesystem::path const& path);

/// The SHA-256 that a file's seal states; empty where there is no seal. Reads that line only.
[[nodiscard]] std::string sealed_digest(std::filesystem::path const& path);

}  // namespace overturn::store

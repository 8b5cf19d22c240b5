/// The one door through which the bytes of an input file enter.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace overturn {

/// More than this is no table, no record and no campaign [byte].
inline constexpr std::size_t largest_input_bytes = std::size_t{1} << 30;

/// Kind of what lies at a path in place of a file: "a folder", "a pipe", "a device", "a socket"; empty for a regular
/// file and where nothing lies.
[[nodiscard]] std::string what_is_no_file(std::filesystem::path const& path);

/// All bytes of a regular file. Never waits: a pipe or device is refused before it is read.
/// \param path    of the file
/// \param problem how an error begins: of what it cannot be had, for example "file 'wave.csv'"
/// \param most    bytes; a larger file is refused before it takes memory
/// \throws InputError if it is no regular file, is not there, may not be read or is larger; SystemError if the disk
/// fails.
[[nodiscard]] std::string read_regular_file(std::filesystem::path const& path, std::string const& problem,
                                            std::size_t most = largest_input_bytes);

}  // namespace overturn

/// Sheets as csv: UTF-8, commas, a header line "peak_slip [m]", one row a line (RFC 4180, but lines end in \n).
#pragma once

#include <filesystem>

#include "output/sheets.hpp"

namespace overturn::output {

/// Numbers are the shortest text that reads back to the same bits; what is absent is an empty cell; infinite ends of
/// intervals are "inf". The file is there whole or not at all. \throws SystemError if it cannot be written
void write_csv(std::filesystem::path const& path, Sheet const& sheet);

}  // namespace overturn::output

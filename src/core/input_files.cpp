#include "core/input_files.hpp"

#include <fstream>
#include <iterator>

#include "core/error.hpp"

namespace overturn {

std::string const& InputFiles::read(std::string const& name) {
    if (auto const known = contents_.find(name); known != contents_.end()) {
        return known->second;
    }
    validate(!from_memory_, "file '{}' (not among the stored ones). Give the campaign's folder instead", name);
    auto const path = folder_ / name;
    std::error_code error;
    validate(!name.empty() && std::filesystem::is_regular_file(path, error),
             "file '{}' (no such file in '{}'). Check the name", name, folder_.string());
    std::ifstream stream(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    validate(stream.good() || stream.eof(), "file '{}' (cannot be read). Check its permissions", path.string());
    validate(!stream.bad(), "file '{}' (reading it failed). Check the disk", path.string());
    return contents_.emplace(name, std::move(bytes)).first->second;
}

}  // namespace overturn

#include "core/input_files.hpp"

#include <algorithm>
#include <fstream>

#include "core/error.hpp"
#include "core/regular_file.hpp"

namespace overturn {

std::string const& InputFiles::read(std::string const& name) {
    if (auto const known = contents_.find(name); known != contents_.end()) {
        return known->second;
    }
    validate(!from_memory_, "file '{}' (not among the stored ones). Give the campaign's folder instead", name);
    auto const path = folder_ / name;
    std::error_code error;
    validate(!name.empty() && std::filesystem::exists(path, error), "file '{}' (no such file in '{}'). Check the name",
             name, folder_.string());
    auto bytes = read_regular_file(path, "file '" + name + "'");
    return contents_.emplace(name, std::move(bytes)).first->second;
}

bool InputFiles::has_folder(std::string const& name) const {
    std::error_code error;
    return from_memory_ || std::filesystem::is_directory(folder_ / name, error);
}

std::vector<std::string> InputFiles::beside(std::string const& name) const {
    auto const folder = std::filesystem::path(name).parent_path();
    std::vector<std::string> names;
    if (from_memory_) {
        for (auto const& [stored, content] : contents_) {
            if (std::filesystem::path(stored).parent_path() == folder) {
                names.push_back(stored);
            }
        }
        return names;
    }
    std::error_code error;
    for (auto const& entry : std::filesystem::directory_iterator(folder_ / folder, error)) {
        if (entry.is_regular_file(error)) {
            names.push_back((folder / entry.path().filename()).string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string InputFiles::head(std::string const& name, std::size_t most) const {
    if (auto const known = contents_.find(name); known != contents_.end()) {
        return known->second.substr(0, most);
    }
    std::string bytes(from_memory_ ? 0 : most, '\0');
    std::ifstream stream(folder_ / name, std::ios::binary);
    stream.read(bytes.data(), bytes.size());
    bytes.resize(std::max<std::streamsize>(0, stream.gcount()));
    return bytes;
}

}  // namespace overturn

/// Folder of a figure's scripts and data while Python draws it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace overturn::report {

/// A folder of its own, gone with the object. The next program removes what a killed one left: a lock, which the kernel
/// drops with its holder, marks folders in use.
class FigureFolder {
  public:
    /// \throws SystemError
    FigureFolder();
    ~FigureFolder();
    FigureFolder(FigureFolder const&) = delete;
    FigureFolder& operator=(FigureFolder const&) = delete;
    FigureFolder(FigureFolder&&) = delete;
    FigureFolder& operator=(FigureFolder&&) = delete;

    /// Writes a file of that name and gives its path. \throws SystemError
    [[nodiscard]] std::string write(std::string_view name, std::string_view text) const;
    [[nodiscard]] std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
    int lock_ = -1;
};

}  // namespace overturn::report

/// Draws a figure: data as JSON, one of the scripts of the Python package in the folder `overturn`, a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace overturn::report {

/// \throws InputError unless `output` ends in .svg, .png or .pdf: to be called before any work
void check_figure_name(std::filesystem::path const& output);

/// Runs `script` (of overturn/report) on `data` and puts the figure at `output`; equal data give equal bytes. The
/// interpreter is $OVERTURN_PYTHON, else /usr/bin/python3, else the first python3 of the path; it runs isolated.
/// \throws SystemError if there is none, the package or a module is missing or the script fails; InputError if `output`
/// cannot be written
void draw_figure(std::string_view script, nlohmann::ordered_json const& data, std::filesystem::path const& output);

/// The same as text, for pages. \param kind ".svg", or ".html" of a script that writes a page \throws SystemError
[[nodiscard]] std::string figure_text(std::string_view script, nlohmann::ordered_json const& data,
                                      std::string const& kind = ".svg");

}  // namespace overturn::report

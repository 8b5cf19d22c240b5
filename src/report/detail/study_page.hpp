/// Common parts of the pages of studies. Rows are given as `overturn cost --json` prints them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace overturn::report {

/// Head and headings of a page. \param style further rules
[[nodiscard]] std::string study_head(std::string const& heading, nlohmann::ordered_json const& study,
                                     std::string const& style = {});

/// The svg element that a script draws of `data`, without the head that only a file of its own may have.
/// \param label its name, escaped \throws as figure_text
[[nodiscard]] std::string study_figure(char const* script, nlohmann::ordered_json const& data,
                                       std::string const& label);

/// A field as text, count, or number by a format of fmt (a dash where it is null).
[[nodiscard]] std::string text_at(nlohmann::ordered_json const& row, char const* key);
[[nodiscard]] std::int64_t count_at(nlohmann::ordered_json const& row, char const* key);
[[nodiscard]] std::string number_at(nlohmann::ordered_json const& row, char const* key, char const* format);

/// A row of a table. \param kind here, front, plain
[[nodiscard]] std::string table_row(std::vector<std::string> const& cells, std::string const& kind = "plain",
                                    std::string const& tip = {});
/// A table with its note, and the end of the section. \param name of the table, escaped
[[nodiscard]] std::string last_table(std::string const& name, std::vector<std::string> const& headings,
                                     std::string const& rows, std::string const& note = {});

}  // namespace overturn::report

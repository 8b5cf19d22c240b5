/// Cost of accuracy, as one page that needs no network: figures, tables and the sentence.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace overturn::report {

/// \throws InputError unless `output` ends in .html
void check_page_name(std::filesystem::path const& output);

/// The page of a study, given as `overturn cost --json` prints it. \throws as draw_figure
[[nodiscard]] std::string cost_page(nlohmann::ordered_json const& tables);

}  // namespace overturn::report

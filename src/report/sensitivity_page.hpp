/// Sensitivity to assumed numbers, as one page that needs no network.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace overturn::report {

/// The page of a study, given as `overturn cost --sensitivity --json` prints it. \throws as draw_figure
[[nodiscard]] std::string sensitivity_page(nlohmann::ordered_json const& tables);

}  // namespace overturn::report

/// What the pages of studies share.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace overturn::report {

/// The style sheet.
extern char const* const study_style;

/// The svg element that a script draws of `data`, without the head that only a file of its own may have.
/// \throws as figure_text
[[nodiscard]] std::string study_figure(char const* script, nlohmann::ordered_json const& data);

}  // namespace overturn::report

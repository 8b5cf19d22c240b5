/// Line on what a body's file states and a spectrum of rigid blocks in one plane has not.
#pragma once

#include <span>
#include <string>

#include <fmt/ranges.h>

namespace overturn::output {

/// "not in these numbers: cask: its friction 0.5, ...; cask: its base and pad"; empty where nothing is left out.
[[nodiscard]] inline std::string left_out_text(std::span<std::string const> left_out) {
    return left_out.empty() ? "" : fmt::format("not in these numbers: {}\n", fmt::join(left_out, "; "));
}

}  // namespace overturn::output

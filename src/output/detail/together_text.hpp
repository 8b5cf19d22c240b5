/// Several bodies under one wave, and curves over two measures, for the terminal.
#pragma once

#include <span>
#include <string>

#include "results/together.hpp"

namespace overturn::output {

/// Of bodies of one mass and one shape, which may be one cask under several assumptions, what P of any of them is then;
/// empty: there are none.
[[nodiscard]] std::string alternatives_text(CampaignSpec const& spec);

/// \param confidence of the exact intervals
[[nodiscard]] std::string together_text(CampaignSpec const& spec, std::span<BodiesTogether const> together,
                                        double confidence);

[[nodiscard]] std::string two_measures_text(CampaignSpec const& spec, std::span<TwoMeasures const> fits,
                                            double confidence);

}  // namespace overturn::output

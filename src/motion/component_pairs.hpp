/// Files that hold two horizontal components of one recording, by their names alone.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace overturn {

/// Pairs of names that are the same but for a direction of theirs, where the two directions are square to each other
/// and no third name has another word there: "kobe_NS.csv" and "kobe_EW.csv", "KJM000.AT2" and "KJM090.AT2",
/// "kobe.NS" and "kobe.EW", "NS/kobe.csv" and "EW/kobe.csv". \return places in `names`, the first below the second
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> component_pairs(std::span<std::string const> names);

}  // namespace overturn

/// Which files hold components of one recording, by their names alone.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace overturn {

/// Names that are the same but for a direction of theirs are of one recording, if no further name has another word
/// there: two directions square to each other ("kobe_NS.csv" and "kobe_EW.csv", "KJM000.AT2" and "KJM090.AT2",
/// "NS/kobe.csv" and "EW/kobe.csv", "q1_NS_acc" and "q1_EW_acc", "comp 1" and "comp 2"), and a vertical one or one at
/// 45 degrees beside them ("x", "y", "z"; "000", "045", "090").
/// \return for each name the place of the first one of its recording
[[nodiscard]] std::vector<std::size_t> named_recordings(std::span<std::string const> names);

}  // namespace overturn

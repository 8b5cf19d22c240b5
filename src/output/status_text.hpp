/// Progress of a run, in words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace overturn::output {

/// A run that ended.
struct Complete {
    std::string title = {};
    std::int64_t trials = 0, waves = 0;
    std::int64_t planned = 0;     ///< waves; more than `waves` where it ended early
    std::string waves_text = {};  ///< counts of the waves (waves_text); empty: nothing to report
    bool changed = false;         ///< the file is not as it was written
};
/// "complete, 960 trials of 'title'; precise enough after 32 of 64 waves"
[[nodiscard]] std::string complete_text(Complete const& of);

/// A run that did not end.
struct Progress {
    std::size_t done = 0, left = 0;        ///< blocks
    std::optional<std::int64_t> all = {};  ///< none: how many it needs is not known yet
    std::string waves_left = {};           ///< numbers of the waves of the blocks that are left; empty: none are
    bool rare = false;                     ///< rare events follow
    bool under_way = false;                ///< a process is computing it
    std::string next = {};                 ///< the command that goes on
};
/// "not complete, 3 of 8 blocks are done, 5 left (waves 24 to 63). Go on with: overturn run ..."
[[nodiscard]] std::string progress_text(Progress const& of);

/// "an extension to 64 waves, 2 bodies and 3 levels is not complete, 3 of 8 blocks are done, ..."
/// \param progress of it, by progress_text
[[nodiscard]] std::string extension_text(std::int64_t waves, std::size_t bodies, std::size_t levels,
                                         std::string const& progress);
/// Line on the file that the extension will replace. \param complete by complete_text
[[nodiscard]] std::string before_extension_text(std::string const& complete);

/// Line on the waves of a run that did not end.
[[nodiscard]] std::string so_far_text(std::string const& waves_text);

/// Line that marks a fit of an unfinished run.
[[nodiscard]] std::string interim_text(std::int64_t waves, std::int64_t planned);

}  // namespace overturn::output

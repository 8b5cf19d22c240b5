/// Verdicts of a trial, and their properties: did the body move, was it decided, did it fall.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace overturn {

/// The ends that all models share. A model of its own kind may have more of them: further values, stated in its traits.
/// Values are stored in results files: never renumber them.
enum class Verdict : std::int64_t {
    at_rest = 0,
    slid = 1,
    rocked = 2,
    overturned = 3,
    contact_lost = 4,
    failed = 5,
    slid_and_rocked = 6
};

/// One line of the table of verdicts.
struct VerdictEntry {
    Verdict value;
    std::string_view name;     ///< as files and messages have it: "contact-lost"
    std::string_view summary;  ///< one line
    bool moved;                ///< the body left its place
    bool decided;  ///< whether it falls is known; what is not decided is left out of P and widens its interval
    bool fell;
};

/// Verdicts of the enumeration, in its order. response/registry.hpp has all of them, with the models' own.
[[nodiscard]] std::span<VerdictEntry const> common_verdicts();

}  // namespace overturn

/// Outcomes of tests on real bodies under the motions of a campaign, from a table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"

namespace overturn::cli {

/// Outcome of a test.
enum class Outcome : std::int8_t { untested = -1, stood = 0, fell = 1 };

/// A body that was tested, and the bodies of the campaign that stand for it.
struct Specimen {
    std::string name;
    std::vector<std::size_t> bodies;  ///< one, or several between which its outcomes under other motions choose
    std::vector<Outcome> outcomes;    ///< by wave
};

struct Outcomes {
    std::vector<std::string> records;  ///< by wave: what the campaign calls it; empty where it was not measured
    std::vector<std::string> motions;  ///< by wave: which motion was shaken; waves of one motion are left out together
    std::vector<Specimen> specimens;
    std::vector<std::string> unread;  ///< lines of text that are not understood
    std::size_t level = 0;            ///< the campaign's level at which waves are as they were measured
};

/// Reads a table parted by commas, semicolons or tabs: a header with `wave`, `motion` (optional: every wave is a motion
/// of its own) and a column for each specimen, named as its body, or with a * that stands for any letters as several
/// (`scan-*`); a row for each wave tested, by its number or its record (as the campaign names it, or the file's name
/// alone), with 1 (fell), 0 (stood) or nothing (not tested). Prose may stand above, comments anywhere. Waves without a
/// row were not tested. \param file for messages \throws InputError naming line and column; if the campaign has no
/// level with factor 1
[[nodiscard]] Outcomes parse_outcomes(std::string const& text, std::string const& file, CampaignSpec const& spec,
                                      Plan const& plan);

}  // namespace overturn::cli

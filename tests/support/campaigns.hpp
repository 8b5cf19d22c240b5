/// Campaigns straight from text: pieces that tests put together, parsed without touching the disk.
#pragma once

#include <map>
#include <string>

#include "campaign/campaign_spec.hpp"

namespace overturn::testing {

/// Three waves of a broad target, quick to make: 20.48 s at 0.02 s, unmatched.
inline std::string const quick_waves =
    "[waves]\nsource='spectrum-compatible'\ncount=3\nduration='20.48 s'\ntime_step='0.02 s'\nmatch='none'\n"
    "[waves.target]\nspectrum='mlit-ch1'\ntime_scale=0.632\n"
    "[waves.envelope]\nshape='jennings'\nrise='2 s'\nlevel_end='10 s'\nend='18 s'\n";

/// 2/5-scale casks: published heights and widths, assumed centre of gravity.
inline std::string const type_a =
    "[[bodies]]\nname='type-a'\nmass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\n";
inline std::string const type_b =
    "[[bodies]]\nname='type-b'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\n";

inline std::string levels(std::string const& keys) { return "[levels]\nmeasure='pga'\n" + keys; }

inline CampaignInput input_from(std::string const& text, std::map<std::string, std::string> files = {}) {
    return {"c.toml", "seed=7\n" + text, {}, std::move(files)};
}

inline CampaignSpec campaign_from(std::string const& text, std::map<std::string, std::string> files = {}) {
    return parse_campaign(input_from(text, std::move(files)));
}

}  // namespace overturn::testing

/// The campaign that the command line tests run: small, with every feature that could depend on ranks.
#pragma once

#include <algorithm>
#include <string>

namespace overturn::testing {

inline std::string const target_csv =
    "# period_s,sa_mps2\n0.02,2.5\n0.1,6.2\n0.4,8\n0.81,8\n2.5,2.56\n5.1,0.64\n10,0.32\n";

/// Two scattered bodies, a vertical component, a target from a file; 12 waves, or as many per level.
inline std::string small_campaign(std::string const& waves = "shared", int count = 12) {
    return "title = 'small'\nseed  = 2013\n"
           "[waves]\nsource='spectrum-compatible'\ncount="
           + std::to_string(count)
           + "\nduration='20.48 s'\ntime_step='0.02 s'\nmatch='each'\nmatch_iterations=3\n"
             "[waves.target]\nfile='target.csv'\nkind='acceleration'\nlongest=6\n"
             "[waves.envelope]\nshape='jennings'\nrise='2 s'\nlevel_end='10 s'\nend='18 s'\n"
             "[waves.vertical]\nratio=0.667\n"
             "[[bodies]]\nname='type-a'\nmass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\n"
             "inertia='uniform-block'\nfriction=0.5\n"
             "[[bodies]]\nname='type-b'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
             "inertia='uniform-block'\nrestitution={distribution='lognormal',median=0.85,beta=0.1}\n"
             "[levels]\nmeasure='pga'\nvalues=['300 gal','600 gal','1200 gal']\ndesign_basis='600 gal'\n"
             "waves='"
           + waves + "'\n";
}

/// As small_campaign, shaken by three components, with bodies that stand on points in the plane and in space.
inline std::string campaign_on_points(int count) {
    auto campaign = small_campaign("shared", count);
    auto const levels = campaign.find("[levels]");
    std::string const body = "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n";
    campaign.insert(levels, "[[bodies]]\nname='flat'\naxes=1\nbase={bedding='flat', points=5}\npad={strength='5 MPa'}\n" + body
                                + "[[bodies]]\nname='round'\nfriction=0.6\nbase={shape='round', points=16}\n" + body
                                + "[[bodies]]\nname='scatters'\npad={vertical_frequency='67 Hz'}\n"
                                  "restitution={distribution='normal',mean=0.8,deviation=0.03,low=0.7,high=0.9}\n"
                                + body);
    campaign.insert(campaign.find("[waves.vertical]"), "[waves.transverse]\nratio=0.8\n");
    return campaign;
}

}  // namespace overturn::testing

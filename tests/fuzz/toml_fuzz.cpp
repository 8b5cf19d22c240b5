// Requirement: whatever bytes a campaign file holds, it is understood or refused with InputError; nothing else happens.
#include "campaign/campaign_spec.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    std::string const text(reinterpret_cast<char const*>(data), size);
    try {
        (void)overturn::parse_campaign(
            {"c.toml",
             text,
             {},
             {{"t.csv", "0.02,2.5\n0.4,8\n10,0.32\n"},
              {"w.csv", "0,0.1\n0.01,0.2\n0.02,0.1\n0.03,0\n"},
              {"b.toml", "mass=1\nbase_width=1\ncentre_height=2\ninertia='uniform-block'\n"}}});
    } catch (overturn::InputError const&) {
        return 0;
    }
    return 0;
}

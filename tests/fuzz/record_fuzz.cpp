// Requirement: whatever bytes a record file holds, it is read or refused with InputError; nothing else happens.
#include <cmath>
#include <cstdlib>

#include "motion/record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

namespace {

void read(std::string_view content, overturn::RecordRequest const& request) {
    try {
        auto const motion = overturn::place(overturn::read_recording(content, request), request.component,
                                            request.components, {request.name})
                                .motion;
        overturn::validate_motion(motion);
        for (double const a : motion.horizontal_mps2) {
            if (!std::isfinite(a)) {
                std::abort();  // a number that is none must not come through
            }
        }
    } catch (overturn::InputError const&) {
        return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    std::string_view const content(reinterpret_cast<char const*>(data), size);
    read(content, {});
    read(content, {.unit_mps2 = 0.01, .unit_has_number = true, .time_step_s = 0.01, .may_be_resampled = true});
    read(content, {.component = "EW", .components = overturn::ComponentChoice::horizontal});
    (void)overturn::station_of_record(content);
    return 0;
}

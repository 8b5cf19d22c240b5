#include "output/status_text.hpp"

#include <fmt/format.h>

#include "core/texts_of.hpp"

namespace overturn::output {

std::string complete_text(Complete const& of) {
    return fmt::format("complete{}, {} trials of '{}'{}{}{}", of.changed ? " but edited or damaged" : "", of.trials,
                       of.title, of.waves_text.empty() ? "" : "; ", of.waves_text,
                       of.waves < of.planned
                           ? fmt::format("; precise enough after {} of {} waves", of.waves, of.planned)
                           : std::string());
}

std::string progress_text(Progress const& of) {
    auto const done = of.all ? fmt::format("not complete, {} of {} blocks are done, {} left", of.done, *of.all, of.left)
                             : fmt::format("not complete, {} blocks are done, at least {} left", of.done, of.left);
    if (of.under_way) {
        return done + "; a run is under way";
    }
    auto const what = of.left > 0 ? fmt::format(" (waves {})", of.waves_left)
                      : of.rare   ? std::string("; its rare events are not")
                                  : std::string("; not merged yet");
    return fmt::format("{}{}. Go on with: {}", done, what, of.next);
}

std::string extension_text(std::int64_t waves, std::size_t bodies, std::size_t levels, std::string const& progress) {
    return fmt::format("an extension to {}, {} and {} is {}", count_text(waves, "wave"),
                       count_text(static_cast<std::int64_t>(bodies), "body", "bodies"),
                       count_text(static_cast<std::int64_t>(levels), "level"), progress);
}

std::string before_extension_text(std::string const& complete) { return "the file until then: " + complete; }

std::string so_far_text(std::string const& waves_text) { return waves_text + " so far"; }

std::string interim_text(std::int64_t waves, std::int64_t planned) {
    return fmt::format("INTERIM: {} of {} waves, those that were done first; the run is not complete\n", waves,
                       planned);
}

}  // namespace overturn::output

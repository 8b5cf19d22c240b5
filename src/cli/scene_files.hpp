/// The files that rock and spectrum take: one record, one body.
#pragma once

#include <string>
#include <vector>

#include "campaign/body_spec.hpp"
#include "cli/command_line.hpp"
#include "motion/recording.hpp"

namespace overturn::cli {

/// A record and what its file does not say itself; empty texts are not stated.
struct RecordOptions {
    std::string wave;
    std::string unit;                 ///< "gal"
    std::string time_step;            ///< "0.01 s"
    std::string format;               ///< a name of record_formats()
    std::string columns;              ///< "time,h1,h2,v"
    std::string component;            ///< component in the rocking plane
    std::string components = "file";  ///< other components, by a name of component_choices()
    std::string baseline = "none";    ///< as parse_baseline takes it

    /// Whether anything but the file is stated.
    [[nodiscard]] bool says_how_to_read() const;
};

/// Declares --unit, --time-step, --format, --columns, --component, --components, --baseline.
void add_record_options(Verb& verb, RecordOptions& options);

/// Says on stderr what was used if that is more than the file named. \throws InputError
[[nodiscard]] PlacedRecord load_motion(RecordOptions const& options);

/// Each as "warning: ..." on stderr.
void note_warnings(std::vector<std::string> const& lines);

[[nodiscard]] BodySpec load_body(std::string const& path);

}  // namespace overturn::cli

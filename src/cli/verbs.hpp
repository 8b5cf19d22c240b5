/// One function per verb: declares its options and what it does.
#pragma once

#include <string>

#include "cli/command_line.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

/// Option of verbs that read a finished file: the file is read even if it changed since it was written.
struct Unverified {
    bool read_changed = false;

    void offered_by(Verb& verb) {
        verb.takes("--unverified", read_changed,
                   "read the file even if it was edited or damaged after overturn wrote it");
    }
    [[nodiscard]] store::Trust trust() const { return read_changed ? store::Trust::unverified : store::Trust::sealed; }
    /// Says that a file is not as it was written, and that what follows is read from it as it is.
    /// \return whether it was changed
    [[nodiscard]] bool warn_if_edited(store::ResultsReader const& file, std::string const& path) const;
    /// The same, and says which verdicts of it this program does not know.
    [[nodiscard]] bool warn_if_changed(store::ResultsReader const& file, std::string const& path) const;
};

/// Option of verbs that write a results file.
struct Packing {
    bool packed = false;

    void offered_by(Verb& verb) {
        verb.takes(
            "--packed", packed,
            "compress the results file, also one that is complete (with --extend); what is packed stays so when it is "
            "extended; state it again with --resume: same content; about one sixth of the size from 100 000 trials on, "
            "one "
            "fifth of 24 000, no smaller up to 16 384");
    }
    [[nodiscard]] store::Layout layout() const { return packed ? store::Layout::packed : store::Layout::plain; }
};

void add_new(CommandLine& line);
void add_run(CommandLine& line);
void add_plan(CommandLine& line);
void add_merge(CommandLine& line);
void add_status(CommandLine& line);
void add_replay(CommandLine& line);
void add_verify(CommandLine& line);
void add_qualify(CommandLine& line);
void add_fit(CommandLine& line);
void add_report(CommandLine& line);
void add_export(CommandLine& line);
void add_cost(CommandLine& line);
void add_rock(CommandLine& line);
void add_spectrum(CommandLine& line);
void add_wave(CommandLine& line);
void add_spectra(CommandLine& line);
void add_list(CommandLine& line);

}  // namespace overturn::cli

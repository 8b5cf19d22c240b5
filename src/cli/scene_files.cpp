#include "cli/scene_files.hpp"

#include <cstdio>

#include "campaign/typed_units.hpp"
#include "core/input_files.hpp"
#include "core/print_note.hpp"
#include "core/units.hpp"
#include "generators/record_baseline.hpp"
#include "motion/column_unit.hpp"
#include "motion/station.hpp"

namespace overturn::cli {

bool RecordOptions::says_how_to_read() const {
    RecordOptions const unsaid{};
    return !(unit + time_step + format + columns + component).empty() || components != unsaid.components
           || baseline != unsaid.baseline;
}

void add_record_options(Verb& verb, RecordOptions& options) {
    verb.takes("--unit", options.unit,
               "unit of the accelerations, if the file does not state it: g, gal, m/s2, or \"2.4e-6 m/s2\" per count");
    verb.takes("--time-step", options.time_step, "time step, if the file does not state it, e.g. \"0.01 s\"");
    verb.takes("--format", options.format,
               "record format (overturn list formats); default: recognised from the content");
    verb.takes("--columns", options.columns,
               "meaning of the columns, if their names do not state it, e.g. time,h1,h2,v");
    verb.takes("--component", options.component, "component in the rocking plane, e.g. EW");
    verb.takes("--components", options.components,
               "file: all in the file; horizontal: one only; station: also from the files beside it");
    verb.takes("--baseline", options.baseline, "baseline correction: none, mean, polynomial, or \"high-pass 0.05 Hz\"");
}

PlacedRecord load_motion(RecordOptions const& options) {
    InputFiles files(".");
    RecordRequest request;
    if (!options.unit.empty()) {
        state_unit(request, options.unit);
    }
    if (!options.time_step.empty()) {
        request.time_step_s = parse_quantity(options.time_step, Dimension::time);
    }
    request.format = options.format.empty() ? "auto" : options.format;
    request.columns = options.columns;
    request.component = options.component;
    request.components = config::find_entry(component_choices(), options.components, "--components").value;
    auto const baseline = parse_baseline(options.baseline);
    auto placed = StationFiles(files).read(options.wave, request);
    if (auto const note = correct_and_tell(placed.motion, baseline); !note.empty()) {
        placed.says += ", " + note;
    }
    if (placed.says != options.wave) {
        print_note("wave: {}\n", placed.says);
    }
    return placed;
}

void note_warnings(std::vector<std::string> const& lines) {
    for (auto const& line : lines) {
        print_note("warning: {}\n", line);
    }
}

BodySpec load_body(std::string const& path) {
    InputFiles files(".");
    auto const table = config::Table::parse(files.read(path), path);
    table.described_by(bodies_table);
    auto body = read_body(table, files);
    body.units = typed_units(table.inputs());
    return body;
}

}  // namespace overturn::cli

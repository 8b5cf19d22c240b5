#include "generators/detail/records.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/withheld.hpp"
#include "generators/detail/axes.hpp"
#include "generators/detail/record_keys.hpp"
#include "generators/detail/recorded_waves.hpp"
#include "generators/detail/sa_change.hpp"
#include "generators/record_baseline.hpp"
#include "motion/intensity.hpp"
#include "motion/named_recordings.hpp"
#include "motion/resample.hpp"
#include "motion/station.hpp"
#include "motion/usual_time_step.hpp"

namespace overturn {
namespace {

// Equal up to what printing or a quotient such as 1/100 costs.
bool same_step(double a, double b) {
    constexpr double printed = 1e-3;
    return std::abs(a - b) <= printed * b;
}

// What a table says about its files besides their names.
struct Request {
    RecordRequest record;
    Coarsening coarsening = Coarsening::refused;
    RecordBaseline baseline;
    double scale = 1;
    double time_scale = 1;
    AxesRequest axes;
};

Request read_request(config::Table const& table) {
    Request request;
    request.record.format = table.text(reading_keys["format"]);
    if (table.has("unit")) {
        auto const unit = table.text(reading_keys["unit"]);
        table.located("unit", [&] { state_unit(request.record, unit); });
    }
    request.record.time_step_s = table.maybe_number(reading_keys["time_step"]);
    request.record.may_be_resampled = true;
    request.record.unit_key = R"(unit = "gal", "g" or "m/s2")";
    request.record.unit_conflict = "Leave it out; where other files need it, give each a [[waves.records]] of its own";
    request.record.columns = table.text(reading_keys["columns"]);
    request.record.columns_key = R"(columns = "{}")";
    request.record.component = table.text(reading_keys["component"]);
    request.record.components = table.choice(reading_keys["components"], component_choices());
    request.coarsening = table.choice<Coarsening>(reading_keys["resample"], coarsenings);
    request.baseline = read_baseline(table);
    request.axes = read_axes(table);
    request.scale = table.number(reading_keys["scale"]);
    request.time_scale = table.number(reading_keys["time_scale"]);
    return request;
}

// The names of a table's files, as they lie in the folder of all records.
std::string in_folder(std::string const& folder, std::string const& name) {
    return folder.empty() ? name : (std::filesystem::path(folder) / name).string();
}

std::string read_folder(config::Table const& waves, InputFiles const& files) {
    auto folder = waves.text(record_files_keys["folder"]);
    if (!folder.empty() && !files.has_folder(folder)) {
        waves.fail("folder",
                   fmt::format("'{}' (no such folder; records are not part of the program). Name the one where "
                               "yours lie: --set waves.folder=FOLDER",
                               folder));
    }
    return folder;
}

void scale(Record& record, double factor) {
    if (factor == 1) {
        return;
    }
    record.motion.scale(factor);
    record.label += fmt::format(", times {:g}", factor);
}

// Before components are mixed or scaled, and after they have their common length: what is cut off would drift again.
void correct(config::Table const& table, Record& record, RecordBaseline const& baseline) {
    if (baseline.method == BaselineMethod::none) {
        return;
    }
    record.label += ", " + table.located("baseline", [&] { return correct_and_tell(record.motion, baseline); });
}

void turn_to_axes(config::Table const& table, Record& record, AxesRequest const& request) {
    if (request.axes == Axes::recorded) {
        return;
    }
    if (record.motion.transverse_mps2.empty()) {
        table.fail("axes", fmt::format("of {} (which has one horizontal component: nothing to turn). State the other "
                                       "one, or components = \"station\"",
                                       record.label));
    }
    bool const principal = request.axes == Axes::principal;
    record.turned_rad = principal ? principal_angle(record.motion) : request.angle_rad;
    turn_axes(record.motion, record.turned_rad);
    record.label += fmt::format(", turned by {:.1f} deg{}", record.turned_rad * 180 / pi,
                                principal ? " to its principal axes" : "");
}

// Corners of filters and polynomials are of the ground's own time.
void scale_time(Record& record, double factor) {
    if (factor != 1) {
        record.motion.time_step_s *= factor;
        record.label += fmt::format(", time times {:g}", factor);
    }
}

void finish_record(config::Table const& table, Request const& request, Record& record) {
    correct(table, record, request.baseline);
    turn_to_axes(table, record, request.axes);
    scale_time(record, request.time_scale);
    scale(record, request.scale);
    record.drift = drift_of(record.motion, request.scale);
}

Record read_motion(config::Table const& table, std::string_view key, std::string const& name, Request const& request,
                   StationFiles& files) {
    return table.located(key, [&] {
        auto placed = files.read(name, request.record);
        if (!placed.unread.empty()) {
            placed.says += fmt::format(" ({} of its lines of text not understood: overturn spectrum lists them)",
                                       placed.unread.size());
        }
        if (auto const odd = unusual_time_step(placed.motion.time_step_s); !odd.empty()) {
            placed.says += fmt::format(", check its unit: {}", odd);
        }
        if (placed.in_borehole) {
            placed.says += ", recorded in a borehole, not at the surface";
        }
        auto const record_of = [&](GroundMotion motion, std::string says) {
            return Record{std::move(motion), std::move(says), placed.direction, 0, {}, {}, {}, {}};
        };
        auto const step = request.record.time_step_s;
        if (!step || same_step(*step, placed.motion.time_step_s)) {
            return record_of(std::move(placed.motion), std::move(placed.says));
        }
        auto resampled = resample(placed.motion, *step, request.coarsening);
        if (resampled.changed) {
            resampled.says += sa_change_text(placed.motion, resampled.motion);
        }
        return record_of(std::move(resampled.motion), fmt::format("{}, {}", placed.says, resampled.says));
    });
}

Record read_horizontal(config::Table const& table, std::string_view key, std::string const& name,
                       Request const& request, StationFiles& files) {
    auto record = read_motion(table, key, name, request, files);
    table.located(key, [&] { validate_rocking_plane(record.direction, {name}); });
    return record;
}

void add_component(config::Table const& table, std::string_view key, Request request, StationFiles& files,
                   std::string const& folder, Record& record, std::vector<double> GroundMotion::*place) {
    if (!table.has(key)) {
        return;
    }
    if (request.record.components == ComponentChoice::station) {
        table.fail(key, "stated beside components = \"station\" (which finds it by itself). Keep one of them");
    }
    request.record.component.clear();
    request.record.components = ComponentChoice::horizontal;
    auto component = read_motion(table, key, in_folder(folder, table.text(key)), request, files);
    if (component.motion.time_step_s != record.motion.time_step_s) {
        table.fail(key, fmt::format("time step {} s beside {} s of the horizontal component (they must agree). State "
                                    "the time_step to which both are resampled",
                                    component.motion.time_step_s, record.motion.time_step_s));
    }
    if (!(record.motion.*place).empty()) {
        table.fail(key, "a second file for a component that the first one holds already. Remove this key");
    }
    bool const vertical = place == &GroundMotion::vertical_mps2;
    bool const recorded_vertically = component.direction == Direction::up || component.direction == Direction::down;
    if (component.direction != Direction::unknown && recorded_vertically != vertical) {
        table.fail(key, fmt::format("'{}' (recorded {}). Name the file of the {} component", table.text(key),
                                    vertical ? "horizontally" : "vertically", key));
    }
    if (component.direction == Direction::down) {
        turn(component.motion.horizontal_mps2);
        component.label += " with its sign turned";
    }
    record.motion.*place = std::move(component.motion.horizontal_mps2);
    record.label += fmt::format(", {} {}", key, component.label);
}

// In the place of a record that is known by its hash alone: enough to count and to name it.
std::optional<Record> withheld_record(config::Table const& table, std::initializer_list<std::string> names,
                                      InputFiles const& files) {
    for (auto const& name : names) {
        auto const found = files.contents().find(name);
        if (found != files.contents().end() && is_withheld(found->second)) {
            (void)read_request(table);
            Record stands_for_it;
            stands_for_it.label = name + " (withheld)";
            stands_for_it.withheld = name;
            return stands_for_it;
        }
    }
    return std::nullopt;
}

// Cuts all components to the shortest; true if that took anything away.
bool cut_to_shortest(GroundMotion& motion) {
    auto shortest = motion.samples();
    bool cut = false;
    for (auto const* component : {&motion.transverse_mps2, &motion.vertical_mps2}) {
        cut = cut || (!component->empty() && component->size() != shortest);
        shortest = component->empty() ? shortest : std::min(shortest, component->size());
    }
    for (auto* component : {&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2}) {
        component->resize(std::min(component->size(), shortest));
    }
    return cut;
}

Record read_file(config::Table const& waves, Request const& request, std::string const& name, StationFiles& files,
                 InputFiles const& contents) {
    if (auto stands_for_it = withheld_record(waves, {name}, contents)) {
        return *std::move(stands_for_it);
    }
    auto record = read_horizontal(waves, "files", name, request, files);
    finish_record(waves, request, record);
    return record;
}

Record read_table(config::Table const& table, StationFiles& files, InputFiles const& contents,
                  std::string const& folder) {
    auto const name = [&](std::string_view key) {
        return table.has(key) ? in_folder(folder, table.text(key)) : std::string();
    };
    if (auto const stands_for_it =
            withheld_record(table, {name("horizontal"), name("transverse"), name("vertical")}, contents)) {
        table.finish();
        return *stands_for_it;
    }
    auto const request = read_request(table);
    auto record =
        read_horizontal(table, "horizontal", in_folder(folder, table.text(record_keys["horizontal"])), request, files);
    add_component(table, "transverse", request, files, folder, record, &GroundMotion::transverse_mps2);
    add_component(table, "vertical", request, files, folder, record, &GroundMotion::vertical_mps2);
    if (cut_to_shortest(record.motion)) {
        record.label += fmt::format(" (components cut to {} samples)", record.motion.samples());
    }
    finish_record(table, request, record);
    table.finish();
    return record;
}

// Where neither the campaign nor the files say of which recording they are, their names do.
void tell_apart(std::vector<Record>& records, std::span<std::string const> paths) {
    std::vector<std::string> names;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (records[i].recording.empty()) {
            records[i].recording = std::filesystem::path(paths[i]).lexically_normal().generic_string();
            names.push_back(records[i].recording);
            places.push_back(i);
        }
    }
    auto const first = named_recordings(names);
    for (std::size_t i = 0; i < places.size(); ++i) {
        records[places[i]].recording = names[first[i]];
    }
}

}  // namespace

std::unique_ptr<WaveSource> make_records(config::Table const& waves, InputFiles& files) {
    if (waves.has("files") == waves.has("records")) {
        waves.fail({}, "no single list of records (state either files or records)");
    }
    std::vector<Record> records;
    std::vector<std::string> paths;
    StationFiles station_files(files);
    auto const folder = read_folder(waves, files);
    if (waves.has("files")) {
        auto const request = read_request(waves);
        for (auto const& name : waves.texts(record_files_keys["files"])) {
            records.push_back(read_file(waves, request, in_folder(folder, name), station_files, files));
            records.back().name = name;
            records.back().recording = station_files.recording_of(in_folder(folder, name));
            paths.push_back(in_folder(folder, name));
        }
    } else {
        for (auto const& key : reading_keys.all) {
            if (waves.has(key.name)) {
                waves.fail(key.name, "beside [[waves.records]] (each record has its own). Move it into these tables");
            }
        }
        for (auto const& table : waves.children(record_files_keys["records"])) {
            records.push_back(read_table(table, station_files, files, folder));
            records.back().name = table.has("horizontal") ? table.text(record_keys["horizontal"]) : std::string();
            paths.push_back(in_folder(folder, records.back().name));
            records.back().recording = station_files.recording_of(paths.back());
        }
    }
    if (records.empty()) {
        waves.fail(waves.has("files") ? "files" : "records", "no record (the list is empty). Name at least one file");
    }
    if (auto const same = files.are_before_format_5() ? std::nullopt : same_motion_twice(records)) {
        waves.fail(
            waves.has("files") ? "files" : "records",
            fmt::format(
                "records {} and {} are one motion{} (counted twice it makes intervals too short). Leave one "
                "out; [levels] scale motions",
                same->first + 1, same->second + 1,
                std::abs(same->factor - 1) < same_motion_share ? "" : fmt::format(" times {:.4g}", same->factor)));
    }
    tell_apart(records, paths);
    return recorded_waves(std::move(records));
}

}  // namespace overturn

#include "motion/station.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/withheld.hpp"

namespace overturn {
namespace {

constexpr std::size_t head_bytes = 16384;  // more than any header

}  // namespace

StationFiles::FilesOfStation const& StationFiles::folder_of(std::string const& name) {
    auto const folder = std::filesystem::path(name).parent_path().string();
    auto const known = folders_.find(folder);
    if (known != folders_.end()) {
        return known->second;
    }
    FilesOfStation found;
    for (auto const& file : files_->beside(name)) {
        if (auto station = station_of_record(files_->head(file, head_bytes)); !station.empty()) {
            found[std::move(station)].push_back(file);
        }
    }
    return folders_.emplace(folder, std::move(found)).first->second;
}

std::string StationFiles::recording_of(std::string const& name) {
    auto const& content = files_->read(name);
    return is_withheld(content) ? recording_of_withheld(content) : station_of_record(content);
}

Recording StationFiles::joined(std::string const& name, Recording own, RecordRequest const& request) {
    auto const station = station_of_record(files_->read(name));
    auto const& component = own.components.front();
    if (station.empty() || component.direction == Direction::unknown) {
        throw InputError({name},
                         "station or direction not stated in it (so its other components cannot be found). "
                         "Name them yourself: horizontal, transverse, vertical");
    }
    if (is_vertical(component.direction)) {
        throw InputError({name}, fmt::format("the vertical component {} (the rocking plane is horizontal). Name a "
                                             "horizontal one, the vertical is then found",
                                             component.name));
    }
    own.components.front().name = name;
    auto const found = folder_of(name);
    auto const of_station = found.find(station);
    for (auto const& file : of_station == found.end() ? std::vector<std::string>{} : of_station->second) {
        if (std::filesystem::path(file).lexically_normal() == std::filesystem::path(name).lexically_normal()) {
            continue;
        }
        auto other_request = request;
        other_request.name = file;
        auto other = read_recording(files_->read(file), other_request);
        if (other.time_step_s != own.time_step_s) {
            throw InputError({file}, fmt::format("time step of {} s beside {} s in '{}' (components must agree). Name "
                                                 "the files that belong together",
                                                 other.time_step_s, own.time_step_s, name));
        }
        other.components.front().name = file;
        own.components.push_back(std::move(other.components.front()));
    }
    if (own.components.size() == 1) {
        throw InputError({name}, fmt::format("no other file of station '{}' beside it (components = \"station\" was "
                                             "asked for). Fetch them, or leave components out",
                                             station));
    }
    return own;
}

PlacedRecord StationFiles::read(std::string const& name, RecordRequest request) {
    request.name = name;
    request.by_place = files_->are_before_format_5();
    auto recording = read_recording(files_->read(name), request);
    bool const alone = recording.components.size() == 1;
    if (request.components == ComponentChoice::station && alone) {
        recording = joined(name, std::move(recording), request);
        request.component.clear();
    }
    auto placed = place(std::move(recording), request.component, request.components, {name});
    validate_motion(placed.motion);
    if (alone && request.components != ComponentChoice::station) {
        placed.says = name;
    } else if (!alone) {
        placed.says = fmt::format("{} ({})", name, placed.says);
    }
    if (request.components == ComponentChoice::station && placed.motion.vertical_mps2.empty()) {
        placed.says += ", no vertical found";
    }
    return placed;
}

}  // namespace overturn

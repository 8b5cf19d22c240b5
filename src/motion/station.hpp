/// The files of one station's recording, found by what they say, never by their names.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/input_files.hpp"
#include "motion/record.hpp"

namespace overturn {

/// Reads records from files. Folders are looked through once, when ComponentChoice::station first needs them.
class StationFiles {
  public:
    explicit StationFiles(InputFiles& files) : files_(&files) {}

    /// The record `name`. With ComponentChoice::station a file of one component is joined by the other components of
    /// its station and event in the same folder: files of the same format whose headers name the same station, event
    /// and time. They must have the same time step; what is longer is cut. PlacedRecord::says names every file used.
    /// \throws InputError as read_recording and place; if the file does not say its station, is a vertical one, stands
    /// alone, or two files state one direction
    [[nodiscard]] PlacedRecord read(std::string const& name, RecordRequest request);
    /// Station, event and time of a file of one component, equal of those of one recording; empty where its head does
    /// not state them. Of a withheld file as it was stated when it was put aside.
    [[nodiscard]] std::string recording_of(std::string const& name);

  private:
    using FilesOfStation = std::map<std::string, std::vector<std::string>>;

    [[nodiscard]] FilesOfStation const& folder_of(std::string const& name);
    [[nodiscard]] Recording joined(std::string const& name, Recording own, RecordRequest const& request);

    InputFiles* files_;
    std::map<std::string, FilesOfStation> folders_;
};

}  // namespace overturn

/// The files of one station's recording.
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
    /// Equal of files that hold components of one recording: by station, event and time, where a file's head states
    /// them, else by its path without the names of directions ("kobe_NS.csv", "kobe_EW.csv").
    [[nodiscard]] std::string recording_of(std::string const& name);

  private:
    using FilesOfStation = std::map<std::string, std::vector<std::string>>;

    [[nodiscard]] FilesOfStation const& folder_of(std::string const& name);
    [[nodiscard]] Recording joined(std::string const& name, Recording own, RecordRequest const& request);

    InputFiles* files_;
    std::map<std::string, FilesOfStation> folders_;
};

}  // namespace overturn

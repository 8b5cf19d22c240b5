/// What the prose of a record file says of its numbers: lines of text above them, comments, names of columns. Nothing
/// is taken from it, but what the user states may not contradict it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motion/record.hpp"

namespace overturn {

class Prose {
  public:
    /// Looks for "in m/s/s", "(gal)", "units: g", and for "dt = 0.005", "Time Increment (s): 0.005", "sampling rate 100
    /// Hz", "points at 0.02 sec", "200 sps". "9.81 m/s2" says nothing. What is said twice, differently, is not said.
    /// "Velocity in cm/s" says that the numbers are no accelerations, unless some line speaks of these.
    void take(std::string_view line, int number);

    /// Of the accelerations [m/s2].
    [[nodiscard]] std::optional<double> unit() const { return unit_.value; }
    /// [s]
    [[nodiscard]] std::optional<double> time_step_s() const { return step_.value; }

    /// "; line 10 says m/s2", or "" if it says none: for messages that ask for it.
    [[nodiscard]] std::string unit_hint() const;
    [[nodiscard]] std::string time_step_hint() const;

    /// \throws InputError if what the request states contradicts what is said, or the numbers are no accelerations
    void check(RecordRequest const& request) const;
    /// \throws InputError if times that rise by `step_s` contradict what is said
    void check_times(double step_s, std::string const& file) const;

  private:
    struct Statement {
        std::optional<double> value;
        int line = 0;
        bool contradicted = false;
        void take(double stated, int number);
    };
    Statement unit_, step_;
    int other_line_ = 0;          ///< that speaks of velocities or displacements in their unit; 0: none
    bool accelerations_ = false;  ///< some line speaks of them
};

}  // namespace overturn

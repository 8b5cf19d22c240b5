/// All faults of a file, reported at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/table.hpp"
#include "core/error.hpp"

namespace overturn::config {

/// One message of several: what() of an InputError, a line each. Breaks within one become blanks.
[[nodiscard]] std::string joined_faults(std::vector<std::string> const& faults);

/// The lines of such a message; one of any other.
[[nodiscard]] std::vector<std::string> faults_of(std::string_view message);

/// `first`, which stopped a reader of `table`, and behind it all of faults() that speak of other places.
[[nodiscard]] std::string with_further_faults(std::string_view first, Table const& table);

/// Runs `build`; its faults are reported together with all other deviations from the description of `table`.
template <class Build> auto with_all_faults(Table const& table, Build&& build) {
    try {
        return build();
    } catch (InputError const& error) {
        throw InputError(with_further_faults(error.what(), table));
    }
}

/// Runs readers that need nothing of each other, and reports the faults of all of them together.
class FaultGatherer {
  public:
    template <class Read> void run(Read&& read) {
        try {
            read();
        } catch (InputError const& error) {
            add(error.what());
        }
    }
    /// \throws InputError if any failed
    void tell() const;

  private:
    void add(std::string_view message);
    std::vector<std::string> faults_;
};

}  // namespace overturn::config

/// Values read from a document and from the files it names.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "config/input_value.hpp"

namespace overturn::config {

/// Holds one entry per key: what is stated outranks a default, a table outranks the file it names.
class Ledger {
  public:
    void add(InputValue value);
    /// Adds the word of a file on a key that it leaves out. A default that stood in for the key keeps its text.
    void add_left_out(InputValue value);
    /// In the order of reading, without what an outer table outranks.
    [[nodiscard]] std::vector<InputValue> values() const;

  private:
    [[nodiscard]] bool is_outranked(InputValue const& value) const;

    std::vector<InputValue> values_;
    std::map<std::string, std::size_t, std::less<>> places_;
};

}  // namespace overturn::config

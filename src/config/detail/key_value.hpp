/// Is a value one that its key takes?
#pragma once

#include <toml++/toml.h>

#include "config/key.hpp"
#include "config/table.hpp"

namespace overturn::config {

/// \throws InputError unless the value is one that the key takes; tables within are not looked into
void read_value(Table const& table, Key const& key, toml::node const& value);

}  // namespace overturn::config

/// Wave sources straight from the text of a [waves] table.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "generators/wave_source.hpp"

namespace overturn::testing {

/// `keys` are those of [waves]; child tables are written [target], not [waves.target]. Nothing may stay unread.
inline std::unique_ptr<WaveSource> source_of(std::string const& keys,
                                             std::map<std::string, std::string> contents = {}) {
    auto const table = config::Table::parse(keys, "c.toml");
    InputFiles files(std::move(contents));
    auto source = make_wave_source(table, files);
    table.finish();
    return source;
}

}  // namespace overturn::testing

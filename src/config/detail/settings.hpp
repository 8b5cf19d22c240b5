/// "key.sub=value" settings of the command line, written into a parsed campaign.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace overturn::config {

/// Sets document[path] = the TOML value right of '='; tables on the way are made, `bodies.0.name` or `bodies[0].name`
/// reaches into a list.
/// Bare words count as text, so a.b=auto needs no quotes. \throws InputError if the path leads nowhere
void apply_setting(toml::table& document, std::string const& setting);

}  // namespace overturn::config

#include "config/detail/settings.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::config {
namespace {

// As messages name places: bodies[0].friction is bodies.0.friction.
std::string dotted(std::string_view path) {
    std::string text{path};
    std::erase(text, ']');
    std::ranges::replace(text, '[', '.');
    return text;
}

}  // namespace

void apply_setting(toml::table& document, std::string const& setting) {
    auto const equals = setting.find('=');
    validate(equals != std::string::npos && equals > 0, "--set {} (no '='). Write key.sub=value", setting);
    auto const path = dotted(trimmed(std::string_view(setting).substr(0, equals)));
    std::string const value{trimmed(std::string_view(setting).substr(equals + 1))};
    toml::table parsed;
    try {
        parsed = toml::parse("value = " + value);
    } catch (toml::parse_error const&) {
        parsed.insert_or_assign("value", value);
    }
    toml::node* at = &document;
    std::size_t begin = 0;
    while (true) {
        auto const dot = path.find('.', begin);
        bool const last = dot == std::string::npos;
        auto const part = path.substr(begin, last ? dot : dot - begin);
        validate(!part.empty(), "--set {} (empty name in '{}'). Write key.sub=value", setting, path);
        if (auto* array = at->as_array()) {
            std::size_t index = 0;
            auto const read = std::from_chars(part.data(), part.data() + part.size(), index);
            validate(read.ec == std::errc{} && read.ptr == part.data() + part.size() && index < array->size(),
                     "--set {} ('{}' is no place in a list of {}). Count from 0", setting, part, array->size());
            validate(!last, "--set {} (replaces a list entry). Name a key inside it", setting);
            at = array->get(index);
        } else if (auto* table = at->as_table()) {
            if (last) {
                table->insert_or_assign(part, *parsed.get("value"));
                return;
            }
            if (table->get(part) == nullptr) {
                table->insert(part, toml::table{});
            }
            at = table->get(part);
        } else {
            throw InputError(
                fmt::format("--set {} ('{}' lies inside a plain value). Name a key of a table", setting, part));
        }
        begin = dot + 1;
    }
}

}  // namespace overturn::config

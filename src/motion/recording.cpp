#include "motion/recording.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/suggestion.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Names = std::vector<std::string>;

bool is_vertical(RecordComponent const& component) { return is_vertical(component.direction); }

Names names_of(Recording const& recording) {
    Names names;
    names.reserve(recording.components.size());
    for (auto const& component : recording.components) {
        names.push_back(component.name);
    }
    return names;
}

std::string list_of(Names const& names) {
    std::string list;
    for (auto const& name : names) {
        list += list.empty() ? "" : ", ";
        list += name.empty() ? "(no name)" : name;
    }
    return list;
}

// Takes the component called `name` out; spaces and case do not count, nor what a column's name says beside it: "E-W"
// is "E-W(cm/s/s)" where no other is.
RecordComponent taken(Recording& recording, std::string_view name, Location const& where) {
    auto const plain = [](std::string_view text) {
        auto lower = lowered(text);
        std::erase(lower, ' ');
        return lower;
    };
    auto at = std::ranges::find_if(recording.components,
                                   [&](RecordComponent const& c) { return plain(c.name) == plain(name); });
    if (at == recording.components.end()) {
        auto const wanted = component_named(name);
        auto const same = [&](RecordComponent const& c) {
            auto const own = component_in(c.name);
            return own.direction != Direction::unknown && own.direction == wanted.direction && own.axis == wanted.axis;
        };
        bool const one = std::ranges::count_if(recording.components, same) == 1;
        at = one ? std::ranges::find_if(recording.components, same) : at;
    }
    if (at == recording.components.end()) {
        auto const names = names_of(recording);
        throw InputError(where, fmt::format("component '{}' (not in the file). {}", name,
                                            config::suggestion(std::string(name), names)));
    }
    auto component = std::move(*at);
    recording.components.erase(at);
    return component;
}

// The only component that satisfies `wanted`, taken out; an empty one if there is none.
template <class Wanted>
RecordComponent only(Recording& recording, char const* what, Location const& where, Wanted&& wanted) {
    auto const at = std::find_if(recording.components.begin(), recording.components.end(), wanted);
    if (at == recording.components.end()) {
        return {};
    }
    auto component = std::move(*at);
    recording.components.erase(at);
    auto const second = std::find_if(recording.components.begin(), recording.components.end(), wanted);
    if (second != recording.components.end()) {
        throw InputError(where, fmt::format("'{}' and '{}' (one {} component is needed). Put those of one sensor into "
                                            "a file of their own",
                                            component.name, second->name, what));
    }
    return component;
}

RecordComponent first_horizontal(Recording& recording, std::string_view first, Location const& where) {
    if (!first.empty()) {
        return taken(recording, first, where);
    }
    auto const at = std::find_if(recording.components.begin(), recording.components.end(),
                                 [](RecordComponent const& c) { return !is_vertical(c); });
    auto const chosen = at == recording.components.end() ? recording.components.begin() : at;
    auto component = std::move(*chosen);
    recording.components.erase(chosen);
    return component;
}

std::string cut_to_shortest(GroundMotion& motion) {
    std::array const all{&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2};
    auto shortest = motion.samples();
    auto longest = shortest;
    for (auto const* component : all) {
        shortest = component->empty() ? shortest : std::min(shortest, component->size());
        longest = std::max(longest, component->size());
    }
    if (shortest == longest) {
        return {};
    }
    for (auto* component : all) {
        component->resize(std::min(component->size(), shortest));
    }
    return fmt::format(", cut to {} samples", shortest);
}

}  // namespace

std::span<config::Entry<ComponentChoice> const> component_choices() {
    static constexpr std::array entries{
        config::Entry<ComponentChoice>{"file", "every component that the file holds", ComponentChoice::file},
        config::Entry<ComponentChoice>{"horizontal", "one horizontal component only", ComponentChoice::horizontal},
        config::Entry<ComponentChoice>{"station", "those of the same station in the files beside it as well",
                                       ComponentChoice::station},
    };
    return entries;
}

std::string PlacedRecord::read_as() const {
    auto const named =
        std::any_of(components.begin(), components.end(), [](auto const& name) { return !name.empty(); });
    return fmt::format("{}, {}{}, {:.6g} s, {} samples, {:.6g} s", format, named ? list_of(components) + ", " : "",
                       name_of_acceleration_unit(unit_mps2), motion.time_step_s, motion.samples(), motion.duration_s());
}

void turn(std::vector<double>& acceleration_mps2) {
    for (double& value : acceleration_mps2) {
        value = 0 - value;  // not -0 where the ground rests
    }
}

PlacedRecord place(Recording recording, std::string_view first, ComponentChoice choice, Location const& where) {
    PlacedRecord placed;
    placed.motion.time_step_s = recording.time_step_s;
    placed.format = recording.format;
    placed.unit_mps2 = recording.unit_mps2;
    placed.statements = std::move(recording.statements);
    placed.unread = std::move(recording.unread);
    placed.in_borehole = recording.in_borehole;
    bool const single = recording.components.size() == 1;
    auto const names = names_of(recording);
    auto horizontal = first_horizontal(recording, first, where);
    placed.says = horizontal.name;
    placed.components = {horizontal.name};
    placed.direction = horizontal.direction;
    placed.motion.horizontal_mps2 = std::move(horizontal.acceleration_mps2);
    if (single || choice == ComponentChoice::horizontal) {
        return placed;
    }
    if (!first.empty() && is_vertical(horizontal)) {
        throw InputError(where, fmt::format("component '{}' (it is vertical, and the rocking plane takes a horizontal "
                                            "one). State a horizontal component: the vertical one finds its place by "
                                            "itself",
                                            horizontal.name));
    }
    auto vertical = only(recording, "vertical", where, [](RecordComponent const& c) { return is_vertical(c); });
    auto transverse = only(recording, "second horizontal", where,
                           [](RecordComponent const& c) { return c.direction == Direction::horizontal; });
    if (!recording.components.empty() || is_vertical(horizontal)) {
        throw InputError(where, fmt::format("components {} (horizontal or vertical is ambiguous). "
                                            "State the columns, or take those that are meant into a file of their own",
                                            list_of(names)));
    }
    if (!transverse.acceleration_mps2.empty()) {
        placed.says += fmt::format(", transverse {}", transverse.name);
        placed.components.push_back(transverse.name);
        placed.motion.transverse_mps2 = std::move(transverse.acceleration_mps2);
    }
    if (!vertical.acceleration_mps2.empty()) {
        if (vertical.direction == Direction::down) {
            turn(vertical.acceleration_mps2);
        }
        placed.components.push_back(vertical.name);
        placed.says += fmt::format(", vertical {}{}", vertical.name,
                                   vertical.direction == Direction::down ? " with its sign turned" : "");
        placed.motion.vertical_mps2 = std::move(vertical.acceleration_mps2);
    }
    placed.says += cut_to_shortest(placed.motion);
    return placed;
}

void validate_rocking_plane(Direction direction, Location const& where) {
    if (is_vertical(direction)) {
        throw InputError(
            where,
            "recorded vertically (the rocking plane takes a horizontal component). Name a horizontal "
            "record: its vertical one joins it by components = station, or as vertical of [[waves.records]]");
    }
}

}  // namespace overturn

#include "spectra/target_input.hpp"

#include <optional>

#include "spectra/named_targets.hpp"

namespace overturn {
namespace {

TargetSpectrum read_named(config::Table const& table, double damping) {
    auto const make = table.choice("spectrum", named_targets());
    NamedTargetInput input{.damping = damping,
                           .pga_mps2 = table.maybe_number("pga", Dimension::acceleration, config::Range::positive())};
    return table.located("spectrum", [&] { return make(input); });
}

TargetSpectrum read_tabulated(config::Table const& table, InputFiles& files, double damping) {
    auto const kind = table.choice("kind", target_kinds());
    auto const ordinate = dimension_of(kind);
    std::optional<double> unit;
    if (table.has("unit")) {
        auto const symbol = table.text("unit");
        unit = table.located("unit", [&] { return unit_factor(symbol, ordinate); });
    }
    if (table.has("file")) {
        auto const name = table.text("file");
        return table.located("file", [&] { return parse_target_table(files.read(name), name, kind, damping, unit); });
    }
    // With a unit stated for all of them, points are numbers alone.
    auto points = table.pairs("points", Dimension::time, unit ? Dimension::none : ordinate);
    for (auto& point : points) {
        point.second *= unit.value_or(1);
    }
    return table.located("points",
                         [&] { return TargetSpectrum::from_points("campaign points", damping, kind, points); });
}

}  // namespace

TargetSpectrum read_target(config::Table const& table, InputFiles& files) {
    table.may_have({"spectrum", "pga", "kind", "points", "file", "unit", "damping", "stated_damping", "damping_rule",
                    "scale", "time_scale", "longest", "ratio", "correlation"});
    constexpr config::Range fraction{.low = 0, .high = 1, .low_open = true, .high_open = true};
    auto const damping = table.number("damping", Dimension::none, fraction, 0.05);
    int const ways = (table.has("spectrum") ? 1 : 0) + (table.has("points") ? 1 : 0) + (table.has("file") ? 1 : 0);
    if (ways != 1) {
        table.fail({}, "no single target (exactly one of spectrum, points, file states it). Keep one");
    }
    auto const stated = table.number("stated_damping", Dimension::none, fraction, damping);
    auto target = table.has("spectrum") ? read_named(table, stated) : read_tabulated(table, files, stated);
    if (table.has("damping_rule")) {
        auto const rule = table.choice("damping_rule", damping_rules());
        target = table.located("damping", [&] { return target.at_damping(damping, rule); });
    } else if (stated != damping) {
        table.fail("stated_damping", fmt::format("{} beside damping {} (nothing says how to carry the spectrum over). "
                                                 "Add damping_rule",
                                                 stated, damping));
    }
    auto const scale = table.number("scale", Dimension::none, config::Range::positive(), 1.0);
    auto const time_scale = table.number("time_scale", Dimension::none, config::Range::positive(), 1.0);
    return target.scaled(scale).at_time_scale(time_scale);
}

}  // namespace overturn

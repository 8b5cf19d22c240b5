#include "spectra/target_input.hpp"

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
    if (table.has("file")) {
        auto const name = table.text("file");
        return table.located("file", [&] { return parse_target_table(files.read(name), name, kind, damping); });
    }
    auto const ordinate = kind == TargetKind::acceleration ? Dimension::acceleration : Dimension::velocity;
    auto const points = table.pairs("points", Dimension::time, ordinate);
    return table.located("points",
                         [&] { return TargetSpectrum::from_points("campaign points", damping, kind, points); });
}

}  // namespace

TargetSpectrum read_target(config::Table const& table, InputFiles& files) {
    auto const damping =
        table.number("damping", Dimension::none, {.low = 0, .high = 1, .low_open = true, .high_open = true}, 0.05);
    int const ways = (table.has("spectrum") ? 1 : 0) + (table.has("points") ? 1 : 0) + (table.has("file") ? 1 : 0);
    if (ways != 1) {
        table.fail({}, "no single target (exactly one of spectrum, points, file states it). Keep one");
    }
    auto target = table.has("spectrum") ? read_named(table, damping) : read_tabulated(table, files, damping);
    auto const scale = table.number("scale", Dimension::none, config::Range::positive(), 1.0);
    auto const time_scale = table.number("time_scale", Dimension::none, config::Range::positive(), 1.0);
    return target.scaled(scale).at_time_scale(time_scale);
}

}  // namespace overturn

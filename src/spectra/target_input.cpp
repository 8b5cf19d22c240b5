#include "spectra/target_input.hpp"

#include <optional>

#include "core/error.hpp"
#include "spectra/detail/design_json.hpp"
#include "spectra/detail/design_part.hpp"
#include "spectra/named_targets.hpp"

namespace overturn {
namespace {

constexpr config::Range fraction{.low = 0, .high = 1, .low_open = true, .high_open = true};
constexpr config::Keys target_keys{
    config::word_key<named_targets>("spectrum", "a published spectrum").only("there are no points and no file"),
    config::number_key("pga", Dimension::acceleration, config::Range::positive(),
                       "peak acceleration that scales a normalised spectrum")
        .optional()
        .only("spectrum is stated"),
    config::pairs_key("points", Dimension::time, Dimension::acceleration,
                      "pairs [period, ordinate], interpolated linearly in log-log")
        .in_unit_of("kind")
        .only("there is no spectrum and no file"),
    config::text_key("file", "file with two columns, period and ordinate").only("there is no spectrum and no points"),
    config::text_key("part", "name of one spectrum in a file with several (JSON name or column name)")
        .optional()
        .only("file is stated"),
    config::word_key<target_kinds>("kind", "quantity of the ordinates").only("points or file are stated"),
    config::text_key("unit", "unit of the ordinates, if file or points do not state it")
        .otherwise_in_words("that of the file; of points SI")
        .only("points or file are stated"),
    config::number_key("damping", Dimension::none, fraction, "damping ratio of the oscillators").otherwise(0.05),
    config::number_key("stated_damping", Dimension::none, fraction, "damping ratio of the given spectrum")
        .otherwise_in_words("equal to damping"),
    config::word_key<damping_rules>("damping_rule", "rule that converts the spectrum from stated_damping to damping")
        .optional(),
    config::number_key("scale", Dimension::none, config::Range::positive(), "factor on all ordinates").otherwise(1),
    config::number_key("time_scale", Dimension::none, config::Range::positive(),
                       "factor on all periods, for a scale model")
        .otherwise(1)};

// RG 1.60 prints its vertical spectra for the horizontal pga, so that both have the same.
std::optional<double> pga_beside(config::Table const& table, config::Table const& beside) {
    auto const name = table.text(target_keys["spectrum"]);
    if (!is_scaled_by_pga(name)) {
        return std::nullopt;
    }
    if (!beside.has("spectrum") || !is_scaled_by_pga(beside.text(target_keys["spectrum"]))) {
        table.fail("spectrum", fmt::format("'{}' without pga (it is printed for 1 g, and the horizontal target states "
                                           "no pga to take). Add pga, the horizontal one",
                                           name));
    }
    return beside.maybe_number(target_keys["pga"]);
}

TargetSpectrum read_named(config::Table const& table, double damping, config::Table const* beside) {
    auto const make = table.choice(target_keys["spectrum"], named_targets());
    NamedTargetInput input{.damping = damping, .pga_mps2 = table.maybe_number(target_keys["pga"])};
    if (!input.pga_mps2 && beside != nullptr) {
        input.pga_mps2 = pga_beside(table, *beside);
    }
    return table.located("spectrum", [&] { return make(input); });
}

TargetSpectrum read_tabulated(config::Table const& table, InputFiles& files, double damping) {
    auto const kind = table.choice(target_keys["kind"], target_kinds());
    auto const ordinate = dimension_of(kind);
    std::optional<double> unit;
    if (table.has("unit")) {
        auto const symbol = table.text(target_keys["unit"]);
        unit = table.located("unit", [&] { return unit_factor(symbol, ordinate); });
    }
    if (table.has("file")) {
        auto const name = table.text(target_keys["file"]);
        auto const part = table.has("part") ? table.text(target_keys["part"]) : std::string();
        return table.located("file", [&] {
            auto const& content = files.read(name);
            bool const silence_is_si = files.are_before_format_5();
            if (is_json(content)) {
                return target_of_table(table_of_design_json(content, name, part, kind), name, kind, damping, unit,
                                       silence_is_si);
            }
            auto const chosen = table_of_one_ordinate(content, name, part);
            validate(chosen || part.empty(), "part '{}' of {} (it holds one spectrum alone). Leave it out", part, name);
            return parse_target_table(chosen ? *chosen : content, name, kind, damping, unit, silence_is_si);
        });
    }
    // With a unit stated for all of them, points are numbers alone.
    auto points = table.pairs(target_keys["points"], {.dimension = unit ? Dimension::none : ordinate});
    for (auto& point : points) {
        point.second *= unit.value_or(1);
    }
    return table.located("points",
                         [&] { return TargetSpectrum::from_points("campaign points", damping, kind, points); });
}

}  // namespace

constinit config::KeyTable const target_table{.meaning = "response spectrum: spectrum, points or file",
                                              .keys = target_keys.all};

TargetSpectrum read_target(config::Table const& table, InputFiles& files, config::Table const* beside) {
    table.may_have(target_table);
    table.may_have({"longest", "ratio", "correlation"});  // of the tables round it
    auto const damping = table.number(target_keys["damping"]);
    int const ways = (table.has("spectrum") ? 1 : 0) + (table.has("points") ? 1 : 0) + (table.has("file") ? 1 : 0);
    if (ways != 1) {
        table.fail({}, "no single target (exactly one of spectrum, points, file states it). Keep one");
    }
    auto const stated = table.number(target_keys["stated_damping"], {.otherwise = damping});
    auto target = table.has("spectrum") ? read_named(table, stated, beside) : read_tabulated(table, files, stated);
    if (table.has("damping_rule")) {
        auto const rule = table.choice(target_keys["damping_rule"], damping_rules());
        target = table.located("damping", [&] { return target.at_damping(damping, rule); });
    } else if (stated != damping) {
        table.fail("stated_damping", fmt::format("{} beside damping {} (nothing says how to carry the spectrum over). "
                                                 "Add damping_rule",
                                                 stated, damping));
    }
    auto const scale = table.number(target_keys["scale"]);
    auto const time_scale = table.number(target_keys["time_scale"]);
    return target.scaled(scale).at_time_scale(time_scale);
}

}  // namespace overturn

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/openquake.hpp"
#include "motion/pair_table.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"
#include "spectra/detail/design_json.hpp"
#include "spectra/detail/target_axis.hpp"
#include "spectra/detail/target_names.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {
namespace {

double period_unit(PairTable const& table, Location const& where) {
    auto const [text, bracketed] = unit_text_in_name(table.first_name);
    auto const unit = unit_in_name(table.first_name, Dimension::time);
    if (bracketed && !unit) {
        throw InputError(where, fmt::format("unit '{}' of the periods (it is not known: one of {}). Mend the header",
                                            text, accepted_units(Dimension::time)));
    }
    return unit.value_or(1);
}

/// That the second name states. \throws InputError if it is one of another quantity, or none that is known and `stated`
/// is none either
std::optional<double> named_unit(PairTable const& table, TargetKind kind, bool stated, Location const& where) {
    auto const dimension = dimension_of(kind);
    auto const ordinates = ordinate_name(table.second_name);
    auto const unit = unit_of_values(ordinates, dimension);
    auto const [text, bracketed] = unit_text_in_name(ordinates);
    bool const another = unit_spelled(text, Dimension::acceleration) || unit_spelled(text, Dimension::velocity)
                         || (bracketed && unit_spelled(text, Dimension::length));
    if (!unit && (another || (bracketed && !stated))) {
        throw InputError(where, fmt::format("unit '{}' in the header (not a unit of {}, which kind says the values "
                                            "are: one of {}). Mend the kind, or the header",
                                            text, name_of(dimension), accepted_units(dimension)));
    }
    return unit;
}

std::string units_to_state(TargetKind kind) {
    return kind == TargetKind::acceleration   ? R"(unit = "g", "gal" or "m/s2")"
           : kind == TargetKind::displacement ? R"(unit = "cm" or "m")"
                                              : R"(unit = "kine" or "m/s")";
}

/// Rows in the units of the header, in rising order of periods.
std::vector<Pair> in_si(PairTable const& table, double abscissa, double ordinate, bool frequencies, bool logarithms) {
    auto points = table.points;
    for (auto& [x, y] : points) {
        x = frequencies ? 1 / (x * abscissa) : x * abscissa;
        y = (logarithms ? std::exp(y) : y) * ordinate;
    }
    if (frequencies) {
        std::ranges::reverse(points);
    }
    return points;
}

/// \throws InputError at the first row that is no point of a spectrum
void check_rows(PairTable const& table, bool frequencies, bool logarithms, TargetKind kind, std::string const& name) {
    for (std::size_t i = 0; i < table.points.size(); ++i) {
        auto const [x, y] = table.points[i];
        bool const pga = i == 0 && x == 0 && !frequencies && kind == TargetKind::acceleration;
        try {
            validate((x > 0 || pga) && std::isfinite(x), "{} {} (must be positive and finite). Mend it",
                     frequencies ? "frequency" : "period", x);
            validate((y > 0 || logarithms) && std::isfinite(y),
                     "ordinate {} at {} (must be positive and finite). "
                     "Mend it",
                     y, x);
            validate(i == 0 || x > table.points[i - 1].first, "{} after {} ({} must rise). Sort the table", x,
                     i == 0 ? 0.0 : table.points[i - 1].first, frequencies ? "frequencies" : "periods");
        } catch (InputError const& error) {
            throw InputError({name, table.line[i]}, error.what());
        }
    }
}

/// \throws InputError at what is no table of text
void check_is_table(std::string_view content, std::string const& name) {
    if (content.find('\0') != std::string_view::npos) {
        throw InputError({name}, "zero bytes in it (a binary or UTF-16 file). Save it as plain text");
    }
    if (is_json(content)) {
        throw InputError({name}, "JSON where a table is read. Write the periods and ordinates as columns T (s),Sa (g)");
    }
}

}  // namespace

TargetSpectrum parse_target_table(std::string_view content, std::string const& name, TargetKind kind, double damping,
                                  std::optional<double> unit_si, bool silence_is_si) {
    check_is_table(content, name);
    auto const uniform = uniform_hazard_of_openquake(content, name);
    auto const table = read_pair_table(
        uniform ? *uniform : content, name,
        {.meaning = "period and value", .check = [](Pair const&, Pair const*) {}, .are_names = are_target_names});
    return target_of_table(table, name, kind, damping, unit_si, silence_is_si);
}

TargetSpectrum target_of_table(PairTable const& table, std::string const& name, TargetKind kind, double damping,
                               std::optional<double> unit_si, bool silence_is_si) {
    Location const where{name, table.names_line};
    auto const hertz = frequency_unit(table, where);
    bool const logarithms = are_logarithms(table, where);
    check_kind(table, kind, where);
    auto const unread = check_text(table, kind, damping, name);
    double const abscissa = hertz ? *hertz : table.names_line > 0 ? period_unit(table, where) : 1;
    check_axis_text(table, hertz.has_value(), abscissa, name);
    TextStatements statements(dimension_of(kind));
    statements.take(table.text, 0);  // what stands beside the names is text
    auto const named = named_unit(table, kind, unit_si.has_value(), where);
    auto unit = statements.unit_beside(named, unit_si, where);
    if (!named && !silence_is_si) {
        statements.check_unit_is_known(name);
    }
    unit = !unit && silence_is_si && statements.doubt().empty() ? std::optional(1.0) : unit;
    if (!unit) {
        throw InputError({name, table.line.front()},
                         fmt::format("unit of the ordinates missing ({}). State {}",
                                     statements.doubt().empty() ? "neither names nor text say it" : statements.doubt(),
                                     units_to_state(kind)));
    }
    check_rows(table, hertz.has_value(), logarithms, kind, name);
    auto const target =
        TargetSpectrum::from_points(name, damping, kind, in_si(table, abscissa, *unit, hertz.has_value(), logarithms));
    return unread.empty() ? target : target.remarked(name + not_understood(unread));
}

}  // namespace overturn

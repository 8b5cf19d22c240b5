#include "campaign/validated_range.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/texts_of.hpp"

namespace overturn {
namespace {

// A quantity of the bodies that were tested, from its lowest to its highest value [SI].
struct ValidatedRange {
    char const* quantity;
    double lowest, highest;
    char const* unit;  // of these numbers
    char const* basis;
};

constexpr std::array tested{
    ValidatedRange{"alpha", 0.08, 0.14, "rad", "fitted to the outcomes of other motions"},
    ValidatedRange{"p", 4.0, 5.4, "rad/s", "of a centre assumed 0.25 to 0.45 m high; mass measured"},
    ValidatedRange{"PGV", 0.01, 0.94, "m/s", "measured"},
};
constexpr std::size_t of_alpha = 0;
constexpr std::size_t of_p = 1;
constexpr std::size_t of_pgv = 2;

std::string with_tests(std::string const& text, std::string const& tests, Tested ranges) {
    return ranges == Tested::stated ? fmt::format("{} ({})", text, tests) : text;
}

// Shown in the unit that the campaign states; without one angles in degrees, all else in the unit of the tests.
void add_outside(std::vector<std::string>& list, std::size_t place, double least, double most, Tested ranges,
                 std::optional<IntensityUnit> const& stated = {}) {
    auto const& range = tested.at(place);
    if (least >= range.lowest && most <= range.highest) {
        return;
    }
    auto const unit = stated.value_or(IntensityUnit{range.unit});
    auto const text = [&](double low, double high) {
        return low == high ? fmt::format("{:.3g} {}", unit.of(low), unit.symbol)
                           : fmt::format("{:.3g} to {:.3g} {}", unit.of(low), unit.of(high), unit.symbol);
    };
    list.push_back(with_tests(fmt::format("{} {}", range.quantity, text(least, most)),
                              "tested: " + text(range.lowest, range.highest), ranges));
}

}  // namespace

std::vector<std::string> outside_validated_range(CampaignSpec const& spec, Tested ranges) {
    TextsOf texts;
    auto const angle = typed_unit(spec, Dimension::angle).value_or(shown_unit(spec, "rad"));
    auto const velocity = typed_unit(spec, Dimension::velocity);
    for (auto const& body : spec.bodies) {
        std::vector<std::string> outside;
        add_outside(outside, of_alpha, body.body.alpha_rad(), body.body.alpha_rad(), ranges, angle);
        add_outside(outside, of_p, body.body.p_radps(), body.body.p_radps(), ranges);
        if (spec.levels.measure == measure_named("pgv")) {
            add_outside(outside, of_pgv, spec.levels.levels.front().value, spec.levels.levels.back().value, ranges,
                        velocity);
        }
        if (body.friction) {
            outside.push_back(with_tests("friction", "no test measured it", ranges));
        }
        if (body.footing.stated) {
            outside.push_back(with_tests("base and pad", "tested: blocks of uneven base, as two corners", ranges));
        }
        texts.add(fmt::format("{}", fmt::join(outside, ", ")), body.name);
    }
    std::vector<std::string> lines;
    for (auto const& [text, names] : texts.entries()) {
        bool const all = names.size() > 1 && names.size() == spec.bodies.size();
        lines.push_back(fmt::format("{}: {}", all ? "all bodies" : names_text(names), text));
    }
    return lines;
}

std::string validated_range_text(CampaignSpec const& spec, std::size_t most) {
    constexpr char const* tests = "245 shaking-table tests of two granite blocks";
    auto const outside = outside_validated_range(spec);
    if (outside.empty()) {
        return fmt::format("all bodies lie within the range of {}", tests);
    }
    auto const shown = std::min(most, outside.size());
    return fmt::format(
        "outside the range of {}: {}{}", tests, fmt::join(std::span(outside).first(shown), "; "),
        shown == outside.size() ? std::string() : fmt::format("; and other bodies ({} more)", outside.size() - shown));
}

}  // namespace overturn

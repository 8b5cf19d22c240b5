#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/intensity_measure.hpp"
#include "cli/command_line.hpp"
#include "cli/fit_tables.hpp"
#include "core/error.hpp"
#include "core/input_files.hpp"
#include "motion/column_unit.hpp"
#include "output/frequency_text.hpp"
#include "output/json.hpp"
#include "output/summary_tables.hpp"
#include "results/hazard_frequency.hpp"
#include "stats/curve_spread.hpp"

namespace overturn::cli {
namespace {

constexpr double five_percent_score = 1.645;  // as HCLPF is defined (EPRI TR-103959)
constexpr double one_percent_score = 2.326347874040841;

// "0.9 g": a number with a unit of acceleration, velocity or length.
struct StatedMedian {
    double value = 0;  // [SI]
    IntensityUnit unit;
    Dimension dimension = Dimension::none;
};

StatedMedian read_median(std::string const& text) {
    auto const [number, unit] =
        stated_number(text, "--median", "a number above 0 with its unit). Write for example '0.9 g'");
    for (auto const dimension : {Dimension::acceleration, Dimension::velocity, Dimension::length}) {
        if (auto const si = unit.empty() ? std::nullopt : unit_spelled(unit, dimension)) {
            return {number * *si, {std::string(unit), *si}, dimension};
        }
    }
    throw InputError(
        fmt::format("--median: '{}' (states no unit of acceleration, velocity or length). Write for "
                    "example '0.9 g' or '90 cm/s'",
                    text));
}

// beta stands for waves and what is not known together where no beta_U is stated.
struct StatedCurve {
    StatedMedian median;
    double beta = 0, beta_u = 0;

    [[nodiscard]] double at(double scores) const { return median.value * std::exp(-scores); }
    [[nodiscard]] double composite() const { return std::hypot(beta, beta_u); }
    [[nodiscard]] double five_percent_point() const { return at(five_percent_score * beta); }
    [[nodiscard]] double one_percent_point() const { return at(one_percent_score * composite()); }
    [[nodiscard]] std::vector<std::string> warnings() const;
    [[nodiscard]] std::optional<double> hclpf() const {
        return beta_u > 0 ? std::optional(at(five_percent_score * (beta + beta_u))) : std::nullopt;
    }
};

// A median that no motion reaches, or under which nothing stands, is in another unit.
std::vector<std::string> StatedCurve::warnings() const {
    auto lines = unusual_spread({beta, beta_u, true, beta_u > 0});
    auto const* const like = measure_named(median.dimension == Dimension::acceleration ? "pga"
                                           : median.dimension == Dimension::velocity   ? "pgv"
                                                                                       : "pgd");
    auto const& usual = like->plausible;
    if (median.value > usual.most || median.value < usual.least) {
        lines.push_back(fmt::format("median {} ({}, casks stand below {:g} {}). Check its unit",
                                    median.unit.text(median.value), usual.known, usual.least / usual.unit_si,
                                    usual.unit));
    }
    return lines;
}

std::string stated_text(StatedCurve const& curve) {
    auto const& unit = curve.median.unit;
    auto const hclpf = curve.hclpf();
    auto text = fmt::format(
        "stated curve (no trials): median {}, {} {:g}{}\n  5 % point {}, HCLPF {}, 1 % point {}\n",
        unit.text(curve.median.value), hclpf ? "beta_R" : "beta", curve.beta,
        hclpf ? fmt::format(", beta_U {:g}", curve.beta_u) : std::string(), unit.text(curve.five_percent_point()),
        hclpf ? unit.text(*hclpf) : std::string("not known without --beta-u"), unit.text(curve.one_percent_point()));
    for (auto const& line : curve.warnings()) {
        text += fmt::format("  note: {}\n", line);
    }
    return text;
}

output::Json stated_json(StatedCurve const& curve) {
    auto const& unit = curve.median.unit;
    output::Json json{{"units", unit.symbol},
                      {"median", unit.of(curve.median.value)},
                      {"beta", curve.beta},
                      {"beta_u", nullptr},
                      {"five_percent_point", unit.of(curve.five_percent_point())},
                      {"one_percent_point", unit.of(curve.one_percent_point())},
                      {"hclpf", nullptr},
                      {"warnings", curve.warnings()}};
    if (auto const hclpf = curve.hclpf()) {
        json["beta_u"] = curve.beta_u;
        json["hclpf"] = unit.of(*hclpf);
    }
    return json;
}

}  // namespace

int fit_stated(FitOptions const& options) {
    validate(*options.beta > 0 && std::isfinite(*options.beta),
             "--beta: {} (must be above 0). It is a lognormal standard deviation", *options.beta);
    check_spread("--beta", *options.beta);
    StatedCurve const curve{read_median(options.median), *options.beta, options.beta_u};
    std::optional<HazardCurve> hazard;
    std::vector<BodyFrequency> frequencies;
    constexpr double none = 1;     // no sample, no confidence: bounds
    constexpr double ends = 3.09;  // from a P of 0.1 % to one of 99.9 %
    if (!options.hazard.empty()) {
        InputFiles files(std::filesystem::path("."));
        hazard = parse_hazard(files.read(options.hazard), options.hazard,
                              {.label = "",
                               .dimension = curve.median.dimension,
                               .unit = curve.median.unit,
                               .lowest = curve.at(ends * curve.composite()),
                               .highest = curve.at(-ends * curve.composite())});
        frequencies.push_back(frequency_of_stated(curve.median.value, curve.beta, curve.beta_u, *hazard));
        frequencies.back().body = "stated curve";
        frequencies.back().limit = overturning_limit;
    }
    if (!options.json) {
        fmt::print("{}{}", stated_text(curve),
                   hazard ? output::frequency_text(frequencies, *hazard, none) : std::string());
        return done;
    }
    auto json = output::Json{{"stated_curve", stated_json(curve)}};
    if (hazard) {
        auto const si = std::string(si_symbol(curve.median.dimension));
        json.update(output::json_of(output::frequency_tables(si, frequencies, *hazard, none)));
        json["hazard_notes"] = hazard->remarks();
    }
    fmt::print("{}\n", json.dump(2));
    return done;
}

}  // namespace overturn::cli

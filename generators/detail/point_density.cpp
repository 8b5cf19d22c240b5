#include "generators/detail/point_density.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/pair_table.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

void check_point(Pair const& point, Pair const* before) {
    auto const [f, s] = point;
    validate(std::isfinite(f) && (before == nullptr ? f >= 0 : f > before->first),
             "frequency {} Hz (must rise from 0 or above). Sort the points", f);
    validate(std::isfinite(s) && s >= 0, "density {} at {} Hz (must not be negative). Mend it", s, f);
}

/// Not over rad/s, and no spectrum of amplitudes.
bool are_of_density(std::string_view first, std::string_view second) {
    auto const lower = lowered(second);
    bool const amplitudes = lower.find("ampl") != std::string::npos || lower.find("fourier") != std::string::npos
                            || lower.find("fas") != std::string::npos;
    return is_frequency_name(first) && is_in_si(first, Dimension::frequency) && !amplitudes;
}

}  // namespace

PointDensity::PointDensity(std::vector<std::pair<double, double>> points) : points_(std::move(points)) {
    validate(points_.size() >= 2, "{} points (a density needs at least two). Add some", points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        check_point(points_[i], i == 0 ? nullptr : &points_[i - 1]);
    }
    validate(integral_hz() > 0, "no density above 0 (nothing shakes). State some");
}

double PointDensity::at(double frequency_hz) const {
    auto const above = std::ranges::lower_bound(points_, frequency_hz, {}, &std::pair<double, double>::first);
    if (above == points_.end() || frequency_hz < first_hz()) {
        return 0;
    }
    if (above == points_.begin()) {
        return above->second;
    }
    auto const [f0, s0] = *(above - 1);
    auto const [f1, s1] = *above;
    double const share = (frequency_hz - f0) / (f1 - f0);
    return s0 + share * (s1 - s0);
}

double PointDensity::integral_hz() const {
    double sum = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        sum += 0.5 * (points_[i].second + points_[i - 1].second) * (points_[i].first - points_[i - 1].first);
    }
    return sum;
}

namespace {

constexpr config::Keys point_density_keys{
    config::pairs_key("points", Dimension::frequency, Dimension::none,
                      "pairs [frequency, power density]; rms scales it, so it has no unit")
        .optional(),
    config::text_key("file", "file with two columns, in place of points").optional()};

}  // namespace

constinit config::KeyTable const point_density_table{.meaning = "one-sided power spectral density: points or file",
                                                     .keys = point_density_keys.all};

PointDensity read_point_density(config::Table const& table, InputFiles& files) {
    if (table.has("points") == table.has("file")) {
        table.fail({}, "no single density (either points or file states it). Keep one");
    }
    if (table.has("file")) {
        auto const name = table.text(point_density_keys["file"]);
        return table.located("file", [&] {
            return PointDensity(read_pairs(
                files.read(name), name,
                {.meaning = "frequency in Hz and power density", .check = check_point, .are_names = are_of_density}));
        });
    }
    auto points = table.pairs(point_density_keys["points"]);
    return table.located("points", [&] { return PointDensity(std::move(points)); });
}

}  // namespace overturn

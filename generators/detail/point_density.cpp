#include "generators/detail/point_density.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

bool begins_with_a_number(std::string_view row) { return row.find_first_of("0123456789.+-") == 0; }

// Two numbers, between blanks or a comma.
std::pair<double, double> parse_row(std::string_view row) {
    auto const end = row.find_first_of(", \t;");
    std::pair<double, double> point;
    auto const rest = end == std::string_view::npos ? std::string_view() : row.substr(end);
    auto const second = trimmed(rest.substr(std::min(rest.find_first_not_of(", \t;"), rest.size())));
    validate(parse_number(trimmed(row.substr(0, end)), point.first) && parse_number(second, point.second),
             "{} (a frequency in Hz and a power density belong here). Write two numbers", in_quotes(row));
    return point;
}

PointDensity parse_table(std::string_view content, std::string const& name) {
    std::vector<std::pair<double, double>> points;
    TextLines lines(content);
    while (auto const line = lines.next()) {
        auto const row = trimmed(line->substr(0, line->find_first_of("#!")));
        if (row.empty() || (points.empty() && !begins_with_a_number(row))) {
            continue;  // a comment, or the columns' names
        }
        try {
            points.push_back(parse_row(row));
        } catch (InputError const& error) {
            throw InputError({name, lines.number()}, error.what());
        }
    }
    try {
        return PointDensity(std::move(points));
    } catch (InputError const& error) {
        throw InputError({name}, error.what());
    }
}

}  // namespace

PointDensity::PointDensity(std::vector<std::pair<double, double>> points) : points_(std::move(points)) {
    validate(points_.size() >= 2, "{} points (a density needs at least two). Add some", points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        auto const [f, s] = points_[i];
        validate(std::isfinite(f) && (i == 0 ? f >= 0 : f > points_[i - 1].first),
                 "frequency {} Hz (must rise from 0 or above). Sort the points", f);
        validate(std::isfinite(s) && s >= 0, "density {} at {} Hz (must not be negative). Mend it", s, f);
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

PointDensity read_point_density(config::Table const& table, InputFiles& files) {
    if (table.has("points") == table.has("file")) {
        table.fail({}, "no single density (either points or file states it). Keep one");
    }
    if (table.has("file")) {
        auto const name = table.text("file");
        return table.located("file", [&] { return parse_table(files.read(name), name); });
    }
    auto points = table.pairs("points", Dimension::frequency, Dimension::none);
    return table.located("points", [&] { return PointDensity(std::move(points)); });
}

}  // namespace overturn

#include "spectra/period_correlation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {

double baker_jayaram_2008(double period_s, double other_period_s) {
    constexpr double shortest_s = 0.01;
    constexpr double longest_s = 10;
    constexpr double bend_s = 0.109;
    constexpr double short_s = 0.2;
    double const a = std::clamp(period_s, shortest_s, longest_s);
    double const b = std::clamp(other_period_s, shortest_s, longest_s);
    double const low = std::min(a, b);
    double const high = std::max(a, b);
    if (low == high) {
        return 1;  // and not what rounding leaves of it
    }
    double const c1 = 1 - std::cos(pi / 2 - 0.366 * std::log(high / std::max(low, bend_s)));
    double const c2 =
        high < short_s ? 1 - 0.105 * (1 - 1 / (1 + std::exp(100 * high - 5))) * (high - low) / (high - 0.0099) : 0;
    double const c3 = high < bend_s ? c2 : c1;
    double const c4 = c1 + 0.5 * (std::sqrt(c3) - c3) * (1 + std::cos(pi * low / bend_s));
    return high <= bend_s ? c2 : low > bend_s ? c1 : high < short_s ? std::min(c2, c4) : c4;
}

namespace {

// The numbers of a line; what follows '#' is a comment.
std::vector<double> numbers_in(std::string_view line, Location const& where) {
    std::vector<double> numbers;
    line = line.substr(0, line.find('#'));
    constexpr std::string_view between = " \t,;\r";
    for (;;) {
        auto const begin = line.find_first_not_of(between);
        if (begin == std::string_view::npos) {
            return numbers;
        }
        line.remove_prefix(begin);
        auto const word = line.substr(0, line.find_first_of(between));
        double value = 0;
        auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size()) {
            throw InputError(where, fmt::format("'{}' (a table of correlations holds numbers alone). Mend it", word));
        }
        numbers.push_back(value);
        line.remove_prefix(word.size());
    }
}

void check_periods(std::vector<double> const& periods_s, Location const& where) {
    for (std::size_t i = 0; i < periods_s.size(); ++i) {
        if (!(periods_s[i] > (i == 0 ? 0 : periods_s[i - 1])) || !std::isfinite(periods_s[i])) {
            throw InputError(where, fmt::format("period {} s (periods are positive and rise). Mend it", periods_s[i]));
        }
    }
    if (periods_s.size() < 2) {
        throw InputError(where, "fewer than two periods (the first line states them all). Mend it");
    }
}

void check_values(Eigen::MatrixXd const& values, std::vector<int> const& lines, std::string const& name) {
    constexpr double rounding = 1e-6;  // of a printed table
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        Location const where{name, lines[i]};
        if (std::abs(values(i, i) - 1) > rounding) {
            throw InputError(where,
                             fmt::format("{} on the diagonal (a period's with itself is 1). Mend it", values(i, i)));
        }
        for (Eigen::Index j = 0; j < values.cols(); ++j) {
            if (!(std::abs(values(i, j)) <= 1)) {
                throw InputError(where,
                                 fmt::format("correlation {} (must lie within -1 and 1). Mend it", values(i, j)));
            }
            if (std::abs(values(i, j) - values(j, i)) > rounding) {
                throw InputError(where, fmt::format("{} here, {} the other way round (a correlation has one value). "
                                                    "Mend it",
                                                    values(i, j), values(j, i)));
            }
        }
    }
}

}  // namespace

TabulatedCorrelation TabulatedCorrelation::parse(std::string_view content, std::string const& name) {
    std::vector<double> periods;
    std::vector<std::vector<double>> rows;
    std::vector<int> lines;
    int number = 0;
    while (!content.empty()) {
        auto const end = std::min(content.find('\n'), content.size());
        Location const where{name, ++number};
        auto values = numbers_in(content.substr(0, end), where);
        content.remove_prefix(std::min(end + 1, content.size()));
        if (values.empty()) {
            continue;
        }
        if (periods.empty()) {
            periods = std::move(values);
            check_periods(periods, where);
            continue;
        }
        if (values.size() != periods.size() + 1) {
            throw InputError(where, fmt::format("{} numbers (a period and its {} correlations are wanted). Mend it",
                                                values.size(), periods.size()));
        }
        constexpr double same = 1e-9;
        if (rows.size() == periods.size() || std::abs(values[0] - periods[rows.size()]) > same * values[0]) {
            throw InputError(
                where, fmt::format("period {} s (lines follow the periods of the first one). Mend it", values[0]));
        }
        rows.emplace_back(values.begin() + 1, values.end());
        lines.push_back(number);
    }
    if (periods.empty() || rows.size() != periods.size()) {
        throw InputError(Location{name, number},
                         fmt::format("{} of {} lines of correlations (one per period). Add the others", rows.size(),
                                     periods.size()));
    }
    TabulatedCorrelation table;
    Eigen::Index const count = periods.size();
    table.values_.resize(count, count);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        table.log_period_.push_back(std::log(periods[i]));
        table.values_.row(i) = Eigen::Map<Eigen::RowVectorXd const>(rows[i].data(), rows[i].size());
    }
    check_values(table.values_, lines, name);
    return table;
}

TabulatedCorrelation::Place TabulatedCorrelation::place(double period_s) const {
    double const at = std::clamp(std::log(period_s), log_period_.front(), log_period_.back());
    auto const above = std::upper_bound(log_period_.begin() + 1, log_period_.end() - 1, at);
    auto const left = static_cast<std::size_t>(above - log_period_.begin()) - 1;
    return {left, (at - log_period_[left]) / (log_period_[left + 1] - log_period_[left])};
}

double TabulatedCorrelation::operator()(double period_s, double other_period_s) const {
    if (period_s == other_period_s) {
        return 1;  // between two periods of the table straight lines would say less
    }
    auto const [i, x] = place(period_s);
    auto const [j, y] = place(other_period_s);
    Eigen::Index const row = i;
    Eigen::Index const column = j;
    return (1 - x) * ((1 - y) * values_(row, column) + y * values_(row, column + 1))
           + x * ((1 - y) * values_(row + 1, column) + y * values_(row + 1, column + 1));
}

CorrelatedNormals::CorrelatedNormals(std::vector<double> const& periods_s, PeriodCorrelation const& correlation) {
    Eigen::Index const count = periods_s.size();
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j) {
            matrix(i, j) = correlation(periods_s[i], periods_s[j]);
        }
    }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const solved(matrix);
    constexpr double rounding = 0.005;
    double const least = solved.eigenvalues().minCoeff();
    validate(
        least >= -rounding * static_cast<double>(count),
        "correlations that no spectra can have (their matrix has an eigenvalue of {:.3g} at {} periods). Mend them",
        least, count);
    // The symmetric root does not hang on the signs that a solver gives its eigenvectors.
    root_ = solved.eigenvectors() * solved.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal()
            * solved.eigenvectors().transpose();
    root_.rowwise().normalize();
}

std::vector<double> CorrelatedNormals::operator()(std::vector<double> const& normals) const {
    OVERTURN_EXPECT(normals.size() == size());
    std::vector<double> deviations(size());
    Eigen::Map<Eigen::VectorXd>(deviations.data(), root_.rows()) =
        root_ * Eigen::Map<Eigen::VectorXd const>(normals.data(), root_.cols());
    return deviations;
}

}  // namespace overturn

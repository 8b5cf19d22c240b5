/// Correlation from period to period of a response spectrum's deviations from its median.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// Correlation of ln Sa at two periods [s]: 1 where they are equal, symmetric, within -1 and 1.
using PeriodCorrelation = std::function<double(double, double)>;

/// Baker and Jayaram (2008), Earthquake Spectra 24(1), their predictive equation for the geometric mean of horizontal
/// components of shallow crustal earthquakes; fitted from 0.01 s to 10 s, at whose ends other periods are taken.
[[nodiscard]] double baker_jayaram_2008(double period_s, double other_period_s);

/// A table of correlations, straight in between over log period; beyond it the last period holds.
class TabulatedCorrelation {
  public:
    /// One line of periods [s], then per period a line of that period and its correlations with all of them; blanks,
    /// commas or semicolons between, `#` begins a comment. \throws InputError with `name:line` at what is none of it:
    /// a period that does not rise, a line that is too short or too long, a matrix that is not symmetric, has no 1 on
    /// its diagonal or a value beyond 1
    [[nodiscard]] static TabulatedCorrelation parse(std::string_view content, std::string const& name);

    [[nodiscard]] double operator()(double period_s, double other_period_s) const;

  private:
    struct Place {
        std::size_t left;
        double share;
    };
    [[nodiscard]] Place place(double period_s) const;

    std::vector<double> log_period_;
    Eigen::MatrixXd values_;
};

/// Turns independent standard normals into deviations that are correlated as stated.
class CorrelatedNormals {
  public:
    /// \throws InputError if no set of deviations can have these correlations: an eigenvalue below -0.5 % of their sum
    /// (rounding and tables between which values are straight make small ones, which are taken for zero)
    CorrelatedNormals(std::vector<double> const& periods_s, PeriodCorrelation const& correlation);

    [[nodiscard]] std::size_t size() const { return root_.rows(); }
    /// \param normals as many as periods
    [[nodiscard]] std::vector<double> operator()(std::vector<double> const& normals) const;

  private:
    Eigen::MatrixXd root_;  // symmetric; every row of unit length
};

}  // namespace overturn

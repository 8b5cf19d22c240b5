#include "motion/detail/printed_times.hpp"

#include <algorithm>
#include <cmath>

#include "motion/detail/record_readers.hpp"

namespace overturn {
namespace {

/// By how much a printed time may differ from the true one, relative to another: half a last digit each, or a whole one
/// of either where times are cut off. Single precision holds 24 bits.
class PrintedTimes {
  public:
    PrintedTimes(TextTable const& table, std::size_t column)
        : last_decimal_(std::pow(10.0, -table.digits.at(column).decimals)),
          figures_(table.digits.at(column).figures),
          time_(table.column[column]) {}

    [[nodiscard]] double digit_at(double time_s) const {
        constexpr double single = 0x1p-23;
        double const t = std::abs(time_s);
        double const by_figures = t > 0 ? std::pow(10.0, std::floor(std::log10(t)) + 1 - figures_) : 0;
        return std::max({last_decimal_, by_figures, single * t});
    }

    /// The coarsest one.
    [[nodiscard]] double digit() const { return std::max(digit_at(time_.front()), digit_at(time_.back())); }

    [[nodiscard]] std::size_t count() const { return time_.size(); }
    [[nodiscard]] double span() const { return time_.back() - time_.front(); }
    [[nodiscard]] double mean_step() const { return span() / static_cast<double>(count() - 1); }

    /// The first row that lies further from a uniform step than `most`; count() if none does.
    [[nodiscard]] std::size_t first_off(double step, double most) const {
        constexpr double rounding = 1e-9;
        for (std::size_t i = 0; i < count(); ++i) {
            double const allowed = most * (1 + rounding) + rounding * step;
            if (!(std::abs(time_[i] - time_[0] - static_cast<double>(i) * step) <= allowed)) {
                return i;
            }
        }
        return count();
    }

  private:
    double last_decimal_;
    int figures_;
    std::vector<double> const& time_;
};

/// \throws InputError at the row whose gap to the one before differs most from the step.
[[noreturn]] void refuse_times(TextTable const& table, std::size_t column, double step, std::string const& file) {
    auto const& time = table.column[column];
    std::size_t worst = 1;
    for (std::size_t i = 2; i < time.size(); ++i) {
        if (std::abs(time[i] - time[i - 1] - step) > std::abs(time[worst] - time[worst - 1] - step)) {
            worst = i;
        }
    }
    auto const falls = std::any_of(time.begin() + 1, time.end(), [&](double const& t) { return t < *(&t - 1); });
    throw InputError({file, table.line[worst]},
                     falls ? fmt::format("time goes from {} to {} (times rise: it is none, or rows are out of "
                                         "order). For columns without a time state what they are, and the time step",
                                         time[worst - 1], time[worst])
                           : fmt::format("time goes from {} to {} s where the mean step is {:.6g} s (samples must be "
                                         "uniform in time: a row is lost, or the times have too few digits). "
                                         "Resample the record, or state its time step if it has one",
                                         time[worst - 1], time[worst], step));
}

}  // namespace

double time_step_of(TextTable const& table, std::size_t column, RecordRequest const& request) {
    Location const start{request.name, table.line[0]};
    if (table.column[column].size() < 2) {
        throw InputError(start, "one row only (a time step needs two). Give the whole record");
    }
    constexpr double little = 1e-3;  // of a step: always forgiven
    PrintedTimes const times(table, column);
    double const mean = times.mean_step();
    if (!(mean > 0)) {
        refuse_times(table, column, mean, request.name);
    }
    // Rounded or cut off, two times differ by less than a last digit from what they should; a lost row of a step that
    // is a whole number of digits differs by one at least.
    constexpr double less = 0.999;
    double const digit = less * times.digit();
    bool const exact = times.first_off(mean, little * mean) == times.count();
    auto const stated = request.time_step_s;
    if (!exact && stated && std::abs(*stated * static_cast<double>(times.count() - 1) - times.span()) <= digit
        && times.first_off(*stated, digit) == times.count()) {
        return *stated;
    }
    bool const telling = 2 * digit < mean;  // a lost row puts one of the others half a step off the mean line
    if (!exact && (!telling || times.first_off(mean, digit) < times.count())) {
        refuse_times(table, column, mean, request.name);
    }
    check_stated_time_step(request, mean, start);
    return mean;
}

}  // namespace overturn

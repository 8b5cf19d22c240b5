/// Targets that differ from wave to wave as recorded spectra do about their median.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/table.hpp"
#include "core/input_files.hpp"
#include "core/random_stream.hpp"
#include "generators/drawn_target.hpp"
#include "spectra/period_correlation.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// ln Sa(T) = ln median(T) + sigma(T) epsilon(T), epsilon standard normal at every period and correlated between
/// periods. With parts, sigma epsilon = between epsilon_event + within epsilon_target. Drawn at 20 periods a decade
/// from 0.01 s to 10 s, straight between them over log period (so that epsilon midway, at 3 s, has 0.99 of its standard
/// deviation under Baker and Jayaram's correlation), constant beyond. Pure.
class TargetVariability {
  public:
    /// A standard deviation of ln Sa by period: (period [s], value), straight over log period, constant beyond.
    using Sigma = std::vector<std::pair<double, double>>;
    struct Input {
        Sigma sigma;  ///< in all; empty if parts are given
        Sigma between, within;
        std::string correlation_name;
        PeriodCorrelation correlation;
        std::uint64_t per_target = 1, targets_per_event = 1;
        /// ln Sa is given at a period: its epsilon there
        struct Condition {
            double period_s, epsilon;
        };
        std::optional<Condition> condition;
    };
    /// \throws InputError if no spectra can have the correlation
    explicit TargetVariability(Input input);

    [[nodiscard]] DrawnTarget draw(std::uint64_t seed, std::uint64_t wave) const;
    /// Standard deviation of ln Sa of the targets, as conditions leave it.
    [[nodiscard]] double spread(double period_s) const;
    [[nodiscard]] bool parted() const { return !input_.between.empty(); }
    [[nodiscard]] Input const& input() const { return input_; }
    /// "ln Sa with sigma 0.6, correlated by baker-jayaram-2008".
    [[nodiscard]] std::string describe() const;

  private:
    [[nodiscard]] std::vector<double> deviations(std::uint64_t seed, std::uint64_t number, Purpose purpose) const;
    [[nodiscard]] double sigma(double period_s) const;
    [[nodiscard]] double at_condition(std::vector<double> const& values) const;

    Input input_;
    std::vector<double> period_s_;
    std::vector<double> log_period_;
    CorrelatedNormals correlated_;
};

/// Its keys.
extern config::KeyTable const variability_table;

/// A file of correlations is read by TabulatedCorrelation::parse. Calls finish(). \throws InputError at the key
[[nodiscard]] TargetVariability read_variability(config::Table const& table, TargetSpectrum const& median,
                                                 InputFiles& files);

}  // namespace overturn

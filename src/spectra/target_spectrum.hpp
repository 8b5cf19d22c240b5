/// Target spectra: what artificial waves are matched to, from a table or a formula, at model scale if wanted.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/registry.hpp"
#include "core/units.hpp"
#include "spectra/damping_rule.hpp"

namespace overturn {

/// Quantity of a table's ordinates. The first three are readings of one response spectrum; energy_velocity is the input
/// energy spectrum V_E(T, damping), which no formula turns into a response: waves are matched to it as it is.
enum class TargetKind { acceleration, pseudo_velocity, displacement, energy_velocity };

/// The kinds under the names users write.
[[nodiscard]] std::span<config::Entry<TargetKind> const> target_kinds();

/// One branch of a target, psa [m/s2] for periods up to `to_s`: constant + slope T + inverse/T + power T^exponent.
struct TargetBranch {
    double to_s = 0;
    double constant = 0, slope = 0, inverse = 0;
    double power = 0, exponent = 0;
};

/// A factor on the ordinates of a spectrum by its period: straight in log-log between points, constant beyond them.
struct SpectrumShape {
    std::vector<double> log_period;  ///< of periods in s, rising
    std::vector<double> log_factor;

    [[nodiscard]] double factor(double period_s) const;
};

/// The peak ground acceleration that a spectrum states or implies.
struct TargetPga {
    double ordinate_mps2 = 0;              ///< at period 0, or at the shortest period [m/s2]
    double period_s = 0;                   ///< this period, as the target states it [s]
    double least_mps2 = 0, most_mps2 = 0;  ///< where the peak ground acceleration lies [m/s2]
};

/// A target for one damping ratio. Immutable. It is defined from first_period_s to last_period_s; outside, psa goes on
/// as constant acceleration below and as constant displacement above: see defined_at. A target of energy velocity
/// stands where psv does, V_E = psv, and scales as a velocity.
class TargetSpectrum {
  public:
    /// \param branches in order of rising period, the first beginning at `first_period_s`.
    TargetSpectrum(std::string name, double damping, double first_period_s, std::vector<TargetBranch> branches);

    /// Straight lines in log-log through (period [s], value [m/s2, m/s or m]).
    /// \throws InputError if there are fewer than two, a period does not rise or a value is not positive.
    [[nodiscard]] static TargetSpectrum from_points(std::string name, double damping, TargetKind kind,
                                                    std::span<std::pair<double, double> const> points);

    [[nodiscard]] double psa_mps2(double period_s) const;
    [[nodiscard]] double psv_mps(double period_s) const;
    [[nodiscard]] bool defined_at(double period_s) const;
    /// Of points that begin at 33 Hz or above, as those of RG 1.60 do; empty: not known. No damping rule changes it.
    [[nodiscard]] std::optional<TargetPga> const& pga() const { return pga_; }

    /// True if psv_mps is to be read as V_E, and waves are to be compared by their input energy.
    [[nodiscard]] bool is_energy() const { return energy_; }
    [[nodiscard]] std::string const& name() const { return name_; }
    /// How its table was read, where that is not plain: one line each, for the description of the input.
    [[nodiscard]] std::vector<std::string> const& remarks() const { return remarks_; }
    [[nodiscard]] double damping() const { return damping_; }
    [[nodiscard]] double first_period_s() const { return first_period_s_ * time_scale_; }
    [[nodiscard]] double last_period_s() const { return branches_.back().to_s * time_scale_; }

    /// The same with one more remark.
    [[nodiscard]] TargetSpectrum remarked(std::string remark) const;
    /// All ordinates times `factor`.
    [[nodiscard]] TargetSpectrum scaled(double factor) const;
    /// For a model whose time runs `time_scale` (s^1/2) times the prototype's: psa_model(T) = psa(T / time_scale).
    [[nodiscard]] TargetSpectrum at_time_scale(double time_scale) const;
    /// Ordinates times the shape's factors, in place of those of an earlier one. Its periods are those that the target
    /// was stated in, before any time scale.
    [[nodiscard]] TargetSpectrum shaped(SpectrumShape shape) const;
    /// The model's period for one that the target was stated at [s].
    [[nodiscard]] double model_period_s(double stated_s) const { return stated_s * time_scale_; }
    /// The period that the target was stated at for one of the model's [s].
    [[nodiscard]] double stated_period_s(double model_s) const { return model_s / time_scale_; }
    /// Carried to another damping ratio. \throws InputError for an energy target, which the rules do not speak of.
    [[nodiscard]] TargetSpectrum at_damping(double damping, DampingRule rule) const;

  private:
    std::string name_;
    std::vector<std::string> remarks_;
    double damping_;
    double first_period_s_;
    std::vector<TargetBranch> branches_;
    double factor_ = 1;
    double time_scale_ = 1;
    bool energy_ = false;
    std::optional<TargetPga> pga_;
    SpectrumShape shape_;
};

/// Two columns, period [s] and value, parted by blanks or a comma; `#` and `!` begin a comment; lines of text may stand
/// above them, the last of two names being those of the columns. Columns named as frequencies or ln Sa are read as
/// such; a first row at period 0 is the peak ground acceleration. The unit is the one that names or text state, "T [s],
/// Sa [gal]", "# 5 % damped, units g", or `unit_si`, the SI value of one unit of the values. \throws InputError with
/// `name:line` at what is not two finite numbers, a period that does not rise, a value <= 0, a quantity or a unit in
/// the names that is none of the kind's or contradicts the stated one; if no unit is stated. \param silence_is_si
/// instead, as before format 5 of results files
[[nodiscard]] TargetSpectrum parse_target_table(std::string_view content, std::string const& name, TargetKind kind,
                                                double damping, std::optional<double> unit_si = {},
                                                bool silence_is_si = false);

struct PairTable;
/// The same of a table that is read already.
[[nodiscard]] TargetSpectrum target_of_table(PairTable const& table, std::string const& name, TargetKind kind,
                                             double damping, std::optional<double> unit_si = {},
                                             bool silence_is_si = false);

/// Dimension of the ordinates of a kind.
[[nodiscard]] Dimension dimension_of(TargetKind kind);

}  // namespace overturn

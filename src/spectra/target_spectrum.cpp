#include "spectra/target_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

double value_of(TargetBranch const& b, double period_s) {
    double value = b.constant + b.slope * period_s + b.inverse / period_s;
    if (b.power != 0) {
        value += b.power * std::pow(period_s, b.exponent);
    }
    return value;
}

// Factors of w = 2 pi / T between an ordinate and psa.
int derivatives_to_acceleration(TargetKind kind) {
    return kind == TargetKind::acceleration ? 0 : kind == TargetKind::displacement ? 2 : 1;
}

// From 33 Hz on the ordinate is the peak ground acceleration (RG 1.60). On hard rock it is larger there, by a factor
// of at most
//   2.49 at 35 Hz, Toro, Abrahamson and Schneider (1997), Seismol. Res. Lett. 68, 41-57, Midcontinent;
//   2.35 at 33 Hz, Pezeshk, Zandieh and Tavakoli (2011), Bull. Seismol. Soc. Am. 101, 1859-1870, Table 2
// (medians, magnitude 5 to 8, up to 200 km). From 100 Hz on it is taken as the peak within 10 %: a judgement (1.01 to
// 1.37 times the peak by the latter).
std::optional<TargetPga> pga_of(std::pair<double, double> const& first, std::pair<double, double> const& second) {
    constexpr double rigid_s = 1 / 33.0;
    constexpr double rigid_of_rock_s = 0.01;
    constexpr double digits = 0.01;
    auto const [period_s, ordinate] = first;
    auto const reaches = [](double at_s, double end_s) { return at_s <= end_s * (1 + digits); };
    if (!reaches(period_s, rigid_s)) {
        return std::nullopt;
    }
    bool const level = reaches(second.first, rigid_s) && std::abs(second.second / ordinate - 1) < digits;
    if (period_s == 0 || level) {
        return TargetPga{ordinate, period_s, ordinate, ordinate};
    }
    constexpr double read_off = 0.1;
    constexpr double on_rock = 2.5;
    double const least = reaches(period_s, rigid_of_rock_s) ? 1 - read_off : 1 / on_rock;
    return TargetPga{ordinate, period_s, least * ordinate, (1 + read_off) * ordinate};
}

void check_point(std::pair<double, double> const& point, std::pair<double, double> const* before) {
    auto const [period, value] = point;
    validate(period > 0 && std::isfinite(period), "period {} s (must be positive and finite). Mend it", period);
    validate(value > 0 && std::isfinite(value), "ordinate {} at period {} s (must be positive and finite). Mend it",
             value, period);
    validate(before == nullptr || period > before->first, "period {} s after {} s (periods must rise). Sort the table",
             period, before == nullptr ? 0.0 : before->first);
}

}  // namespace

std::span<config::Entry<TargetKind> const> target_kinds() {
    static constexpr std::array entries{
        config::Entry<TargetKind>{"acceleration", "pseudo-acceleration [m/s2]", TargetKind::acceleration},
        config::Entry<TargetKind>{"pseudo-velocity", "pseudo-velocity [m/s]", TargetKind::pseudo_velocity},
        config::Entry<TargetKind>{"displacement", "relative displacement [m]", TargetKind::displacement},
        config::Entry<TargetKind>{"energy-velocity", "input energy as a velocity V_E [m/s]",
                                  TargetKind::energy_velocity},
    };
    return entries;
}

TargetSpectrum::TargetSpectrum(std::string name, double damping, double first_period_s,
                               std::vector<TargetBranch> branches)
    : name_(std::move(name)), damping_(damping), first_period_s_(first_period_s), branches_(std::move(branches)) {
    validate(damping_ > 0 && damping_ < 1, "damping {} of target '{}' (must be above 0 and below 1). Use 0.05",
             damping_, name_);
    OVERTURN_EXPECT(!branches_.empty() && first_period_s_ >= 0);
}

TargetSpectrum TargetSpectrum::from_points(std::string name, double damping, TargetKind kind,
                                           std::span<std::pair<double, double> const> points) {
    validate(points.size() >= 2, "target '{}' has {} points (needs at least two). Add some", name, points.size());
    std::vector<TargetBranch> branches;
    double first_s = points.front().first;
    auto const stated = points;
    if (first_s == 0 && kind == TargetKind::acceleration) {
        auto const [t1, v1] = points[1];
        double const pga = points.front().second;
        validate(t1 > 0 && pga > 0, "ordinate {} at period 0 (the peak ground acceleration: above 0). Mend it", pga);
        branches.push_back({.to_s = t1, .constant = pga, .slope = (v1 - pga) / t1});
        constexpr double stiff_s = 0.01;  // below it nothing responds to the ground's motion
        first_s = std::min(stiff_s, t1 / 2);
        points = points.subspan(1);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        check_point(points[i], i == 0 ? nullptr : &points[i - 1]);
        if (i == 0) {
            continue;
        }
        auto const [t0, v0] = points[i - 1];
        auto const [t1, v1] = points[i];
        double const exponent = std::log(v1 / v0) / std::log(t1 / t0);
        double const power = v0 * std::pow(t0, -exponent);
        int const order = derivatives_to_acceleration(kind);
        branches.push_back({.to_s = t1, .power = power * std::pow(2 * pi, order), .exponent = exponent - order});
    }
    TargetSpectrum target(std::move(name), damping, first_s, std::move(branches));
    if (stated.size() > points.size()) {
        target.remarks_.push_back(
            fmt::format("{}: the row at period 0, {:.4g} m/s2, is the PGA; a straight line joins it to the next row",
                        target.name_, stated.front().second));
    }
    target.energy_ = kind == TargetKind::energy_velocity;
    if (!target.energy_) {
        auto const ordinate = [&](std::pair<double, double> const& point) {
            return std::pair(point.first, point.first == 0 ? point.second : target.psa_mps2(point.first));
        };
        target.pga_ = pga_of(ordinate(stated[0]), ordinate(stated[1]));
    }
    return target;
}

double SpectrumShape::factor(double period_s) const {
    if (log_period.empty()) {
        return 1;
    }
    double const at = std::clamp(std::log(period_s), log_period.front(), log_period.back());
    auto const above = std::lower_bound(log_period.begin(), log_period.end(), at);
    auto const right = static_cast<std::size_t>(above - log_period.begin());
    if (right == 0) {
        return std::exp(log_factor.front());
    }
    double const share = (at - log_period[right - 1]) / (log_period[right] - log_period[right - 1]);
    return std::exp(log_factor[right - 1] + share * (log_factor[right] - log_factor[right - 1]));
}

double TargetSpectrum::psa_mps2(double period_s) const {
    validate(period_s > 0, "period {} s (must be positive). Mend it", period_s);
    double const asked = period_s / time_scale_;
    double const last = branches_.back().to_s;
    double const period = std::clamp(asked, first_period_s_, last);
    auto const branch =
        std::find_if(branches_.begin(), branches_.end() - 1, [&](TargetBranch const& b) { return period <= b.to_s; });
    double const value = factor_ * shape_.factor(asked) * value_of(*branch, period);
    return asked > last ? value * (last / asked) * (last / asked) : value;
}

double TargetSpectrum::psv_mps(double period_s) const { return psa_mps2(period_s) * period_s / (2 * pi); }

bool TargetSpectrum::defined_at(double period_s) const {
    return period_s >= first_period_s() && period_s <= last_period_s();
}

TargetSpectrum TargetSpectrum::remarked(std::string remark) const {
    auto copy = *this;
    copy.remarks_.push_back(std::move(remark));
    return copy;
}

TargetSpectrum TargetSpectrum::scaled(double factor) const {
    validate(factor > 0 && std::isfinite(factor), "scale {} of target '{}' (must be positive). Mend it", factor, name_);
    auto copy = *this;
    copy.factor_ *= factor;
    if (copy.pga_) {
        copy.pga_->ordinate_mps2 *= factor;
        copy.pga_->least_mps2 *= factor;
        copy.pga_->most_mps2 *= factor;
    }
    return copy;
}

TargetSpectrum TargetSpectrum::at_time_scale(double time_scale) const {
    validate(time_scale > 0 && std::isfinite(time_scale), "time scale {} of target '{}' (must be positive). Mend it",
             time_scale, name_);
    auto copy = *this;
    copy.time_scale_ *= time_scale;
    return copy;
}

TargetSpectrum TargetSpectrum::shaped(SpectrumShape shape) const {
    OVERTURN_EXPECT(shape.log_period.size() == shape.log_factor.size());
    auto copy = *this;
    copy.shape_ = std::move(shape);
    return copy;
}

TargetSpectrum TargetSpectrum::at_damping(double damping, DampingRule rule) const {
    validate(!energy_,
             "damping {} of '{}' stated for {} (no rule carries an energy spectrum to another damping). Use {}",
             damping, name_, damping_, damping_);
    validate(damping > 0 && damping < 1, "damping {} of target '{}' (must be above 0 and below 1). Use 0.05", damping,
             name_);
    auto copy = scaled(rule(damping) / rule(damping_));
    copy.damping_ = damping;
    copy.pga_ = pga_;
    return copy;
}

Dimension dimension_of(TargetKind kind) {
    return kind == TargetKind::acceleration   ? Dimension::acceleration
           : kind == TargetKind::displacement ? Dimension::length
                                              : Dimension::velocity;
}

}  // namespace overturn

/// A trial for rare-event estimators: standard normals in, a limit state's answer out.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace overturn::rare {

/// Answer of a trial: its distance from failure, and whether it failed.
struct Answer {
    /// Continuous, finite, and the larger the nearer to failure: all failures lie above every trial that is far from it
    /// (nested). For overturning: where the body rests, peak demand over threshold, less 1; where it rocks, its largest
    /// tilt over the critical angle [-]. (Its peak energy will not do where impacts take much: a body that brings twice
    /// the energy to an impact with e = 0.765 stands as a rule.)
    double driver = 0;
    bool failed = false;
    bool undecided = false;  ///< whether it failed is not known
};

/// When and to which side a trial failed.
struct Moment {
    double time_s = 0;
    double sign = 1;
};

/// Map from the first normals to a wave: a(t) = sum_k S_k Re[(x_{2k-2} + i x_{2k-1}) exp(i w_k t)], k = 1, 2, ...,
/// under an envelope. Only waves that are linear in their normals have one.
struct PulseFrame {
    std::size_t lines = 0;     ///< K: pairs of normals that are lines
    double spacing_radps = 0;  ///< w_k = k spacing
    double duration_s = 0;     ///< of the wave
    double body_period_s = 0;  ///< 2 pi / p of the body: pulses last some of these, faster lines do not move it
};

/// A limit state under waves that one common factor scales. Pure: answers depend on the arguments alone.
class Problem {
  public:
    Problem() = default;
    Problem(Problem const&) = delete;
    Problem& operator=(Problem const&) = delete;
    Problem(Problem&&) = delete;
    Problem& operator=(Problem&&) = delete;
    virtual ~Problem() = default;

    [[nodiscard]] virtual std::size_t normals() const = 0;
    /// answers[i] under the wave of these normals times factors[i].
    virtual void respond(std::span<double const> normals, std::span<double const> factors,
                         std::span<Answer> answers) const = 0;
    /// The same of several trials, whose normals lie one behind another: for each its answers at all factors.
    virtual void respond_each(std::span<double const> normals, std::span<double const> factors,
                              std::span<Answer> answers) const {
        auto const each = this->normals();
        for (std::size_t i = 0; i * each < normals.size(); ++i) {
            respond(normals.subspan(i * each, each), factors, answers.subspan(i * factors.size(), factors.size()));
        }
    }
    /// Nothing: pulses are not for this problem.
    [[nodiscard]] virtual std::optional<PulseFrame> frame() const { return std::nullopt; }
    /// The last instant at which the failing trial left the range from which it could have come back. \pre it failed
    [[nodiscard]] virtual Moment moment(std::span<double const> /*normals*/, double /*factor*/) const { return {}; }
};

}  // namespace overturn::rare

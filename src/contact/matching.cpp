#include "contact/matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "contact/detail/rim_law.hpp"

namespace overturn {
namespace {

// Tilt from which the body is let go, of alpha: where the model is called for (wild, in contact_model.cpp). Other
// amplitudes change the restitution by less than 0.02.
constexpr double start_share = 0.3;
// Points give back so much at least and at most: what is below costs ever smaller steps, above it nothing settles.
constexpr double softest = 0.05;
constexpr double hardest = 0.95;
constexpr double close_enough = 1e-4;  // of the restitution: a two-hundredth of what the amplitude changes it by

/// A value tried, and the restitution that came of it.
struct Tried {
    double value, restitution;
};

// The value between one of too much restitution and one of too little: false position with the Illinois rule, which
// halves the distance of an end that stays twice.
// 30 steps are far more than it takes: the match is then as near as they came.
template <class Restitution> void seek(Tried generous, Tried greedy, double wanted, Restitution restitution) {
    enum class Kept : std::uint8_t { neither, upper, lower } last = Kept::neither;
    for (int i = 0; i < 30; ++i) {
        double const over = generous.restitution - wanted;
        double const under = wanted - greedy.restitution;
        double const middle = (generous.value * under + greedy.value * over) / (under + over);
        Tried const tried{middle, restitution(middle)};
        if (std::abs(tried.restitution - wanted) < close_enough) {
            return;
        }
        bool const still_over = tried.restitution > wanted;
        auto& kept = still_over ? greedy : generous;
        auto const which = still_over ? Kept::lower : Kept::upper;
        (still_over ? generous : greedy) = tried;
        if (std::exchange(last, which) == which) {
            kept.restitution = wanted + (kept.restitution - wanted) / 2;
        }
    }
}

// Searches for the base and the points that give the wanted restitution.
class Search {
  public:
    Search(RigidBody const& body, BasePlan const& base, Pad const& pad, ContactAccuracy const& accuracy)
        : body_(body), accuracy_(accuracy), stated_(pad.normal_restitution), match_{base, pad, 0} {}

    MatchedFooting run() {
        auto& base = match_.base;
        double const stated = gives();
        if (!match_.pad.match_restitution || std::abs(stated - wanted_) <= close_enough) {
            return match_;
        }
        if (stated > wanted_) {
            tune_points({stated_, stated}, std::min(softest, stated_));
        } else if (base.on_corners()) {
            base.points = base.points > 2 ? base.points : BasePlan::points_across;
            spread({1, stated});
        } else {
            tune_points({stated_, stated}, std::max(hardest, stated_));
        }
        return match_;
    }

  private:
    double gives() {
        match_.restitution = emergent_restitution(body_, match_.base, match_.pad, accuracy_);
        return match_.restitution;
    }
    double with_share(double share) {
        match_.base.corner_share = share;
        return gives();
    }
    double with_points(double restitution) {
        match_.pad.normal_restitution = restitution;
        return gives();
    }
    // From corners alone towards a flat bed, and on to harder points.
    void spread(Tried corners) {
        double const share = flat_share(match_.base.points);
        Tried const flat{share, with_share(share)};
        if (flat.restitution > wanted_) {
            seek(flat, corners, wanted_, [&](double between) { return with_share(between); });
        } else {
            tune_points({stated_, flat.restitution}, std::max(hardest, stated_));
        }
    }
    // Up to a bound, where the search ends if that is not enough.
    void tune_points(Tried stated, double most) {
        Tried const bound{most, with_points(most)};
        bool const softer = stated.restitution > wanted_;
        if (softer == (bound.restitution < wanted_)) {
            seek(softer ? stated : bound, softer ? bound : stated, wanted_,
                 [&](double between) { return with_points(between); });
        }
    }

    RigidBody const& body_;
    ContactAccuracy accuracy_;
    double stated_;  // of the points
    double wanted_ = body_.restitution();
    MatchedFooting match_;
};

}  // namespace

double emergent_restitution(RigidBody const& body, BasePlan const& base, Pad const& pad,
                            ContactAccuracy const& accuracy) {
    auto elastic = pad;
    elastic.strength_pa.reset();
    auto const block = contact_block(body, base, elastic, {});
    double const alpha = body.alpha_rad();
    // In quarter periods of the linearised body (Housner 1963, eq. 5): it falls for one, and then rises for less than
    // one, as it has lost energy. The margin is for what compliance and sin psi add (empirical); what comes later
    // swings less far.
    constexpr double quarters = 2.3;
    double const quarter_s = std::acosh(1 / (1 - start_share)) / body.p_radps();
    auto const lifted = [&](double tilt) { return 2 * std::sin(alpha - tilt / 2) * std::sin(tilt / 2); };
    double const start = start_share * alpha;
    if (base.continuous()) {
        auto const inner_m = base.is_disc() ? std::optional(base.inner_radius_m) : std::nullopt;
        double const swing = rim_swing_rad(block, start, quarters * quarter_s, accuracy.step_ratio, inner_m);
        return std::sqrt(lifted(swing) / lifted(start));
    }
    std::array<double, 2> const calm{};
    auto const out = simulate_contact(
        block, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = quarters * quarter_s},
        {.step_ratio = accuracy.step_ratio, .longest_after_s = 0, .rest_gate = false}, leaning_start(block, start));
    return std::sqrt(lifted(std::max(0.0, -out.trough_rad)) / lifted(start));
}

MatchedFooting matched_footing(RigidBody const& body, Footing const& footing) {
    if (footing.matched) {
        return *footing.matched;
    }
    return footing.base.shape == BaseShape::polygon ? MatchedFooting{footing.base, footing.pad, never}
                                                    : match_restitution(body, footing.base, footing.pad);
}

MatchedFooting match_restitution(RigidBody const& body, BasePlan const& base, Pad const& pad,
                                 ContactAccuracy const& accuracy) {
    return Search(body, base, pad, accuracy).run();
}

}  // namespace overturn

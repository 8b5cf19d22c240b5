#include "contact/matching.hpp"

#include <array>
#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

constexpr double start_share = 0.3;  // of alpha
// Points give back so much at least and at most: what is below costs ever smaller steps, above it nothing settles.
constexpr double softest = 0.05;
constexpr double hardest = 0.95;
constexpr double close_enough = 1e-4;

// Between a value that gives too much and one that gives too little.
template <class Restitution> double bisect(double generous, double greedy, double wanted, Restitution restitution) {
    double middle = generous + (greedy - generous) / 2;
    for (int i = 0; i < 20; ++i) {
        double const found = restitution(middle);
        if (std::abs(found - wanted) < close_enough) {
            break;
        }
        (found > wanted ? generous : greedy) = middle;
        middle = generous + (greedy - generous) / 2;
    }
    return middle;
}

// Of base and points that give what is wanted.
class Search {
  public:
    Search(RigidBody const& body, ContactBase const& base, ContactPad const& pad, ContactAccuracy const& accuracy)
        : body_(body), accuracy_(accuracy), stated_(pad.normal_restitution), match_{base, pad, 0} {
        match_.base.points = base.points > 2 ? base.points : ContactBase{}.points;
    }

    ContactMatch run() {
        double const corners = with_share(1);
        if (corners > wanted_ + close_enough) {
            soften();
        } else if (corners < wanted_ - close_enough) {
            double const flat = ContactBase::flat_share(match_.base.points);
            if (with_share(flat) >= wanted_) {
                with_share(bisect(flat, 1, wanted_, [&](double share) { return with_share(share); }));
            } else {
                harden();
            }
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
    void soften() {
        double const least = std::min(softest, stated_);
        if (double const bound = with_points(least); bound > wanted_ + close_enough) {
            refuse(bound, "at least");
        }
        between(stated_, least);
    }
    void harden() {
        double const most = std::max(hardest, stated_);
        if (double const bound = with_points(most); bound < wanted_ - close_enough) {
            refuse(bound, "at most");
        }
        between(most, stated_);
    }
    void between(double generous, double greedy) {
        with_points(bisect(generous, greedy, wanted_, [&](double restitution) { return with_points(restitution); }));
    }
    [[noreturn]] void refuse(double bound, char const* side) const {
        throw InputError(
            fmt::format("a restitution of {:.4f} cannot be had on this pad (its base gives {} {:.4f}) state "
                        "one that can, or leave it unmatched",
                        wanted_, side, bound));
    }

    RigidBody const& body_;
    ContactAccuracy accuracy_;
    double stated_;  // of the points
    double wanted_ = body_.restitution();
    ContactMatch match_;
};

}  // namespace

double emergent_restitution(RigidBody const& body, ContactBase const& base, ContactPad const& pad,
                            ContactAccuracy const& accuracy) {
    auto elastic = pad;
    elastic.strength_pa.reset();
    auto const block = contact_block(body, base, elastic, {});
    double const alpha = body.alpha_rad();
    // Housner's quarter period, of the linearised body; the first swing back ends before the second one.
    constexpr double quarters = 2.3;
    double const quarter_s = std::acosh(1 / (1 - start_share)) / body.p_radps();
    std::array<double, 2> const calm{};
    auto const out =
        simulate_contact(block, {.horizontal_mps2 = calm, .vertical_mps2 = {}, .time_step_s = quarters * quarter_s},
                         {.step_ratio = accuracy.step_ratio, .longest_after_s = 0, .rest_gate = false},
                         leaning_start(block, start_share * alpha));
    auto const lifted = [&](double tilt) { return 2 * std::sin(alpha - tilt / 2) * std::sin(tilt / 2); };
    return std::sqrt(lifted(std::max(0.0, -out.trough_rad)) / lifted(start_share * alpha));
}

ContactMatch match_restitution(RigidBody const& body, ContactBase const& base, ContactPad const& pad,
                               ContactAccuracy const& accuracy) {
    return Search(body, base, pad, accuracy).run();
}

}  // namespace overturn

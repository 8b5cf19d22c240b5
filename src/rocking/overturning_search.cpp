#include "rocking/overturning_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "core/error.hpp"

namespace overturn {
namespace {

struct Tried {
    double factor = 0;
    Fate fate = Fate::stands;
    double nearness = 0;  // to the other verdict: the peak rotation of one that stands, how long one took to fall
};

Tried tried(double factor, RockingOutcome const& outcome) {
    switch (outcome.verdict) {
        case Verdict::overturned:
            return {factor, outcome.impacts > 0 ? Fate::after_impact : Fate::without_impact, outcome.overturn_time_s};
        case Verdict::contact_lost:
        case Verdict::failed:
            return {factor, Fate::undecided, 0};
        default:
            return {factor, Fate::stands, outcome.peak_rotation_rad};
    }
}

class Search {
  public:
    Search(RockingBlock const& block, Excitation const& shaking, OverturningScan const& scan)
        : block_(block),
          shaking_(shaking),
          scan_(scan),
          ends_still_(ends_still(shaking)),
          horizontal_(with_calm(shaking.horizontal_mps2)),
          vertical_(with_calm(shaking.vertical_mps2)),
          chunks_(horizontal_, vertical_) {
        shaking_.horizontal_mps2 = horizontal_;
        shaking_.vertical_mps2 = vertical_;
        shaking_.chunks = &chunks_;
    }

    // Side by side in lanes.
    [[nodiscard]] std::vector<Tried> run(std::vector<double> const& factors) const {
        std::vector<RockingTrial> trials(factors.size(), {block_, shaking_});
        for (std::size_t i = 0; i < factors.size(); ++i) {
            trials[i].shaking.scale = factors[i];
        }
        std::vector<RockingOutcome> outcomes(factors.size());
        simulate_rocking(trials, scan_.accuracy, Slip::ignored, outcomes);
        std::vector<Tried> all;
        for (std::size_t i = 0; i < factors.size(); ++i) {
            all.push_back(tried(factors[i], outcomes[i]));
        }
        return all;
    }

    [[nodiscard]] std::vector<Tried> in_equal_ratios(double lowest) const {
        auto const count = static_cast<int>(std::ceil(std::log(scan_.highest) / std::log1p(scan_.step)));
        std::vector<double> factors;
        for (int i = 0; i <= count; ++i) {
            factors.push_back(lowest * std::pow(scan_.highest, static_cast<double>(i) / count));
        }
        return run(factors);
    }

    // Adds amplitudes beside those that came nearer to the other verdict than both their neighbours.
    void look_closer(std::vector<Tried>& all) const {
        constexpr int parts = 8;
        std::vector<double> further;
        auto const divide = [&](Tried const& low, Tried const& high) {
            for (int k = 1; k < parts; ++k) {
                further.push_back(low.factor + (high.factor - low.factor) * k / parts);
            }
        };
        std::size_t divided = 0;  // the interval up to this place
        for (std::size_t i = 1; i + 1 < all.size(); ++i) {
            auto const& [before, at, behind] = std::tie(all[i - 1], all[i], all[i + 1]);
            if (before.fate != at.fate || behind.fate != at.fate || at.nearness <= before.nearness
                || at.nearness <= behind.nearness) {
                continue;
            }
            if (divided < i) {
                divide(before, at);
            }
            divide(at, behind);
            divided = i + 1;
        }
        for (auto const& one : run(further)) {
            all.push_back(one);
        }
        std::ranges::sort(all, {}, &Tried::factor);
    }

    struct Bracket {
        Tried low, high;
    };

    // All brackets at once; one whose middle is of a third fate becomes two.
    [[nodiscard]] std::vector<Bracket> bisected(std::vector<Bracket> open) const {
        std::vector<Bracket> closed;
        while (!open.empty()) {
            std::vector<double> middles;
            middles.reserve(open.size());
            for (auto const& [low, high] : open) {
                middles.push_back(0.5 * (low.factor + high.factor));
            }
            auto const found = run(middles);
            std::vector<Bracket> next;
            for (std::size_t i = 0; i < open.size(); ++i) {
                auto const& [low, high] = open[i];
                for (auto const& part : {Bracket{low, found[i]}, Bracket{found[i], high}}) {
                    if (part.low.fate != part.high.fate) {
                        bool const fine = part.high.factor - part.low.factor <= scan_.precision * part.high.factor;
                        (fine ? closed : next).push_back(part);
                    }
                }
            }
            open = std::move(next);
        }
        std::ranges::sort(closed, {}, [](Bracket const& one) { return one.low.factor; });
        return closed;
    }

  private:
    // A still ground behind a shaking that ends at 0 changes nothing, but there the block is stepped in lanes, behind
    // the last sample alone. The linearised block is stepped alone everywhere.
    [[nodiscard]] std::vector<double> with_calm(std::span<double const> wave) const {
        std::vector<double> longer(wave.begin(), wave.end());
        if (!wave.empty() && ends_still_ && scan_.accuracy.restoring == Restoring::nonlinear) {
            constexpr double falls_within = 8;  // over p: all that are not within exp(-8) of the balance
            longer.resize(wave.size() + static_cast<std::size_t>(falls_within / block_.p_radps / shaking_.time_step_s));
        }
        return longer;
    }

    static bool ends_still(Excitation const& shaking) {
        auto const still = [](std::span<double const> wave) { return wave.empty() || wave.back() == 0; };
        return still(shaking.horizontal_mps2) && still(shaking.vertical_mps2);
    }

    RockingBlock block_;
    Excitation shaking_;
    OverturningScan scan_;
    bool ends_still_;
    std::vector<double> horizontal_, vertical_;
    ChunkExtremes chunks_;
};

double boundary_of(Search::Bracket const& bracket) {
    return bracket.low.fate == Fate::stands    ? bracket.low.factor
           : bracket.high.fate == Fate::stands ? bracket.high.factor
                                               : 0.5 * (bracket.low.factor + bracket.high.factor);
}

}  // namespace

char const* name_of(Fate fate) {
    switch (fate) {
        case Fate::after_impact:
            return "overturns-with-impact";
        case Fate::without_impact:
            return "overturns-without-impact";
        case Fate::undecided:
            return "undecided";
        case Fate::stands:
            break;
    }
    return "stands";
}

double OverturningRanges::overturning() const {
    auto const found = std::ranges::find_if(ranges, [](FateRange const& range) {
        return range.fate == Fate::after_impact || range.fate == Fate::without_impact;
    });
    return found == ranges.end() ? std::numeric_limits<double>::infinity() : found->from;
}

double OverturningRanges::stands_to() const {
    return ranges.empty() ? uplift : ranges.front().fate == Fate::stands ? ranges.front().to : ranges.front().from;
}

double uplift_factor(RockingBlock const& block, Excitation const& shaking, Restoring restoring) {
    double const slope = restoring == Restoring::linear ? block.alpha_rad : std::tan(block.alpha_rad);
    double strongest = 0;
    for (std::size_t i = 0; i < shaking.horizontal_mps2.size(); ++i) {
        double const vertical = shaking.vertical_mps2.empty() ? 0 : shaking.vertical_mps2[i];
        strongest = std::max(strongest, std::abs(shaking.horizontal_mps2[i]) - slope * vertical);
    }
    return strongest > 0 ? slope * block.gravity_mps2 / strongest : std::numeric_limits<double>::infinity();
}

OverturningRanges overturning_ranges(RockingBlock const& block, Excitation const& shaking,
                                     OverturningScan const& scan) {
    OVERTURN_EXPECT(!block.lopsided && scan.highest > 1 && scan.step > 0 && scan.precision > 0);
    OverturningRanges found{.uplift = uplift_factor(block, shaking, scan.accuracy.restoring), .ranges = {}};
    if (!std::isfinite(found.uplift)) {
        return found;
    }
    Search const search(block, shaking, scan);
    auto all = search.in_equal_ratios(found.uplift);
    constexpr int looks = 2;
    for (int look = 0; look < looks; ++look) {
        search.look_closer(all);
    }
    std::vector<Search::Bracket> changes;
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i - 1].fate != all[i].fate) {
            changes.push_back({all[i - 1], all[i]});
        }
    }
    found.ranges.push_back({all.front().fate, found.uplift, all.back().factor});
    for (auto const& change : search.bisected(changes)) {
        double const boundary = boundary_of(change);
        found.ranges.back().to = boundary;
        found.ranges.push_back({change.high.fate, boundary, all.back().factor});
    }
    return found;
}

}  // namespace overturn

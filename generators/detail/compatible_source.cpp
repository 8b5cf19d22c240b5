#include "generators/detail/compatible_source.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "generators/detail/high_pass_baseline.hpp"
#include "generators/detail/matched_normals.hpp"
#include "generators/wave_quality.hpp"

namespace overturn {
namespace {

constexpr double compared_at_s = 1;  // targets of two components

}  // namespace

SpectrumCompatible::SpectrumCompatible(CompatibleRequest request, std::vector<FurtherTarget> const& further)
    : rule_(request.input.rule),
      rule_name_(request.acceptance.rule),
      match_(request.match),
      time_step_s_(request.input.time_step_s),
      variability_(std::move(request.variability)),
      seeds_(std::move(request.seeds)),
      seed_labels_(std::move(request.seed_labels)) {
    auto const& target = request.input.target;
    add(horizontal_kind, request.input, std::nullopt, 1);
    for (auto const& [kind, own, correlation] : further) {
        auto input = request.input;
        input.target = own;
        input.longest_s = std::min(input.longest_s, std::max(own.last_period_s(), 1.0));
        add(kind, input, correlation, own.psa_mps2(compared_at_s) / target.psa_mps2(compared_at_s));
    }
    std::vector<std::string> remarks;
    for (auto const& part : parts_) {
        std::ranges::copy(part.input.target.remarks(), std::back_inserter(remarks));
    }
    describe({.text = summary(Median::not_yet),
              .remarks = std::move(remarks),
              .variability = variability(),
              .available = seeds_.empty() ? std::nullopt : std::optional<std::uint64_t>(seeds_.size()),
              .acceptance = request.acceptance,
              .draws_targets = variability_.has_value(),
              .draws_events = variability_ && variability_->parted(),
              .stated_sigma = stated_sigma(),
              .of_one_spectrum = !variability_,
              .shared = shared_of(request.seeds_shared),
              // What lies beyond the target's own ends is compared with nothing that anybody stated.
              .compared_periods =
                  ComparedPeriods{target.first_period_s(), std::min(request.input.longest_s, target.last_period_s())},
              .target_pga = target.pga(),
              .began_with = seeds_,
              .began_with_names = seed_labels_});
}

// A drawn target, and a recording of which seeds are components, are shared.
SharedDraws SpectrumCompatible::shared_of(SharedDraws const& seeds) const {
    SharedDraws const targets{variability_ ? static_cast<std::int64_t>(variability_->input().per_target
                                                                       * variability_->input().targets_per_event)
                                           : 1};
    return seeds.most == 1 ? targets : seeds.joined(targets, std::ssize(seeds_));
}

std::string SpectrumCompatible::summary(Median median) const {
    auto const& input = parts_.front().input;
    auto const& target = input.target;
    constexpr std::array how{"each wave matched", "matched in the median", "not matched"};
    auto text =
        fmt::format("{} samples of {} s, target {} at {} % damping to {:g} s, {}", input.samples, time_step_s_,
                    target.name(), 100 * target.damping(), input.longest_s, how.at(static_cast<std::size_t>(match_)));
    text += variability_ ? fmt::format(" to a target of its own: {}", variability_->describe()) : "";
    text += rule_.enabled() ? " by " + rule_name_ : "";
    if (constexpr double rounding = 1e-9; input.longest_s > target.last_period_s() * (1 + rounding)) {
        text += fmt::format(", beyond its end at {:g} s on at constant displacement", target.last_period_s());
    }
    text += seeds_.empty() ? "" : fmt::format(", phases of {} records", seeds_.size());
    if (auto const* const reached = median == Median::reached ? parts_.front().matcher.median() : nullptr) {
        text += fmt::format(" (to {:.1f} % on the mean, {:.1f} % at {:.3g} s)", 100 * reached->mean_misfit,
                            100 * reached->max_misfit, reached->max_misfit_period_s);
    }
    for (auto const& part : std::span(parts_).subspan(1)) {
        text += fmt::format(", {} target {} ({:.3g} times the horizontal one at {} s)", part.kind.name,
                            part.input.target.name(), part.of_horizontal, compared_at_s);
        text += part.correlation ? fmt::format(", correlation {:g}", *part.correlation) : "";
    }
    return text;
}

void SpectrumCompatible::prepare(ShareRows const& share) const {
    for (auto const& part : parts_) {
        part.matcher.prepare(share);
    }
}

std::string SpectrumCompatible::variability() const {
    auto const* const phases = seeds_.empty() ? "random phases" : "records' phases";
    if (variability_) {
        return fmt::format("every wave is matched to a drawn target spectrum ({}); {}", variability_->describe(),
                           phases);
    }
    switch (match_) {
        case Match::each:
            return fmt::format("{} only; every wave is matched to the same target spectrum", phases);
        case Match::ensemble:
            return "random noise about one median spectrum; event, path and site do not vary";
        case Match::none:
            break;
    }
    return "random noise about one spectrum, which is not centred on the target; event, path and site do not vary";
}

std::optional<StatedSigma> SpectrumCompatible::stated_sigma() const {
    auto const& part = parts_.front();
    if (!variability_ || part.input.target.is_energy()) {
        return std::nullopt;
    }
    auto const& periods_s = part.matcher.periods_s();
    return StatedSigma{{periods_s.front(), periods_s.back()}, [this](double period_s) {
                           return variability_->spread(parts_.front().input.target.stated_period_s(period_s));
                       }};
}

// Waves that begin or end abruptly jump to a velocity, and no slow motion can take that back.
std::string SpectrumCompatible::pgd_drift() const {
    constexpr std::uint64_t draws = 8;
    constexpr std::uint64_t seed = 0xd21f7;
    constexpr double most = 0.25;
    auto const& noise = parts_.front().matcher.noise();
    double const slow_s = 2 * noise.longest_s();
    std::uint64_t const waves = seeds_.empty() ? draws : std::min<std::uint64_t>(draws, seeds_.size());
    double share = 0;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const lines = seeds_.empty() ? noise.draw(LineStreams::of_calibration(seed, wave))
                                          : noise.analyse(seeds_[wave].horizontal_mps2);
        share +=
            slow_share(noise.synthesise(lines, noise.envelope()), time_step_s_, slow_s) / static_cast<double>(waves);
    }
    return share > most ? fmt::format(
               "{:.0f} % of their displacement's power is slower than {:g} s, as they begin or end "
               "abruptly or are short",
               100 * share, slow_s)
                        : "";
}

std::unique_ptr<NormalWaves> SpectrumCompatible::from_normals() const {
    std::vector<MatchedNormals::Part> parts;
    for (auto const& part : parts_) {
        parts.push_back({&part.matcher, part.kind.place});
    }
    // A stated correlation is brought about by iterating both components together.
    bool const drawn =
        seeds_.empty() && !variability_
        && std::none_of(parts_.begin(), parts_.end(), [](Part const& part) { return part.correlation.has_value(); });
    return drawn ? std::make_unique<MatchedNormals>(std::move(parts), time_step_s_) : nullptr;
}

GeneratedWave SpectrumCompatible::make(std::uint64_t seed, std::uint64_t wave, Judging judging) const {
    GeneratedWave made;
    made.motion.time_step_s = time_step_s_;
    made.rule = rule_;
    made.label = seeds_.empty() ? fmt::format("random wave {}", wave) : "";
    if (!seeds_.empty()) {
        validate_wave(wave, seeds_.size());
        made.label = "match of " + seed_labels_[wave];
    }
    if (variability_) {
        made.drawn = variability_->draw(seed, wave);
        made.label += fmt::format(", target {}", made.drawn->number);
    }
    for (auto const& part : parts_) {
        // Looks and gains of a matcher hang on its periods alone, but making it anew is a tenth of a match.
        std::optional<SpectrumMatcher> own;
        if (made.drawn) {
            auto input = part.input;
            input.target = input.target.shaped(made.drawn->shape);
            own.emplace(std::move(input));
        }
        auto const& matcher = own ? *own : part.matcher;
        auto component = seeds_.empty() ? drawn(part, matcher, made.motion, seed, wave, judging)
                                        : matcher.match_motion(seeds_[wave].*(part.kind.place));
        add_clauses(part, component.match, made.clauses);
        made.motion.*(part.kind.place) = std::move(component.acceleration_mps2);
        made.*(part.kind.match) = component.match;
        if (part.kind.place == horizontal_kind.place && !component.ratios.empty()) {
            made.judged_periods_s = part.matcher.periods_s();
            made.ratios = std::move(component.ratios);
        }
    }
    return made;
}

void SpectrumCompatible::add(ComponentKind const& kind, SpectrumMatcherInput const& input,
                             std::optional<double> correlation, double of_horizontal) {
    constexpr double asked_to_s = 10;  // 0.1 Hz
    parts_.push_back({kind, input, SpectrumMatcher(input), correlation, of_horizontal,
                      std::min(asked_to_s, input.target.last_period_s())});
}

namespace {

bool independent(std::span<double const> a, std::span<double const> b, double largest) {
    return b.empty() || std::abs(correlation_of(a, b)) <= largest;
}

}  // namespace

// Chance alone correlates one pair in twenty too much for the rules; the first draw that does not stays.
SpectrumMatcher::Component SpectrumCompatible::drawn(Part const& part, SpectrumMatcher const& matcher,
                                                     GroundMotion const& before, std::uint64_t seed, std::uint64_t wave,
                                                     Judging judging) {
    constexpr std::uint64_t streams_per_attempt = 16;
    constexpr std::uint64_t attempts = 8;
    constexpr double largest_correlation = 0.16;
    if (part.correlation) {
        return mixed(part, matcher, before.horizontal_mps2, seed, wave);
    }
    for (std::uint64_t attempt = 0;; ++attempt) {
        auto component = matcher.make(seed, wave, part.kind.stream + attempt * streams_per_attempt, judging);
        bool const apart = std::all_of(further_kinds.begin(), further_kinds.end(), [&](ComponentKind const& kind) {
            return independent(component.acceleration_mps2, before.*(kind.place), largest_correlation);
        });
        if ((apart && independent(component.acceleration_mps2, before.horizontal_mps2, largest_correlation))
            || attempt + 1 == attempts) {
            return component;
        }
    }
}

// Of the horizontal component and a draw of its own that is matched, matched again; that takes some of what both share,
// which further mixtures make good as far as they can. The nearest is kept.
SpectrumMatcher::Component SpectrumCompatible::mixed(Part const& part, SpectrumMatcher const& matcher,
                                                     std::vector<double> const& horizontal, std::uint64_t seed,
                                                     std::uint64_t wave) {
    auto const own = matcher.make(seed, wave, part.kind.stream).acceleration_mps2;
    std::vector<double> scaled(horizontal);
    for (double& value : scaled) {
        value *= part.of_horizontal;
    }
    constexpr double close = 0.02;
    constexpr int most = 4;
    SpectrumMatcher::Component best;
    double least = 2;
    double weight = *part.correlation;
    for (int mixture = 0; mixture < most && least > close; ++mixture) {
        auto made = matcher.match_motion(correlated(scaled, own, weight));
        double const missing = *part.correlation - correlation_of(horizontal, made.acceleration_mps2);
        weight = std::clamp(weight + missing, -1.0, 1.0);
        if (std::abs(missing) < least) {
            least = std::abs(missing);
            best = std::move(made);
        }
    }
    return best;
}

void SpectrumCompatible::add_clauses(Part const& part, MatchReport const& match, std::vector<Clause>& clauses) const {
    if (!rule_.enabled()) {
        return;
    }
    for (auto clause : spectrum_clauses(rule_, {.figures = match.all,
                                               .worst_decade = match.worst_decade,
                                               .intensity_ratio = match.intensity_ratio,
                                               .judged_to_s = part.input.longest_s,
                                               .defined_to_s = part.defined_to_s})) {
        clause.component = part.kind.name;
        if (part.kind.place != horizontal_kind.place) {
            clause.name += ", " + clause.component;
        }
        clauses.push_back(std::move(clause));
    }
}

}  // namespace overturn

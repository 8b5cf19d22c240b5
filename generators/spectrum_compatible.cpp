#include "generators/spectrum_compatible.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/detail/components.hpp"
#include "generators/detail/matched_normals.hpp"
#include "generators/detail/spectrum_matcher.hpp"
#include "generators/records.hpp"
#include "generators/wave_quality.hpp"
#include "spectra/target_input.hpp"

namespace overturn {
namespace {

enum class Match { each, ensemble, none };

constexpr std::array matches{
    config::Entry<Match>{"each", "every wave is iterated to the target", Match::each},
    config::Entry<Match>{"ensemble", "the median of many waves meets the target", Match::ensemble},
    config::Entry<Match>{"none", "waves are left as they are drawn", Match::none},
};
constexpr std::array line_amplitudes{
    config::Entry<LineAmplitudes>{"fixed", "random phases only", LineAmplitudes::fixed},
    config::Entry<LineAmplitudes>{"gaussian", "random phases and amplitudes", LineAmplitudes::gaussian},
};

// What the table of a further component is called, where its motion and its match go, which streams it draws from.
struct ComponentKind {
    char const* name;
    std::vector<double> GroundMotion::*place;
    MatchReport GeneratedWave::*match;
    std::uint64_t stream;
};
constexpr ComponentKind horizontal_kind{"horizontal", &GroundMotion::horizontal_mps2, &GeneratedWave::match, 0};
constexpr std::array further_kinds{
    ComponentKind{"transverse", &GroundMotion::transverse_mps2, &GeneratedWave::transverse_match, 2},
    ComponentKind{"vertical", &GroundMotion::vertical_mps2, &GeneratedWave::vertical_match, 1}};

struct Part {
    ComponentKind kind;
    SpectrumMatcher matcher;
    std::optional<double> correlation;  // stated, with the horizontal one
    double of_horizontal;               // ratio of the targets
    double defined_to_s;                // how far a rule asks for the target
    double longest_s;
};

// A component beside the horizontal one, as its table says.
struct Further {
    ComponentKind kind;
    TargetSpectrum target;
    std::optional<double> correlation;
};

// What the campaign says about all components alike.
struct Request {
    SpectrumMatcherInput input;
    Match match = Match::each;
    std::string rule_name = "none";
    std::vector<GroundMotion> seeds{};
    std::vector<std::string> seed_labels{};
};

class SpectrumCompatible : public WaveSource {
  public:
    SpectrumCompatible(Request request, std::vector<Further> const& further)
        : rule_(request.input.rule),
          rule_name_(std::move(request.rule_name)),
          time_step_s_(request.input.time_step_s),
          seeds_(std::move(request.seeds)),
          seed_labels_(std::move(request.seed_labels)),
          stated_to_s_(request.input.target.last_period_s()) {
        auto const& target = request.input.target;
        constexpr std::array how{"each wave matched", "matched in the median", "not matched"};
        summary_ = fmt::format("{} samples of {} s, target {} at {} % damping to {:g} s, {}", request.input.samples,
                               time_step_s_, target.name(), 100 * target.damping(), request.input.longest_s,
                               how.at(static_cast<std::size_t>(request.match)));
        summary_ += rule_.asks() ? " by " + rule_name_ : "";
        if (constexpr double rounding = 1e-9; request.input.longest_s > stated_to_s_ * (1 + rounding)) {
            summary_ += fmt::format(", beyond its end at {:g} s on at constant displacement", stated_to_s_);
        }
        summary_ += seeds_.empty() ? "" : fmt::format(", phases of {} records", seeds_.size());
        add(horizontal_kind, request.input, std::nullopt, 1);
        if (auto const& median = parts_.front().matcher.median(); median.max_misfit > 0) {
            summary_ += fmt::format(" (to {:.1f} % on the mean, {:.1f} % at {:.3g} s)", 100 * median.mean_misfit,
                                    100 * median.max_misfit, median.max_misfit_period_s);
        }
        for (auto const& [kind, own, correlation] : further) {
            auto input = request.input;
            input.target = own;
            input.longest_s = std::min(input.longest_s, std::max(own.last_period_s(), 1.0));
            constexpr double at_s = 1;
            add(kind, input, correlation, own.psa_mps2(at_s) / target.psa_mps2(at_s));
            summary_ += fmt::format(", {} target {}, {:.3g} of the horizontal one at {} s", kind.name, own.name(),
                                    own.psa_mps2(at_s) / target.psa_mps2(at_s), at_s);
            summary_ += correlation ? fmt::format(", correlation {:g}", *correlation) : "";
        }
    }

    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const override {
        return make(seed, wave, Judging::whole);
    }
    [[nodiscard]] GeneratedWave make_unjudged(std::uint64_t seed, std::uint64_t wave) const override {
        return make(seed, wave, Judging::least);
    }

    [[nodiscard]] std::unique_ptr<NormalWaves> from_normals() const override {
        std::vector<MatchedNormals::Part> parts;
        for (auto const& part : parts_) {
            parts.push_back({&part.matcher, part.kind.place});
        }
        // A stated correlation is brought about by iterating both components together.
        bool const drawn = seeds_.empty() && std::none_of(parts_.begin(), parts_.end(), [](Part const& part) {
                               return part.correlation.has_value();
                           });
        return drawn ? std::make_unique<MatchedNormals>(std::move(parts), time_step_s_) : nullptr;
    }

    [[nodiscard]] std::optional<std::uint64_t> available() const override {
        return seeds_.empty() ? std::nullopt : std::optional<std::uint64_t>(seeds_.size());
    }
    [[nodiscard]] std::string describe() const override { return summary_; }
    [[nodiscard]] std::string acceptance() const override { return rule_name_; }
    /// What lies beyond the target's own last period is compared with nothing that anybody stated.
    [[nodiscard]] std::optional<double> judged_to_s() const override {
        return std::min(parts_.front().longest_s, stated_to_s_);
    }

  private:
    using Judging = SpectrumMatcher::Judging;

    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave, Judging judging) const {
        GeneratedWave made;
        made.motion.time_step_s = time_step_s_;
        made.rule = rule_;
        made.label = seeds_.empty() ? fmt::format("random wave {}", wave) : "";
        if (!seeds_.empty()) {
            validate_wave(wave, seeds_.size());
            made.label = "match of " + seed_labels_[wave];
        }
        for (auto const& part : parts_) {
            auto component = seeds_.empty() ? drawn(part, made.motion, seed, wave, judging)
                                            : part.matcher.match_motion(seeds_[wave].*(part.kind.place));
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

    void add(ComponentKind const& kind, SpectrumMatcherInput const& input, std::optional<double> correlation,
             double of_horizontal) {
        constexpr double asked_to_s = 10;  // 0.1 Hz
        parts_.push_back({kind, SpectrumMatcher(input), correlation, of_horizontal,
                          std::min(asked_to_s, input.target.last_period_s()), input.longest_s});
    }

    // Chance alone correlates one pair in twenty too much for the rules; the first draw that does not stays.
    static SpectrumMatcher::Component drawn(Part const& part, GroundMotion const& before, std::uint64_t seed,
                                            std::uint64_t wave, Judging judging) {
        constexpr std::uint64_t streams_per_attempt = 16;
        constexpr std::uint64_t attempts = 8;
        constexpr double largest_correlation = 0.16;
        if (part.correlation) {
            return mixed(part, before.horizontal_mps2, seed, wave);
        }
        for (std::uint64_t attempt = 0;; ++attempt) {
            auto component = part.matcher.make(seed, wave, part.kind.stream + attempt * streams_per_attempt, judging);
            bool const apart = std::all_of(further_kinds.begin(), further_kinds.end(), [&](ComponentKind const& kind) {
                return independent(component.acceleration_mps2, before.*(kind.place), largest_correlation);
            });
            if ((apart && independent(component.acceleration_mps2, before.horizontal_mps2, largest_correlation))
                || attempt + 1 == attempts) {
                return component;
            }
        }
    }

    // Of the horizontal component and a draw of its own that is matched, matched again; that takes some of what both
    // share, which further mixtures make good as far as they can. The nearest is kept.
    static SpectrumMatcher::Component mixed(Part const& part, std::vector<double> const& horizontal, std::uint64_t seed,
                                            std::uint64_t wave) {
        auto const own = part.matcher.make(seed, wave, part.kind.stream).acceleration_mps2;
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
            auto made = part.matcher.match_motion(correlated(scaled, own, weight));
            double const missing = *part.correlation - correlation_of(horizontal, made.acceleration_mps2);
            weight = std::clamp(weight + missing, -1.0, 1.0);
            if (std::abs(missing) < least) {
                least = std::abs(missing);
                best = std::move(made);
            }
        }
        return best;
    }

    static bool independent(std::span<double const> a, std::span<double const> b, double largest) {
        return b.empty() || std::abs(correlation_of(a, b)) <= largest;
    }

    void add_clauses(Part const& part, MatchReport const& match, std::vector<Clause>& clauses) const {
        if (!rule_.asks()) {
            return;
        }
        for (auto clause : spectrum_clauses(rule_, {.figures = match.all,
                                                   .worst_decade = match.worst_decade,
                                                   .intensity_ratio = match.intensity_ratio,
                                                   .judged_to_s = part.longest_s,
                                                   .defined_to_s = part.defined_to_s})) {
            if (part.kind.place != horizontal_kind.place) {
                clause.name += std::string(", ") + part.kind.name;
            }
            clauses.push_back(std::move(clause));
        }
    }

    AcceptanceRule rule_;
    std::string rule_name_;
    double time_step_s_;
    std::vector<GroundMotion> seeds_;
    std::vector<std::string> seed_labels_;
    std::vector<Part> parts_;
    double stated_to_s_;
    std::string summary_;
};

double read_longest(config::Table const& table, TargetSpectrum const& target, double duration_s) {
    constexpr double usual = 10;
    constexpr double most = 20;
    double const longest = table.number("longest", Dimension::time, {.low = 0.2, .high = most},
                                        std::min({usual, target.last_period_s(), duration_s}));
    if (longest > duration_s) {
        table.fail("longest", fmt::format("{} s (longer than the wave of {} s). Lower it", longest, duration_s));
    }
    return longest;
}

// A further component with a target of its own, or a ratio of the horizontal one; nothing if there is no such one.
std::optional<Further> read_further(config::Table const& waves, ComponentKind const& kind,
                                    TargetSpectrum const& horizontal, InputFiles& files) {
    if (!waves.has(kind.name)) {
        return std::nullopt;
    }
    auto const table = waves.child(kind.name);
    std::optional<TargetSpectrum> target;
    if (table.has("target")) {
        auto const own = table.child("target");
        target = read_target(own, files);
        own.finish();
    } else {
        target = horizontal.scaled(read_ratio(table));
    }
    auto const correlation = read_correlation(table);
    if (correlation && waves.has("seed")) {
        table.fail("correlation", "beside seed (records have one of their own). Leave it out");
    }
    table.finish();
    return Further{kind, *target, correlation};
}

// Reads the measured motions whose phases are to be kept; the first one's time step is everybody's.
void read_seeds(config::Table const& waves, InputFiles& files, Request& request) {
    auto const table = waves.child("seed");
    auto const records = make_records(table, files);
    table.finish();
    std::size_t longest = 0;
    for (std::uint64_t i = 0; i < records->available().value_or(0); ++i) {
        auto made = records->make(0, i);
        if (made.motion.time_step_s != request.input.time_step_s && (i > 0 || waves.has("time_step"))) {
            waves.fail("seed",
                       fmt::format("time step {} s of {} beside {} s (seeds have one step). State waves.seed.time_step",
                                   made.motion.time_step_s, made.label, request.input.time_step_s));
        }
        request.input.time_step_s = made.motion.time_step_s;
        longest = std::max(longest, made.motion.samples());
        request.seeds.push_back(std::move(made.motion));
        request.seed_labels.push_back(std::move(made.label));
    }
    request.input.samples =
        waves.has("duration") ? read_samples(waves, request.input.time_step_s) : std::max<std::size_t>(longest, 101);
    request.input.envelope = {.shape = EnvelopeShape::constant};
}

void read_match(config::Table const& waves, Request& request) {
    auto& input = request.input;
    request.match = waves.choice<Match>("match", matches, Match::each);
    request.rule_name = waves.text("acceptance", "none");
    input.rule = waves.choice<AcceptanceRule>("acceptance", acceptance_rules(), {});
    if (request.match == Match::each) {
        input.tolerance = waves.number("match_tolerance", Dimension::none, {.low = 0.001, .high = 1}, input.tolerance);
        input.iterations = static_cast<int>(waves.integer("match_iterations", 1, 1000, input.iterations));
    } else {
        input.iterations = 0;
        input.calibrated = request.match == Match::ensemble;
        if (input.rule.asks()) {
            waves.fail("acceptance", "judges single waves (which scatter unless match = 'each'). Use none here");
        }
        if (waves.has("seed")) {
            waves.fail("match", "beside seed (a record is matched as it is). Use each");
        }
    }
    if (input.rule.asks()) {
        expect_judgeable(waves, "acceptance", input.target);
    }
}

}  // namespace

std::unique_ptr<WaveSource> make_spectrum_compatible(config::Table const& waves, InputFiles& files) {
    auto const target_table = waves.child("target");
    Request request{.input = {.target = read_target(target_table, files)}};
    auto& input = request.input;
    input.time_step_s = waves.number("time_step", Dimension::time, {.low = 1e-4, .high = 0.1}, 0.01);
    if (waves.has("seed")) {
        read_seeds(waves, files, request);
    } else {
        input.samples = read_samples(waves, input.time_step_s);
    }
    double const duration = input.time_step_s * static_cast<double>(input.samples - 1);
    input.longest_s = read_longest(target_table, input.target, duration);
    target_table.finish();
    read_match(waves, request);
    if (request.seeds.empty()) {
        input.envelope = read_envelope(waves.child_or_empty("envelope"), duration);
        input.amplitudes = waves.choice<LineAmplitudes>(
            "amplitudes", line_amplitudes, input.calibrated ? LineAmplitudes::gaussian : LineAmplitudes::fixed);
    }
    std::vector<Further> further;
    for (auto const& kind : further_kinds) {
        if (auto const found = read_further(waves, kind, input.target, files)) {
            if (input.rule.asks()) {
                expect_judgeable(waves, kind.name, found->target);
            }
            further.push_back(*found);
        }
        bool const measured = std::all_of(request.seeds.begin(), request.seeds.end(),
                                          [&](GroundMotion const& seed) { return !(seed.*(kind.place)).empty(); });
        if (waves.has(kind.name) && !measured) {
            waves.fail(kind.name, "no such component in every seed (its phases are missing). State the files' own");
        }
    }
    return waves.located("target", [&] { return std::make_unique<SpectrumCompatible>(std::move(request), further); });
}

}  // namespace overturn

#include "generators/detail/target_variability.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/ranges.h>
#include <gsl/gsl_randist.h>

#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/pair_table.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr double shortest_s = 0.01;
constexpr double longest_s = 10;

double interpolated(TargetVariability::Sigma const& table, double period_s) {
    auto const above = std::lower_bound(table.begin(), table.end(), period_s,
                                        [](auto const& point, double period) { return point.first < period; });
    if (above == table.begin()) {
        return table.front().second;
    }
    if (above == table.end()) {
        return table.back().second;
    }
    auto const [t0, v0] = *(above - 1);
    auto const [t1, v1] = *above;
    return v0 + (v1 - v0) * std::log(period_s / t0) / std::log(t1 / t0);
}

// The period of a condition is one of them: what is given there is met exactly.
std::vector<double> drawn_periods(std::optional<TargetVariability::Input::Condition> const& condition) {
    constexpr double per_decade = 20;
    auto const gaps = std::lround(per_decade * std::log10(longest_s / shortest_s));
    std::vector<double> periods;
    for (long i = 0; i <= gaps; ++i) {
        periods.push_back(shortest_s * std::pow(10.0, static_cast<double>(i) / per_decade));
    }
    if (condition) {
        auto const above = std::lower_bound(periods.begin(), periods.end(), condition->period_s);
        constexpr double same = 1e-6;
        if (above != periods.end() && std::abs(*above - condition->period_s) < same * *above) {
            *above = condition->period_s;
        } else {
            periods.insert(above, condition->period_s);
        }
    }
    return periods;
}

using SigmaAt = std::function<double(double)>;

// Of deviations at the periods that are drawn.
SpectrumShape shape_of(std::vector<double> const& log_period, std::vector<double> const& period_s,
                       std::vector<double> const& deviations, SigmaAt const& sigma) {
    SpectrumShape shape{log_period, {}};
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        shape.log_factor.push_back(sigma(period_s[i]) * deviations[i]);
    }
    return shape;
}

Epsilons epsilons(SpectrumShape const& shape, SigmaAt const& sigma) {
    Epsilons epsilon{};
    for (std::size_t i = 0; i < epsilon.size(); ++i) {
        epsilon[i] = std::log(shape.factor(epsilon_periods_s[i])) / sigma(epsilon_periods_s[i]);
    }
    return epsilon;
}

std::string text_of(TargetVariability::Sigma const& sigma) {
    return sigma.size() == 1 ? fmt::format("{:g}", sigma.front().second)
                             : fmt::format("{:g} at {:g} s to {:g} at {:g} s", sigma.front().second,
                                           sigma.front().first, sigma.back().second, sigma.back().first);
}

}  // namespace

TargetVariability::TargetVariability(Input input)
    : input_(std::move(input)), period_s_(drawn_periods(input_.condition)), correlated_(period_s_, input_.correlation) {
    OVERTURN_EXPECT(input_.sigma.empty() == parted() && (!parted() || !input_.condition));
    for (double const period : period_s_) {
        log_period_.push_back(std::log(period));
    }
}

double TargetVariability::sigma(double period_s) const {
    return parted() ? std::hypot(interpolated(input_.between, period_s), interpolated(input_.within, period_s))
                    : interpolated(input_.sigma, period_s);
}

double TargetVariability::spread(double period_s) const {
    double const rho = input_.condition ? input_.correlation(period_s, input_.condition->period_s) : 0;
    return sigma(period_s) * std::sqrt(std::max(0.0, 1 - rho * rho));
}

std::vector<double> TargetVariability::deviations(std::uint64_t seed, std::uint64_t number, Purpose purpose) const {
    RandomStream stream(seed, number, purpose);
    std::vector<double> normals(correlated_.size());
    for (double& normal : normals) {
        normal = gsl_ran_gaussian_ziggurat(stream.gsl(), 1);
    }
    return correlated_(normals);
}

double TargetVariability::at_condition(std::vector<double> const& values) const {
    auto const place = std::find(period_s_.begin(), period_s_.end(), input_.condition->period_s);
    return values[place - period_s_.begin()];
}

DrawnTarget TargetVariability::draw(std::uint64_t seed, std::uint64_t wave) const {
    DrawnTarget drawn;
    drawn.number = wave / input_.per_target;
    drawn.event = drawn.number / input_.targets_per_event;
    auto epsilon = deviations(seed, drawn.number, Purpose::target_spectrum);
    if (parted()) {
        auto const event = deviations(seed, drawn.event, Purpose::event_spectrum);
        SigmaAt const between = [this](double period) { return interpolated(input_.between, period); };
        SigmaAt const within = [this](double period) { return interpolated(input_.within, period); };
        drawn.epsilon_between = epsilons(shape_of(log_period_, period_s_, event, between), between);
        drawn.epsilon_within = epsilons(shape_of(log_period_, period_s_, epsilon, within), within);
        for (std::size_t i = 0; i < epsilon.size(); ++i) {
            double const period = period_s_[i];
            epsilon[i] = (between(period) * event[i] + within(period) * epsilon[i]) / sigma(period);
        }
    }
    if (input_.condition) {
        // What is drawn freely, moved by what it misses: distributed as normals given one of them.
        double const missing = input_.condition->epsilon - at_condition(epsilon);
        for (std::size_t i = 0; i < epsilon.size(); ++i) {
            epsilon[i] += input_.correlation(period_s_[i], input_.condition->period_s) * missing;
        }
    }
    SigmaAt const in_all = [this](double period) { return sigma(period); };
    drawn.shape = shape_of(log_period_, period_s_, epsilon, in_all);
    drawn.epsilon = epsilons(drawn.shape, in_all);
    return drawn;
}

std::string TargetVariability::describe() const {
    auto text = parted() ? fmt::format("ln Sa with sigma {} between events and {} within", text_of(input_.between),
                                       text_of(input_.within))
                         : fmt::format("ln Sa with sigma {}", text_of(input_.sigma));
    text += fmt::format(", correlated by {}", input_.correlation_name);
    if (input_.condition) {
        text += fmt::format(", given epsilon {:g} at {:g} s", input_.condition->epsilon, input_.condition->period_s);
    }
    text += input_.per_target > 1 ? fmt::format(", {} waves a target", input_.per_target) : "";
    text += input_.targets_per_event > 1 ? fmt::format(", {} targets an event", input_.targets_per_event) : "";
    return text;
}

namespace {

constexpr config::Range sigmas{.low = 0, .high = 3, .low_open = true};

void check_sigma(Pair const& point, Pair const* before) {
    auto const [period, sigma] = point;
    validate(period > 0 && std::isfinite(period) && (before == nullptr || period > before->first),
             "period {} s (periods are positive and rise). Sort the table", period);
    validate(sigma > sigmas.low && sigma <= sigmas.high, "sigma {} at {} s (must be above {} and at most {}). Mend it",
             sigma, period, sigmas.low, sigmas.high);
}

/// Not in ms, and not of log10 Sa.
bool are_of_sigma(std::string_view first, std::string_view second) {
    return is_period_name(first) && is_in_si(first, Dimension::time)
           && lowered(second).find("log") == std::string::npos;
}

constexpr double most_epsilon = 4;
constexpr config::Keys condition_keys{
    config::number_key("period", Dimension::time, {.low = shortest_s, .high = longest_s},
                       "period at which Sa is given"),
    config::number_key("epsilon", Dimension::none, {.low = -most_epsilon, .high = most_epsilon},
                       "given Sa at that period, as standard deviations of ln Sa above the median")
        .otherwise(0),
    config::number_key("sa", Dimension::acceleration, config::Range::positive(),
                       "given Sa at that period, in place of epsilon")
        .optional()};
constexpr config::KeyTable condition_table{.meaning = "conditional spectra: Sa is given at one period",
                                           .keys = condition_keys.all};

// A number, a list of [period, number], or a file of two columns.
constexpr config::Key sigma_key(std::string_view name, std::string_view meaning) {
    return config::number_key(name, Dimension::none, sigmas, meaning)
        .or_as(config::pairs_key(name, Dimension::time, Dimension::none, ""))
        .or_as(config::text_key(name, ""));
}

constexpr std::int64_t many = 1'000'000;
constexpr config::Keys variability_keys{
    sigma_key("sigma", "standard deviation of ln Sa: a number, pairs [period, sigma], or a file with two columns")
        .only("there is no between and within"),
    sigma_key("between", "between-event standard deviation of ln Sa").only("within is stated too, in place of sigma"),
    sigma_key("within", "within-event standard deviation of ln Sa").only("between is stated too, in place of sigma"),
    config::text_key("correlation", "correlation between periods: baker-jayaram-2008, none, full, or a file"),
    config::integer_key("per_target", 1, many, "waves that share a target").otherwise(1),
    config::integer_key("targets_per_event", 1, many, "targets that share an event")
        .otherwise(1)
        .only("between and within are stated"),
    config::table_key<condition_table>("conditional", "condition: Sa given at one period")
        .optional()
        .only("sigma is stated")};

TargetVariability::Sigma read_sigma(config::Table const& table, config::Key const& described, InputFiles& files) {
    using config::Kind;
    auto const key = described.name;
    if (table.kind(key) == Kind::list) {
        auto points = table.pairs(described);
        return table.located(key, [&] {
            validate(!points.empty(), "empty (no standard deviation). State a number, or [[period, sigma], ...]");
            for (std::size_t i = 0; i < points.size(); ++i) {
                check_sigma(points[i], i == 0 ? nullptr : &points[i - 1]);
            }
            return points;
        });
    }
    if (table.kind(key) == Kind::text) {
        auto const name = table.text(key);
        return table.located(key, [&] {
            return read_pairs(files.read(name), name,
                              {.meaning = "period in s and sigma", .check = check_sigma, .are_names = are_of_sigma});
        });
    }
    return {{1.0, table.number(described)}};
}

PeriodCorrelation read_correlation_model(config::Table const& table, InputFiles& files, std::string const& name) {
    if (name == "baker-jayaram-2008") {
        return baker_jayaram_2008;
    }
    if (name == "none") {
        return [](double a, double b) { return a == b ? 1.0 : 0.0; };
    }
    if (name == "full") {
        return [](double, double) { return 1.0; };
    }
    if (name.find('.') == std::string::npos) {
        table.fail("correlation",
                   fmt::format("'{}' (one of baker-jayaram-2008, none, full, or a file). Choose one", name));
    }
    return table.located("correlation", [&] { return TabulatedCorrelation::parse(files.read(name), name); });
}

TargetVariability::Input::Condition read_condition(config::Table const& table, TargetSpectrum const& median,
                                                   TargetVariability::Sigma const& sigma) {
    table.may_have(condition_table);
    double const period = table.number(condition_keys["period"]);
    if (!table.has("sa")) {
        double const epsilon = table.number(condition_keys["epsilon"]);
        table.finish();
        return {period, epsilon};
    }
    if (table.has("epsilon")) {
        table.fail("epsilon", "beside sa (one of them gives the other). Keep one");
    }
    double const sa = table.number(condition_keys["sa"]);
    double const there = median.psa_mps2(median.model_period_s(period));
    double const epsilon = std::log(sa / there) / interpolated(sigma, period);
    if (std::abs(epsilon) > most_epsilon) {
        table.fail("sa", fmt::format("{:.4g} m/s2, {:.3g} standard deviations from the target's {:.4g} m/s2 (at most "
                                     "{:g}). Scale the target",
                                     sa, epsilon, there, most_epsilon));
    }
    table.finish();
    return {period, epsilon};
}

}  // namespace

constinit config::KeyTable const variability_table{
    .meaning = "targets with the variability of recorded spectra about the given target", .keys = variability_keys.all};

TargetVariability read_variability(config::Table const& table, TargetSpectrum const& median, InputFiles& files) {
    table.may_have(variability_table);
    TargetVariability::Input input;
    bool const parts = table.has("between") || table.has("within");
    if (parts && table.has("sigma")) {
        table.fail("sigma", "beside between and within (their squares add up to its own). Keep one or the other");
    }
    if (parts) {
        input.between = read_sigma(table, variability_keys["between"], files);
        input.within = read_sigma(table, variability_keys["within"], files);
    } else {
        input.sigma = read_sigma(table, variability_keys["sigma"], files);
    }
    if (!table.has("correlation")) {
        table.fail_missing("correlation", "State baker-jayaram-2008, none, full, or a file");
    }
    input.correlation_name = table.text(variability_keys["correlation"]);
    input.correlation = read_correlation_model(table, files, input.correlation_name);
    input.per_target = table.integer(variability_keys["per_target"]);
    if (table.has("targets_per_event") && !parts) {
        table.fail("targets_per_event",
                   "without between and within (targets are independent). State both, or leave it "
                   "out");
    }
    input.targets_per_event = table.integer(variability_keys["targets_per_event"]);
    if (table.has("conditional")) {
        if (parts) {
            table.fail("conditional",
                       "beside between and within (an event's part would have to be known). State sigma");
        }
        input.condition = read_condition(table.child(variability_keys["conditional"]), median, input.sigma);
    }
    table.finish();
    return table.located("correlation", [&] { return TargetVariability(std::move(input)); });
}

}  // namespace overturn

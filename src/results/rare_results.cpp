#include "results/rare_results.hpp"

#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/detail/column_values.hpp"
#include "results/rare_rows.hpp"

namespace overturn {
namespace {

constexpr std::string_view between_tries = "; then ";

/// A look at an estimator's health, as a row of /rare/<body>/health; the names are lines of that group's attribute.
struct HealthRow {
    std::int64_t level = 0;
    double value = 0, limit = 0;
    std::int64_t passed = 0;
};

Fields const& health_fields() {
    using H = HealthRow;
    static Fields const fields{field<&H::level>("level", "1", "number of the level that was looked at"),
                               field<&H::value>("value", "1", "what was found"),
                               field<&H::limit>("limit", "1", "what it was held against"),
                               field<&H::passed>("passed", "1", "1: on the trusted side of the limit")};
    return fields;
}

store::TableSpec health_table(std::string const& group) {
    return {group + "/health", sizeof(HealthRow), health_fields(), "check",
            "number of the look, as the lines of health_checks"};
}

void write_health(store::ResultsWriter& file, std::string const& group, std::span<rare::Estimate const> estimates) {
    std::vector<HealthRow> rows;
    std::vector<std::string> names;
    for (std::size_t l = 0; l < estimates.size(); ++l) {
        for (auto const& check : estimates[l].health) {
            rows.push_back({static_cast<std::int64_t>(l), check.value, check.limit, check.passed ? 1 : 0});
            names.push_back(check.name);
        }
    }
    auto const table = file.table(health_table(group), static_cast<std::int64_t>(rows.size()));
    file.append(table, std::as_bytes(std::span(rows)));
    file.attribute(group, "health_checks", fmt::format("{}", fmt::join(names, "\n")));
}

void write_estimates(store::ResultsWriter& file, std::string const& group, std::span<rare::Estimate const> estimates) {
    auto const real = [&](char const* name, char const* description, auto get) {
        file.array(group, {name, "1", description}, column_values<double>(estimates, get), "amplitude");
    };
    auto const integer = [&](char const* name, char const* description, auto get) {
        file.array(group, {name, "1", description}, column_values<std::int64_t>(estimates, get), "amplitude");
    };
    real("amplitude", "value of the level", [](rare::Estimate const& e) { return e.factor; });
    real("probability", "of overturning; NaN where nothing can be trusted",
         [](rare::Estimate const& e) { return e.probability.value_or(never); });
    real("lower", "lower end of the 95 % interval", [](rare::Estimate const& e) { return e.interval_95.lower; });
    real("upper", "upper end; of plain trials alone where nothing else can be trusted",
         [](rare::Estimate const& e) { return e.interval_95.upper; });
    real("cov", "standard error over probability; 0 without one", [](rare::Estimate const& e) { return e.cov; });
    real("crude_runs", "waves that crude Monte Carlo needs for this; 0 without a probability",
         [](rare::Estimate const& e) { return e.crude_runs; });
    integer("runs", "waves made, those that levels share included", [](rare::Estimate const& e) { return e.runs; });
    integer("method", "0 crude, 1 subset, 2 pulse-mixture", [](rare::Estimate const& e) { return e.method; });
    integer("state", "0 trusted, 1 not-trusted, 2 not-resolved", [](rare::Estimate const& e) { return e.state; });
    std::vector<double> replicates;
    std::vector<std::int64_t> counts;
    std::vector<std::string> reasons;
    std::vector<std::string> tried;
    for (auto const& estimate : estimates) {
        replicates.insert(replicates.end(), estimate.replicates.begin(), estimate.replicates.end());
        counts.push_back(static_cast<std::int64_t>(estimate.replicates.size()));
        reasons.push_back(estimate.reason);
        tried.push_back(fmt::format("{}", fmt::join(estimate.tried, between_tries)));
    }
    file.array(group,
               {"replicates", "1", "estimates of the replicates, level by level; not to be used where not trusted"},
               replicates);
    file.array(group, {"replicate_count", "1", "replicates of each level"}, counts, "amplitude");
    file.attribute(group, "reasons", fmt::format("{}", fmt::join(reasons, "\n")));
    file.attribute(group, "tried", fmt::format("{}", fmt::join(tried, "\n")));
    write_health(file, group, estimates);
}

void write_mixture(store::ResultsWriter& file, std::string const& group, rare::PulseResult const& result) {
    for (std::size_t s = 0; s < result.stages.front().size(); ++s) {
        auto const place = fmt::format("{}/stage-{}", group, s);
        std::vector<double> shares;
        std::vector<double> lines;
        std::vector<double> arrivals;
        for (auto const& replicate : result.stages) {
            for (auto const& pulse : replicate[s].mixture.pulses()) {
                shares.push_back(pulse.share);
                for (auto const& line : pulse.lines) {
                    lines.push_back(line.real());
                    lines.push_back(line.imag());
                }
                arrivals.insert(arrivals.end(), pulse.arrival.begin(), pulse.arrival.end());
            }
        }
        file.array(place, {"factors", "1", "factors on the wave; bit i of a row is the i-th"},
                   result.stages.front()[s].factors);
        file.array(place, {"shares", "1", "how often each pulse is chosen, by replicate"}, shares);
        file.array(place, {"lines", "1", "shift of each line, real and imaginary part, by replicate and pulse"}, lines);
        file.array(place, {"arrivals", "1", "how often it arrives at each point in time, by replicate and pulse"},
                   arrivals);
    }
}

void write_subset(store::ResultsWriter& file, std::string const& place, rare::SubsetResult const& result) {
    std::vector<std::int64_t> levels;
    std::vector<double> thresholds;
    std::vector<double> acceptance;
    for (auto const& replicate : result.replicates) {
        levels.push_back(replicate.levels);
        thresholds.insert(thresholds.end(), replicate.thresholds.begin(), replicate.thresholds.end());
        acceptance.insert(acceptance.end(), replicate.acceptance.begin(), replicate.acceptance.end());
    }
    file.array(place, {"factors", "1", "factor on the wave"}, std::vector<double>{result.estimate.factor});
    file.array(place, {"levels", "1", "levels below the last, of each replicate"}, levels);
    file.array(place, {"thresholds", "1", "of the driver, level by level of each replicate"}, thresholds);
    file.array(place, {"acceptance", "1", "share of moves that were taken, level by level of each replicate"},
               acceptance);
}

rare::Estimate read_estimate(store::ResultsReader const& file, std::string const& group, std::int64_t level) {
    auto const real = [&](char const* name) { return file.real_at(group + "/" + name, level); };
    rare::Estimate made;
    made.factor = real("amplitude");
    if (double const p = real("probability"); !std::isnan(p)) {
        made.probability = p;
    }
    made.interval_95 = {real("lower"), real("upper")};
    made.cov = real("cov");
    made.crude_runs = real("crude_runs");
    made.runs = file.integer_at(group + "/runs", level);
    made.method = static_cast<rare::Method>(file.integer_at(group + "/method", level));
    made.state = static_cast<rare::State>(file.integer_at(group + "/state", level));
    return made;
}

// The parts of a text, at least one.
std::vector<std::string> parts_of(std::string_view text, std::string_view between) {
    std::vector<std::string> parts;
    for (auto end = text.find(between); end != std::string_view::npos; end = text.find(between)) {
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(end + between.size());
    }
    parts.emplace_back(text);
    return parts;
}

// The lines of a text, as many as there are levels.
std::vector<std::string> lines_of(std::string const& text) { return parts_of(text, "\n"); }

// The looks of all levels, each to its own.
void read_health(store::ResultsReader const& file, std::string const& group, std::vector<rare::Estimate>& estimates) {
    auto const names = lines_of(file.text_attribute(group, "health_checks"));
    auto const count = file.integers(group + "/health/level").size();
    std::vector<HealthRow> rows(count);
    file.rows(health_table(group), static_cast<std::int64_t>(count), 0, std::as_writable_bytes(std::span(rows)));
    for (std::size_t i = 0; i < count; ++i) {
        estimates.at(static_cast<std::size_t>(rows[i].level))
            .health.push_back({names.at(i), rows[i].value, rows[i].limit, rows[i].passed != 0});
    }
}

}  // namespace

std::string rare_group(CampaignSpec const& spec, std::size_t body, std::size_t limit) {
    return (limit == 0 ? "rare/" : "limits/" + spec.limits[limit].name + "/rare/") + spec.bodies[body].name;
}

void write_rare(store::ResultsWriter& file, CampaignSpec const& spec, std::span<RareBody const> bodies) {
    for (auto const& body : bodies) {
        auto const group = rare_group(spec, body.body, body.limit);
        write_estimates(file, group, body.estimates);
        auto const rows = rare_rows(body);
        auto const table =
            file.table({group + "/rows", sizeof(RareRow), fields_of<RareRow>(), "row", "number of the row"},
                       static_cast<std::int64_t>(rows.size()));
        file.append(table, std::as_bytes(std::span(rows)));
        for (std::size_t m = 0; m < body.record.mixtures.size(); ++m) {
            write_mixture(file, fmt::format("{}/mixture-{}", group, m), body.record.mixtures[m]);
        }
        for (std::size_t s = 0; s < body.record.subsets.size(); ++s) {
            write_subset(file, fmt::format("{}/subset-{}", group, s), body.record.subsets[s]);
        }
    }
}

std::vector<RareBody> read_rare_estimates(store::ResultsReader const& file, CampaignSpec const& spec) {
    std::vector<RareBody> bodies;
    for (std::size_t p = 0; p < spec.bodies.size() * spec.limits.size(); ++p) {
        RareBody made{.body = p % spec.bodies.size(), .limit = p / spec.bodies.size(), .estimates = {}, .record = {}};
        auto const group = rare_group(spec, made.body, made.limit);
        if (!spec.rare || !file.has(group)) {
            return {};
        }
        auto const reasons = lines_of(file.text_attribute(group, "reasons"));
        auto const tried = lines_of(file.text_attribute(group, "tried"));
        auto const counts = file.integers(group + "/replicate_count");
        auto const replicates = file.reals(group + "/replicates");
        std::size_t taken = 0;
        for (std::size_t l = 0; l < counts.size(); ++l) {
            auto estimate = read_estimate(file, group, static_cast<std::int64_t>(l));
            estimate.reason = l < reasons.size() ? reasons[l] : "";
            if (l < tried.size() && !tried[l].empty()) {
                estimate.tried = parts_of(tried[l], between_tries);
            }
            auto const count = static_cast<std::size_t>(counts[l]);
            auto const own = std::span(replicates).subspan(taken, count);
            estimate.replicates.assign(own.begin(), own.end());
            taken += count;
            made.estimates.push_back(std::move(estimate));
        }
        read_health(file, group, made.estimates);
        bodies.push_back(std::move(made));
    }
    return bodies;
}

std::string rare_table(CampaignSpec const& spec, std::span<RareBody const> bodies) {
    std::string text;
    for (auto const& body : bodies) {
        auto const& limit = spec.limits[body.limit];
        text += fmt::format("\nrare events of {}{}, by {}\n{:>10}  {:>10}  {:>22}  {:>6}  {:>13}  {:>9}  {:>10}\n",
                            spec.bodies[body.body].name, body.limit == 0 ? "" : ": " + limit.name,
                            spec.levels.measure_name(), "amplitude", "P", "95 % interval", "c.o.v.", "method", "waves",
                            "crude");
        for (auto const& e : body.estimates) {
            auto const interval = fmt::format("[{:.3g}, {:.3g}]", e.interval_95.lower, e.interval_95.upper);
            text += e.probability
                        ? fmt::format("{:>10.4g}  {:>10.3e}  {:>22}  {:>6.3f}  {:>13}  {:>9}  {:>10.2g}\n", e.factor,
                                      *e.probability, interval, e.cov, name_of(e.method), e.runs, e.crude_runs)
                        : fmt::format("{:>10.4g}  {:>10}  {:>22}  {:>6}  {:>13}  {:>9}  {}: {}\n", e.factor,
                                      fmt::format("< {:.2e}", e.interval_95.upper), "", "", name_of(e.method), e.runs,
                                      name_of(e.state), e.reason);
        }
        for (auto const& e : body.estimates) {
            for (auto const& words : e.tried) {
                text += fmt::format("  note: at {:.4g} tried before: {}\n", e.factor, words);
            }
            if (e.probability && e.cov > spec.rare->target_cov) {
                text += fmt::format(
                    "  note: at {:.4g} the c.o.v. {:.3f} exceeds target_cov {:g} (replicates grow up to "
                    "four times, within max_runs). State more of them\n",
                    e.factor, e.cov, spec.rare->target_cov);
            }
        }
    }
    return text;
}

}  // namespace overturn

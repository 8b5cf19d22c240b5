#include "results/rare_results.hpp"

#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/rare_rows.hpp"
#include "results/schema.hpp"

namespace overturn {
namespace {

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
        file.array(place, {"shares", "1", "probability of each pulse, by replicate"}, shares);
        file.array(place, {"lines", "1", "shift of each line, real and imaginary part, by replicate and pulse"}, lines);
        file.array(place, {"arrivals", "1", "probability of each arrival time, by replicate and pulse"}, arrivals);
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
    file.array(place, {"levels", "1", "number of levels before the last, of each replicate"}, levels);
    file.array(place, {"thresholds", "1", "threshold of the driver, by level of each replicate"}, thresholds);
    file.array(place, {"acceptance", "1", "share of accepted moves, by level of each replicate"}, acceptance);
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

// A text of each level: a column, up to format 4 lines of an attribute.
std::vector<std::string> texts_of(store::ResultsReader const& file, std::string const& group, char const* column,
                                  char const* attribute) {
    auto const path = group + "/" + column;
    return file.has(path) || file.attribute_or(group, attribute, "").empty()
               ? file.texts(path)
               : parts_of(file.attribute_or(group, attribute, ""), "\n");
}

// The numbers of names; up to format 4 numbers alone.
std::vector<std::int64_t> numbers_of(store::ResultsReader const& file, std::string const& path,
                                     std::vector<std::string> names) {
    return file.categories(path).empty() ? file.integers(path) : file.named(path, numbered(std::move(names)));
}

std::vector<rare::Estimate> read_estimates(store::ResultsReader const& file, std::string const& group) {
    auto const amplitudes = file.reals(group + "/amplitude");
    std::vector<rare::Estimate> estimates(amplitudes.size());
    auto const reals = [&](char const* name, auto put) {
        auto const values = file.reals(group + "/" + name);
        for (std::size_t l = 0; l < estimates.size(); ++l) {
            put(estimates[l], values.at(l));
        }
    };
    using E = rare::Estimate;
    reals("amplitude", [](E& e, double value) { e.factor = value; });
    reals("probability",
          [](E& e, double value) { e.probability = std::isnan(value) ? std::nullopt : std::optional(value); });
    reals("lower", [](E& e, double value) { e.interval_95.lower = value; });
    reals("upper", [](E& e, double value) { e.interval_95.upper = value; });
    reals("cov", [](E& e, double value) { e.cov = std::isnan(value) ? 0 : value; });
    reals("crude_runs", [](E& e, double value) { e.crude_runs = std::isnan(value) ? 0 : value; });
    auto const runs = file.integers(group + "/runs");
    auto const methods = numbers_of(file, group + "/method", rare_method_names());
    auto const states = numbers_of(file, group + "/state", rare_state_names());
    auto const reasons = texts_of(file, group, "reason", "reasons");
    auto const tried = texts_of(file, group, "tried", "tried");
    for (std::size_t l = 0; l < estimates.size(); ++l) {
        auto& estimate = estimates[l];
        estimate.runs = runs.at(l);
        estimate.method = static_cast<rare::Method>(methods.at(l));
        estimate.state = static_cast<rare::State>(states.at(l));
        estimate.reason = l < reasons.size() ? reasons[l] : "";
        if (l < tried.size() && !tried[l].empty()) {
            estimate.tried = parts_of(tried[l], between_tries);
        }
    }
    return estimates;
}

void read_replicates(store::ResultsReader const& file, std::string const& group, std::string const& own,
                     std::vector<rare::Estimate>& estimates) {
    if (file.has(own)) {
        auto const levels = file.integers(own + "/level");
        auto const values = file.reals(own + "/estimate");
        for (std::size_t i = 0; i < levels.size(); ++i) {
            estimates.at(levels[i]).replicates.push_back(values.at(i));
        }
        return;
    }
    if (!file.has(group + "/replicate_count")) {
        return;
    }
    auto const counts = file.integers(group + "/replicate_count");
    auto const values = file.reals(group + "/replicates");
    std::size_t taken = 0;
    for (std::size_t l = 0; l < counts.size(); ++l) {
        auto const of_level = std::span(values).subspan(taken, counts[l]);
        estimates.at(l).replicates.assign(of_level.begin(), of_level.end());
        taken += of_level.size();
    }
}

void read_health(store::ResultsReader const& file, std::string const& group, std::string const& own,
                 std::vector<rare::Estimate>& estimates) {
    bool const now = file.has(own);
    auto const place = now ? own : group + "/health";
    if (!file.has(place)) {
        return;
    }
    auto const names =
        now ? file.texts(place + "/check") : parts_of(file.attribute_or(group, "health_checks", ""), "\n");
    auto const levels = file.integers(place + "/level");
    auto const values = file.reals(place + "/value");
    auto const limits = file.reals(place + (now ? "/limit_value" : "/limit"));
    auto const passed = file.integers(place + "/passed");
    for (std::size_t i = 0; i < levels.size(); ++i) {
        estimates.at(levels[i]).health.push_back({names.at(i), values.at(i), limits.at(i), passed.at(i) != 0});
    }
}

}  // namespace

std::string rare_group(CampaignSpec const& spec, std::size_t body, std::size_t limit, std::string const& table) {
    return group_of(table, spec.bodies[body].name, spec.limits[limit].name);
}

void write_rare_record(store::ResultsWriter& file, CampaignSpec const& spec, std::span<RareBody const> bodies) {
    for (auto const& body : bodies) {
        auto const group = rare_group(spec, body.body, body.limit);
        auto const rows = rare_rows(body);
        auto const table = file.table(
            {group + "/rows", sizeof(RareRow), fields_of<RareRow>(), "row", "number of the row"}, rows.size());
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
        made.estimates = read_estimates(file, group);
        read_replicates(file, group, rare_group(spec, made.body, made.limit, "rare_replicates"), made.estimates);
        read_health(file, group, rare_group(spec, made.body, made.limit, "rare_health"), made.estimates);
        bodies.push_back(std::move(made));
    }
    return bodies;
}

}  // namespace overturn

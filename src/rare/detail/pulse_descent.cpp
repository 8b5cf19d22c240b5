#include "rare/detail/pulse_descent.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "rare/detail/answer_items.hpp"
#include "rare/detail/normals.hpp"

namespace overturn::rare {
namespace {

std::int64_t failures_of(MixtureStage const& stage) {
    return std::count_if(stage.rows.begin(), stage.rows.end(),
                         [](WeightedRow const& row) { return (row.failed & 1U) != 0; });
}

// A mixture as numbers of one length: per pulse its share, its lines, its arrivals.
std::size_t numbers_of(PulseFrame const& frame, std::size_t pulses) {
    return pulses * (1 + 2 * frame.lines + Mixture::grid_of(frame));
}

void put(Mixture const& mixture, std::vector<double>& numbers) {
    for (auto const& pulse : mixture.pulses()) {
        numbers.push_back(pulse.share);
        for (auto const& line : pulse.lines) {
            numbers.push_back(line.real());
            numbers.push_back(line.imag());
        }
        numbers.insert(numbers.end(), pulse.arrival.begin(), pulse.arrival.end());
    }
}

Mixture taken(PulseFrame const& frame, std::span<double const> numbers, std::size_t count) {
    std::vector<Pulse> pulses(count);
    auto next = numbers.begin();
    for (auto& pulse : pulses) {
        pulse.share = *next++;
        for (std::size_t k = 0; k < frame.lines; ++k) {
            double const real = *next++;
            pulse.lines.emplace_back(real, *next++);
        }
        auto const after = next + Mixture::grid_of(frame);
        pulse.arrival.assign(next, after);
        next = after;
    }
    return {frame, std::move(pulses)};
}

}  // namespace

bool draw_from(Mixture const& mixture, DrawKey const& key, std::span<double> normals) {
    draw_normals(key, normals);
    auto choice = key.stream(Purpose::rare_choice);
    return !mixture.shift(normals, choice);
}

PulseDescent::PulseDescent(Problem const& problem, Request const& request, Workforce& workers,
                           PulseOptions const& options)
    : problem_(problem), request_(request), workers_(workers), options_(options), frame_(problem.frame().value()) {
    std::size_t const replicates = request.replicates;
    stages_.resize(replicates);
    mixtures_.assign(replicates, Mixture(frame_));
}

// Rows of trials of a stage, from the one of that number on.
void PulseDescent::respond(MixtureStage const& stage, std::int64_t first, std::span<WeightedRow> rows) const {
    auto const draw = [&](std::size_t i, std::span<double> normals) {
        auto key = stage.key;
        key.index = static_cast<std::uint64_t>(first) + i;
        rows[i].plain = draw_from(stage.mixture, key, normals) ? 1 : 0;
        rows[i].weight = stage.mixture.weight(normals);
    };
    answer_items(problem_, rows.size(), stage.factors, draw,
                 [&](std::size_t i, std::span<Answer const> answers) { set_bits(rows[i], answers); });
}

void PulseDescent::run(std::string const& name, std::int64_t first, std::int64_t count) {
    auto const rows = workers_.map<WeightedRow>(
        {.name = name, .items = count * request_.replicates}, [&](std::int64_t from, std::span<WeightedRow> out) {
            while (!out.empty()) {  // what is left of a replicate: its factors are its own
                auto const place = from % count;
                auto const now = static_cast<std::size_t>(std::min<std::int64_t>(std::ssize(out), count - place));
                respond(stages_[from / count].back(), first + place, out.first(now));
                out = out.subspan(now);
                from += static_cast<std::int64_t>(now);
            }
        });
    for (std::size_t r = 0; r < stages_.size(); ++r) {
        auto const begin = rows.begin() + static_cast<std::ptrdiff_t>(r) * count;
        auto& own = stages_[r].back().rows;
        own.insert(own.end(), begin, begin + count);
    }
    runs_ += count * request_.replicates;
}

void PulseDescent::pilot(double factor) {
    spent_ = spent_ || runs_ + options_.pilot_runs * request_.replicates > request_.max_runs;
    if (spent_) {
        return;
    }
    auto const stage = stages_.front().size();
    for (std::size_t r = 0; r < stages_.size(); ++r) {
        stages_[r].push_back({.key = {.seed = request_.seed,
                                      .problem = request_.problem,
                                      .replicate = r,
                                      .phase = Phase::pilot,
                                      .level = stage},
                              .factors = {factor},
                              .mixture = mixtures_[r],
                              .rows = {}});
    }
    run(fmt::format("pilot-{}", stage), 0, options_.pilot_runs);
    constexpr std::int64_t fewest = 20;  // to group into pulses
    for (auto const& stages : stages_) {
        auto const failed = failures_of(stages.back());
        broken_ = broken_ || failed < fewest;
        if (stage > 0) {
            poorest_hits_ =
                std::min(poorest_hits_, static_cast<double>(failed) / static_cast<double>(options_.pilot_runs));
        }
    }
}

Mixture PulseDescent::fitted(std::vector<MixtureStage> const& stages, std::size_t pooled) const {
    std::vector<FailedWave> waves;
    std::vector<double> normals(problem_.normals());
    for (auto const& stage : std::span(stages).last(pooled)) {
        for (std::size_t i = 0; i < stage.rows.size(); ++i) {
            if ((stage.rows[i].failed & 1U) == 0) {
                continue;
            }
            auto key = stage.key;
            key.index = i;
            draw_from(stage.mixture, key, normals);
            FailedWave wave{
                .lines = {}, .moment = problem_.moment(normals, stage.factors.front()), .weight = stage.rows[i].weight};
            for (std::size_t k = 0; k < frame_.lines; ++k) {
                wave.lines.emplace_back(normals[2 * k], normals[2 * k + 1]);
            }
            waves.push_back(std::move(wave));
        }
    }
    return fit_pulses(frame_, waves, options_.fit);
}

void PulseDescent::fit(std::size_t pooled, double strengthened) {
    auto const numbers = numbers_of(frame_, options_.fit.pulses);
    Stage const stage{.name = fmt::format("fit-{}", stages_.front().size() - 1),
                      .items = request_.replicates,
                      .block = 1,
                      .row_bytes = numbers * sizeof(double)};
    auto const bytes = workers_.rows_of(stage, [&](std::int64_t first, std::span<std::byte> out) {
        std::vector<double> made;
        put(fitted(stages_[first], pooled).strengthened(strengthened), made);
        std::memcpy(out.data(), made.data(), out.size());
    });
    std::vector<double> all(bytes.size() / sizeof(double));
    std::memcpy(all.data(), bytes.data(), bytes.size());
    for (std::size_t r = 0; r < mixtures_.size(); ++r) {
        mixtures_[r] = taken(frame_, std::span(all).subspan(r * numbers, numbers), options_.fit.pulses);
    }
}

void PulseDescent::descend(double from, double to) {
    if (options_.fit.pulses == 0) {
        return;
    }
    double factor = from;
    pilot(factor);
    while (!broken_ && !spent_ && factor > to) {
        double const next = std::max(to, options_.descent * factor);
        fit(1, factor / next);
        factor = next;
        pilot(factor);
    }
    for (std::int64_t refit = 0; !broken_ && !spent_ && refit < options_.refits; ++refit) {
        fit(static_cast<std::size_t>(refit) + 1, 1);
        if (refit + 1 < options_.refits) {
            pilot(factor);
        }
    }
}

void PulseDescent::finish(std::span<double const> factors, std::int64_t runs_each) {
    auto const begun = !stages_.front().empty() && stages_.front().back().key.phase == Phase::final;
    for (std::size_t r = 0; !begun && r < stages_.size(); ++r) {
        stages_[r].push_back(
            {.key = {.seed = request_.seed, .problem = request_.problem, .replicate = r, .phase = Phase::final},
             .factors = {factors.begin(), factors.end()},
             .mixture = mixtures_[r],
             .rows = {}});
    }
    std::int64_t const first = stages_.front().back().rows.size();
    run(fmt::format("final-{}", first), first, runs_each);
}

}  // namespace overturn::rare

#include "stats/rank.hpp"

#include <algorithm>
#include <map>

#include "core/random_stream.hpp"

namespace overturn {
namespace {

// Trials in rising order, each with the number of its wave from 0.
struct Ranked {
    struct Entry {
        double intensity;
        std::size_t wave;
        bool overturned;
    };
    std::vector<Entry> entries;
    std::size_t waves = 0;
};

Ranked ranked(std::span<SingleTrial const> trials) {
    std::map<std::int64_t, std::size_t> numbers;
    for (auto const& trial : trials) {
        numbers.emplace(trial.wave, 0);
    }
    Ranked result;
    for (auto& [wave, number] : numbers) {
        number = result.waves++;
    }
    result.entries.reserve(trials.size());
    for (auto const& trial : trials) {
        result.entries.push_back({trial.intensity, numbers.at(trial.wave), trial.overturned});
    }
    std::stable_sort(result.entries.begin(), result.entries.end(),
                     [](auto const& a, auto const& b) { return a.intensity < b.intensity; });
    return result;
}

// With every wave counted `times[wave]` times; whole numbers and halves, so exact in any order.
double weighted_area(Ranked const& ranked, std::span<double const> times) {
    double stood_below = 0;
    double overturned = 0;
    double above = 0;
    auto const& e = ranked.entries;
    for (std::size_t i = 0; i < e.size();) {
        double tied_stood = 0;
        double tied_overturned = 0;
        for (double const at = e[i].intensity; i < e.size() && e[i].intensity == at; ++i) {
            (e[i].overturned ? tied_overturned : tied_stood) += times[e[i].wave];
        }
        above += tied_overturned * (stood_below + tied_stood / 2);
        stood_below += tied_stood;
        overturned += tied_overturned;
    }
    return above / (overturned * stood_below);
}

}  // namespace

double rank_area(std::span<SingleTrial const> trials) {
    auto const order = ranked(trials);
    return weighted_area(order, std::vector<double>(order.waves, 1.0));
}

double rank_area(std::span<FragilityPoint const> points) {
    double stood_below = 0;
    double above = 0;
    for (auto const& point : points) {
        double const stood = point.trials - point.overturned;
        above += point.overturned * (stood_below + stood / 2);
        stood_below += stood;
    }
    return above / (sum_of(points).overturned * stood_below);
}

std::vector<double> rank_area_replicates(std::span<SingleTrial const> trials, BootstrapKey const& key) {
    auto const order = ranked(trials);
    std::vector<double> areas;
    areas.reserve(key.replicates);
    for (int r = 0; r < key.replicates; ++r) {
        RandomStream stream(key.seed, r, Purpose::bootstrap, key.stream);
        std::vector<double> times(order.waves, 0.0);
        for (std::size_t draw = 0; draw < order.waves; ++draw) {
            times[gsl_rng_uniform_int(stream.gsl(), order.waves)] += 1;
        }
        areas.push_back(weighted_area(order, times));
    }
    return areas;
}

}  // namespace overturn

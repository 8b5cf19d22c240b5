#include "results/rare_waves.hpp"

#include <algorithm>
#include <complex>

#include <fmt/format.h>

#include "core/units.hpp"
#include "results/rare_replayer.hpp"
#include "results/rare_results.hpp"

namespace overturn {
namespace {

GroundMotion times(GroundMotion motion, double factor) {
    motion.scale(factor);
    return motion;
}

// No wave but the pulse, at its commonest arrival.
std::vector<double> normals_of(rare::Pulse const& pulse, std::size_t count) {
    std::vector<double> normals(count, 0.0);
    auto const grid = pulse.arrival.size();
    auto const most = std::ranges::max_element(pulse.arrival);
    auto const arrival = static_cast<std::size_t>(most - pulse.arrival.begin());
    for (std::size_t k = 1; k <= pulse.lines.size(); ++k) {
        double const turn = -2 * pi * static_cast<double>(k * arrival % grid) / static_cast<double>(grid);
        auto const line = pulse.lines[k - 1] * std::polar(1.0, turn);
        normals[2 * k - 2] = line.real();
        normals[2 * k - 1] = line.imag();
    }
    return normals;
}

/// Keeps time and tilt.
class Tilts : public Observer {
  public:
    explicit Tilts(FailingWave& wave) : wave_(wave) {}
    void begin(std::span<Channel const> channels) override {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            time_ = channels[c].key == "time_s" ? c : time_;
            tilt_ = channels[c].key == "rotation_rad" || channels[c].key == "tilt_rad" ? c : tilt_;
        }
    }
    void at(std::span<double const> values) override {
        wave_.tilt_time_s.push_back(values[time_]);
        wave_.tilt_rad.push_back(values[tilt_]);
    }

  private:
    FailingWave& wave_;
    std::size_t time_ = 0, tilt_ = 0;
};

std::vector<FailurePulse> pulses_of(RareReplayer const& replayer, RareRow const& row) {
    std::vector<FailurePulse> pulses;
    double const fitted = replayer.factors(row).back();  // of a final stage the wanted ones come before it
    auto const& problem = replayer.problem();
    auto const mixture = replayer.mixture_of(row);
    for (auto const& pulse : mixture.pulses()) {
        auto const wave = problem.motion(normals_of(pulse, problem.normals()));
        pulses.push_back({.share = pulse.share, .factor = fitted, .motion = times(wave, fitted)});
    }
    std::ranges::stable_sort(pulses, std::ranges::greater{}, &FailurePulse::share);
    return pulses;
}

FailingWave failing_wave(RareReplayer const& replayer, RareRow const& row, std::int64_t number) {
    double const factor = replayer.factors(row).front();
    auto const normals = replayer.normals_of_chain(row, number);
    FailingWave wave{.row = number, .factor = factor, .motion = times(replayer.problem().motion(normals), factor)};
    Tilts tilts(wave);
    replayer.problem().show(normals, factor, tilts);
    return wave;
}

// Of what was not trusted no pulse is what failing waves have in common.
bool mixture_is_trusted(store::ResultsReader const& file, CampaignSpec const& spec, std::size_t body) {
    auto const group = rare_group(spec, body, 0);
    auto const methods = file.integers(group + "/method");
    auto const states = file.integers(group + "/state");
    for (std::size_t l = 0; l < methods.size(); ++l) {
        if (methods[l] == static_cast<std::int64_t>(rare::Method::pulse_mixture)
            && states[l] == static_cast<std::int64_t>(rare::State::trusted)) {
            return true;
        }
    }
    return false;
}

}  // namespace

RareWaves rare_waves(store::ResultsReader const& file, CampaignSpec const& spec, std::size_t body) {
    RareReplayer const replayer(file, spec, body);
    RareWaves waves;
    std::optional<std::int64_t> drawn_last;
    std::optional<std::int64_t> failed_last;
    auto const group = fmt::format("rare/{}/rows/", spec.bodies[body].name);
    auto const methods = file.integers(group + "method");
    auto const replicates = file.integers(group + "replicate");
    auto const failed = file.integers(group + "failed");
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (replicates[i] != 0) {
            continue;
        }
        if (methods[i] == static_cast<std::int64_t>(rare::Method::pulse_mixture)) {
            drawn_last = static_cast<std::int64_t>(i);
        } else if (failed[i] != 0) {
            failed_last = static_cast<std::int64_t>(i);
        }
    }
    if (drawn_last && mixture_is_trusted(file, spec, body)) {
        waves.pulses = pulses_of(replayer, replayer.stored(*drawn_last));
    }
    if (failed_last) {
        waves.failing = failing_wave(replayer, replayer.stored(*failed_last), *failed_last);
    }
    return waves;
}

}  // namespace overturn

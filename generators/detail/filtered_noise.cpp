#include "generators/detail/filtered_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>

#include "generators/detail/aftershock.hpp"
#include "generators/detail/baseline.hpp"
#include "generators/detail/components.hpp"
#include "generators/detail/line_draws.hpp"
#include "generators/detail/noise_keys.hpp"
#include "generators/detail/point_density.hpp"
#include "generators/detail/real_fft.hpp"
#include "generators/envelope.hpp"

namespace overturn {
namespace {

/// The power of white noise behind a filter: only its shape counts.
struct NoiseShape {
    std::function<double(double)> density;  ///< at a frequency [rad/s]
    double integral_radps = 0;              ///< over all frequencies
    std::string text;
};

struct FilteredNoiseInput {
    NoiseShape shape;
    double rms_mps2 = 0;
    double time_step_s = 0.01;
    std::size_t samples = 0;
    Envelope envelope;
    LineAmplitudes amplitudes = LineAmplitudes::gaussian;
    struct Further {
        FurtherComponent component;
        double ratio, correlation;
    };
    std::vector<Further> further{};
};

class FilteredNoise : public WaveSource {
  public:
    explicit FilteredNoise(FilteredNoiseInput const& input)
        : fft_(RealFft::good_length(input.samples)),
          time_step_s_(input.time_step_s),
          amplitudes_(input.amplitudes),
          further_(input.further),
          envelope_(input.envelope.samples(input.time_step_s, input.samples)) {
        double const spacing = 2 * pi / (time_step_s_ * static_cast<double>(fft_.length()));
        line_amplitude_.push_back(0);
        double held = 0;  // of the filter's integral, by the frequencies that the time step holds
        for (std::size_t k = 1; k < fft_.length() / 2; ++k) {
            double const power = input.shape.density(spacing * static_cast<double>(k)) * spacing;
            held += power;
            line_amplitude_.push_back(std::sqrt(2 * power));
        }
        validate(held > 0,
                 "no line of the wave lies where the density is (lines are {:.3g} Hz apart, up to {:g} Hz). "
                 "Lengthen duration or shorten time_step",
                 spacing / (2 * pi), 0.5 / time_step_s_);
        for (double& amplitude : line_amplitude_) {
            amplitude *= input.rms_mps2 / std::sqrt(held);
        }
        auto text = fmt::format("{} samples of {} s, noise of {} m/s2, {}", input.samples, time_step_s_, input.rms_mps2,
                                input.shape.text);
        constexpr double nearly_all = 0.98;
        if (double const share = held / input.shape.integral_radps; share < nearly_all) {
            text += fmt::format(" (its spectrum cut at {:g} Hz, where {:.0f} % of its power lie below)",
                                0.5 / time_step_s_, 100 * share);
        }
        for (auto const& [component, ratio, correlation] : further_) {
            text += fmt::format(", {} {:g} of it, correlation {:g}", component.name, ratio, correlation);
        }
        describe({.text = text,
                  .variability = "random noise of one power spectral density; event, path and site do not vary",
                  .of_one_spectrum = true});
    }

    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const override {
        return made_of([&](std::uint64_t component) { return drawn(seed, wave, component); },
                       fmt::format("filtered noise {}", wave));
    }

    [[nodiscard]] std::unique_ptr<NormalWaves> from_normals() const override;

    /// Of normals, `lines` pairs for each component.
    [[nodiscard]] GroundMotion motion_of(std::span<double const> normals, std::size_t lines) const {
        std::size_t taken = 0;
        auto const next = [&](std::uint64_t /*component*/) {
            auto const own = normals.subspan(taken, 2 * lines);
            taken += own.size();
            return lines_of_normals(own, line_amplitude_, amplitudes_);
        };
        return made_of(next, {}).motion;
    }

    [[nodiscard]] std::size_t components() const { return 1 + further_.size(); }
    [[nodiscard]] std::vector<double> const& line_amplitude() const { return line_amplitude_; }
    [[nodiscard]] double spacing_radps() const { return 2 * pi / (time_step_s_ * static_cast<double>(fft_.length())); }
    [[nodiscard]] bool is_gaussian() const { return amplitudes_ == LineAmplitudes::gaussian; }

    [[nodiscard]] std::string pgd_drift() const override {
        return "the envelope puts energy of filtered noise at long periods: its displacement grows with the duration";
    }

  private:
    using Lines = std::vector<std::complex<double>>;

    // The components in turn from what `lines_of` says of each.
    template <class LinesOf> [[nodiscard]] GeneratedWave made_of(LinesOf&& lines_of, std::string label) const {
        auto const lines = lines_of(0);
        GeneratedWave made;
        made.motion.time_step_s = time_step_s_;
        made.motion.horizontal_mps2 = shaped(lines, 1);
        for (auto const& [component, ratio, correlation] : further_) {
            made.motion.*(component.place) = shaped(correlated(lines, lines_of(component.stream), correlation), ratio);
        }
        made.label = std::move(label);
        return made;
    }

    [[nodiscard]] Lines drawn(std::uint64_t seed, std::uint64_t wave, std::uint64_t component) const {
        return draw_lines(LineStreams::of_wave(seed, wave, component), line_amplitude_, amplitudes_);
    }

    [[nodiscard]] std::vector<double> shaped(Lines const& lines, double ratio) const {
        std::vector<double> series(fft_.length());
        fft_.synthesise(lines, series);
        series.resize(envelope_.size());
        for (std::size_t i = 0; i < series.size(); ++i) {
            series[i] *= ratio * envelope_[i];
        }
        correct_baseline(series);
        return series;
    }

    RealFft fft_;
    double time_step_s_;
    LineAmplitudes amplitudes_;
    std::vector<FilteredNoiseInput::Further> further_;
    std::vector<double> envelope_;
    std::vector<double> line_amplitude_;
};

// Line k is A_k z / sqrt 2, z the k-th pair of normals; with fixed amplitudes A_k z / |z|.
class FilteredNoiseOfNormals : public NormalWaves {
  public:
    explicit FilteredNoiseOfNormals(FilteredNoise const& source) : source_(source) {
        auto const& all = source.line_amplitude();
        auto const strong = std::find_if(all.rbegin(), all.rend(), [](double a) { return a > 0; });
        lines_ = static_cast<std::size_t>(all.rend() - strong) - 1;
    }

    [[nodiscard]] std::size_t normals() const override { return 2 * lines_ * source_.components(); }
    [[nodiscard]] GroundMotion make(std::span<double const> normals) const override {
        return source_.motion_of(normals, lines_);
    }

    [[nodiscard]] std::optional<LinearLines> linear() const override {
        return source_.is_gaussian() ? std::optional(LinearLines{lines_, source_.spacing_radps()}) : std::nullopt;
    }

  private:
    FilteredNoise const& source_;
    std::size_t lines_ = 0;
};

std::unique_ptr<NormalWaves> FilteredNoise::from_normals() const {
    return std::make_unique<FilteredNoiseOfNormals>(*this);
}

NoiseShape read_ground(config::Table const& waves, NoiseModel model, double time_step_s) {
    GroundFilter filter;
    double const ground_hz = waves.number(noise_keys["ground_frequency"]);
    filter.ground_radps = 2 * pi * ground_hz;
    filter.ground_damping = waves.number(noise_keys["ground_damping"]);
    bool const held_back = model == NoiseModel::clough_penzien;
    if (held_back) {
        filter.filter_radps = 2 * pi * waves.number(noise_keys["filter_frequency"]);
        filter.filter_damping = waves.number(noise_keys["filter_damping"]);
    }
    constexpr double steps_per_period = 4;
    if (1 / ground_hz < steps_per_period * time_step_s) {
        waves.fail("ground_frequency",
                   fmt::format("{:g} Hz (less than {} time steps a period). Use a shorter time_step", ground_hz,
                               steps_per_period));
    }
    return {[filter](double w_radps) { return filter.shape(w_radps); }, filter.integral_radps(),
            fmt::format("{}, ground {:.3g} Hz", held_back ? "Clough-Penzien" : "Kanai-Tajimi", ground_hz)};
}

NoiseShape read_points(config::Table const& waves, InputFiles& files) {
    auto const table = waves.child(noise_keys["density"]);
    auto const density = read_point_density(table, files);
    table.finish();
    return {[density](double w_radps) { return density.at(w_radps / (2 * pi)); }, 2 * pi * density.integral_hz(),
            fmt::format("density stated from {:g} Hz to {:g} Hz", density.first_hz(), density.last_hz())};
}

}  // namespace

double GroundFilter::shape(double w_radps) const {
    double const r = w_radps / ground_radps;
    double const z2 = 4 * ground_damping * ground_damping * r * r;
    double const ground = (1 + z2) / ((1 - r * r) * (1 - r * r) + z2);
    if (filter_radps == 0) {
        return ground;
    }
    double const q2 = (w_radps / filter_radps) * (w_radps / filter_radps);
    return ground * q2 * q2 / ((1 - q2) * (1 - q2) + 4 * filter_damping * filter_damping * q2);
}

double GroundFilter::integral_radps() const {
    double const z = ground_damping;
    double const w = ground_radps;
    if (filter_radps == 0) {
        return pi * w * (1 + 4 * z * z) / (4 * z);
    }
    // The transfer function is (b3 s^3 + b2 s^2) / (s^4 + a3 s^3 + a2 s^2 + a1 s + a0): James, Nichols and Phillips
    // (1947), the integral of order four.
    double const u = 2 * z * w;
    double const v = 2 * filter_damping * filter_radps;
    double const f2 = filter_radps * filter_radps;
    double const a3 = u + v;
    double const a2 = w * w + u * v + f2;
    double const a1 = u * f2 + v * w * w;
    double const a0 = w * w * f2;
    double const b2 = w * w;
    return pi / 2 * (u * u * (a0 * a3 - a1 * a2) - a1 * b2 * b2) / (a0 * a3 * a3 + a1 * a1 - a1 * a2 * a3);
}

constinit config::KeyTable const filtered_noise_table{.meaning = "noise filtered by a model of the ground",
                                                      .keys = noise_keys.all,
                                                      .also = {&every_wave_table, &aftershock_table},
                                                      .chosen_by = "source",
                                                      .word = "filtered-noise"};

std::unique_ptr<WaveSource> make_filtered_noise(config::Table const& waves, InputFiles& files) {
    FilteredNoiseInput input;
    input.rms_mps2 = waves.number(noise_keys["rms"]);
    input.time_step_s = waves.number(noise_keys["time_step"]);
    input.samples = read_samples(waves, input.time_step_s);
    auto const model = waves.choice(noise_keys["model"], std::span<config::Entry<NoiseModel> const>(noise_models));
    input.shape =
        model == NoiseModel::points ? read_points(waves, files) : read_ground(waves, model, input.time_step_s);
    input.amplitudes =
        waves.choice(noise_keys["amplitudes"], std::span<config::Entry<LineAmplitudes> const>(noise_amplitudes));
    double const duration = input.time_step_s * static_cast<double>(input.samples - 1);
    input.envelope = read_envelope(waves.child_or_empty(noise_keys["envelope"]), duration);
    for (auto const& component : further_components) {
        if (waves.has(component.name)) {
            auto const table = waves.child(component.name);
            input.further.push_back({component, read_ratio(table), read_correlation(table).value_or(0)});
            table.finish();
        }
    }
    return waves.located("duration", [&] { return std::make_unique<FilteredNoise>(input); });
}

}  // namespace overturn

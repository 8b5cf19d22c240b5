#include "generators/record_baseline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include <gsl/gsl_linalg.h>

#include "core/units.hpp"
#include "generators/detail/real_fft.hpp"
#include "generators/detail/sa_change.hpp"
#include "motion/intensity.hpp"

namespace overturn {
namespace {

constexpr int lowest_order = 1;
constexpr int highest_order = 10;
constexpr std::string_view high_pass_word = "high-pass";

constexpr std::array<config::Entry<BaselineMethod>, 3> plain_methods{
    {{"none", "as the file has it", BaselineMethod::none},
     {"mean", "without its mean acceleration", BaselineMethod::mean},
     {"polynomial", "without the polynomial that fits its displacement", BaselineMethod::polynomial}}};

constexpr std::array<config::Entry<FilterPhase>, 2> filter_phases{
    {{"zero", "forwards and backwards", FilterPhase::zero}, {"causal", "forwards only", FilterPhase::causal}}};

constexpr config::Keys high_pass_keys{
    config::number_key("high_pass", Dimension::frequency, config::Range::positive(), "corner frequency of the filter"),
    config::integer_key("order", lowest_order, highest_order, "order of the Butterworth filter")
        .otherwise(RecordBaseline{}.order),
    config::word_key<filter_phases>("phase", "phase of the filter: zero or causal").otherwise("zero")};

void take_mean_off(std::vector<double>& a) {
    double const mean = std::accumulate(a.begin(), a.end(), 0.0) / static_cast<double>(a.size());
    for (double& value : a) {
        value -= mean;
    }
}

struct Matrix {
    Matrix(std::size_t rows, std::size_t columns) : m(gsl_matrix_alloc(rows, columns)) {}
    ~Matrix() { gsl_matrix_free(m); }
    Matrix(Matrix const&) = delete;
    Matrix& operator=(Matrix const&) = delete;
    Matrix(Matrix&&) = delete;
    Matrix& operator=(Matrix&&) = delete;
    gsl_matrix* m;
};

// d = c2 s^2 + ... + c6 s^6 of the share s of the duration T. The end velocity is met exactly: 2 c2 = v T - sum k c_k
// of the higher ones, so that these are fitted as s^k - (k/2) s^2 to what (v T / 2) s^2 leaves of the displacement.
void take_polynomial_off(std::vector<double>& a, double time_step_s) {
    constexpr std::size_t terms = 4;
    constexpr std::size_t lowest = 3;
    auto const n = a.size();
    if (n <= 2 * terms) {
        return;  // every motion is a polynomial then
    }
    auto const last = static_cast<double>(n - 1);
    double const duration = last * time_step_s;
    double const end = velocity_of(a, time_step_s).back() * duration;
    auto left = displacement_of(a, time_step_s);
    Matrix const powers(n, terms);
    for (std::size_t i = 0; i < n; ++i) {
        double const s = static_cast<double>(i) / last;
        left[i] -= 0.5 * end * s * s;
        double power = s * s * s;
        for (std::size_t j = 0; j < terms; ++j, power *= s) {
            gsl_matrix_set(powers.m, i, j, power - 0.5 * static_cast<double>(j + lowest) * s * s);
        }
    }
    std::array<double, terms> tau{}, fitted{};
    std::vector<double> residual(n);
    auto tau_view = gsl_vector_view_array(tau.data(), terms);
    auto fitted_view = gsl_vector_view_array(fitted.data(), terms);
    auto left_view = gsl_vector_view_array(left.data(), n);
    auto residual_view = gsl_vector_view_array(residual.data(), n);
    gsl_linalg_QR_decomp(powers.m, &tau_view.vector);
    gsl_linalg_QR_lssolve(powers.m, &tau_view.vector, &left_view.vector, &fitted_view.vector, &residual_view.vector);
    double curvature_at_start = end;  // 2 c2
    for (std::size_t j = 0; j < terms; ++j) {
        curvature_at_start -= static_cast<double>(j + lowest) * fitted[j];
    }
    for (std::size_t i = 0; i < n; ++i) {
        double const s = static_cast<double>(i) / last;
        double curvature = 0;
        for (std::size_t j = terms; j-- > 0;) {
            auto const power = static_cast<double>(j + lowest);
            curvature = s * (curvature + power * (power - 1) * fitted[j]);
        }
        a[i] -= (curvature_at_start + curvature) / (duration * duration);
    }
}

// What a Butterworth low-pass of the same corner's complement leaves: 1 - H of the high-pass H, at f / corner.
std::complex<double> below_corner(double ratio, RecordBaseline const& baseline) {
    if (baseline.phase == FilterPhase::zero) {
        return 1 / (1 + std::pow(ratio, 2 * baseline.order));
    }
    std::complex<double> passed = 1;
    std::complex<double> const s(0, ratio);
    for (int k = 1; k <= baseline.order; ++k) {
        double const angle = pi * (2 * k + baseline.order - 1) / (2 * baseline.order);
        passed *= s / (s - std::polar(1.0, angle));
    }
    return 1.0 - passed;
}

// Taken off rather than kept: what lies far above the corner then stays as it is, to the last bits.
void high_pass(std::vector<double>& a, double time_step_s, RecordBaseline const& baseline) {
    double const pad_s = 1.5 * baseline.order / baseline.corner_hz;
    auto const pad = static_cast<std::size_t>(std::ceil(pad_s / time_step_s));
    auto const before = baseline.phase == FilterPhase::zero ? pad : 0;
    RealFft const fft(RealFft::good_length(a.size() + 2 * pad));
    std::vector<double> series(fft.length(), 0.0);
    std::copy(a.begin(), a.end(), series.begin() + before);
    std::vector<std::complex<double>> lines(fft.length() / 2);
    fft.analyse(series, lines);
    double const spacing_hz = 1 / (static_cast<double>(fft.length()) * time_step_s);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines[k] *= below_corner(static_cast<double>(k) * spacing_hz / baseline.corner_hz, baseline);
    }
    fft.synthesise(lines, series);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] -= series[before + i];
    }
}

void check_order(std::int64_t order) {
    validate(order >= lowest_order && order <= highest_order, "order {} (must be {} to {}). Use 4", order, lowest_order,
             highest_order);
}

}  // namespace

std::string RecordBaseline::says() const {
    switch (method) {
        case BaselineMethod::none:
            return {};
        case BaselineMethod::mean:
            return "mean taken off";
        case BaselineMethod::polynomial:
            return "baseline polynomial taken off";
        case BaselineMethod::high_pass:
            return fmt::format("high-passed at {:g} Hz (Butterworth, order {}, {})", corner_hz, order,
                               phase == FilterPhase::zero ? "zero phase" : "causal");
    }
    return {};
}

RecordBaseline parse_baseline(std::string_view text) {
    auto const plain = trimmed(text);
    if (plain.starts_with(high_pass_word)) {
        auto const corner = parse_quantity(plain.substr(high_pass_word.size()), Dimension::frequency);
        validate(corner > 0, "high-pass at {} Hz (must be above 0). Use 0.05 Hz", corner);
        return {.method = BaselineMethod::high_pass, .corner_hz = corner};
    }
    for (auto const& entry : plain_methods) {
        if (entry.name == plain) {
            return {.method = entry.value};
        }
    }
    auto known = config::names_of<BaselineMethod>(plain_methods);
    known.emplace_back("high-pass 0.05 Hz");
    throw InputError(fmt::format("baseline '{}' (unknown). {}", plain, config::suggestion(plain, known)));
}

constinit config::KeyTable const high_pass_table{.meaning = "Butterworth filter that removes long periods from records",
                                                 .keys = high_pass_keys.all};

RecordBaseline read_baseline(config::Table const& table) {
    if (!table.has("baseline")) {
        return {};
    }
    if (table.kind("baseline") != config::Kind::table) {
        auto const text = table.text(baseline_key);
        return table.located("baseline", [&] { return parse_baseline(text); });
    }
    auto const filter = table.child(baseline_key);
    RecordBaseline baseline{.method = BaselineMethod::high_pass};
    baseline.corner_hz = filter.number(high_pass_keys["high_pass"]);
    baseline.order = static_cast<int>(filter.integer(high_pass_keys["order"]));
    baseline.phase = filter.choice<FilterPhase>(high_pass_keys["phase"], filter_phases);
    filter.finish();
    return baseline;
}

void correct_record(GroundMotion& motion, RecordBaseline const& baseline) {
    if (baseline.method == BaselineMethod::none) {
        return;
    }
    bool const filtered = baseline.method == BaselineMethod::high_pass;
    check_order(baseline.order);
    constexpr double lowest_hz = 0.001;  // its pads are 6000 s long; no instrument holds a baseline longer
    validate(!filtered || baseline.corner_hz >= lowest_hz, "high-pass at {} Hz (must be at least {} Hz). Raise it",
             baseline.corner_hz, lowest_hz);
    validate(!filtered || 4 * baseline.corner_hz * motion.time_step_s < 1,
             "high-pass at {} Hz on a time step of {} s (must be below a quarter of the sampling frequency). Lower it",
             baseline.corner_hz, motion.time_step_s);
    validate(!filtered || baseline.corner_hz * motion.duration_s() >= 1,
             "high-pass at {} Hz of {:.4g} s (below {:.4g} Hz, 1 / duration, a record holds no whole period). Raise it",
             baseline.corner_hz, motion.duration_s(), 1 / motion.duration_s());
    for (auto* component : {&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2}) {
        if (component->empty()) {
            continue;
        }
        take_mean_off(*component);
        if (filtered) {
            high_pass(*component, motion.time_step_s, baseline);
        }
        if (baseline.method != BaselineMethod::mean) {
            take_polynomial_off(*component, motion.time_step_s);
        }
    }
}

std::string correct_and_tell(GroundMotion& motion, RecordBaseline const& baseline) {
    if (baseline.method == BaselineMethod::none) {
        return {};
    }
    auto const before = motion;
    correct_record(motion, baseline);
    return fmt::format("{} ({}{})", baseline.says(), changes_text(before, motion), sa_change_text(before, motion));
}

}  // namespace overturn

#include "spectra/window_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "spectra/fourier.hpp"
#include "spectra/wide.hpp"

namespace overturn {
namespace {

using LaneValues = std::array<double, wide::lanes>;

struct WindowTables {
    std::vector<double> cosine, sine;      // exp(-ixj) = cosine - i sine, j inside a block of one window, 16 lanes each
    std::vector<double> head_re, head_im;  // the window's part in the block before, seen from this block
    std::vector<double> past_re, past_im;  // the integral from the start to each sample of the last block
    std::vector<double> squares;           // weighted lanes of one block
    LaneValues hat_re, hat_im, whole, turn_re, turn_im, weight;
};

// Adds 16 nodes' share of V_WES^2 to `total`. A window that ends at place j of a block is the tail of the block before
// from j on and the head of this block up to j; both are plain sums.
struct WindowSweep {
    std::span<double const> samples;
    std::size_t window;
    bool running;
    WindowTables* tables;
    double* total;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        auto& t = *tables;
        constexpr auto lanes = wide::lanes;
        R hat_re, hat_im, whole, turn_re, turn_im, weight, base_re, base_im;
        R::load(hat_re, t.hat_re.data());
        R::load(hat_im, t.hat_im.data());
        R::load(whole, t.whole.data());
        R::load(turn_re, t.turn_re.data());
        R::load(turn_im, t.turn_im.data());
        R::load(weight, t.weight.data());
        // The first sample has only its right half hat: whole hat less the conjugate of `right`.
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            base_re.at[r] = -hat_re.at[r] * samples[0];
            base_im.at[r] = hat_im.at[r] * samples[0];
        }
        for (std::size_t j = 0; j < window; ++j) {
            R::store(t.head_re.data() + j * lanes, base_re);
            R::store(t.head_im.data() + j * lanes, base_im);
        }
        for (std::size_t begin = 0; begin < samples.size(); begin += window) {
            std::size_t const length = std::min(window, samples.size() - begin);
            R sum_re, sum_im;
            if (begin > 0) {
                R::clear(sum_re);
                R::clear(sum_im);
                for (std::size_t j = window; j-- > 0;) {
                    R c, s;
                    R::load(c, t.cosine.data() + j * lanes);
                    R::load(s, t.sine.data() + j * lanes);
                    double const a = samples[begin - window + j];
                    R head_re, head_im;
#pragma GCC unroll 8
                    for (int r = 0; r < R::count; ++r) {
                        auto const re = a * c.at[r];
                        auto const im = -a * s.at[r];
                        auto const f_re = hat_re.at[r] * re - hat_im.at[r] * im + whole.at[r] * sum_re.at[r];
                        auto const f_im = hat_re.at[r] * im + hat_im.at[r] * re + whole.at[r] * sum_im.at[r];
                        head_re.at[r] = turn_re.at[r] * f_re - turn_im.at[r] * f_im;
                        head_im.at[r] = turn_re.at[r] * f_im + turn_im.at[r] * f_re;
                        sum_re.at[r] = sum_re.at[r] + re;
                        sum_im.at[r] = sum_im.at[r] + im;
                    }
                    R::store(t.head_re.data() + j * lanes, head_re);
                    R::store(t.head_im.data() + j * lanes, head_im);
                }
            }
            R::clear(sum_re);
            R::clear(sum_im);
            for (std::size_t j = 0; j < length; ++j) {
                R c, s, head_re, head_im, past_re, past_im, square;
                R::load(c, t.cosine.data() + j * lanes);
                R::load(s, t.sine.data() + j * lanes);
                R::load(head_re, t.head_re.data() + j * lanes);
                R::load(head_im, t.head_im.data() + j * lanes);
                R::load(past_re, t.past_re.data() + j * lanes);
                R::load(past_im, t.past_im.data() + j * lanes);
                double const a = samples[begin + j];
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const re = a * c.at[r];
                    auto const im = -a * s.at[r];
                    auto const here_re = whole.at[r] * sum_re.at[r] + (hat_re.at[r] * re + hat_im.at[r] * im);
                    auto const here_im = whole.at[r] * sum_im.at[r] + (hat_re.at[r] * im - hat_im.at[r] * re);
                    auto const f_re = head_re.at[r] + here_re;
                    auto const f_im = head_im.at[r] + here_im;
                    square.at[r] = f_re * f_re + f_im * f_im;
                    if (running) {
                        auto const s_re = turn_re.at[r] * past_re.at[r] - turn_im.at[r] * past_im.at[r];
                        auto const s_im = turn_re.at[r] * past_im.at[r] + turn_im.at[r] * past_re.at[r];
                        square.at[r] = square.at[r] + 2.0 * (f_re * s_re + f_im * s_im);
                        past_re.at[r] = base_re.at[r] + here_re;
                        past_im.at[r] = base_im.at[r] + here_im;
                    }
                    square.at[r] = weight.at[r] * square.at[r];
                    sum_re.at[r] = sum_re.at[r] + re;
                    sum_im.at[r] = sum_im.at[r] + im;
                }
                R::store(t.past_re.data() + j * lanes, past_re);
                R::store(t.past_im.data() + j * lanes, past_im);
                R::store(t.squares.data() + j * lanes, square);
            }
#pragma GCC unroll 8
            for (int r = 0; r < R::count; ++r) {
                auto const re = base_re.at[r] + whole.at[r] * sum_re.at[r];
                auto const im = base_im.at[r] + whole.at[r] * sum_im.at[r];
                base_re.at[r] = turn_re.at[r] * re - turn_im.at[r] * im;
                base_im.at[r] = turn_re.at[r] * im + turn_im.at[r] * re;
            }
            for (std::size_t j = 0; j < length; ++j) {
                double sum = 0;
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    sum += t.squares[j * lanes + lane];
                }
                total[begin + j] += sum;
            }
        }
    }
};

void fill_tables(WindowTables& tables, std::span<double const> frequencies, std::span<double const> weights,
                 double time_step_s, std::size_t window) {
    for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
        double const x = frequencies[lane] * time_step_s;
        HatWeights const hat(x);
        tables.hat_re.at(lane) = hat.right.real();
        tables.hat_im.at(lane) = hat.right.imag();
        tables.whole.at(lane) = hat.whole;
        tables.turn_re.at(lane) = std::cos(x * static_cast<double>(window));
        tables.turn_im.at(lane) = std::sin(x * static_cast<double>(window));
        tables.weight.at(lane) = weights[lane] * time_step_s * time_step_s;
        for (std::size_t j = 0; j < window; ++j) {
            tables.cosine[j * wide::lanes + lane] = std::cos(x * static_cast<double>(j));
            tables.sine[j * wide::lanes + lane] = std::sin(x * static_cast<double>(j));
        }
    }
    std::fill(tables.past_re.begin(), tables.past_re.end(), 0.0);
    std::fill(tables.past_im.begin(), tables.past_im.end(), 0.0);
}

}  // namespace

std::vector<double> swept_window_squares(std::span<double const> acceleration_mps2, double time_step_s,
                                         std::size_t window, BandRule const& rule, WindowReading reading) {
    std::vector<double> squares(acceleration_mps2.size(), 0.0);
    std::vector<double> const lanes_of_block(window * wide::lanes, 0.0);
    WindowTables tables{lanes_of_block,
                        lanes_of_block,
                        lanes_of_block,
                        lanes_of_block,
                        lanes_of_block,
                        lanes_of_block,
                        lanes_of_block,
                        {},
                        {},
                        {},
                        {},
                        {},
                        {}};
    for (std::size_t begin = 0; begin < rule.weight.size(); begin += wide::lanes) {
        fill_tables(tables, std::span(rule.frequency_radps).subspan(begin), std::span(rule.weight).subspan(begin),
                    time_step_s, window);
        wide::dispatch(
            WindowSweep{acceleration_mps2, window, reading == WindowReading::running, &tables, squares.data()});
    }
    squares[0] = 0;  // a window of no length
    return squares;
}

}  // namespace overturn

#include "spectra/detail/window_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "spectra/detail/fourier.hpp"
#include "spectra/detail/window_nodes.hpp"

namespace overturn {
namespace {

void fill_nodes(WindowNodes& nodes, std::span<double const> frequencies, std::span<double const> weights,
                double time_step_s, std::size_t window) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
        double const x = frequencies[lane] * time_step_s;
        HatWeights const hat(x);
        nodes.hat_re.at(lane) = hat.right.real();
        nodes.hat_im.at(lane) = hat.right.imag();
        nodes.whole.at(lane) = hat.whole;
        nodes.turn_re.at(lane) = std::cos(x * static_cast<double>(window));
        nodes.turn_im.at(lane) = std::sin(x * static_cast<double>(window));
        nodes.weight.at(lane) = weights[lane] * time_step_s * time_step_s;
        for (std::size_t j = 0; j < window; ++j) {
            nodes.cosine[j * simd::sweep_lanes + lane] = std::cos(x * static_cast<double>(j));
            nodes.sine[j * simd::sweep_lanes + lane] = std::sin(x * static_cast<double>(j));
        }
    }
    std::fill(nodes.past_re.begin(), nodes.past_re.end(), 0.0);
    std::fill(nodes.past_im.begin(), nodes.past_im.end(), 0.0);
}

}  // namespace

std::vector<double> swept_window_squares(std::span<double const> acceleration_mps2, double time_step_s,
                                         std::size_t window, BandRule const& rule, WindowReading reading) {
    std::vector<double> squares(acceleration_mps2.size(), 0.0);
    std::vector<double> const lanes_of_block(window * simd::sweep_lanes, 0.0);
    WindowNodes nodes{.cosine = lanes_of_block,
                      .sine = lanes_of_block,
                      .head_re = lanes_of_block,
                      .head_im = lanes_of_block,
                      .past_re = lanes_of_block,
                      .past_im = lanes_of_block,
                      .squares = lanes_of_block};
    for (std::size_t begin = 0; begin < rule.weight.size(); begin += simd::sweep_lanes) {
        fill_nodes(nodes, std::span(rule.frequency_radps).subspan(begin), std::span(rule.weight).subspan(begin),
                   time_step_s, window);
        add_window_squares(acceleration_mps2, window, reading, nodes, squares);
    }
    squares[0] = 0;  // a window of no length
    return squares;
}

}  // namespace overturn

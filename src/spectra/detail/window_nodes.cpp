#include "spectra/detail/window_nodes.hpp"

#include <algorithm>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/window_nodes.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;

// Some lanes of the nodes, from `lane` on. A window that ends at place j of a block is the tail of the block before
// from j on and the head of this block up to j; both are plain sums.
template <class V> class WindowSums {
  public:
    WindowSums(std::span<double const> samples, std::size_t window, WindowNodes& nodes, std::size_t lane)
        : samples_(samples),
          window_(window),
          nodes_(nodes),
          lane_(lane),
          hat_re_(V::load(nodes.hat_re.data() + lane)),
          hat_im_(V::load(nodes.hat_im.data() + lane)),
          whole_(V::load(nodes.whole.data() + lane)),
          turn_re_(V::load(nodes.turn_re.data() + lane)),
          turn_im_(V::load(nodes.turn_im.data() + lane)) {}

    // The first sample has only its right half hat: whole hat less the conjugate of `right`.
    OVERTURN_LANES_INLINE void start() {
        V const re = -hat_re_ * samples_[0];
        V const im = hat_im_ * samples_[0];
        re.store(nodes_.base_re.data() + lane_);
        im.store(nodes_.base_im.data() + lane_);
        for (std::size_t j = 0; j < window_; ++j) {
            re.store(nodes_.head_re.data() + j * simd::sweep_lanes + lane_);
            im.store(nodes_.head_im.data() + j * simd::sweep_lanes + lane_);
        }
    }

    // The block before [begin, ...) from each place on.
    OVERTURN_LANES_INLINE void sum_heads(std::size_t begin) {
        Table<double const> const cosine{nodes_.cosine.data() + lane_};
        Table<double const> const sine{nodes_.sine.data() + lane_};
        Table<double> const head_re{nodes_.head_re.data() + lane_};
        Table<double> const head_im{nodes_.head_im.data() + lane_};
        V sum_re = 0;
        V sum_im = 0;
        for (std::size_t j = window_; j-- > 0;) {
            double const a = samples_[begin - window_ + j];
            V const re = a * cosine[j];
            V const im = -a * sine[j];
            V const f_re = hat_re_ * re - hat_im_ * im + whole_ * sum_re;
            V const f_im = hat_re_ * im + hat_im_ * re + whole_ * sum_im;
            head_re.set(j, turn_re_ * f_re - turn_im_ * f_im);
            head_im.set(j, turn_re_ * f_im + turn_im_ * f_re);
            sum_re = sum_re + re;
            sum_im = sum_im + im;
        }
    }

    // Fills the squares of the windows that end in the block.
    template <bool Running> OVERTURN_LANES_INLINE void sum_tails(std::size_t begin, std::size_t length) {
        Table<double const> const cosine{nodes_.cosine.data() + lane_};
        Table<double const> const sine{nodes_.sine.data() + lane_};
        Table<double const> const head_re{nodes_.head_re.data() + lane_};
        Table<double const> const head_im{nodes_.head_im.data() + lane_};
        Table<double> const past_re{nodes_.past_re.data() + lane_};
        Table<double> const past_im{nodes_.past_im.data() + lane_};
        Table<double> const squares{nodes_.squares.data() + lane_};
        V const weight = V::load(nodes_.weight.data() + lane_);
        V const base_re = V::load(nodes_.base_re.data() + lane_);
        V const base_im = V::load(nodes_.base_im.data() + lane_);
        V sum_re = 0;
        V sum_im = 0;
        for (std::size_t j = 0; j < length; ++j) {
            double const a = samples_[begin + j];
            V const re = a * cosine[j];
            V const im = -a * sine[j];
            V const here_re = whole_ * sum_re + (hat_re_ * re + hat_im_ * im);
            V const here_im = whole_ * sum_im + (hat_re_ * im - hat_im_ * re);
            V const f_re = head_re[j] + here_re;
            V const f_im = head_im[j] + here_im;
            V square = f_re * f_re + f_im * f_im;
            if constexpr (Running) {
                V const s_re = turn_re_ * past_re[j] - turn_im_ * past_im[j];
                V const s_im = turn_re_ * past_im[j] + turn_im_ * past_re[j];
                square = square + 2.0 * (f_re * s_re + f_im * s_im);
                past_re.set(j, base_re + here_re);
                past_im.set(j, base_im + here_im);
            }
            squares.set(j, weight * square);
            sum_re = sum_re + re;
            sum_im = sum_im + im;
        }
        V const re = base_re + whole_ * sum_re;
        V const im = base_im + whole_ * sum_im;
        (turn_re_ * re - turn_im_ * im).store(nodes_.base_re.data() + lane_);
        (turn_re_ * im + turn_im_ * re).store(nodes_.base_im.data() + lane_);
    }

  private:
    // These lanes of the nodes' places in a block.
    template <class Number> struct Table {
        Number* lanes;

        OVERTURN_LANES_INLINE V operator[](std::size_t j) const { return V::load(lanes + j * simd::sweep_lanes); }
        OVERTURN_LANES_INLINE void set(std::size_t j, V values) const { values.store(lanes + j * simd::sweep_lanes); }
    };

    std::span<double const> samples_;
    std::size_t window_;
    WindowNodes& nodes_;
    std::size_t lane_;
    V hat_re_, hat_im_, whole_, turn_re_, turn_im_;
};

void add_all(std::span<double const> samples, std::size_t window, bool running, WindowNodes& nodes,
             std::span<double> total) {
    for (std::size_t begin = 0; begin < samples.size(); begin += window) {
        std::size_t const length = std::min(window, samples.size() - begin);
        for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += SomeLanes::count) {
            WindowSums<SomeLanes> some(samples, window, nodes, lane);
            begin == 0 ? some.start() : some.sum_heads(begin);
            running ? some.sum_tails<true>(begin, length) : some.sum_tails<false>(begin, length);
        }
        for (std::size_t j = 0; j < length; ++j) {
            double sum = 0;
            for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
                sum += nodes.squares[j * simd::sweep_lanes + lane];
            }
            total[begin + j] += sum;
        }
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(add_all);

void add_window_squares(std::span<double const> samples, std::size_t window, WindowReading reading, WindowNodes& nodes,
                        std::span<double> total) {
    HWY_DYNAMIC_DISPATCH(add_all)(samples, window, reading == WindowReading::running, nodes, total);
}

}  // namespace overturn
#endif

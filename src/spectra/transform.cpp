#include "spectra/transform.hpp"

#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <string_view>

#include <fftw3.h>

#include "core/error.hpp"

// FFTW takes other codelets, and so other last bits, where the CPU has AVX and more. It asks these functions of its
// own; a program's own definitions come before a library's, so that SSE2's are taken everywhere: every x86-64 has them,
// and a campaign takes 3 % longer with them. The test portable/cpus holds the bits of whole files against that.
extern "C" {
int fftw_have_simd_avx() { return 0; }
int fftw_have_simd_avx2() { return 0; }
int fftw_have_simd_avx2_128() { return 0; }
int fftw_have_simd_avx_128_fma() { return 0; }
int fftw_have_simd_avx512() { return 0; }
}

namespace overturn {
namespace {

using Complex = std::complex<double>;

struct Freed {
    void operator()(void* p) const { fftw_free(p); }
};
template <class T> using Buffer = std::unique_ptr<T, Freed>;  // aligned for FFTW's vectors

template <class T> Buffer<T> buffer(std::size_t count) {
    Buffer<T> made(static_cast<T*>(fftw_malloc(count * sizeof(T))));
    if (!made) {
        throw std::bad_alloc();
    }
    return made;
}

// FFTW aborts, with pages of stack, where its planner gets no memory: so that much is asked for first, and given back.
void require_room(std::size_t length) {
    constexpr std::size_t each = 64;  // twiddles and buffers of a point
    constexpr std::size_t planner_takes = 4U << 20U;
    std::unique_ptr<char, Freed> const room(static_cast<char*>(fftw_malloc(planner_takes + each * length)));
    if (!room) {
        throw std::bad_alloc();
    }
}

fftw_complex* raw(Complex* p) { return reinterpret_cast<fftw_complex*>(p); }  // as the standard allows

// FFTW plans one thing at a time.
std::mutex& planner() {
    static std::mutex one;
    return one;
}

// An estimated plan depends on the length and on the library, not on what else the machine does.
struct Forward {
    using In = Complex;
    using Out = Complex;
    static std::size_t lines(std::size_t n) { return n; }
    static std::size_t outs(std::size_t n) { return n; }
    static fftw_plan plan(int n, Complex* in, Complex* out) {
        return fftw_plan_dft_1d(n, raw(in), raw(out), FFTW_FORWARD, FFTW_ESTIMATE);
    }
};
struct Backward : Forward {
    static fftw_plan plan(int n, Complex* in, Complex* out) {
        return fftw_plan_dft_1d(n, raw(in), raw(out), FFTW_BACKWARD, FFTW_ESTIMATE);
    }
};
struct Analysis {
    using In = double;
    using Out = Complex;
    static std::size_t lines(std::size_t n) { return n; }
    static std::size_t outs(std::size_t n) { return n / 2 + 1; }
    static fftw_plan plan(int n, double* in, Complex* out) {
        return fftw_plan_dft_r2c_1d(n, in, raw(out), FFTW_ESTIMATE);
    }
};
struct Synthesis {
    using In = Complex;
    using Out = double;
    static std::size_t lines(std::size_t n) { return n / 2 + 1; }
    static std::size_t outs(std::size_t n) { return n; }
    static fftw_plan plan(int n, Complex* in, double* out) {
        return fftw_plan_dft_c2r_1d(n, raw(in), out, FFTW_ESTIMATE);
    }
};

// A library that was linked so that it asks itself (statically, -Bsymbolic) takes AVX after all. A plan names its
// codelets with their instruction set, "n2fv_32_avx".
void require_sse2(fftw_plan plan) {
    std::unique_ptr<char, decltype(&std::free)> const text(fftw_sprint_plan(plan), &std::free);
    if (text && std::string_view(text.get()).find("avx") != std::string_view::npos) {
        throw SystemError(
            "FFTW takes AVX's codelets here and so gives other last bits than on other machines (a static or "
            "-Bsymbolic "
            "library?). Link Debian's libfftw3, or one that is built without --enable-avx");
    }
}

template <class Kind> class Plan {
  public:
    using In = typename Kind::In;
    using Out = typename Kind::Out;

    explicit Plan(std::size_t length)
        : length_(length), in_(buffer<In>(Kind::lines(length))), out_(buffer<Out>(Kind::outs(length))) {
        std::scoped_lock const alone(planner());
        require_room(length);
        plan_ = Kind::plan(static_cast<int>(length), in_.get(), out_.get());
        require_sse2(plan_);
    }
    Plan(Plan const&) = delete;
    Plan& operator=(Plan const&) = delete;
    Plan(Plan&&) = delete;
    Plan& operator=(Plan&&) = delete;
    ~Plan() {
        std::scoped_lock const alone(planner());
        fftw_destroy_plan(plan_);
    }
    [[nodiscard]] Transform<In, Out> transform() const {
        return {{in_.get(), Kind::lines(length_)}, {out_.get(), Kind::outs(length_)}, plan_};
    }

  private:
    std::size_t length_;
    Buffer<In> in_;
    Buffer<Out> out_;
    fftw_plan plan_;
};

template <class Kind> auto transform_of(std::size_t length) {
    OVERTURN_EXPECT(length >= 1 && length <= std::size_t{1} << 30U);
    thread_local std::map<std::size_t, Plan<Kind>> known;
    constexpr std::size_t most = 16;
    if (known.size() > most) {
        known.clear();
    }
    return known.try_emplace(length, length).first->second.transform();
}

}  // namespace

template <class In, class Out> void Transform<In, Out>::run() const { fftw_execute(static_cast<fftw_plan>(plan)); }
template struct Transform<Complex, Complex>;
template struct Transform<double, Complex>;
template struct Transform<Complex, double>;

ComplexTransform forward_transform(std::size_t length) { return transform_of<Forward>(length); }
ComplexTransform backward_transform(std::size_t length) { return transform_of<Backward>(length); }
RealAnalysis real_analysis(std::size_t length) { return transform_of<Analysis>(length); }
RealSynthesis real_synthesis(std::size_t length) { return transform_of<Synthesis>(length); }

}  // namespace overturn

#include "spectra/transform.hpp"

#include <cstddef>
#include <map>
#include <memory>

#include <gsl/gsl_fft_complex.h>
#include <gsl/gsl_fft_real.h>

namespace overturn {
namespace {

template <auto Free> struct Freed {
    template <class T> void operator()(T* p) const { Free(p); }
};

struct ComplexTables {
    std::unique_ptr<gsl_fft_complex_wavetable, Freed<gsl_fft_complex_wavetable_free>> factors;
    std::unique_ptr<gsl_fft_complex_workspace, Freed<gsl_fft_complex_workspace_free>> room;
    explicit ComplexTables(std::size_t n)
        : factors(gsl_fft_complex_wavetable_alloc(n)), room(gsl_fft_complex_workspace_alloc(n)) {}
};

struct RealTables {
    std::unique_ptr<gsl_fft_real_wavetable, Freed<gsl_fft_real_wavetable_free>> factors;
    std::unique_ptr<gsl_fft_real_workspace, Freed<gsl_fft_real_workspace_free>> room;
    explicit RealTables(std::size_t n)
        : factors(gsl_fft_real_wavetable_alloc(n)), room(gsl_fft_real_workspace_alloc(n)) {}
};

// A memory of what only the length decides; it changes no result. Making it anew takes longer than the transform.
template <class Tables> Tables const& tables_of(std::size_t n) {
    thread_local std::map<std::size_t, Tables> known;
    constexpr std::size_t most = 16;
    if (known.size() > most) {
        known.clear();
    }
    return known.try_emplace(n, n).first->second;
}

double* data(std::vector<std::complex<double>>& x) {
    return reinterpret_cast<double*>(x.data());  // as the standard allows
}

}  // namespace

void transform_forward(std::vector<std::complex<double>>& values) {
    auto const& tables = tables_of<ComplexTables>(values.size());
    gsl_fft_complex_forward(data(values), 1, values.size(), tables.factors.get(), tables.room.get());
}

void transform_backward(std::vector<std::complex<double>>& values) {
    auto const& tables = tables_of<ComplexTables>(values.size());
    gsl_fft_complex_backward(data(values), 1, values.size(), tables.factors.get(), tables.room.get());
}

void transform_real(std::vector<double>& values) {
    auto const& tables = tables_of<RealTables>(values.size());
    gsl_fft_real_transform(values.data(), 1, values.size(), tables.factors.get(), tables.room.get());
}

}  // namespace overturn

// Limit states of standard normals whose probabilities are known in closed form or by quadrature.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "rare/problem.hpp"

namespace overturn::testing {

/// Fails where value(normals) > limit / factor.
class LimitState : public rare::Problem {
  public:
    using Value = std::function<double(std::span<double const>)>;
    LimitState(std::size_t normals, double limit, Value value)
        : normals_(normals), limit_(limit), value_(std::move(value)) {}

    [[nodiscard]] std::size_t normals() const override { return normals_; }
    void respond(std::span<double const> x, std::span<double const> factors,
                 std::span<rare::Answer> answers) const override {
        double const value = value_(x);
        for (std::size_t f = 0; f < factors.size(); ++f) {
            answers[f] = {factors[f] * value / limit_ - 1, factors[f] * value > limit_, false};
        }
    }

  private:
    std::size_t normals_;
    double limit_;
    Value value_;
};

inline double sum_of(std::span<double const> x) {
    double sum = 0;
    for (double const one : x) {
        sum += one;
    }
    return sum;
}

inline double squares_of(std::span<double const> x) {
    double sum = 0;
    for (double const one : x) {
        sum += one * one;
    }
    return sum;
}

}  // namespace overturn::testing

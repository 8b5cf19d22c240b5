/// The answer of a rare problem at one factor.
#pragma once

#include <span>

#include "rare/problem.hpp"

namespace overturn::rare {

[[nodiscard]] inline Answer respond_at(Problem const& problem, std::span<double const> normals, double factor) {
    Answer answer;
    problem.respond(normals, {&factor, 1}, {&answer, 1});
    return answer;
}

}  // namespace overturn::rare

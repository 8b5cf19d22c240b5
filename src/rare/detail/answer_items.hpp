/// Many trials answered together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rare/problem.hpp"

namespace overturn::rare {

/// Draws items one by one and answers them side by side, at all factors: as many at once as fill vector lanes.
/// \param draw (i, normals) fills those of the i-th item \param take (i, answers) sees its answers, one a factor
template <class Draw, class Take>
void answer_items(Problem const& problem, std::size_t count, std::span<double const> factors, Draw const& draw,
                  Take const& take) {
    constexpr std::size_t most_at_once = 64;
    auto const each = problem.normals();
    std::vector<double> normals(std::min(count, most_at_once) * each);
    std::vector<Answer> answers(std::min(count, most_at_once) * factors.size());
    for (std::size_t first = 0; first < count; first += most_at_once) {
        auto const now = std::min(most_at_once, count - first);
        for (std::size_t i = 0; i < now; ++i) {
            draw(first + i, std::span(normals).subspan(i * each, each));
        }
        auto const given = std::span(answers).first(now * factors.size());
        problem.respond_each(std::span(normals).first(now * each), factors, given);
        for (std::size_t i = 0; i < now; ++i) {
            take(first + i, std::span<Answer const>(given).subspan(i * factors.size(), factors.size()));
        }
    }
}

/// Sets bit f of a row's `failed` and `undecided` by its answer at the f-th factor.
template <class Row> void set_bits(Row& row, std::span<Answer const> answers) {
    for (std::size_t f = 0; f < answers.size(); ++f) {
        row.failed |= static_cast<std::uint64_t>(answers[f].failed) << f;
        row.undecided |= static_cast<std::uint64_t>(answers[f].undecided && !answers[f].failed) << f;
    }
}

}  // namespace overturn::rare

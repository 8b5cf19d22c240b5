/// Answer of a trial, as ranks send it.
#pragma once

#include <cstdint>

#include "rare/problem.hpp"

namespace overturn::rare {

struct AnswerRow {
    double driver = 0;
    std::int64_t failed = 0, undecided = 0;  ///< 0 or 1; a failed one is decided
};

[[nodiscard]] inline AnswerRow row_of(Answer const& answer) {
    return {answer.driver, answer.failed ? 1 : 0, answer.undecided && !answer.failed ? 1 : 0};
}

}  // namespace overturn::rare

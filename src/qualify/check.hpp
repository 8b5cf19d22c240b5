/// One thing that an installation must show: a number found here, compared with a known one.
#pragma once

#include <string>
#include <vector>

namespace overturn::qualify {

/// What an expected value rests on.
enum class Basis {
    printed,       ///< a number, or a formula, that others printed
    solved_again,  ///< a published problem; its source was not at hand, or prints no number
    law            ///< a closed form, or a symmetry, that needs no source
};
[[nodiscard]] char const* name_of(Basis basis);

struct Check {
    std::string number;  ///< "M-03"; never given to another check
    std::string shows;   ///< statement that holds if it passes
    std::string source;  ///< whence the expected value: author and year, or the law
    std::string unit;    ///< of found and expected; "1" where they are pure numbers
    double found = 0, expected = 0;
    double tolerance = 0;     ///< largest |found - expected| that passes
    std::string remark = {};  ///< further facts for a reader
    /// Why a published number is another one than what is right; empty: it is to be met. No failure then.
    std::string differs_because = {};
    Basis basis = Basis::printed;

    [[nodiscard]] double error() const;
    /// Within the tolerance; false also where nothing finite was found.
    [[nodiscard]] bool agrees() const;
    [[nodiscard]] bool passed() const;
};

using Checks = std::vector<Check>;

/// A published result that is not among the checks, and why.
struct LeftOut {
    std::string result, source, reason;
};

/// A check whose tolerance is a share of what is expected.
[[nodiscard]] Check relative(std::string number, std::string shows, std::string source, std::string unit, double found,
                             double expected, double relative_tolerance, std::string remark = {});

}  // namespace overturn::qualify

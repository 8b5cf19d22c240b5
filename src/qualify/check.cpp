#include "qualify/check.hpp"

#include <cmath>
#include <utility>

namespace overturn::qualify {

char const* name_of(Basis basis) {
    switch (basis) {
        case Basis::printed:
            return "printed";
        case Basis::solved_again:
            return "solved again";
        case Basis::law:
            break;
    }
    return "law";
}

double Check::error() const { return std::abs(found - expected); }

bool Check::agrees() const { return error() <= tolerance; }

bool Check::passed() const { return agrees() || (!differs_because.empty() && std::isfinite(found)); }

Check relative(std::string number, std::string shows, std::string source, std::string unit, double found,
               double expected, double relative_tolerance, std::string remark) {
    return {std::move(number),
            std::move(shows),
            std::move(source),
            std::move(unit),
            found,
            expected,
            relative_tolerance * std::abs(expected),
            std::move(remark)};
}

}  // namespace overturn::qualify

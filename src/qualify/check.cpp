#include "qualify/check.hpp"

#include <cmath>

namespace overturn::qualify {

double Check::error() const { return std::abs(found - expected); }

bool Check::passed() const { return error() <= tolerance; }

}  // namespace overturn::qualify

#include "stats/stripe.hpp"

namespace overturn {

double Stripe::probability() const {
    return decided() == 0 ? 0 : static_cast<double>(overturned) / static_cast<double>(decided());
}

void Confusion::add(bool said_safe, bool overturned) {
    auto& cell = said_safe ? (overturned ? false_safe : true_safe) : (overturned ? true_overturn : false_alarm);
    ++cell;
}

}  // namespace overturn

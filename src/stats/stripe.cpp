#include "stats/stripe.hpp"

#include <limits>

namespace overturn {

double Stripe::probability() const {
    return decided() == 0 ? std::numeric_limits<double>::quiet_NaN()
                          : static_cast<double>(overturned) / static_cast<double>(decided());
}

Interval Stripe::interval(double confidence) const {
    return clopper_pearson_of_groups(overturned, overturned + trials - decided(), trials, group_size, confidence);
}

void Confusion::add(bool predicted_safe, bool overturned) {
    auto& cell = predicted_safe ? (overturned ? false_safe : true_safe) : (overturned ? true_overturn : false_alarm);
    ++cell;
}

}  // namespace overturn

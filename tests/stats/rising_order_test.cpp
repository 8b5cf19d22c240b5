// Requirement R-712: millions of trials are put in order as a plain sort puts them.
#include "stats/detail/rising_order.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"

namespace overturn {
namespace {

// So many numbers, spread as `of` makes them from numbers in [0, 1).
template <class Of> std::vector<double> numbers(std::size_t count, Of const& of) {
    RandomStream stream(1, count, Purpose::body_scatter, 0);
    std::vector<double> list(count);
    std::ranges::generate(list, [&] { return of(gsl_rng_uniform(stream.gsl())); });
    return list;
}

TEST(RisingOrder, IsThatOfAPlainSort) {
    std::vector<std::function<double(double)>> const spreads{[](double u) { return u; },
                                                             [](double u) { return std::log(u + 1e-9); },
                                                             [](double u) { return std::floor(5 * u); },
                                                             [](double u) { return u < 0.001 ? 1e9 : u; },
                                                             [](double u) { return u < 0.5 ? -1e300 : 1e-300 * u; },
                                                             [](double) { return 3.0; }};
    for (auto const& spread : spreads) {
        for (std::size_t const count : {0, 1, 2, 1000, 1023, 1024, 50'000}) {
            auto sorted = numbers(count, spread);
            auto plain = sorted;
            sort_rising(sorted, std::identity());
            std::ranges::sort(plain);
            EXPECT_EQ(sorted, plain);
        }
    }
}

TEST(RisingOrder, KeepsWhatBelongsToANumber) {
    struct Item {
        double value = 0;
        double twice = 0;
    };
    std::vector<Item> items;
    for (double const value : numbers(20'000, [](double u) { return u * u; })) {
        items.push_back({value, 2 * value});
    }
    sort_rising(items, &Item::value);
    EXPECT_TRUE(std::ranges::is_sorted(items, {}, &Item::value));
    EXPECT_TRUE(std::ranges::all_of(items, [](Item const& item) { return item.twice == 2 * item.value; }));
}

}  // namespace
}  // namespace overturn

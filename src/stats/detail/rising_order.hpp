/// Sorting of millions of numbers that are spread over a range, in a few passes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <vector>

namespace overturn {

/// Sorts by `value` of each item, a finite double; items of one value come in any order. Items go into buckets of equal
/// width, and each bucket is sorted.
template <class Item, class Value> void sort_rising(std::vector<Item>& items, Value value) {
    constexpr std::size_t few = 1 << 10;
    constexpr std::size_t in_a_bucket = 8;
    auto const number = [&](Item const& item) { return std::invoke(value, item); };
    if (items.size() < few) {
        std::ranges::sort(items, {}, value);
        return;
    }
    auto const [least, most] = std::ranges::minmax_element(items, {}, value);
    double const low = number(*least);
    double const width = number(*most) - low;
    std::size_t const buckets = items.size() / in_a_bucket;
    double const scale = width > 0 ? static_cast<double>(buckets - 1) / width : 0;
    auto const bucket_of = [&](Item const& item) { return static_cast<std::size_t>((number(item) - low) * scale); };
    std::vector<std::size_t> ends(buckets + 1);
    for (auto const& item : items) {
        ++ends[bucket_of(item) + 1];
    }
    for (std::size_t b = 0; b < buckets; ++b) {
        ends[b + 1] += ends[b];
    }
    std::vector<Item> placed(items.size());
    for (auto const& item : items) {
        placed[ends[bucket_of(item)]++] = item;  // each begin moves on to its end
    }
    std::size_t begin = 0;
    for (std::size_t b = 0; b < buckets; ++b) {
        std::ranges::sort(placed.begin() + static_cast<std::ptrdiff_t>(begin),
                          placed.begin() + static_cast<std::ptrdiff_t>(ends[b]), {}, value);
        begin = ends[b];
    }
    items.swap(placed);
}

}  // namespace overturn

#include "response/accuracy.hpp"

#include <algorithm>
#include <array>

#include <fmt/ranges.h>

#include "config/registry.hpp"

namespace overturn {
namespace {

// Constants of campaigns, which files of results of before may state otherwise.
void read_withdrawn(config::Table const& table, RockingAccuracy& a) {
    if (table.has("taylor_order")) {
        auto const order = table.integer("taylor_order", 1, 99);
        if (std::ranges::find(taylor_orders, order) == taylor_orders.end()) {
            table.fail("taylor_order", fmt::format("{} (not offered). Use {}", order, fmt::join(taylor_orders, ", ")));
        }
        a.taylor_order = static_cast<int>(order);
    }
    if (table.has("substeps")) {
        constexpr int most_substeps = 1000;
        a.substeps = static_cast<int>(table.integer("substeps", 1, most_substeps));
    }
    if (table.has("step_tolerance")) {
        a.step_tolerance = table.number("step_tolerance", Dimension::none, {.low = 1e-16, .high = 1e-3});
    }
    if (table.has("settle")) {
        a.settle = table.number("settle", Dimension::none, {.low = 0, .high = 1e-2, .low_open = true});
    }
}

RockingAccuracy read_rocking(config::Table const& table) {
    RockingAccuracy a;
    read_withdrawn(table, a);
    static constexpr std::array restorings{
        config::Entry<Restoring>{"nonlinear", "the block as it is", Restoring::nonlinear},
        config::Entry<Restoring>{"linear", "for the closed forms of the literature", Restoring::linear}};
    a.restoring = table.choice<Restoring>("restoring", restorings, a.restoring);
    return a;
}

ContactAccuracy read_contact(config::Table const& table) {
    ContactAccuracy a;
    a.step_ratio = table.number("contact_step", Dimension::none, {.low = 1e-4, .high = 1}, a.step_ratio);
    return a;
}

}  // namespace

Accuracy read_accuracy(config::Table const& table) {
    return {.rocking = read_rocking(table), .contact = read_contact(table)};
}

}  // namespace overturn

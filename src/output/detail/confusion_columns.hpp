/// Columns on how a criterion did against time histories.
#pragma once

#include "output/table.hpp"
#include "stats/criterion.hpp"

namespace overturn::output {

/// The decided trials by prediction and outcome. `get(row)` is a Confusion.
template <class Row, class Get> void add_confusion(TableOf<Row>& table, Get get) {
    auto const of = [get](std::int64_t Confusion::*member) {
        return [get, member](Row const& row) { return get(row).*member; };
    };
    table.add("false_safe", "1", "predicted safe, overturned", of(&Confusion::false_safe))
        .add("false_alarm", "1", "predicted unsafe, did not overturn", of(&Confusion::false_alarm))
        .add("true_safe", "1", "predicted safe, did not overturn", of(&Confusion::true_safe))
        .add("true_overturn", "1", "predicted unsafe, overturned", of(&Confusion::true_overturn));
}

}  // namespace overturn::output

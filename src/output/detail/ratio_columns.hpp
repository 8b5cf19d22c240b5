/// Columns of shares and of quantiles of a ratio.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "output/table.hpp"
#include "stats/criterion.hpp"

namespace overturn::output {

/// A share with its exact interval: name, name_lower, name_upper, name_count, name_of. `get(row)` is a Share.
template <class Row, class Get>
void add_share(TableOf<Row>& table, std::string const& name, std::string const& meaning, Get get) {
    auto const any = [get](auto of) {
        return [get, of](Row const& row) {
            auto const& share = get(row);
            bool const known =
                share.of > 0 && !std::isnan(share.interval.lower);  // else counts of waves that are no sample
            return known ? std::optional(of(share)) : std::nullopt;
        };
    };
    table.add(name, "1", meaning, any([](Share const& share) { return share.value(); }))
        .add(name, "1", "it, exact", any([](Share const& share) { return share.interval; }))
        .add(name + "_count", "1", "count of " + name, [get](Row const& row) { return get(row).count; })
        .add(name + "_of", "1", "number of trials or waves that it is a share of",
             [get](Row const& row) { return get(row).of; });
}

/// "0.93"; "not known" of too few values. \param form 'g', or 'f' in a table, where "-" stands for it
[[nodiscard]] inline std::string percentile_text(double value, char form = 'g') {
    bool const in_table = form == 'f';
    return std::isnan(value) ? in_table ? "-" : "not known"
           : in_table        ? fmt::format("{:.3f}", value)
                             : fmt::format("{:.3g}", value);
}

/// Percentiles of a ratio: name_count, name_lowest, name_p05 to name_p95, name_highest. `get(row)` is a RatioQuantiles
/// or none.
template <class Row, class Get>
void add_percentiles(TableOf<Row>& table, std::string const& name, std::string const& meaning, Get get) {
    table.add(name + "_count", "1", "number of " + meaning, [get](Row const& row) {
        std::optional<RatioQuantiles> const& q = get(row);
        return q ? q->count : 0;
    });
    auto const one = [&](char const* suffix, std::string const& what, double RatioQuantiles::*member) {
        table.add(name + suffix, "1", what + meaning, [get, member](Row const& row) {
            std::optional<RatioQuantiles> const& q = get(row);
            return q ? std::optional((*q).*member) : std::nullopt;
        });
    };
    using Q = RatioQuantiles;
    one("_lowest", "lowest value of ", &Q::lowest);
    one("_p05", "5th percentile of ", &Q::p05);
    one("_p25", "25th percentile of ", &Q::p25);
    one("_median", "median of ", &Q::median);
    one("_p75", "75th percentile of ", &Q::p75);
    one("_p95", "95th percentile of ", &Q::p95);
    one("_highest", "highest value of ", &Q::highest);
}

}  // namespace overturn::output

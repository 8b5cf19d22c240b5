#include "store/format_versions.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "store/results_file.hpp"

namespace overturn::store {
namespace {

/// An error whose last files are of a version: whoever mends one that touched results adds a line, and gives the format
/// its next number if the version does not distinguish the files.
struct KnownError {
    std::int64_t last_version;
    char const* text;
};

constexpr std::array known_errors{
    KnownError{
        1, "impacts of early files lie up to 8 % of a step away where the forcing changes fast (mended in bb5d42d)"},
    KnownError{1, "contact of early files may be lost up to 2 ms late in samples of 0.05 s (mended in a8b8acc)"},
    KnownError{
        3,
        "hclpf of files without a drawn beta_u is the 5 % point of one curve; that of drawn bodies has intervals "
        "that leave the split out; curves leave undecided trials out"},
    KnownError{1, "intervals of the earliest files leave undecided trials out (mended in 0f4925a)"},
};

/// Columns that came after the oldest format: whoever adds one adds its name here.
struct Came {
    std::int64_t version;
    std::string_view group;         ///< with all that lies in it
    std::string_view columns = {};  ///< parted by blanks; none: all of it
};

constexpr std::array came{
    Came{4, "fragility/<body>",
         "five_percent_point five_percent_point_lower five_percent_point_upper median_at_05 median_at_50 median_at_95 "
         "one_percent_point stripe_p_value"},
    Came{4, "rare/<body>/subset-<n>", "acceptance levels thresholds"},
    Came{4, "waves",
         "epsilon_between_0.1s epsilon_between_0.2s epsilon_between_0.5s epsilon_between_10s epsilon_between_1s "
         "epsilon_between_2s epsilon_between_3s epsilon_between_4s epsilon_between_5s epsilon_within_0.1s "
         "epsilon_within_0.2s epsilon_within_0.5s epsilon_within_10s epsilon_within_1s epsilon_within_2s "
         "epsilon_within_3s epsilon_within_4s epsilon_within_5s"},
    Came{5, "bodies/<body>", "name"},
    Came{5, "criterion"},
    Came{5, "criterion_by_level"},
    Came{5, "fragility/<body>",
         "beta_u_drawn bootstrap_five_percent_point_lower bootstrap_five_percent_point_upper bootstrap_hclpf_lower "
         "bootstrap_hclpf_upper bound_exceeded bound_from bound_lower bound_overturned bound_to bound_trials "
         "bound_upper degrees_of_freedom depends_on_levels exceeded label lowest_proportion overturned pooled_exceeded "
         "pooled_from pooled_lower pooled_overturned pooled_to pooled_trials pooled_upper "
         "profile_five_percent_point_lower profile_five_percent_point_upper profile_hclpf_lower profile_hclpf_upper "
         "rank_area_lower rank_area_upper replicates replicates_without_curve title trials undecided units waves"},
    Came{5, "grid/<body>", "period"},
    Came{5, "grid_by_level"},
    Came{5, "isotonic"},
    Came{5, "limit_states"},
    Came{5, "limits/<limit>/stripes/<body>", "level"},
    Came{5, "models"},
    Came{5, "pairs"},
    Came{5, "probabilities"},
    Came{5, "quantiles"},
    Came{5, "rare/<body>", "reason tried"},
    Came{5, "rare_health"},
    Came{5, "rare_replicates"},
    Came{5, "response"},
    Came{5, "sigma"},
    Came{5, "stripes/<body>", "fell_after_record level peaked_after_record slid_and_rocked undecided"},
    Came{5, "together"},
    Came{5, "trials",
         "edge_margin landing_energy landing_spin landing_top_velocity landing_velocity least_clearance "
         "standardised_cav"},
    Came{5, "trials/contact", "edge_x_least edge_x_most peak_top residual_x rotation_least rotation_most"},
    Came{5, "trials/rocking"},
    Came{5, "trials/sliding"},
    Came{5, "trials/spatial",
         "edge_x_least edge_x_most edge_y_least edge_y_most landing_azimuth peak_top residual_x residual_y"},
    Came{5, "waves", "cav standardised_cav"},
};

bool names(Came const& row, std::string_view group, std::string_view column) {
    if (row.columns.empty()) {
        return group == row.group || group.starts_with(std::string(row.group) + "/");
    }
    auto const list = fmt::format(" {} ", row.columns);
    return group == row.group && list.find(fmt::format(" {} ", column)) != std::string::npos;
}

}  // namespace

std::int64_t first_format_of(std::string_view group, std::string_view column) {
    // Tables of limit states have the columns of those of overturning, but for their stripes, which are older.
    constexpr std::string_view of_limit = "limits/<limit>/";
    if (group.starts_with(of_limit) && !group.starts_with("limits/<limit>/stripes/")) {
        group.remove_prefix(of_limit.size());
    }
    auto const* const row = std::ranges::find_if(came, [&](Came const& one) { return names(one, group, column); });
    return row == came.end() ? oldest_format_read : row->version;
}

std::string known_errors_of(std::int64_t version) {
    std::string text;
    for (auto const& error : known_errors) {
        if (version <= error.last_version) {
            text += fmt::format("{}{}", text.empty() ? " Known of its version: " : "; ", error.text);
        }
    }
    return text;
}

}  // namespace overturn::store

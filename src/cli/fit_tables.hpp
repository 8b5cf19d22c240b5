/// Fits that need no results file: stripes of anybody's own, and a stated curve.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/text_choice.hpp"
#include "cli/verbs.hpp"
#include "output/json.hpp"
#include "output/table.hpp"
#include "results/curves.hpp"
#include "results/hazard_frequency.hpp"
#include "stats/hazard.hpp"

namespace overturn::cli {

/// Options of `fit`.
struct FitOptions {
    std::string file;
    std::string stripes;
    std::optional<std::int64_t> waves;  ///< of stripes: so many different ones
    std::string capacities;
    bool json = false;
    bool interim = false;              ///< of a run that is not complete
    std::optional<double> beta_u;      ///< none: the campaign's, or none
    std::optional<double> confidence;  ///< none: the campaign's, or 0.95
    std::string design_basis;          ///< of stripes, in their unit or with its own
    std::string median;                ///< of a stated curve, with its unit
    std::optional<double> beta;        ///< of it
    TextChoice text;
    std::string hazard;
    std::string measures;
    Unverified unverified;
};

/// Intensities of a table: its column's name, the measure and unit that it states, and the range of the trials.
struct TableAxis {
    std::string option;              ///< "--stripes", for messages
    std::string column;              ///< "pga [g]"
    std::string measure;             ///< "pga"; empty: none is named
    std::string unit;                ///< "g"; empty: none
    double lowest = 0, highest = 0;  ///< in that unit
};
/// The hazard curve that --hazard names, its intensities in the table's unit. \throws InputError also where the table
/// states no unit, or sa without its period
[[nodiscard]] HazardCurve hazard_of_table(FitOptions const& options, TableAxis const& axis);

/// Annual frequencies of a table's or a stated curve; none without a hazard curve.
struct TableFrequency {
    std::optional<HazardCurve> hazard = {};
    std::vector<BodyFrequency> of = {};

    TableFrequency() = default;
    /// \param name of the curve
    TableFrequency(HazardCurve curve, BodyFrequency frequency, std::string name);
    [[nodiscard]] std::string text(double confidence) const;
    /// Adds its tables and notes. \param unit of the intensities
    void add_to(output::Json& json, std::string const& unit, double confidence) const;
};

/// A curve fitted to a table, and what is printed beside it.
struct TableFit {
    TableAxis axis;
    MeasuredFragility measured = {};  ///< name, fit and what belongs to it; the rest follows from the axis
    FragilityData data = {};          ///< of the trials, for annual frequencies
    std::vector<std::string> unread = {};
    std::string above = {}, remark = {}, below = {};  ///< the curve; the remark stands below its table
    std::vector<output::Table> tables = {};           ///< in JSON, before those of the curve
    output::Json json = {};                           ///< further members
};

/// Confidence and beta_U of a fit to a table.
[[nodiscard]] FragilityRequest request_of(FitOptions const& options);
/// "g"; "1": none is stated.
[[nodiscard]] std::string unit_of(TableAxis const& axis);
/// Prints it, with annual frequencies where --hazard names a hazard curve. \return exit code
[[nodiscard]] int print_fit(FitOptions const& options, FragilityRequest const& request, TableFit fit);

/// "0.9 g" parted.
struct StatedNumber {
    double value = 0;
    std::string_view unit;  ///< empty: none is stated
};
/// \param option "--median" \param what a number it must be, and an example, for the message
/// \throws InputError unless it begins with a number above 0
[[nodiscard]] StatedNumber stated_number(std::string_view text, std::string_view option, std::string_view what);

/// `fit --stripes TABLE`: curve, and annual frequency where there is a hazard curve. \return exit code
[[nodiscard]] int fit_stripes(FitOptions const& options);

/// `fit --capacities TABLE`: intensities at which each wave's body fell. \return exit code
[[nodiscard]] int fit_capacities(FitOptions const& options);

/// `fit --median M --beta B`: the points of a stated curve, and its annual frequency. \return exit code
[[nodiscard]] int fit_stated(FitOptions const& options);

}  // namespace overturn::cli

/// TextStatements of a file's text about its numbers: prose above them, comments. Each line is used, contradicts what
/// the user states, or is listed as not understood.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/component_name.hpp"
#include "motion/record.hpp"
#include "motion/text_table.hpp"

namespace overturn {

class TextStatements {
  public:
    /// TextStatements about accelerations, or about a table's column of another dimension: an acceleration, a velocity
    /// or a length.
    explicit TextStatements(Dimension of = Dimension::acceleration) : of_(of) {}

    /// Looks for units ("in m/s/s", "(gal)", "units: g"), quantities ("velocity in cm/s", "M/S", "counts"), the time
    /// step or rate, the count, the peak and the components ("COMP. EW"). A unit in a line on a peak, a trigger or a
    /// filter is of that alone. What is stated twice, differently, is not used.
    void take(std::string_view line, int number);
    /// All lines above, between and below the numbers, but that of the names.
    void take(std::span<TextLine const> lines, int names_line);

    /// SI value of one unit of the numbers.
    [[nodiscard]] std::optional<double> unit() const { return unit_.value; }
    [[nodiscard]] int unit_line() const { return unit_.line; }
    /// "line 3 names gal among other words": why a unit is none of the numbers; empty if no line names one so.
    [[nodiscard]] std::string const& doubt() const { return doubt_; }
    /// [s]
    [[nodiscard]] std::optional<double> time_step_s() const { return step_.value; }
    /// SI value of one unit of the times.
    [[nodiscard]] std::optional<double> time_unit_s() const { return time_unit_.value; }
    [[nodiscard]] int time_unit_line() const { return time_unit_.line; }
    /// Another quantity that the text calls the numbers, "velocities"; empty if none.
    [[nodiscard]] std::string const& other() const { return other_; }
    /// Are the numbers called accelerations anywhere?
    [[nodiscard]] bool accelerations() const { return accelerations_; }
    /// Other columns of the table are counts, "collapse counts at each level": they are none of the numbers.
    void expect_counts() { beside_counts_ = true; }
    /// The line is a title that ends in the unit, as other programs write above a count and a step.
    void expect_title(int number) { title_ = number; }
    /// A name of a column calls them so. \param alone is no other column one of a motion, or of a spectrum?
    void take_named_accelerations(bool alone) {
        accelerations_ = named_ = true;
        alone_ = alone;
    }
    [[nodiscard]] std::vector<std::string> const& components() const { return components_; }
    /// Is a peak stated, for check_peaks?
    [[nodiscard]] bool states_peak() const { return !peaks_.empty(); }
    [[nodiscard]] int components_line() const { return components_line_; }
    /// Components of all lines that state some, "Channel 3: UD" among them, with the line of each.
    [[nodiscard]] std::vector<std::pair<std::string, int>> const& all_components() const { return all_components_; }

    /// "line 10: m/s2", for each statement that is used.
    [[nodiscard]] std::vector<std::string> used() const;
    /// "line 3: 'Station X'", for each line that states nothing known, and each in which a word that may change what
    /// the numbers are ("vertical", "scaled by", "velocity") leads to no statement. The latter come first.
    [[nodiscard]] std::vector<std::string> unread() const;
    /// The latter alone.
    [[nodiscard]] std::vector<std::string> const& telling() const { return telling_; }
    /// The line that calls numbers something else which their names, or the unit of another line, say are
    /// accelerations; empty: none.
    [[nodiscard]] std::string beside_names() const { return named_ || unit_.value ? other_text_ : std::string(); }

    /// The unit of numbers whose names say `named` and whose user says `stated`; nothing if neither these nor the text
    /// say one. \param names where these stand \param advice where the stated unit contradicts the file
    /// \throws InputError at the line that contradicts another, or what is stated
    [[nodiscard]] std::optional<double> unit_beside(std::optional<double> named, std::optional<double> stated,
                                                    Location const& names,
                                                    std::string_view advice = "Leave the stated unit out") const;
    /// \throws InputError if what the request states contradicts what the text states, or the numbers are no
    /// accelerations
    void check(RecordRequest const& request) const;
    /// For numbers of one column among others. \throws InputError if the text states a unit of another quantity
    void check_unit_of(std::string_view column, std::string const& file) const;
    /// For numbers whose names state no unit. \throws InputError if the text states one that is not known: "g/10"
    void check_unit_is_known(std::string const& file) const;
    /// For numbers whose component neither a name nor the user states. \throws InputError if a line holds a word of the
    /// vertical and none of a horizontal component, and no line states the component
    void check_no_vertical(std::string const& file, std::string_view advice) const;
    /// \throws InputError if times that rise by `step_s` contradict what the text states
    void check_times(double step_s, std::string const& file) const;
    /// \throws InputError unless one of these counts of values is the one that the text states, if it states one
    void check_count(std::span<std::size_t const> counts, std::string const& file) const;
    /// \param whole are these the peaks of all columns of the file? \throws InputError if the text states a peak that
    /// the peaks meet only in another unit, 100 or 981 times as much; or, of the whole file, not at all \return the
    /// lines whose peak is none of these, where that may be another's
    [[nodiscard]] std::vector<std::string> check_peaks(std::span<double const> peaks_mps2, double unit_mps2,
                                                       std::string const& file, bool whole) const;

  private:
    struct Statement {
        std::optional<double> value;
        int line = 0;
        bool contradicted = false;
        void take(double stated, int number);
    };
    struct Peak {
        double value = 0;
        std::optional<double> unit;
        int line = 0;
        double digit = 0;
        std::vector<double> beside;  ///< of other components
        bool rough = false, other = false;
        [[nodiscard]] bool is_met_by(double found, double unit_of_numbers) const;
    };
    /// Name of a quantity other than the numbers' own; empty if it is their own, or none.
    [[nodiscard]] std::string_view other_than_own(Quantity quantity) const;
    [[nodiscard]] bool take_unit(std::string const& lower, int number);
    [[nodiscard]] bool take_other_quantity(std::string_view line, std::string const& lower, int number);
    [[nodiscard]] bool take_components(std::string_view line, std::string const& lower, int number);
    [[nodiscard]] bool a_part_has_other_unit(std::string_view line) const;
    [[nodiscard]] bool leaves_a_part(std::string const& lower) const;
    [[nodiscard]] bool tells_more(std::string const& lower, bool component, bool quantity, bool step) const;

    Dimension of_;
    Statement unit_, step_, count_, time_unit_;
    std::vector<Peak> peaks_;
    int vertical_line_ = 0;  ///< that may say so of the numbers; 0: none
    int title_ = 0;          ///< its line; 0: none
    std::string vertical_text_;
    std::string doubt_;
    std::string unknown_unit_;
    int unknown_unit_line_ = 0;
    int other_line_ = 0;  ///< that calls the numbers velocities, displacements or counts; 0: none
    std::string other_;
    bool other_of_several_ = false;  ///< in a line that names such a quantity, perhaps beside accelerations
    bool doubted_ = false;           ///< is a unit of the line at hand among other words?
    bool other_unit_ = false;        ///< as that line's unit says, and it is not on where or when
    std::string other_text_;
    std::string plainly_other_;  ///< as a line of known words alone calls the numbers, without "accelerations"
    int plainly_other_line_ = 0;
    bool spectrum_ = false;  ///< of accelerations: the unit does not show it
    bool named_ = false, alone_ = false;
    bool beside_counts_ = false;
    bool accelerations_ = false;
    std::vector<std::string> components_;
    int components_line_ = 0;
    std::vector<std::pair<std::string, int>> all_components_;
    std::vector<std::string> telling_, unread_;
};

/// For one line of a message: " (not understood: line 3: 'x'; line 5: 'y')"; empty if there is no such line.
[[nodiscard]] std::string not_understood(std::span<std::string const> lines);

}  // namespace overturn

#include "cli/stripe_columns.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "motion/cell_rows.hpp"
#include "motion/text_lines.hpp"

namespace overturn::cli {
namespace {

using enum StripeField;

struct Alias {
    std::string_view name;
    StripeField field;
};
// Of other programs and papers, as counted_things has them; "n_gms" as well as "gms".
constexpr auto aliases = std::to_array<Alias>({{"trial", trials},
                                               {"n", trials},
                                               {"gm", trials},
                                               {"groundmotion", trials},
                                               {"motion", trials},
                                               {"record", trials},
                                               {"wave", trials},
                                               {"analyse", trials},
                                               {"test", trials},
                                               {"total", trials},
                                               {"overturned", overturned},
                                               {"overturning", overturned},
                                               {"collapse", overturned},
                                               {"collapsed", overturned},
                                               {"coll", overturned},
                                               {"failure", overturned},
                                               {"fell", overturned},
                                               {"k", overturned},
                                               {"collapsecount", overturned},
                                               {"collapsescount", overturned},
                                               {"overturningcount", overturned},
                                               {"overturnedcount", overturned},
                                               {"countofcollapse", overturned},
                                               {"failed", failed}});

class TrialsColumn {
  public:
    TrialsColumn(std::string const& text, std::string const& file) {
        CellRows rows(text, file, "");
        place(rows.header());
        if (!trials_ || !overturned_ || !amplitude_) {
            return;
        }
        while (auto const cells = rows.next()) {
            take(*cells);
        }
    }
    [[nodiscard]] TrialsHeld held() const {
        if (!trials_ || !overturned_ || !amplitude_ || !verdicts_ || rows_ < 2) {
            return TrialsHeld::counts;
        }
        bool const numbered = counts_rows_ || is_permutation();
        bool const all_differ = values_.size() == rows_;
        if (!numbers_ || amplitudes_.size() < rows_ || numbered || (singular_ && all_differ)) {
            return singular_ ? TrialsHeld::labels : numbered ? TrialsHeld::either : TrialsHeld::counts;
        }
        return singular_ && values_.size() > 1 ? TrialsHeld::either : TrialsHeld::counts;
    }

  private:
    /// Of 1, 2, 3, ...
    [[nodiscard]] bool is_permutation() const {
        return values_.size() == rows_ && *values_.begin() == 1 && *values_.rbegin() == static_cast<double>(rows_);
    }
    void place(std::vector<Cell> const& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            auto const field = stripe_field_of(named_column(cells[i].text));
            if (field == trials) {
                trials_ = i;
                singular_ = may_name_trials(cells[i].text);
            } else if (field == overturned) {
                overturned_ = i;
            } else if (field == amplitude) {
                amplitude_ = i;
            }
        }
    }
    void take(std::vector<Cell> const& cells) {
        double number = 0;
        bool const read = parse_number(cells[*trials_].text, number);
        numbers_ = numbers_ && read;
        bool const from_0 = read && number == static_cast<double>(rows_);
        bool const from_1 = read && number == static_cast<double>(rows_ + 1);
        counts_rows_ = counts_rows_ && (from_0 || from_1);
        values_.insert(number);
        verdicts_ = verdicts_ && CellRows::yes_or_no(cells[*overturned_]).has_value();
        amplitudes_.emplace(cells[*amplitude_].text);
        ++rows_;
    }

    std::optional<std::size_t> trials_, overturned_, amplitude_;
    bool singular_ = false, numbers_ = true, counts_rows_ = true, verdicts_ = true;
    std::size_t rows_ = 0;
    std::set<std::string> amplitudes_;
    std::set<double> values_;
};

}  // namespace

bool may_name_trials(std::string_view cell) {
    auto const lower = lowered(trimmed(named_column(cell).bare));
    constexpr auto singular = std::to_array<std::string_view>(
        {"trial", "gm", "ground motion", "ground_motion", "motion", "record", "wave", "analysis", "test"});
    return std::ranges::find(singular, lower) != singular.end();
}

std::optional<StripeField> stripe_field_of(NamedColumn const& column) {
    if (column.is_intensity()) {
        return amplitude;
    }
    auto plain = counted_things(column.bare);
    auto const find = [&] { return std::ranges::find(aliases, std::string_view(plain), &Alias::name); };
    auto const* alias = find();
    if (alias == aliases.end() && plain.starts_with('n') && plain.size() > 1) {
        plain.erase(0, 1);
        alias = find();
    }
    return alias == aliases.end() ? std::nullopt : std::optional(alias->field);
}

TrialsHeld trials_held(std::string const& text, std::string const& file) { return TrialsColumn(text, file).held(); }

}  // namespace overturn::cli

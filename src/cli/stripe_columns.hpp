/// Columns of a table of stripes by their names; where a name has two meanings, by all rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/named_column.hpp"

namespace overturn::cli {

enum class StripeField : std::uint8_t { amplitude, trials, overturned, failed };
inline constexpr std::size_t stripe_fields = 4;

/// The field that a column's name is a word for.
[[nodiscard]] std::optional<StripeField> stripe_field_of(NamedColumn const& column);

/// "wave", "record", "GM": the name of one, where "waves" and "n_gms" are a number of them.
[[nodiscard]] bool may_name_trials(std::string_view cell);

/// Content of a column that is named as trials.
enum class TrialsHeld : std::uint8_t { counts, labels, either };

/// Labels where none of the outcomes is above 1 and the column, called by the name of one, numbers the rows, differs
/// from row to row, or an amplitude comes twice; either where it may be both. \param file for messages
/// \throws InputError where the text is no table
[[nodiscard]] TrialsHeld trials_held(std::string const& text, std::string const& file);

}  // namespace overturn::cli

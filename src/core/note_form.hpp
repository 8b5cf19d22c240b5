/// Form of notes on stderr: as they are, or each line in a form that programs read.
#pragma once

#include <string>

namespace overturn {

/// \param line without its end \return what is written in its place, likewise
using NoteForm = std::string (*)(std::string const& line);

/// From here on every line of a note is written as `form` makes it; what is a line of JSON already stays.
void form_notes(NoteForm form) noexcept;

}  // namespace overturn

/// A campaign of a person's own answers, as a commented file.
#pragma once

#include <string>

#include "campaign/study_answers.hpp"

namespace overturn {

/// TOML. Answers stand as they were typed; what was not answered stands behind a line "# assumed: ..., because ...",
/// and among the keys `basis` with that reason, so that plan, fit and report list it. \param name of the campaign's
/// file \pre check_answers(answers), and none is missing
[[nodiscard]] std::string study_text(std::string const& name, StudyAnswers const& answers);

/// "overturn new NAME --mass '117 t'": the command that gives these answers, for a shell.
[[nodiscard]] std::string study_command(std::string const& name, StudyAnswers const& answers);

}  // namespace overturn

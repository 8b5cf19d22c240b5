/// Lines of text as UTF-8, whatever their writer's system wrote.
#pragma once

#include <string>
#include <string_view>

namespace overturn {

/// UTF-8 as it is; else decoded from Shift_JIS, EUC-JP, GB 18030, Big5 or EUC-KR where that yields a word that records
/// use ("time", "acceleration", a compass point), from ISO-2022-JP where its escapes stand, or else from the letters of
/// West Europe and Turkey. Always UTF-8. Letters of full width become plain ones, tags (<i>T</i>) are left out.
[[nodiscard]] std::string decoded(std::string_view line);

}  // namespace overturn

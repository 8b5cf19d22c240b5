/// How a box of a page shows that there is more of it to the side.
#pragma once

namespace overturn {

/// Declaration of a style for a box that scrolls to the sides, on --paper: a shadow at the side where more is to be
/// seen. Covers of the page's colour move with the content, shadows stay.
inline constexpr char const* scroll_hint =
    "background: linear-gradient(to right, var(--paper) 40%, transparent) left / 2.5rem 100% no-repeat local, "
    "linear-gradient(to left, var(--paper) 40%, transparent) right / 2.5rem 100% no-repeat local, "
    "linear-gradient(to right, #8889, transparent) left / 1rem 100% no-repeat, "
    "linear-gradient(to left, #8889, transparent) right / 1rem 100% no-repeat;";

}  // namespace overturn

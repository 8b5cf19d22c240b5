/// Checks that bad input is refused with one line that says what was expected of it.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace overturn::testing {

/// Runs `action`, which must throw InputError; the message must be one line and hold every one of `parts`.
template <class Action, class... Parts> void expect_input_error(Action&& action, Parts const&... parts) {
    try {
        action();
        ADD_FAILURE() << "accepted without an error";
    } catch (InputError const& error) {
        std::string const message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        for (std::string const& part : std::vector<std::string>{parts...}) {
            EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
        }
    }
}

}  // namespace overturn::testing

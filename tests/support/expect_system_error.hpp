/// Checks that trouble outside the program is reported in one line that names what is wrong.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace overturn::testing {

/// Runs `action`, which must throw SystemError; the message must be one line and hold every one of `parts`.
template <class Action, class... Parts> void expect_system_error(Action&& action, Parts const&... parts) {
    try {
        action();
        ADD_FAILURE() << "went on without an error";
    } catch (SystemError const& error) {
        std::string const message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        for (std::string const& part : std::vector<std::string>{parts...}) {
            EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
        }
    }
}

}  // namespace overturn::testing

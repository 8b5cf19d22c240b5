/// Files as others write them, and what is to be read from each.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn::testing {

struct Form {
    char const* name;
    std::string text;
    char const* format;
    double peak;  ///< of the horizontal component [m/s2]
    double unit_mps2;
    double time_step_s;
    std::vector<std::string> components;
};

inline void expect_read(std::vector<Form> const& forms) {
    for (auto const& form : forms) {
        try {
            auto const placed = read_placed(form.text, {.name = "f"});
            EXPECT_EQ(placed.format, form.format) << form.name;
            EXPECT_DOUBLE_EQ(peak_of(placed.motion.horizontal_mps2), form.peak) << form.name;
            EXPECT_DOUBLE_EQ(placed.unit_mps2, form.unit_mps2) << form.name;
            EXPECT_DOUBLE_EQ(placed.motion.time_step_s, form.time_step_s) << form.name;
            EXPECT_EQ(placed.components, form.components) << form.name;
        } catch (InputError const& error) {
            ADD_FAILURE() << form.name << ": " << error.what();
        }
    }
}

/// Another unit, and another step, than the file's own are refused.
inline void expect_contradictions(std::vector<Form> const& forms) {
    constexpr double gal = 0.01;
    for (auto const& form : forms) {
        SCOPED_TRACE(form.name);
        double const other = form.unit_mps2 == 1 ? gal : 1;
        expect_input_error([&] { (void)read_placed(form.text, {.name = "f", .unit_mps2 = other}); },
                           "f:", "contradict");
        expect_input_error([&] { (void)read_placed(form.text, {.name = "f", .time_step_s = 2 * form.time_step_s}); },
                           "f:", "contradict");
    }
}

/// The text is refused at a place of the file, with these words.
inline void refuse(std::string const& text, char const* part, RecordRequest const& request = {.name = "f"}) {
    expect_input_error([&] { (void)read_placed(text, request); }, "f:", part);
}

}  // namespace overturn::testing

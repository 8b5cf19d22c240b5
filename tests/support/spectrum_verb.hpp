/// `overturn spectrum` in a folder of its own.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace overturn::testing {

class SpectrumVerb : public ::testing::Test {
  protected:
    /// \param always stated in all that `done` runs
    explicit SpectrumVerb(std::vector<std::string> always) : always_(std::move(always)) {}

    Ended done(std::vector<std::string> const& arguments) {
        auto ended = overturn(folder, joined(joined({"spectrum"}, always_), arguments));
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended;
    }
    /// Without what is always stated.
    void refused(std::vector<std::string> const& arguments, std::string const& why) {
        auto const ended = overturn(folder, joined({"spectrum"}, arguments));
        EXPECT_EQ(ended.code, 2) << why;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    }
    /// That the figure is drawn from what --json prints.
    void expect_drawn_from_the_same_numbers(std::vector<std::string> const& arguments) {
        folder.write("interpreter", "#!/bin/sh\ncp \"$4\" \"$5\"\n");
        std::filesystem::permissions(folder / "interpreter", std::filesystem::perms::owner_all);
        ::setenv("OVERTURN_PYTHON", (folder / "interpreter").c_str(), 1);
        auto const shown = done(joined(arguments, {"--plot", "figure.svg", "--json"}));
        ::unsetenv("OVERTURN_PYTHON");

        EXPECT_EQ(nlohmann::json::parse(folder.read("figure.svg")), nlohmann::json::parse(shown.out));
    }

    Folder folder;

  private:
    std::vector<std::string> always_;
};

}  // namespace overturn::testing

#include "core/next_step.hpp"

#include <utility>

namespace overturn {

namespace {

std::string& stated_step() {
    static std::string text = "repeat the command";
    return text;
}

}  // namespace

NextStep::NextStep(std::string text) : before_(std::exchange(stated_step(), std::move(text))) {}
NextStep::~NextStep() { stated_step() = std::move(before_); }

std::string const& next_step() { return stated_step(); }

}  // namespace overturn

/// In which unit figures and tables show velocities; JSON and csv stay SI.
#pragma once

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::output {

/// "m/s", or the user's unit: kine.
struct ShownVelocity {
    static constexpr char const* usual = "m/s";
    std::string symbol = usual;

    /// SI value of one of it. \throws InputError if it is no unit of velocity
    [[nodiscard]] double si() const {
        try {
            return unit_factor(symbol, Dimension::velocity);
        } catch (InputError const& error) {
            throw InputError(std::string("--velocities: ") + error.what());
        }
    }
    [[nodiscard]] double of(double mps) const { return mps / si(); }
    /// "1.3492", "134.92": the same five digits of a velocity about 1 m/s.
    [[nodiscard]] std::string number(double mps) const {
        return symbol == usual ? fmt::format("{:.4f}", mps) : fmt::format("{:.5g}", of(mps));
    }
    /// "1.3492 m/s", "134.92 kine".
    [[nodiscard]] std::string text(double mps) const { return number(mps) + ' ' + symbol; }
    [[nodiscard]] nlohmann::ordered_json json() const { return {{"symbol", symbol}, {"si", si()}}; }
};

}  // namespace overturn::output

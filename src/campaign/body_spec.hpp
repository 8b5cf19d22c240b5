/// One body of a campaign, or of a body file: the rigid body, its friction and the scatter of its restitution.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "body/rigid_body.hpp"
#include "config/table.hpp"
#include "core/input_files.hpp"
#include "response/response.hpp"

namespace overturn {

/// ln(e) is normal with median and beta, drawn anew for each wave until e <= 1.
struct RestitutionScatter {
    double median = 0;
    double beta = 0;
};

struct BodySpec {
    std::string name;
    BodyInput input;
    RigidBody body;  ///< with the median restitution
    std::optional<Friction> friction;
    std::optional<RestitutionScatter> restitution_scatter;

    /// The body as it is under a given wave: its own draw of whatever scatters. Pure.
    [[nodiscard]] RigidBody for_wave(std::uint64_t seed, std::uint64_t wave, std::uint64_t index) const;
};

/// Keys: name, file, mass, base_width, centre_height, inertia (number or "uniform-block"), parts, restitution,
/// friction, gravity, similarity. Reads every key of `table` and finishes it.
/// \throws InputError
[[nodiscard]] BodySpec read_body(config::Table const& table, InputFiles& files);

}  // namespace overturn

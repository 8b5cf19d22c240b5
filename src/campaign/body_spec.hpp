/// One body of a campaign, or of a body file: the rigid body, its friction and what scatters about them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "body/footing.hpp"
#include "body/parts.hpp"
#include "body/rigid_body.hpp"
#include "body/similarity.hpp"
#include "campaign/scatter.hpp"
#include "campaign/text_units.hpp"
#include "config/table.hpp"
#include "core/input_files.hpp"
#include "model/friction.hpp"

namespace overturn {

/// The keys describe a prototype whose model is meant, or a model whose prototype is.
struct Scaling {
    SimilarityLaw law;
    bool to_model = true;
};

/// A body as it stands under one wave.
struct DrawnBody {
    RigidBody body;
    std::optional<Friction> friction;
};

struct BodySpec {
    std::string name;
    BodyInput stated;  ///< values of the keys, central ones of uncertain values
    std::optional<Scaling> scaling;
    RigidBody body;                    ///< of what is stated, scaled
    std::optional<Friction> friction;  ///< likewise central; empty: no slip
    BodyScatter scatter;
    int axes = 3;                 ///< Scene::axes
    Footing stated_footing = {};  ///< as the keys say
    Footing footing = {};         ///< of the body in force
    /// Its parts, in the size of the body in force, with the masses stated; empty: stated as a whole
    std::vector<BodyPart> parts = {};
    TypedUnits units = {};  ///< of texts about it: those of its file

    /// The first of its keys offset, slope and initial_tilt that says anything: of models only rocking and sliding hold
    /// them. Null: none does.
    [[nodiscard]] char const* planar_key() const;
    /// Those of mass, centre_height, restitution and friction that scatter, in that order.
    [[nodiscard]] std::vector<std::string> scattering() const;
    /// The standard normal scores of a draw of these.
    [[nodiscard]] std::vector<double> scores(DrawnBody const& drawn) const;
    /// The body as it is under a given wave: its own draw of whatever scatters. A drawn mass keeps the radius of
    /// gyration, a drawn centre height the inertia about the centre. Pure. \param index of the body in its campaign
    [[nodiscard]] DrawnBody for_wave(DrawnFor const& wave, std::uint64_t index) const;
    /// The draw that has these standard normal scores: the inverse of `scores`. \pre one for each of scattering()
    [[nodiscard]] DrawnBody at_scores(std::span<double const> scores) const;
    /// Is alpha another one under each wave?
    [[nodiscard]] bool draws_alpha() const;
};

extern config::KeyTable const body_table;    ///< of a body file
extern config::KeyTable const bodies_table;  ///< of [[bodies]]: with `file`

/// Reads every key of `table` and finishes it. \throws InputError
[[nodiscard]] BodySpec read_body(config::Table const& table, InputFiles& files);

[[nodiscard]] std::vector<std::string> names_of(std::span<BodySpec const> bodies);

}  // namespace overturn

/// Keys of a body, in its file or in [[bodies]].
#pragma once

#include <array>
#include <string_view>

#include "body/similarity.hpp"
#include "campaign/detail/footing_spec.hpp"
#include "campaign/detail/parts_spec.hpp"
#include "campaign/detail/placement_spec.hpp"
#include "campaign/scatter.hpp"
#include "config/table.hpp"
#include "core/units.hpp"

namespace overturn {

inline constexpr std::string_view uniform_block = "uniform-block";
inline constexpr std::array<config::Word, 1> inertia_words{{{uniform_block, "m (b^2 + h^2) / 3"}}};
inline constexpr std::array<config::Word, 1> restitution_words{
    {{"housner", "1 - 3/2 sin^2 alpha of a block, by its inertia"}}};
inline constexpr std::array scaling_directions{
    config::Entry<bool>{"to-model", "the keys describe the prototype", true},
    config::Entry<bool>{"to-prototype", "the keys describe the model", false}};

inline constexpr config::Keys similarity_keys{
    config::word_key<scaling_directions>("direction", "direction of the conversion"),
    config::number_key("length", Dimension::none, config::Range::positive(), "ratio of lengths, model to prototype")
        .otherwise(SimilarityLaw{}.length),
    config::number_key("mass_factor", Dimension::none, config::Range::positive(),
                       "ratio of the mass to the geometrically similar mass")
        .otherwise(SimilarityLaw{}.mass_factor)};
inline constexpr config::KeyTable similarity_table{.meaning = "similarity law between a model and its prototype",
                                                   .keys = similarity_keys.all};
inline constexpr config::Keys friction_keys{
    distribution_key("static", Dimension::none, config::Range::not_negative(), "static coefficient"),
    config::number_key("kinetic", Dimension::none, config::Range::not_negative(), "kinetic coefficient")
        .only("there is no kinetic_ratio"),
    config::number_key("kinetic_ratio", Dimension::none, config::Range::between(0, 1),
                       "kinetic over static coefficient")
        .optional()};
inline constexpr config::KeyTable friction_table{.meaning = "coefficients of friction at rest and in motion",
                                                 .keys = friction_keys.all};

inline constexpr std::string_view whole = "there is no file and no parts";
inline constexpr config::Keys body_keys{
    config::text_key("name", "unique name of the body").otherwise_in_words("name in its file, otherwise body"),
    config::number_key("base_width", Dimension::length, config::Range::positive(),
                       "width 2 b of the base in the rocking plane")
        .only("there is no file"),
    config::tables_key<part_table>("parts", "parts of the body, in place of mass, centre_height and inertia")
        .optional()
        .only("there is no file"),
    distribution_key("mass", Dimension::mass, config::Range::positive(), "mass; with a file only as a distribution")
        .only(whole),
    distribution_key("centre_height", Dimension::length, config::Range::positive(),
                     "height h of the centre of gravity; with a file only as a distribution")
        .only(whole),
    config::word_key<inertia_words>("inertia", "moment of inertia about the centre of gravity, in the rocking plane")
        .or_as(config::number_key("inertia", Dimension::inertia, config::Range::positive(), ""))
        .only(whole),
    distribution_key("restitution", Dimension::none, config::Range::between(0, 1),
                     "ratio of angular velocities after and before an impact")
        .or_as(config::word_key<restitution_words>("restitution", ""))
        .otherwise_in_words("housner"),
    distribution_key("friction", Dimension::none, config::Range::not_negative(),
                     "coefficient of friction; not stated: no slip")
        .or_as(config::table_key<distribution_table, friction_table>("friction", ""))
        .optional(),
    // Of asteroids and of centrifuges. Beyond, a motion is long or short beside what a body does under it.
    config::number_key("gravity", Dimension::acceleration, config::Range::between(0.01, 1e4), "acceleration of gravity")
        .otherwise(g0)
        .only("there is no file"),
    config::table_key<similarity_table>("similarity", "convert the described body to a model or its prototype")
        .optional()
        .only("there is no file"),
    config::integer_key("axes", 1, 3,
                        "components that act on it: 1 (horizontal), 2 (both horizontal), 3 (and vertical)")
        .otherwise_in_words("value in its file, otherwise 3")};

inline constexpr config::Keys bodies_keys{
    config::text_key("file", "file that describes the body; keys stated here override those of the file").optional()};

}  // namespace overturn

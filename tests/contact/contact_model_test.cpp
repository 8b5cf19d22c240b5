// Requirement R-504: contact keeps the contract of models: it holds what it says, fills outcomes and own fields, and is
// called for where a cheaper model cannot be trusted.
#include "contact/contact_model.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "support/bit_equal.hpp"
#include "support/describe_all.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::body_a;

constexpr EffectMask contact = mask_of(Effect::contact);
Footing const on_corners;
Footing const unmatched{.pad = {.match_restitution = false}};
constexpr EffectMask all = mask_of(Effect::vertical) | mask_of(Effect::sliding) | contact;

TEST(ContactModel, SaysWhatItIs) {
    auto const& traits = contact_traits();
    EXPECT_EQ(traits.name, "contact");
    EXPECT_EQ(traits.number, 3);
    EXPECT_EQ(traits.holds, all);
    EXPECT_EQ(traits.brings(), contact);
    EXPECT_TRUE(testing::describe_all(traits.fields, traits.default_row.size()));
    EXPECT_TRUE(std::isnan(real_at(traits.default_row, field_named(traits.fields, "peak_crush"))));
}

/// Counts what it is shown.
struct Seen : Observer {
    void begin(std::span<Channel const> /*channels*/) override { ++begun; }
    void at(std::span<double const> values) override {
        width = values.size();
        ++instants;
    }
    int begun = 0, instants = 0;
    std::size_t width = 0;
};

// Whoever asks for a history begins it, with the channels that the traits name.
TEST(ContactModel, ShowsTheChannelsThatItNames) {
    auto const wave = testing::sine(1, 1, 1, 2, 0.01);
    auto const body = body_a();
    Trial const trial{&body, &unmatched, {}, {.horizontal_mps2 = wave, .time_step_s = 0.01, .scale = 9}, contact};
    Outcome outcome;
    Seen seen;
    (void)make_contact_model({})->run(
        {.trials = std::span(&trial, 1), .outcomes = std::span(&outcome, 1), .observer = &seen});
    EXPECT_EQ(seen.begun, 0);
    EXPECT_GT(seen.instants, 10);
    EXPECT_EQ(seen.width, contact_traits().channels.size());
}

// R-1002.
TEST(ContactModel, RunsABatchAsItsTrialsAlone) {
    auto const wave = testing::sine(1, 1, 1, 2, 0.01);
    auto const body = body_a();
    auto const model = make_contact_model({});
    std::vector<Trial> trials;
    for (double const level : {3.0, 7.0, 9.0, 12.0, 14.0}) {
        for (EffectMask const simulated : {contact, all}) {
            trials.push_back({&body,
                              &unmatched,
                              Friction{0.5, 0.4},
                              {.horizontal_mps2 = wave, .vertical_mps2 = wave, .time_step_s = 0.01, .scale = level},
                              simulated});
        }
    }
    std::vector<Outcome> outcomes(trials.size());
    std::vector<std::byte> own(trials.size() * sizeof(ContactQuantities));
    model->run({.trials = trials, .outcomes = outcomes, .extra = own});
    for (std::size_t i = 0; i < trials.size(); ++i) {
        bool const everything = trials[i].simulated == all;
        auto const block = contact_block(body, {}, {}, everything ? trials[i].friction : std::nullopt);
        auto shaking = trials[i].excitation;
        shaking.vertical_mps2 = everything ? shaking.vertical_mps2 : std::span<double const>{};
        auto alone = simulate_contact(block, shaking);
        alone.required = contact;
        EXPECT_TRUE(testing::bit_equal<Outcome>(alone, outcomes[i])) << i;
        alone.extra.restitution = emergent_restitution(body, {}, {});
        alone.extra.corner_share = 1;
        alone.extra.normal_restitution = 0.25;
        ContactQuantities row;
        std::memcpy(&row, own.data() + i * sizeof(row), sizeof(row));
        EXPECT_TRUE(testing::bit_equal(alone.extra, row)) << i;
    }
}

//
TEST(ContactModel, MatchesEveryBody) {
    auto const wave = testing::sine(8, 1, 1, 2, 0.01);
    RigidBody const body({.mass_kg = 12.6e3,
                          .half_width_m = 0.68,
                          .centre_height_m = 1.045,
                          .inertia_kgm2 = body_a().inertia_kgm2(),
                          .restitution = 0.7});
    Trial const trial{&body, &on_corners, {}, {.horizontal_mps2 = wave, .time_step_s = 0.01}, contact};
    Outcome outcome;
    std::vector<std::byte> own(sizeof(ContactQuantities));
    make_contact_model({})->run({.trials = {&trial, 1}, .outcomes = {&outcome, 1}, .extra = own});
    auto const match = match_restitution(body, {}, {});
    auto const alone = simulate_contact(contact_block(body, match.base, match.pad, {}), trial.excitation);
    EXPECT_EQ(outcome.peak_rotation_rad, alone.peak_rotation_rad);
    EXPECT_LT(match.base.corner_share, 0.5);
    ContactQuantities row;
    std::memcpy(&row, own.data(), sizeof(row));
    EXPECT_EQ(row.restitution, match.restitution);
    EXPECT_NEAR(row.restitution, 0.7, 1e-4);
    EXPECT_EQ(row.corner_share, match.base.corner_share);
    EXPECT_EQ(row.normal_restitution, 0.25);
}

// Reasons by their stored numbers: 3 bedding, 4 tilt, 5 contact-lost, 6 pad-strength.
TEST(ContactModel, IsCalledForWhereItMatters) {
    auto const body = body_a();
    auto const model = make_contact_model({});
    auto const reason = [&](Footing const& footing, Outcome const* said) -> std::int64_t {
        auto const call = model->required_of(Trial{&body, &footing, {}, {}, 0}, said);
        EXPECT_EQ(call.effects, call.reason == no_reason ? 0 : contact);
        return call.reason;
    };
    Footing const stated{.stated = true};
    Outcome said;
    EXPECT_EQ(reason(stated, nullptr), 0);
    EXPECT_EQ(reason(stated, &said), 0);
    said.peak_rotation_ratio = 0.29;
    EXPECT_EQ(reason(stated, &said), 0);
    said.peak_rotation_ratio = 0.3;
    EXPECT_EQ(reason(stated, &said), 4);
    EXPECT_EQ(reason(on_corners, &said), 0);  // nothing is known of its pad
    said.verdict = Verdict::contact_lost;
    EXPECT_EQ(reason(stated, &said), 5);
    EXPECT_EQ(reason(on_corners, &said), 5);
    said.verdict = Verdict::failed;
    EXPECT_EQ(reason(stated, &said), 0);
    EXPECT_EQ(reason({.base = testing::flat_bed()}, nullptr), 3);
    EXPECT_EQ(reason({.base = {.corner_share = {}}}, nullptr), 3);
    EXPECT_EQ(reason({.base = {.shape = BaseShape::round}}, nullptr), 3);
    EXPECT_EQ(reason({.base = {.shape = BaseShape::polygon}}, nullptr), 0);  // that is motion in space

    // Where there is friction, contact slips.
    Footing const flat{.base = testing::flat_bed()};
    EXPECT_EQ(model->required_of(Trial{&body, &flat, Friction{0.5, 0.5}, {}, 0}, nullptr).effects,
              contact | mask_of(Effect::sliding));

    // On a pad of 1 MPa an impact far below 0.3 alpha crushes: its energy decides.
    Footing const weak{.pad = {.strength_pa = 1e6}, .stated = true};
    Outcome small;
    EXPECT_EQ(reason(weak, &small), 0);
    small.peak_energy_ratio = 0.2;
    EXPECT_EQ(reason(weak, &small), 6);
    EXPECT_EQ(reason(stated, &small), 0);
}

}  // namespace
}  // namespace overturn

// Requirement R-504: which model a trial needs follows from the effects that it calls for and that models hold; trials
// of many at once are those that each is alone, with their models' own quantities.
#include "response/model_selector.hpp"

#include <array>

#include <gtest/gtest.h>

#include "rocking/rocking_models.hpp"
#include "support/bit_equal.hpp"
#include "support/describe_all.hpp"
#include "support/expect_input_error.hpp"
#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

constexpr Effect crushing{16};
constexpr Verdict crushed{16};

struct CrushRow {
    double depth_m = never;
    std::int64_t hits = -1;
};

}  // namespace

template <> Fields const& fields_of<CrushRow>() {
    static Fields const fields{field<&CrushRow::depth_m>("depth", "m", "of a made-up crush"),
                               field<&CrushRow::hits>("hits", "1", "places in its batch")};
    return fields;
}

namespace {

// A made-up model: called for where a body rocks beyond a third of alpha, it calls every such trial crushed.
template <EffectMask Holds> ModelTraits const& crush_traits() {
    static constexpr std::array effects{EffectEntry{crushing, "crushing", "made up"}};
    static constexpr std::array verdicts{VerdictEntry{crushed, "crushed", "made up", true, true, false}};
    static ModelTraits const traits{.name = "crush",
                                    .number = 9,
                                    .holds = Holds,
                                    .always = mask_of(crushing),
                                    .effects = effects,
                                    .verdicts = verdicts,
                                    .fields = fields_of<CrushRow>(),
                                    .default_row = default_row_of<CrushRow>()};
    return traits;
}

template <EffectMask Holds> class Crush : public Model {
  public:
    [[nodiscard]] ModelTraits const& traits() const override { return crush_traits<Holds>(); }
    [[nodiscard]] Requirement required_of(Trial const& /*trial*/, Outcome const* said) const override {
        bool const rocks = said != nullptr && said->verdict != Verdict::failed && said->peak_rotation_ratio > 0.3;
        return {rocks ? mask_of(crushing) : 0};
    }
    std::unique_ptr<Checkpoints> run(Batch const& batch) const override {
        for (std::size_t i = 0; i < batch.trials.size(); ++i) {
            batch.outcomes[i].verdict = crushed;
            CrushRow const row{batch.trials[i].excitation.scale, static_cast<std::int64_t>(batch.places.size())};
            if (!batch.extra.empty()) {
                std::ranges::copy(bytes_of(row), batch.extra.begin() + static_cast<std::ptrdiff_t>(i * sizeof row));
            }
        }
        return nullptr;
    }
};

template <EffectMask Holds> ModelEntry crush_entry() {
    return {crush_traits<Holds>,
            [](Accuracy const&) -> std::unique_ptr<Model> { return std::make_unique<Crush<Holds>>(); }};
}

// The same, called for by every body from the start.
class Tied : public Crush<mask_of(Effect::vertical) | mask_of(Effect::sliding) | mask_of(crushing)> {
  public:
    [[nodiscard]] Requirement required_of(Trial const& /*trial*/, Outcome const* /*said*/) const override {
        return {mask_of(crushing)};
    }
};

ModelEntry tied_entry() {
    return {crush_traits<mask_of(Effect::vertical) | mask_of(Effect::sliding) | mask_of(crushing)>,
            [](Accuracy const&) -> std::unique_ptr<Model> { return std::make_unique<Tied>(); }};
}

constexpr EffectMask planar = mask_of(Effect::vertical) | mask_of(Effect::sliding);
constexpr EffectMask all = planar | mask_of(crushing);
constexpr EffectMask without_sliding = mask_of(Effect::vertical) | mask_of(crushing);

// As in the program, were there no other models.
ModelSelector without_crush() {
    static std::array const entries{models()[0], models()[1]};
    return ModelSelector(EffectRequest{}, {}, entries);
}

template <EffectMask Holds> ModelSelector with_crush(EffectRequest const& request = {}) {
    static std::array const entries{models()[0], models()[1], crush_entry<Holds>()};
    return ModelSelector(request, {}, entries);
}

RigidBody const body({.mass_kg = 1000,
                      .half_width_m = 0.68,
                      .centre_height_m = 1.045,
                      .inertia_kgm2 = 1000 * (0.68 * 0.68 + 1.045 * 1.045) / 3,
                      .restitution = 0.5538});

// Trials in no order of their strength, on grounds that hold and that do not.
class Many {
  public:
    Many() {
        for (int i = 0; i < 6; ++i) {
            motions_.push_back({.time_step_s = 0.02,
                                .horizontal_mps2 = testing::short_wave(i),
                                .transverse_mps2 = {},
                                .vertical_mps2 = {}});
            if (i % 2 == 1) {
                motions_.back().vertical_mps2 = testing::short_wave(i + 50);
                for (double& a : motions_.back().vertical_mps2) {
                    a *= 0.3;
                }
            }
        }
        for (double const share : {0.6, 1.02, 1.2, 2.0}) {
            double const mu = share * testing::type_a_tips;
            scenes_.push_back({body, Friction{mu, 0.9 * mu}});
        }
        scenes_.push_back({body, std::nullopt});
        for (std::size_t i = 0; i < 240; ++i) {
            trials_.push_back({scenes_[i % scenes_.size()], motions_[i % motions_.size()],
                               2.0 + static_cast<double>(i * 7 % 23) / 1.5});
        }
    }
    [[nodiscard]] std::vector<SceneTrial> const& trials() const { return trials_; }

  private:
    std::vector<GroundMotion> motions_;
    std::vector<Scene> scenes_;
    std::vector<SceneTrial> trials_;
};

struct Answers {
    std::vector<Response> responses;
    std::vector<std::byte> extra;
    std::vector<ModelCost> costs;
};

Answers answers_of(ModelSelector const& selector, std::span<SceneTrial const> trials) {
    Answers answers{
        std::vector<Response>(trials.size()), std::vector<std::byte>(trials.size() * selector.extra_bytes()), {}};
    answers.costs = selector.respond(trials, answers.responses, answers.extra);
    return answers;
}

// What the made-up model says of a trial, behind what other models say of it.
CrushRow row_at(ModelSelector const& selector, Answers const& answers, std::size_t i) {
    std::size_t place = 0;
    for (auto const& [traits, offset] : selector.extra_parts()) {
        place = traits->number == 9 ? offset : place;
    }
    CrushRow row;
    std::memcpy(&row, answers.extra.data() + i * selector.extra_bytes() + place, sizeof row);
    return row;
}

// R-1002: A trial that goes on from where friction gave out goes on from its own place, wherever it stood in the batch.
TEST(ModelSelector, TrialsOfManyAreThoseOfEachAlone) {
    Many const many;
    for (auto const& selector : {ModelSelector(EffectRequest{}), with_crush<all>()}) {
        auto const& trials = many.trials();
        auto const together = answers_of(selector, trials);
        std::vector<SceneTrial> backwards;
        for (auto i = trials.size(); i-- > 0;) {
            backwards.push_back(trials[i]);
        }
        auto const reversed = answers_of(selector, backwards);
        std::int64_t sliding = 0;
        for (std::size_t i = 0; i < trials.size(); ++i) {
            std::vector<std::byte> own(selector.extra_bytes());
            auto const alone = selector.respond(trials[i], own);
            EXPECT_TRUE(testing::bit_equal(together.responses[i], alone)) << i;
            EXPECT_TRUE(testing::bit_equal(reversed.responses[trials.size() - 1 - i], alone)) << i;
            sliding += together.responses[i].model == sliding_traits().number ? 1 : 0;
        }
        EXPECT_GT(sliding, 30);
        EXPECT_LT(sliding, 200);
    }
}

// What a model says of a trial that another one follows is not kept beside the other's answer.
TEST(ModelSelector, OnlyTheModelThatAnswersHasARow) {
    Many const many;
    ModelSelector const selector(EffectRequest{});
    auto const answers = answers_of(selector, many.trials());
    std::map<std::int64_t, int> followed;
    for (std::size_t i = 0; i < many.trials().size(); ++i) {
        auto const model = answers.responses[i].model;
        ++followed[model];
        if (model == 0) {
            continue;  // at rest: no model followed it
        }
        for (auto const& [traits, offset] : selector.extra_parts()) {
            auto const row =
                std::span(answers.extra).subspan(i * selector.extra_bytes() + offset, traits->default_row.size());
            EXPECT_EQ(std::ranges::equal(row, traits->default_row), traits->number != model) << i << traits->name;
        }
    }
    EXPECT_GT(followed[rocking_traits().number], 10);
    EXPECT_GT(followed[sliding_traits().number], 10);
}

TEST(ModelSelector, RequiredSlipIsReportedEvenWhereNothingMovesInTheEnd) {
    Many const many;
    auto const chosen = answers_of(ModelSelector(EffectRequest{}), many.trials());
    auto const forced = answers_of(ModelSelector({EffectMode::forced, planar}), many.trials());
    for (std::size_t i = 0; i < many.trials().size(); ++i) {
        bool const slid = forced.responses[i].peak_slip_m > 0;
        auto const said = [&](Answers const& a) {
            return has(static_cast<EffectMask>(a.responses[i].required), Effect::sliding);
        };
        EXPECT_EQ(said(forced), slid) << i;
        EXPECT_EQ(said(chosen), chosen.responses[i].model == sliding_traits().number) << i;
        EXPECT_TRUE(said(chosen) || !slid) << i;
    }
}

TEST(ModelSelector, GoesOnToAModelThatHoldsAllThatIsCalledFor) {
    Many const many;
    auto const plain = answers_of(without_crush(), many.trials());
    auto const selector = with_crush<all>();
    auto const answers = answers_of(selector, many.trials());
    std::array<int, 2> seen{};
    for (std::size_t i = 0; i < many.trials().size(); ++i) {
        auto const& before = plain.responses[i];
        auto const& after = answers.responses[i];
        bool const called = before.peak_rotation_ratio > 0.3;
        ++seen[called ? 1 : 0];
        EXPECT_EQ(after.verdict == crushed, called) << i;
        EXPECT_EQ(after.model == 9, called) << i;
        auto const row = row_at(selector, answers, i);
        if (called) {
            EXPECT_EQ(row.depth_m, many.trials()[i].scale) << i;
            EXPECT_GT(row.hits, 0) << "it came from another model's batch";
            EXPECT_EQ(after.effects, before.effects | mask_of(crushing)) << i;
        } else {
            EXPECT_TRUE(testing::bit_equal(after, before)) << i;
            EXPECT_TRUE(same_bits(row, CrushRow{})) << "it did not run: its row says nothing";
        }
    }
    EXPECT_GT(seen[0], 30);
    EXPECT_GT(seen[1], 30);
}

// A model that cannot slide never takes a trial that slips; the slip stays, and what is left out is said.
TEST(ModelSelector, LeavesOutWhatNoModelSupportsTogether) {
    Many const many;
    auto const plain = answers_of(without_crush(), many.trials());
    auto const answers = answers_of(with_crush<without_sliding>(), many.trials());
    int left_out = 0;
    for (std::size_t i = 0; i < many.trials().size(); ++i) {
        auto const& before = plain.responses[i];
        auto const& after = answers.responses[i];
        if (has(static_cast<EffectMask>(before.effects), Effect::sliding)) {
            EXPECT_EQ(after.verdict, before.verdict) << i;
            EXPECT_EQ(after.peak_slip_m, before.peak_slip_m) << i;
            EXPECT_EQ(after.effects, before.effects) << i;
            bool const called = has(static_cast<EffectMask>(after.required), crushing);
            EXPECT_EQ(after.reason == left_out_reason, called) << i;
            left_out += called ? 1 : 0;
        } else if (before.peak_rotation_ratio > 0.3) {
            EXPECT_EQ(after.verdict, crushed) << i;
            EXPECT_NE(after.reason, left_out_reason) << i;
        }
    }
    EXPECT_GT(left_out, 10);
    testing::expect_input_error(
        [] {
            (void)with_crush<without_sliding>({EffectMode::forced, mask_of(Effect::sliding) | mask_of(crushing)});
        },
        "no model supports them together");
}

// A body on a bed of its own, and something else of it that the model of beds does not hold: said before anything runs.
TEST(ModelSelector, ReportsRequiredEffectsThatNoModelSupportsTogether) {
    static std::array const entries{models()[0], models()[1], tied_entry(), models()[2]};
    Footing flat;
    flat.base.corner_share.reset();
    flat.pad.match_restitution = false;
    flat.stated = true;
    Many const many;
    auto const& motion = many.trials()[1].motion;
    Scene const on_bed{body, std::nullopt, flat};
    Scene const plain{body, std::nullopt};
    ModelSelector const chooses(EffectRequest{}, {}, entries);
    EXPECT_EQ(chooses.left_out({on_bed, motion, 5}), mask_of(Effect::contact));
    EXPECT_EQ(chooses.left_out({plain, motion, 5}), 0U);
    auto const answer = chooses.respond({on_bed, motion, 5});
    EXPECT_EQ(answer.reason, left_out_reason);
    EXPECT_EQ(answer.model, 9) << "the cheaper model's effect is kept";
    EXPECT_TRUE(has(static_cast<EffectMask>(answer.required), Effect::contact));
    EXPECT_FALSE(has(static_cast<EffectMask>(answer.effects), Effect::contact));
    EXPECT_EQ(ModelSelector(EffectRequest{}).left_out({on_bed, motion, 5}), 0U)
        << "the program's own models hold theirs";
    auto const together = mask_of(crushing) | mask_of(Effect::contact);
    testing::expect_input_error(
        [&] {
            (void)ModelSelector({EffectMode::forced, together}, {}, entries);
        },
        "no model supports them together");
}

// An effect that is forced on a body that cannot have it is no effect.
TEST(ModelSelector, ReportsForcedEffectsThatABodyCannotHave) {
    auto const impossible = [](EffectMask forced, RigidBody const& of, std::optional<Friction> friction) {
        return ModelSelector({EffectMode::forced, forced}).impossible({of, friction});
    };
    auto const contact = mask_of(Effect::contact);
    RigidBody const reed({.mass_kg = 1000,
                          .half_width_m = 0.01,
                          .centre_height_m = 2,
                          .inertia_kgm2 = 1000 * (0.01 * 0.01 + 2.0 * 2.0) / 3,
                          .restitution = 0.9});
    EXPECT_EQ(impossible(mask_of(Effect::sliding) | contact, body, std::nullopt), mask_of(Effect::sliding));
    EXPECT_EQ(impossible(mask_of(Effect::sliding) | contact, body, Friction{0.5, 0.4}), 0U);
    EXPECT_EQ(impossible(contact, reed, std::nullopt), contact) << "the usual pad does not hold it upright";
    EXPECT_EQ(impossible(mask_of(Effect::vertical), reed, std::nullopt), 0U) << "a matter of the wave";
    EXPECT_EQ(ModelSelector(EffectRequest{}).impossible({reed, std::nullopt}), 0U);
}

TEST(ModelSelector, CountsTrialsAndSecondsOfTheModelsThatEndedThem) {
    Many const many;
    auto const answers = answers_of(with_crush<all>(), many.trials());
    std::array<std::int64_t, 4> trials{};
    for (auto const& response : answers.responses) {
        ++trials[response.model == 9 ? 3 : static_cast<std::size_t>(response.model)];
    }
    ASSERT_EQ(answers.costs.size(), trials.size());
    for (std::size_t model = 0; model < trials.size(); ++model) {
        EXPECT_EQ(answers.costs[model].trials, trials[model]) << model;
        EXPECT_GT(trials[model], 0) << model;
        EXPECT_GT(answers.costs[model].seconds, 0) << model;
    }
}

// R-1104.
TEST(ModelSelector, AVerticalComponentBeyondAllBoundsHasNoVerdictEither) {
    GroundMotion motion{.time_step_s = 0.02,
                        .horizontal_mps2 = testing::short_wave(1),
                        .transverse_mps2 = {},
                        .vertical_mps2 = std::vector<double>(1001, 1e9)};
    Scene const scene{body, std::nullopt};
    EXPECT_EQ(ModelSelector(EffectRequest{}).respond({scene, motion, 1}).failure, FailureReason::out_of_range);
    EXPECT_EQ(ModelSelector({EffectMode::none, 0}).respond({scene, motion, 1}).failure, FailureReason::none)
        << "what is left out does no harm";
}

/// Keeps what it is shown.
struct Shown : Observer {
    void begin(std::span<Channel const> channels) override { width = channels.size(); }
    void at(std::span<double const> values) override {
        EXPECT_EQ(values.size(), width);
        largest_slip = std::max(largest_slip, std::abs(values[5]));
        ++instants;
    }
    std::size_t width = 0, instants = 0;
    double largest_slip = 0;
};

TEST(ModelSelector, ShowsTheModelThatAnswered) {
    Many const many;
    auto const selector = without_crush();
    int slid = 0;
    for (std::size_t i = 0; i < 60; ++i) {
        auto const response = selector.respond(many.trials()[i]);
        Shown shown;
        selector.show(many.trials()[i], response, shown);
        EXPECT_EQ(shown.width, 11U);
        EXPECT_GT(shown.instants, 0U) << i;
        EXPECT_LE(shown.largest_slip, response.peak_slip_m) << i;
        EXPECT_EQ(shown.largest_slip > 0, response.peak_slip_m > 0) << i;
        slid += response.peak_slip_m > 0 ? 1 : 0;
    }
    EXPECT_GT(slid, 5);
    Shown nothing;
    auto const failed = SceneTrial{many.trials()[0].scene, many.trials()[0].motion, 1e12};
    selector.show(failed, selector.respond(failed), nothing);
    EXPECT_EQ(nothing.width, 11U);
    EXPECT_EQ(nothing.instants, 0U);
}

TEST(Registry, NumbersBitsAndNamesAreEachTheirOwn) {
    std::set<std::int64_t> numbers{0};
    std::set<std::string_view> names{"at-rest"};
    EffectMask bits = 0;
    std::size_t effects_seen = 0;
    for (auto const& entry : models()) {
        auto const& traits = entry.traits();
        EXPECT_TRUE(numbers.insert(traits.number).second) << traits.name;
        EXPECT_TRUE(names.insert(traits.name).second) << traits.name;
        EXPECT_TRUE(holds_all(traits.holds, traits.brings() | traits.always)) << traits.name;
        EXPECT_EQ(bits & traits.brings(), 0U) << traits.name << " brings what another one brings";
        bits |= traits.brings();
        effects_seen += traits.effects.size();
        EXPECT_EQ(traits.fields.empty(), traits.default_row.empty());
        EXPECT_TRUE(traits.fields.empty() || testing::describe_all(traits.fields, traits.default_row.size()))
            << traits.name;
    }
    EXPECT_EQ(effects().size(), effects_seen);
    for (auto const& field : fields_of<Response>()) {
        EXPECT_FALSE(names.contains(field.name)) << "a model's group beside this column";
        EXPECT_FALSE(field.key().empty());
    }
}

}  // namespace
}  // namespace overturn

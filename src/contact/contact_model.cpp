#include "contact/contact_model.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "contact/matching.hpp"
#include "core/error.hpp"

namespace overturn {
namespace {

constexpr std::array contact_effect{EffectEntry{
    Effect::contact, "contact",
    "compliant base that can bounce and crush the pad; required by a bedding other than two corners, by a loss of "
    "contact, and, if base or pad is stated, by a tilt of 0.3 alpha or an impact near the pad's strength"}};

constexpr std::array channels{Channel{"time_s"},
                              Channel{"rotation_rad"},
                              Channel{"velocity_radps"},
                              Channel{"sway_m"},
                              Channel{"sway_mps"},
                              Channel{"rise_m"},
                              Channel{"rise_mps"},
                              Channel{"contact_force_over_weight"},
                              Channel{"crush_m"},
                              Channel{"slip_m"},
                              Channel{"x_m"},
                              Channel{"edge_x_most_m"},
                              Channel{"edge_x_least_m"},
                              Channel{"top_x_m"}};

/// Instants of the kernel as rows of channels.
class Shown : public ContactObserver {
  public:
    Shown(Observer& observer, ContactBlock const& block)
        : rows_(observer, 1), half_width_m_(block.half_width_m), centre_height_m_(block.centre_height_m) {}
    void at(ContactInstant const& i) override {
        double const lean_m = centre_height_m_ * std::sin(i.rotation_rad);
        double const base_m = i.sway_m - lean_m;
        double const reach_m = half_width_m_ * std::abs(std::cos(i.rotation_rad));
        rows_.at({i.time_s, i.rotation_rad, i.velocity_radps, i.sway_m, i.sway_mps, i.rise_m, i.rise_mps,
                  i.contact_force_ratio, i.crush_m, i.slip_m, base_m, base_m + reach_m, base_m - reach_m,
                  i.sway_m + lean_m});
    }

  private:
    UntilItLies<std::array<double, channels.size()>> rows_;
    double half_width_m_, centre_height_m_;
};

constexpr std::int64_t of_base = 3;
constexpr std::int64_t of_tilt = 4;
constexpr std::int64_t of_lost_contact = 5;
constexpr std::int64_t of_strength = 6;
constexpr std::array reasons{ReasonEntry{of_base, "bedding", "the base is not two corners: its restitution is its own"},
                             ReasonEntry{of_tilt, "tilt", "it rocks to 0.3 alpha, or falls, on a stated pad"},
                             ReasonEntry{of_lost_contact, "contact-lost", "a rigid base would leave the ground"},
                             ReasonEntry{of_strength, "pad-strength", "an impact may crush the pad"}};

class ContactModel : public Model {
  public:
    explicit ContactModel(ContactAccuracy const& accuracy) : accuracy_(accuracy) {}
    [[nodiscard]] ModelTraits const& traits() const override { return contact_traits(); }

    /// Not of a body that is off the middle, on a slope or tilted at first; nor, where neither base nor pad is stated,
    /// of one so slender that the default pad could not hold it upright.
    [[nodiscard]] EffectMask possible(Trial const& trial) const override {
        // Corners hold the body upright where (w_v b)^2 > g h, a flat bed, a third as stiff against turning, where it
        // is three times that; twice as much is asked for, so that whatever bedding the match finds holds it.
        constexpr double ample = 2 * 3;
        auto const& body = *trial.body;
        double const edge = 2 * pi * trial.footing->pad.vertical_frequency_hz * body.half_width_m();
        bool const holds = edge * edge > ample * body.gravity_mps2() * body.centre_height_m();
        return !body.needs_planar_rocking() && (trial.footing->stated || holds) ? mask_of(Effect::contact) : 0;
    }

    [[nodiscard]] Requirement required_of(Trial const& trial, Outcome const* earlier) const override {
        // With friction its points slip one by one, under far less shaking than slides a rigid base.
        auto const contact = mask_of(Effect::contact) | (trial.friction ? mask_of(Effect::sliding) : 0);
        constexpr double wild = 0.3;  // of alpha
        auto const& footing = *trial.footing;
        if (footing.base.continuous()) {
            return {};  // space follows it
        }
        if (!footing.base.on_corners() && footing.base.shape != BaseShape::polygon) {
            return {contact, of_base};
        }
        if (earlier == nullptr || earlier->verdict == Verdict::failed) {
            return {};
        }
        if (earlier->verdict == Verdict::contact_lost) {
            return {contact, of_lost_contact};
        }
        if (footing.stated && earlier->peak_rotation_ratio >= wild) {
            return {contact, of_tilt};
        }
        return crushes(trial, *earlier) ? Requirement{contact, of_strength} : Requirement{};
    }

    [[nodiscard]] std::unique_ptr<Checkpoints> run(Batch const& batch) const override {
        auto const matched = blocks_of(batch.trials);
        std::vector<ContactTrial> trials;
        trials.reserve(batch.trials.size());
        for (std::size_t i = 0; i < batch.trials.size(); ++i) {
            trials.push_back({&matched[i].block, planar_excitation(batch.trials[i])});
        }
        std::vector<ContactOutcome> outcomes(trials.size());
        if (batch.observer != nullptr) {
            OVERTURN_EXPECT(trials.size() == 1);
            Shown shown(*batch.observer, *trials.front().block);
            outcomes.front() = simulate_contact(*trials.front().block, trials.front().shaking, accuracy_, {}, &shown);
        } else {
            simulate_contact(trials, accuracy_, outcomes, batch.before_each);
        }
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            batch.outcomes[i] = outcomes[i];
            batch.outcomes[i].required = mask_of(Effect::contact);
            if (!batch.extra.empty()) {
                fill_match(matched[i].match, outcomes[i].extra);
                constexpr std::size_t row = sizeof(ContactQuantities);
                std::memcpy(batch.extra.subspan(i * row, row).data(), &outcomes[i].extra, row);
            }
        }
        return nullptr;
    }

  private:
    // One each: friction may differ. Neighbours of the same body and footing share its match.
    [[nodiscard]] std::vector<MatchedBlock> blocks_of(std::span<Trial const> trials) const {
        std::vector<MatchedBlock> blocks;
        blocks.reserve(trials.size());
        Trial const* before = nullptr;
        for (auto const& trial : trials) {
            auto const friction = has(trial.simulated, Effect::sliding) ? trial.friction : std::nullopt;
            if (before != nullptr && before->body == trial.body && before->footing == trial.footing) {
                auto const& match = blocks.back().match;
                blocks.push_back({contact_block(*trial.body, match.base, match.pad, friction), match});
            } else {
                blocks.push_back(matched_block(*trial.body, *trial.footing, friction));
            }
            before = &trial;
        }
        return blocks;
    }

    // The fastest impact that the energy allows, through corner and effective mass: v sqrt(k m_e).
    [[nodiscard]] static bool crushes(Trial const& trial, Outcome const& earlier) {
        auto const& footing = *trial.footing;
        if (!footing.pad.strength_pa || footing.base.shape == BaseShape::polygon) {
            return false;
        }
        // Largest force of an impact over v sqrt(k m_e). Integrating the law of one point in a flat drop gives 1.31 at
        // a point's restitution of 0.25, 1.87 at 0.1, 2.43 at 0.055 and 2.54 at 0.05, the least that matching comes to.
        constexpr double peak_force_factor = 2.55;
        auto const& body = *trial.body;
        auto const block = contact_block(body, footing.base, footing.pad, {});
        double const b = block.half_width_m;
        double const spin =
            body.p_radps() * std::sqrt(2 * earlier.peak_energy_ratio * (1 - std::cos(body.alpha_rad())));
        double const mass_share = 1 / (1 + b * b / block.inertia_over_mass_m2);
        double const w = block.vertical_radps();
        double const stiffness = block.points.front().stiffness_share * w * w;
        return peak_force_factor * 2 * b * spin * std::sqrt(mass_share / stiffness) > block.yield_depth_m;
    }

    ContactAccuracy accuracy_;
};

}  // namespace

ModelTraits const& contact_traits() {
    static ModelTraits const traits{
        .name = "contact",
        .number = 3,
        .holds = mask_of(Effect::vertical) | mask_of(Effect::sliding) | mask_of(Effect::contact),
        .always = mask_of(Effect::contact),
        .effects = contact_effect,
        .reasons = reasons,
        .channels = channels,
        .fields = fields_of<ContactQuantities>(),
        .default_row = default_row_of<ContactQuantities>(),
        .lacks = lacks_on_points};
    return traits;
}

std::unique_ptr<Model> make_contact_model(ContactAccuracy const& accuracy) {
    return std::make_unique<ContactModel>(accuracy);
}

MatchedBlock matched_block(RigidBody const& body, Footing const& footing, std::optional<Friction> const& friction) {
    auto const match = matched_footing(body, footing);
    return {contact_block(body, match.base, match.pad, friction), match};
}

}  // namespace overturn

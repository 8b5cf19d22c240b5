#include "contact/contact_model.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/error.hpp"

namespace overturn {
namespace {

constexpr std::array contact_effect{
    EffectEntry{Effect::contact, "contact",
                "a compliant base that bounces and is crushed; called for by a base that is not two corners, a tilt of "
                "0.3 alpha, a loss of contact, or an impact near the pad's strength"}};

constexpr std::array channels{Channel{"time_s"},  Channel{"rotation_rad"}, Channel{"velocity_radps"},
                              Channel{"sway_m"},  Channel{"sway_mps"},     Channel{"rise_m"},
                              Channel{"rise_mps"}};

/// Instants of the kernel as rows of channels.
class Shown : public ContactObserver {
  public:
    explicit Shown(Observer& observer) : observer_(observer) {}
    void at(ContactInstant const& i) override {
        observer_.at(
            std::array{i.time_s, i.rotation_rad, i.velocity_radps, i.sway_m, i.sway_mps, i.rise_m, i.rise_mps});
    }

  private:
    Observer& observer_;
};

class ContactModel : public Model {
  public:
    explicit ContactModel(ContactSetup const& setup) : setup_(setup) {}
    [[nodiscard]] ModelTraits const& traits() const override { return contact_traits(); }

    [[nodiscard]] EffectMask called_for(Trial const& trial, Outcome const* said) const override {
        bool const corners = setup_.base.corner_share == 1;
        bool const called = !corners || (said != nullptr && (wild(*said) || crushes(*trial.body, *said)));
        return called ? mask_of(Effect::contact) : 0;
    }

    [[nodiscard]] std::unique_ptr<Checkpoints> run(Batch const& batch) const override {
        auto const blocks = blocks_of(batch.trials);
        std::vector<ContactTrial> trials;
        trials.reserve(batch.trials.size());
        for (std::size_t i = 0; i < batch.trials.size(); ++i) {
            trials.push_back({&blocks[i], planar_excitation(batch.trials[i])});
        }
        std::vector<ContactOutcome> outcomes(trials.size());
        if (batch.observer != nullptr) {
            OVERTURN_EXPECT(trials.size() == 1);
            Shown shown(*batch.observer);
            outcomes.front() = simulate_contact(blocks.front(), trials.front().shaking, setup_.accuracy, {}, &shown);
        } else {
            simulate_contact(trials, setup_.accuracy, outcomes);
        }
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            batch.outcomes[i] = outcomes[i];
            batch.outcomes[i].called = mask_of(Effect::contact);
            if (!batch.own.empty()) {
                constexpr std::size_t row = sizeof(ContactQuantities);
                std::memcpy(batch.own.subspan(i * row, row).data(), &outcomes[i].own, row);
            }
        }
        return nullptr;
    }

  private:
    // One each: friction may differ. Neighbours with the same body share its match.
    [[nodiscard]] std::vector<ContactBlock> blocks_of(std::span<Trial const> trials) const {
        std::vector<ContactBlock> blocks;
        blocks.reserve(trials.size());
        RigidBody const* matched = nullptr;
        ContactMatch match{setup_.base, setup_.pad, 0};
        for (auto const& trial : trials) {
            bool const again = matched != nullptr && trial.body == matched;
            if (!again && setup_.restitution == Restitution::of_the_body) {
                matched = trial.body;
                match = match_restitution(*trial.body, setup_.base, setup_.pad, setup_.accuracy);
            }
            bool const slides = has(trial.simulated, Effect::sliding);
            blocks.push_back(contact_block(*trial.body, match.base, match.pad, slides ? trial.friction : std::nullopt,
                                           setup_.base_depth_m));
        }
        return blocks;
    }

    static bool wild(Outcome const& said) {
        constexpr double share = 0.3;  // of alpha
        return said.peak_rotation_ratio >= share || said.verdict == Verdict::contact_lost;
    }

    // The fastest impact that the energy allows, through corner and effective mass: v sqrt(k m_e).
    [[nodiscard]] bool crushes(RigidBody const& body, Outcome const& said) const {
        if (!setup_.pad.strength_pa) {
            return false;
        }
        constexpr double hardest = 2.4;  // largest measured ratio of force to v sqrt(k m_e)
        auto const block = contact_block(body, setup_.base, setup_.pad, {}, setup_.base_depth_m);
        double const b = block.half_width_m;
        double const spin = body.p_radps() * std::sqrt(2 * said.peak_energy_ratio * (1 - std::cos(body.alpha_rad())));
        double const mass_share = 1 / (1 + b * b / block.inertia_over_mass_m2);
        double const w = block.vertical_radps();
        double const stiffness = block.points.front().stiffness_share * w * w;
        return hardest * 2 * b * spin * std::sqrt(mass_share / stiffness) > block.yield_depth_m;
    }

    ContactSetup setup_;
};

}  // namespace

ModelTraits const& contact_traits() {
    static ModelTraits const traits{
        .name = "contact",
        .number = 3,
        .holds = mask_of(Effect::vertical) | mask_of(Effect::sliding) | mask_of(Effect::contact),
        .always = mask_of(Effect::contact),
        .effects = contact_effect,
        .channels = channels,
        .fields = fields_of<ContactQuantities>(),
        .nothing = nothing_of<ContactQuantities>()};
    return traits;
}

std::unique_ptr<Model> make_contact_model(ContactSetup const& setup) { return std::make_unique<ContactModel>(setup); }

}  // namespace overturn

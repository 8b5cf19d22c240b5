/// One trial of contact: what is rare and what needs thought, between the steps that lanes take.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "contact/detail/pressing.hpp"
#include "contact/planar_contact.hpp"

namespace overturn::contact {

class ContactRun {
  public:
    using Trial = ContactTrial;
    using Accuracy = ContactAccuracy;
    using Outcome = ContactOutcome;
    using Lanes = PressLanes<simd::most_lanes>;

    [[nodiscard]] static int width() { return press_width(); }
    [[nodiscard]] static std::uint32_t step(Lanes& lanes, int used) { return press_on(lanes, used); }

    /// \param block and what the shaking shows outlive this
    ContactRun(ContactBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
               std::optional<ContactStart> const& start);

    /// On to where lanes can step. \return false once the trial is over
    [[nodiscard]] bool advance();
    [[nodiscard]] ContactOutcome finish() const;

    /// The lane that holds the trial.
    [[nodiscard]] PressLanes<1>& lane() { return lane_; }
    [[nodiscard]] PressLanes<1> const& lane() const { return lane_; }
    [[nodiscard]] ContactInstant instant() const;

  private:
    enum class Phase : std::uint8_t { resting, shaken, running_out };

    void fill_trial(ContactAccuracy const& accuracy);
    void fill_steps(ContactAccuracy const& accuracy);
    void fill_law();
    void fill_points();
    void place(ContactStart const& start);
    void turn_to(double rotation_rad);
    void show_sample();
    void wake();
    void begin_run_out();
    void tell_peaks(ContactOutcome& out) const;
    [[nodiscard]] bool calm(std::size_t sample) const;
    [[nodiscard]] bool decided() const;
    [[nodiscard]] bool slipped() const;
    [[nodiscard]] double deepest_crush() const;
    [[nodiscard]] double mechanical_energy() const;
    /// Of motion and unbalance, over the mass: below it a body may be held at rest.
    [[nodiscard]] double quiet_energy() const;
    [[nodiscard]] double across(std::size_t sample) const;
    [[nodiscard]] double up(std::size_t sample) const;
    [[nodiscard]] double get(Pressing field) const { return lane_.body.at(field, 0); }
    void put(Pressing field, double value) { lane_.body.at(field, 0) = value; }

    ContactBlock const& block_;
    Excitation shaking_;
    std::size_t last_ = 0;  // sample
    double longest_step_s_ = 0;
    double run_out_s_ = 0;  // at most
    Phase phase_ = Phase::resting;
    bool from_rest_ = true;
    double held_across_ = 0, held_up_ = 0;  // shaking under which the body came to rest
    PressLanes<1> lane_;
};

}  // namespace overturn::contact

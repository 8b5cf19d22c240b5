/// One trial of contact, all but the steps that lanes take: how it starts, rests and wakes, when it is over, its
/// outcome.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "contact/detail/contact_step.hpp"
#include "contact/planar_contact.hpp"
#include "contact/point_run.hpp"

namespace overturn::contact {

class ContactRun : public PointRun<ContactRun, ContactField, Spot, ContactLanes<1>> {
  public:
    using Trial = ContactTrial;
    using Accuracy = ContactAccuracy;
    using Outcome = ContactOutcome;
    using Lanes = ContactLanes<simd::most_lanes>;

    [[nodiscard]] static int width() { return lane_width(); }
    [[nodiscard]] static std::uint32_t step(Lanes& lanes, int used) { return step_lanes(lanes, used); }

    /// \param block and what the shaking shows outlive this
    ContactRun(ContactBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
               std::optional<ContactStart> const& start);

    [[nodiscard]] ContactOutcome finish() const;

    [[nodiscard]] ContactInstant instant() const;

  private:
    using Base = PointRun<ContactRun, ContactField, Spot, ContactLanes<1>>;
    friend Base;
    static constexpr std::array shaken_by{ContactField::horizontal, ContactField::horizontal_change,
                                          ContactField::vertical, ContactField::vertical_change};

    void fill_trial(ContactAccuracy const& accuracy);
    void fill_waves();
    void fill_points();
    void place(ContactStart const& start);
    void turn_to(double rotation_rad);
    void show_sample();
    void hold(std::size_t sample);
    void wake();
    void fill_landing(ContactOutcome& out) const;
    void fill_peaks(ContactOutcome& out) const;
    void fill_reach(ContactOutcome& out) const;
    [[nodiscard]] bool fallen() const;
    [[nodiscard]] bool calm(std::size_t sample) const;
    [[nodiscard]] bool slipped() const;
    [[nodiscard]] double slip_m() const;
    [[nodiscard]] double across(std::size_t sample) const;
    [[nodiscard]] double up(std::size_t sample) const;

    double held_across_ = 0, held_up_ = 0;  // shaking under which the body came to rest
};

}  // namespace overturn::contact

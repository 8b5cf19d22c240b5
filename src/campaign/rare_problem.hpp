/// Overturning of one body of a campaign as a problem of rare events.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "campaign/campaign_spec.hpp"
#include "generators/normal_waves.hpp"
#include "rare/problem.hpp"
#include "response/ladder.hpp"

namespace overturn {

/// A trial measures nothing but how near to overturning it came.
class RareProblem : public rare::Problem {
  public:
    /// \param spec must outlive it
    RareProblem(CampaignSpec const& spec, std::size_t body);

    [[nodiscard]] std::size_t normals() const override { return waves_->normals(); }
    void respond(std::span<double const> normals, std::span<double const> factors,
                 std::span<rare::Answer> answers) const override;
    [[nodiscard]] std::optional<rare::PulseFrame> frame() const override;
    /// When the tilt last passed the critical angle outwards.
    [[nodiscard]] rare::Moment moment(std::span<double const> normals, double factor) const override;

    [[nodiscard]] GroundMotion motion(std::span<double const> normals) const { return waves_->make(normals); }

  private:
    [[nodiscard]] rare::Answer answer_of(Response const& response, double demand) const;

    BodySpec const& body_;
    std::unique_ptr<NormalWaves> waves_;
    Ladder ladder_;
};

}  // namespace overturn

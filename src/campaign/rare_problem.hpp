/// A limit state of one body of a campaign as a problem of rare events.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "campaign/campaign_spec.hpp"
#include "campaign/limit_state.hpp"
#include "campaign/site_judge.hpp"
#include "generators/normal_waves.hpp"
#include "rare/problem.hpp"
#include "response/model_selector.hpp"

namespace overturn {

/// A trial measures nothing but how near to the limit state it came. Its normals: the wave's, then one for each
/// quantity of the body that scatters.
class RareProblem : public rare::Problem {
  public:
    /// \param spec must outlive it \param limit place in its list; 0: overturning
    RareProblem(CampaignSpec const& spec, std::size_t body, std::size_t limit = 0);

    [[nodiscard]] std::size_t normals() const override { return waves_->normals() + scatter_; }
    void respond(std::span<double const> normals, std::span<double const> factors,
                 std::span<rare::Answer> answers) const override {
        respond_each(normals, factors, answers);
    }
    void respond_each(std::span<double const> normals, std::span<double const> factors,
                      std::span<rare::Answer> answers) const override;
    /// Frame of pulses, for overturning only: no instant of passing another limit state is known, as pulses need it.
    [[nodiscard]] std::optional<rare::PulseFrame> frame() const override;
    /// When the tilt last passed the critical angle outwards.
    [[nodiscard]] rare::Moment moment(std::span<double const> normals, double factor) const override;

    [[nodiscard]] GroundMotion motion(std::span<double const> normals) const {
        return waves_->make(normals.first(waves_->normals()));
    }

    /// The history of a trial.
    void show(std::span<double const> normals, double factor, Observer& observer) const;

  private:
    /// Drawn by the normals behind the wave's.
    [[nodiscard]] DrawnBody body_of(std::span<double const> normals) const {
        return body_.at_scores(normals.subspan(waves_->normals()));
    }
    [[nodiscard]] rare::Answer answer_of(Response const& response, double demand) const;
    [[nodiscard]] rare::Answer held_to_limit(DrawnBody const& drawn, Response const& response,
                                             std::span<std::byte const> extra, double demand) const;

    std::size_t body_number_;
    BodySpec const& body_;
    std::unique_ptr<NormalWaves> waves_;
    ModelSelector selector_;
    LimitJudge judge_;
    SiteJudge site_;
    std::size_t limit_;
    std::size_t scatter_;  ///< quantities of the body that scatter, a normal each
};

}  // namespace overturn

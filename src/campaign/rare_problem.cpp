#include "campaign/rare_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "rare/peak.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

/// Remembers when the tilt last passed the critical angle outwards.
class LastDeparture : public Observer {
  public:
    explicit LastDeparture(double critical_rad) : critical_rad_(critical_rad) {}

    void begin(std::span<Channel const> channels) override {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            time_ = channels[c].key == "time_s" ? c : time_;
            rotation_ = channels[c].key == "rotation_rad" ? c : rotation_;
        }
    }
    void at(std::span<double const> values) override {
        double const now = values[rotation_];
        if (std::abs(before_) < critical_rad_ && std::abs(now) >= critical_rad_) {
            last_ = {values[time_], now > 0 ? 1.0 : -1.0};
        }
        before_ = now;
    }
    [[nodiscard]] rare::Moment last() const { return last_; }

  private:
    double critical_rad_;
    std::size_t time_ = 0, rotation_ = 0;
    double before_ = 0;
    rare::Moment last_;
};

// At rest, or moving in another way beyond the demand that would have tipped it.
double not_begun(double demand) {
    constexpr double just_below = 1e-6;
    return demand < 1 ? demand - 1 : -just_below / demand;
}

}  // namespace

RareProblem::RareProblem(CampaignSpec const& spec, std::size_t body, std::size_t limit)
    : body_number_(body),
      body_(spec.bodies.at(body)),
      waves_(spec.source->from_normals()),
      selector_(spec.effects, spec.accuracy),
      judge_(spec.limits, selector_),
      site_(spec.site, spec.bodies, selector_),
      limit_(limit),
      scatter_(body_.scattering().size()) {}

rare::Answer RareProblem::answer_of(Response const& response, double demand) const {
    auto const& end = entry_of(response.verdict);
    rare::Answer answer{.driver = response.peak_rotation_ratio, .failed = end.fell, .undecided = !end.decided};
    if (!(response.peak_rotation_rad > 0)) {
        answer.driver = not_begun(demand);
    }
    if (!std::isfinite(answer.driver)) {
        answer.driver = answer.failed ? 1 : 0;
    }
    return answer;
}

rare::Answer RareProblem::held_to_limit(DrawnBody const& drawn, Response const& response,
                                        std::span<std::byte const> extra, double demand) const {
    TrialRow row;
    static_cast<Response&>(row) = response;
    row.centre_height_m = drawn.body.centre_height_m();
    row.body = body_number_;
    site_.fill(row, {row, extra});
    auto const outcomes = judge_.judge(row, extra);
    double const near = judge_.nearness(limit_, row, extra);
    rare::Answer answer{.driver = near == 0 ? not_begun(demand) : near,
                        .failed = outcomes.has_passed(limit_),
                        .undecided = !outcomes.is_decided(limit_)};
    if (!std::isfinite(near)) {
        answer.driver = answer.failed ? std::numeric_limits<double>::max() : 0;
    }
    return answer;
}

void RareProblem::respond_each(std::span<double const> normals, std::span<double const> factors,
                               std::span<rare::Answer> answers) const {
    struct Item {
        GroundMotion wave;
        DrawnBody drawn;
        double peak;
    };
    auto const each = this->normals();
    std::vector<Item> items;
    std::vector<Scene> scenes;
    std::vector<SceneTrial> trials;
    auto const count = normals.size() / each;
    items.reserve(count);
    scenes.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        auto const own = normals.subspan(i * each, each);
        auto& item = items.emplace_back(Item{motion(own), body_of(own), 0});
        item.peak = rare::peak_of_wave(item.wave.horizontal_mps2);
        scenes.push_back({item.drawn.body, item.drawn.friction, body_.footing, body_.axes});
        for (double const factor : factors) {
            trials.push_back({.scene = scenes.back(),
                              .motion = item.wave,
                              .scale = factor,
                              .peak_mps2 = item.peak,
                              .chunks = nullptr});
        }
    }
    auto const bytes = judge_.reads_extra() || site_.asked() ? selector_.extra_bytes() : 0;
    std::vector<std::byte> records(trials.size() * bytes);
    std::vector<Response> responses(trials.size());
    (void)selector_.respond(trials, responses, records);
    for (std::size_t t = 0; t < trials.size(); ++t) {
        auto const& [wave, drawn, peak] = items[t / factors.size()];
        double const demand = trials[t].scale * peak / drawn.body.uplift_acceleration_mps2();
        auto const record = std::span<std::byte const>(records).subspan(t * bytes, bytes);
        answers[t] = limit_ == 0 ? answer_of(responses[t], demand) : held_to_limit(drawn, responses[t], record, demand);
    }
}

std::optional<rare::PulseFrame> RareProblem::frame() const {
    auto const linear = waves_->linear();
    if (!linear || limit_ != 0) {
        return std::nullopt;
    }
    constexpr double fastest = 7.5;  // what is faster than so many cycles a body period does not move it
    double const body_period = 2 * pi / body_.body.p_radps();
    double const duration = 2 * pi / linear->spacing_radps;
    auto const lines = static_cast<std::size_t>(fastest / body_period * duration);
    return rare::PulseFrame{.lines = std::clamp<std::size_t>(lines, 1, linear->count),
                            .spacing_radps = linear->spacing_radps,
                            .duration_s = duration,
                            .body_period_s = body_period};
}

void RareProblem::show(std::span<double const> normals, double factor, Observer& observer) const {
    auto const wave = motion(normals);
    auto const drawn = body_of(normals);
    Scene const scene{drawn.body, drawn.friction, body_.footing, body_.axes};
    SceneTrial const trial{.scene = scene, .motion = wave, .scale = factor};
    selector_.show(trial, selector_.respond(trial), observer);
}

rare::Moment RareProblem::moment(std::span<double const> normals, double factor) const {
    LastDeparture departure(body_of(normals).body.alpha_rad());
    show(normals, factor, departure);
    return departure.last();
}

}  // namespace overturn

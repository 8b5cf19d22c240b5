/// The history of a trial as a figure shows it: the wave, what the body did, and its energy beside what the wave
/// offers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "campaign/body_spec.hpp"
#include "campaign/campaign_spec.hpp"
#include "model/history.hpp"
#include "motion/ground_motion.hpp"

namespace overturn::cli {

/// Keeps all instants of a trial.
class KeptHistory : public Observer {
  public:
    /// \param next sees them too, if given
    explicit KeptHistory(Observer* next = nullptr) : next_(next) {}
    void begin(std::span<Channel const> channels) override;
    void at(std::span<double const> values) override;

    [[nodiscard]] std::vector<std::string> const& keys() const { return keys_; }
    /// One per key, all of one length.
    [[nodiscard]] std::vector<std::vector<double>> const& columns() const { return columns_; }
    /// Did no model run the trial?
    [[nodiscard]] bool empty() const { return columns_.empty() || columns_.front().empty(); }

  private:
    Observer* next_;
    std::vector<std::string> keys_;
    std::vector<std::vector<double>> columns_;
};

/// Trial, body and wave of a history.
struct HistoryOf {
    std::string title;
    BodySpec const& spec;   ///< whose base it is
    RigidBody const& body;  ///< as it was drawn
    GroundMotion const& motion;
    double scale = 1;             ///< of every component of the motion
    MeasureSpec const* measures;  ///< settings for V_WES; null: not wanted
};

/// Most values of a quantity over time in a figure.
inline constexpr std::size_t for_a_page = 1500;
inline constexpr std::size_t for_a_file = 6000;

/// Data of history_figure.py: title, alpha, outline of the base, channels with v_resp_mps (response_velocity of the
/// tilt at every instant), wave and V_WES with times of their own, and V_Ereq; thinned, but without losing a peak. \pre
/// the history is not empty
[[nodiscard]] nlohmann::ordered_json history_data(KeptHistory const& history, HistoryOf const& of, std::size_t most);

/// Draws it. \throws InputError where the history is empty; else as report::draw_figure
/// \param units of the kinds of quantities that are drawn (units_json)
void draw_history(KeptHistory const& history, HistoryOf const& of, nlohmann::ordered_json const& units,
                  std::string const& output);

}  // namespace overturn::cli

/// Down from where failure is common to where it is rare, a fit of the pulses at every stage.
#pragma once

#include <string>
#include <vector>

#include "rare/detail/scout.hpp"
#include "rare/pulse_mixture.hpp"

namespace overturn::rare {

class PulseDescent {
  public:
    PulseDescent(Problem const& problem, Request const& request, Workforce& workers, PulseOptions const& options);

    /// Pilot runs of all replicates from `from` to `to` and the refits there. Stops where hits die out.
    void descend(double from, double to);
    /// Runs of all replicates from what was fitted last, appended to one last stage.
    void finish(std::span<double const> factors, std::int64_t runs_each);

    [[nodiscard]] std::vector<std::vector<MixtureStage>> const& stages() const { return stages_; }
    [[nodiscard]] std::vector<std::vector<MixtureStage>>& stages() { return stages_; }
    [[nodiscard]] std::int64_t runs() const { return runs_; }
    /// Smallest share of draws that failed, over the stages after the first [-].
    [[nodiscard]] double poorest_hits() const { return poorest_hits_; }
    [[nodiscard]] bool broken() const { return broken_; }  ///< a replicate had too few failures to fit
    [[nodiscard]] bool spent() const { return spent_; }    ///< max_runs ended the descent

  private:
    void pilot(double factor);
    /// \param pooled how many of the last stages' failures are fitted together \param strengthened how many times as
    /// strong as fitted the pulses are drawn
    void fit(std::size_t pooled, double strengthened);
    [[nodiscard]] Mixture fitted(std::vector<MixtureStage> const& stages, std::size_t pooled) const;
    void run(std::string const& name, std::int64_t first, std::int64_t count);
    void respond(MixtureStage const& stage, std::int64_t first, std::span<WeightedRow> rows) const;

    Problem const& problem_;
    Request request_;
    Workforce& workers_;
    PulseOptions options_;
    PulseFrame frame_;
    std::vector<std::vector<MixtureStage>> stages_;  ///< of every replicate
    std::vector<Mixture> mixtures_;                  ///< from which each replicate draws next
    std::int64_t runs_ = 0;
    double poorest_hits_ = 1;
    bool broken_ = false;
    bool spent_ = false;
};

}  // namespace overturn::rare

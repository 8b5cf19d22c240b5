#include "results/telling_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "campaign/rows.hpp"
#include "core/error.hpp"
#include "response/registry.hpp"
#include "results/recount.hpp"

namespace overturn {
namespace {

/// The candidates of one body as the trials come, in order of their numbers: an equal one does not displace an earlier.
class Candidates {
  public:
    /// \param slips whether it has friction: what a base without one wanders on points is no slip
    explicit Candidates(bool slips) : slips_(slips) {}
    void add(TellingTrial const& trial) {
        auto const& end = entry_of(trial.verdict);
        if (!end.moved || !end.decided) {
            return;
        }
        if (end.fell) {
            if (!first_overturned_ || trial.level < first_overturned_->level) {
                first_overturned_ = trial;
            }
            if (!fall_ || fall_->wave != trial.wave) {
                fall_ = trial;  // levels rise within a wave
            }
            return;
        }
        if (trial.peak_rotation_ratio > (nearest_miss_ ? nearest_miss_->peak_rotation_ratio : 0)) {
            nearest_miss_ = trial;
        }
        if (slips_ && trial.peak_slip_m > (largest_slip_ ? largest_slip_->peak_slip_m : 0)) {
            largest_slip_ = trial;
        }
        if (fall_ && fall_->wave == trial.wave) {
            if (non_monotonic_.empty() || non_monotonic_.back().wave != trial.wave) {
                non_monotonic_.emplace_back();
            }
            non_monotonic_.back() = trial;  // of a wave the highest
            non_monotonic_.back().overturned_at = fall_->amplitude;
        }
    }

    void append_to(std::vector<TellingTrial>& all) {
        auto const put = [&](std::optional<TellingTrial> const& trial, TellingKind kind) {
            if (trial) {
                all.push_back(*trial);
                all.back().kind = kind;
            }
        };
        put(first_overturned_, TellingKind::first_overturned);
        put(nearest_miss_, TellingKind::nearest_miss);
        put(largest_slip_, TellingKind::largest_slip);
        std::ranges::stable_sort(non_monotonic_, [](auto const& a, auto const& b) {
            return a.amplitude / a.overturned_at > b.amplitude / b.overturned_at;
        });
        non_monotonic_.resize(std::min(non_monotonic_.size(), most_non_monotonic));
        for (auto const& trial : non_monotonic_) {
            put(trial, TellingKind::non_monotonic);
        }
    }

  private:
    bool slips_;
    std::optional<TellingTrial> first_overturned_, nearest_miss_, largest_slip_;
    std::optional<TellingTrial> fall_;  // the last wave's lowest
    std::vector<TellingTrial> non_monotonic_;
};

// All bodies' candidates, as trials come in the order of their numbers.
class Scan {
  public:
    Scan(CampaignSpec const& spec, Plan plan) : spec_(spec), plan_(std::move(plan)) {
        for (auto const& body : spec.bodies) {
            bodies_.emplace_back(body.friction.has_value());
        }
    }

    void add(Verdict verdict, double peak_rotation_ratio, double peak_slip_m) {
        auto const [wave, body, level] = plan_.trial(next_);
        TellingTrial trial;
        trial.trial = next_++;
        trial.wave = plan_.number(wave);
        trial.body = body;
        trial.level = level;
        trial.amplitude = spec_.levels.levels.at(level).value;
        trial.verdict = verdict;
        trial.peak_rotation_ratio = peak_rotation_ratio;
        trial.peak_slip_m = peak_slip_m;
        bodies_.at(body).add(trial);
    }

    [[nodiscard]] std::vector<TellingTrial> found() {
        std::vector<TellingTrial> all;
        for (auto& body : bodies_) {
            body.append_to(all);
        }
        return all;
    }

  private:
    CampaignSpec const& spec_;
    Plan plan_;
    std::vector<Candidates> bodies_;
    std::int64_t next_ = 0;
};

}  // namespace

std::vector<std::size_t> share_fairly(std::span<std::size_t const> offered, std::size_t most) {
    std::vector<std::size_t> gets(offered.size(), 0);
    std::vector<std::size_t> wanting;
    for (std::size_t i = 0; i < offered.size(); ++i) {
        if (offered[i] > 0) {
            wanting.push_back(i);
        }
    }
    if (wanting.size() > most) {
        for (std::size_t k = 0; k < most; ++k) {
            gets[wanting[k * wanting.size() / most]] = 1;
        }
        return gets;
    }
    for (std::size_t left = most; left > 0 && !wanting.empty();) {
        for (auto const i : wanting) {
            gets[i] += left > 0 ? 1 : 0;
            left -= left > 0 ? 1 : 0;
        }
        std::erase_if(wanting, [&](std::size_t i) { return gets[i] == offered[i]; });
    }
    return gets;
}

std::vector<TellingTrial> telling_trials(CampaignSpec const& spec, Plan const& plan, TrialColumns const& columns) {
    OVERTURN_EXPECT(columns.verdicts.size() == columns.peak_rotation_ratios.size()
                    && columns.verdicts.size() == columns.peak_slips_m.size());
    Scan scan(spec, plan);
    for (std::size_t t = 0; t < columns.verdicts.size(); ++t) {
        scan.add(columns.verdicts[t], columns.peak_rotation_ratios[t], columns.peak_slips_m[t]);
    }
    return scan.found();
}

std::vector<TellingTrial> telling_trials(CampaignSpec const& spec, store::ResultsReader const& file) {
    constexpr std::array<std::string_view, 3> columns{"verdict", "peak_rotation_ratio", "peak_slip"};
    TrialRow unknown;
    unknown.peak_rotation_ratio = unknown.peak_slip_m = never;
    Scan scan(spec, plan_in(file, spec));
    each_trial(file, spec, columns, unknown, [&](std::int64_t, TrialRow const& row) {
        scan.add(row.verdict, row.peak_rotation_ratio, row.peak_slip_m);
    });
    return scan.found();
}

}  // namespace overturn

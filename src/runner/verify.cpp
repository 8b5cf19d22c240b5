#include "runner/verify.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "campaign/block_rows.hpp"
#include "campaign/plan.hpp"
#include "output/made_by.hpp"
#include "parallel/rows_of_ranks.hpp"
#include "results/rare_replayer.hpp"
#include "results/rare_results.hpp"
#include "results/recount.hpp"
#include "results/schema.hpp"
#include "results/stored_rows.hpp"
#include "runner/progress.hpp"

namespace overturn {
namespace {

/// Rows of /trials that are computed together: a block of waves, or those drawn of one wave.
struct Unit {
    std::int64_t first = 0, count = 0;  ///< waves
    std::vector<std::int64_t> drawn;    ///< trials; empty: all
};

/// Where the first difference stands, in the order of the file: of what kind, which row.
struct Place {
    int kind = std::numeric_limits<int>::max();  ///< 0 trial, 1 wave, 2 rare event
    std::int64_t row = 0;
    std::string text;
};

// Runs through the numbers of rows, which are too many to be listed.
class RowNumber {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::int64_t;
    using difference_type = std::ptrdiff_t;
    using pointer = std::int64_t const*;
    using reference = std::int64_t const&;

    explicit RowNumber(std::int64_t number) : number_(number) {}
    [[nodiscard]] reference operator*() const { return number_; }
    RowNumber& operator++() {
        ++number_;
        return *this;
    }
    RowNumber operator++(int) { return RowNumber(number_++); }
    [[nodiscard]] bool operator==(RowNumber const&) const = default;

  private:
    std::int64_t number_;
};

class Verifier {
  public:
    Verifier(store::ResultsReader const& file, CampaignSpec const& spec, VerifyRequest const& request)
        : file_(file),
          spec_(spec),
          selector_(spec.effects, spec.accuracy),
          plan_(plan_in(file, spec)),
          rows_(file, spec) {
        waves_ = rows_.wave_count();
        trials_ = waves_ * plan_.trials_per_wave();
        auto const limits = spec.rare ? spec.limits.size() : 0;
        for (std::size_t b = 0; b < spec.bodies.size() && limits > 0; ++b) {
            for (std::size_t l = 0; l < limits; ++l) {
                rare_.push_back(std::make_unique<RareReplayer>(file, spec, b, l));
                rare_names_.push_back(rare_group(spec, b, l));
            }
        }
        draw(request);
    }

    [[nodiscard]] std::int64_t units() const { return units_.size() + rare_rows_.size(); }

    void compute(std::int64_t unit) {
        std::size_t const number = unit;
        if (number >= units_.size()) {
            compare_rare(rare_rows_[number - units_.size()]);
        } else if (units_[number].drawn.empty()) {
            compute_block(units_[number]);
        } else {
            compute_drawn(units_[number]);
        }
    }

    void add_stored(Verified& sum) const {
        sum.stored_trials = trials_;
        sum.stored_waves = waves_;
        for (auto const& replayer : rare_) {
            sum.stored_rare += replayer->rows();
        }
    }

    [[nodiscard]] std::string found() const {
        return nlohmann::json{{"counts", counts_}, {"kind", first_.kind}, {"row", first_.row}, {"text", first_.text}}
            .dump();
    }

  private:
    struct RareRowPlace {
        std::size_t replayer;
        std::int64_t row;
    };

    void draw(VerifyRequest const& request) {
        Verified stored;
        add_stored(stored);
        auto const all = stored.stored_trials + stored.stored_rare;
        validate(!request.sample || (*request.sample >= 1 && *request.sample <= all),
                 "--sample {} (the file has {} rows of trials). Choose from 1 to {}, or leave it out for all",
                 request.sample.value_or(0), all, all);
        if (!request.sample) {
            for (std::int64_t first = 0; first < waves_; first += plan_.block_size()) {
                units_.push_back({first, std::min(plan_.block_size(), waves_ - first), {}});
            }
            for (auto row = trials_; row < all; ++row) {
                add_rare(row - trials_);
            }
            return;
        }
        std::vector<std::int64_t> drawn;
        std::mt19937_64 random(request.seed);
        std::sample(RowNumber{0}, RowNumber{all}, std::back_inserter(drawn), *request.sample, random);
        for (auto const row : drawn) {
            if (row >= trials_) {
                add_rare(row - trials_);
                continue;
            }
            auto const wave = row / plan_.trials_per_wave();
            if (units_.empty() || units_.back().first != wave) {
                units_.push_back({wave, 1, {}});
            }
            units_.back().drawn.push_back(row);
        }
    }

    void add_rare(std::int64_t row) {
        std::size_t r = 0;
        for (; row >= rare_[r]->rows(); ++r) {
            row -= rare_[r]->rows();
        }
        rare_rows_.push_back({r, row});
    }

    void differ(int kind, std::int64_t row, std::vector<std::string> const& columns, std::string const& what) {
        if (columns.empty()) {
            return;
        }
        ++counts_.at(static_cast<std::size_t>(kind) + 3);
        if (kind < first_.kind || (kind == first_.kind && row < first_.row)) {
            first_ = {kind, row, fmt::format("{}: {}", what, fmt::join(columns, ", "))};
        }
    }

    void compare_trial(std::int64_t number, TrialRows const& stored, TrialRows const& again, std::size_t at) {
        auto const extra = selector_.extra_bytes();
        auto const one = [&](TrialRows const& trials) {
            auto const part = std::span(trials.extra).subspan(at * extra, extra);
            return TrialRows{{trials.rows[at]}, {part.begin(), part.end()}};
        };
        auto const a = one(stored);
        auto const b = one(again);
        ++counts_[0];
        if (same_bits(a.rows.front(), b.rows.front()) && a.extra == b.extra) {
            return;
        }
        auto const& row = b.rows.front();
        differ(0, number, differing_columns(file_, spec_, a, b),
               fmt::format("trial {} (wave {}, {}, {})", number, row.wave, spec_.bodies[row.body].name,
                           spec_.levels.text(row.amplitude)));
    }

    // Where a wave was compared with nothing, files of earlier programs hold 0, and this one nothing.
    [[nodiscard]] std::vector<std::string> different(Fields const& fields, std::span<std::byte const> stored,
                                                     std::span<std::byte const> again) const {
        auto names = differing(fields, stored, again);
        std::erase_if(names, [&](std::string const& name) {
            auto const& field = *std::ranges::find(fields, name, &Field::name);
            return of_another_program_ && field.type == FieldType::real && is_match_figure(name)
                   && real_at(stored, field) == 0 && std::isnan(real_at(again, field));
        });
        return names;
    }

    void compare_waves(std::int64_t first, std::span<WaveRow const> waves, std::span<MeasureRow const> measures) {
        auto const bodies = spec_.bodies.size();
        std::int64_t const count = waves.size();
        auto const stored = rows_.waves(first, count);
        auto const stored_measures = rows_.measures(first, count);
        for (std::size_t w = 0; w < waves.size(); ++w) {
            auto columns =
                different(rows_.wave_table().columns, overturn::bytes_of(stored[w]), overturn::bytes_of(waves[w]));
            auto const mine = [&](std::span<MeasureRow const> rows) {
                return std::as_bytes(rows.subspan(w * bodies, bodies));
            };
            for (std::size_t b = 0; b < bodies; ++b) {
                for (auto const& name :
                     different(rows_.measure_tables()[b].columns, mine(stored_measures), mine(measures))) {
                    columns.push_back(spec_.bodies[b].name + "/" + name);
                }
            }
            ++counts_[1];
            auto const row = first + static_cast<std::int64_t>(w);
            differ(1, row, columns, fmt::format("row {} of /waves", row));
        }
    }

    void compute_block(Unit const& unit) {
        auto const again = run_block(spec_, plan_, unit.first / plan_.block_size(), seconds_);
        auto const first = unit.first * plan_.trials_per_wave();
        auto const count = unit.count * plan_.trials_per_wave();
        auto const stored = rows_.trials(first, count);
        for (std::int64_t i = 0; i < count; ++i) {
            compare_trial(first + i, stored, again.trials, i);
        }
        std::size_t const waves = unit.count;
        compare_waves(unit.first, std::span(again.waves).first(waves),
                      std::span(again.measures).first(waves * spec_.bodies.size()));
    }

    void compute_drawn(Unit const& unit) {
        auto const wave = prepare_wave(spec_, plan_, unit.first, seconds_);
        for (auto const number : unit.drawn) {
            auto const [of_wave, body, level] = plan_.trial(number);
            compare_trial(number, rows_.trials(number, 1), run_trial(spec_, wave, body, level), 0);
        }
        compare_waves(unit.first, std::span(&wave.row, 1), wave.measures);
    }

    void compare_rare(RareRowPlace const& place) {
        auto const& replayer = *rare_[place.replayer];
        auto const stored = replayer.stored(place.row);
        ++counts_[2];
        differ(2, place.row, replayer.differing(stored, replayer.again(stored, place.row)),
               fmt::format("row {} of /{}/rows", place.row, rare_names_[place.replayer]));
    }

    store::ResultsReader const& file_;
    CampaignSpec const& spec_;
    ModelSelector selector_;
    Plan plan_;
    StoredRows rows_;
    bool of_another_program_ = !output::is_of_this_program(file_);
    std::int64_t waves_ = 0, trials_ = 0;
    std::vector<Unit> units_;
    std::vector<std::unique_ptr<RareReplayer>> rare_;
    std::vector<std::string> rare_names_;
    std::vector<RareRowPlace> rare_rows_;
    PhaseSeconds seconds_;
    std::vector<std::int64_t> counts_ = std::vector<std::int64_t>(6);  ///< looked at, then differing, by kind
    Place first_;
};

Verified together(std::vector<std::string> const& ranks) {
    Verified sum;
    Place first;
    for (auto const& rank : ranks) {
        auto const found = nlohmann::json::parse(rank);
        auto const counts = found.at("counts").get<std::vector<std::int64_t>>();
        sum.trials += counts[0];
        sum.waves += counts[1];
        sum.rare += counts[2];
        sum.differing_trials += counts[3];
        sum.differing_waves += counts[4];
        sum.differing_rare += counts[5];
        Place const place{found.at("kind").get<int>(), found.at("row").get<std::int64_t>(),
                          found.at("text").get<std::string>()};
        if (std::pair(place.kind, place.row) < std::pair(first.kind, first.row)) {
            first = place;
        }
    }
    sum.first = first.text;
    return sum;
}

}  // namespace

Verified verify_rows(store::ResultsReader const& file, CampaignSpec const& spec, VerifyRequest const& request,
                     parallel::Communicator const& comm) {
    Verifier verifier(file, spec, request);
    spec.source->prepare(parallel::rows_of_ranks(comm));
    {
        parallel::SharedCounter given(comm);
        parallel::SharedCounter done(comm);
        Progress progress(verifier.units(), 0, 0, request.sample ? "waves" : "blocks");
        auto const show = [&] {
            if (comm.is_root() && progress.is_due()) {
                progress.show(done.look());
            }
        };
        for (auto unit = given.take(); unit < verifier.units(); unit = given.take()) {
            verifier.compute(unit);
            (void)done.take();
            show();
        }
        comm.wait_for_all(show);
        if (comm.is_root()) {
            progress.finish();
        }
    }
    auto const ranks = comm.gather(verifier.found());
    if (!comm.is_root()) {
        return {};
    }
    auto sum = together(ranks);
    verifier.add_stored(sum);
    return sum;
}

}  // namespace overturn

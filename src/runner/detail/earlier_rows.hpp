/// Rows that an earlier campaign of the same waves and bodies left: in a finished file, or in blocks of a run that was
/// not finished.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/block_rows.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/known_trials.hpp"
#include "campaign/plan.hpp"
#include "results/stored_rows.hpp"
#include "store/results_file.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Rows of an earlier campaign, by wave.
class EarlierRows {
  public:
    virtual ~EarlierRows() = default;
    EarlierRows(EarlierRows const&) = delete;
    EarlierRows& operator=(EarlierRows const&) = delete;
    EarlierRows(EarlierRows&&) = delete;
    EarlierRows& operator=(EarlierRows&&) = delete;

    [[nodiscard]] std::string const& place() const { return place_; }
    [[nodiscard]] CampaignSpec const& spec() const { return spec_; }
    [[nodiscard]] Plan const& plan() const { return plan_; }
    /// Waves that are there.
    [[nodiscard]] std::int64_t count() const { return std::ssize(places_); }
    /// CampaignInput::record_identities()
    [[nodiscard]] std::vector<RecordIdentity> const& records() const { return records_; }
    /// Place of the wave with that identity among those that are there.
    [[nodiscard]] std::optional<std::int64_t> find(std::int64_t wave_id) const;
    /// Rows of consecutive waves, as the earlier campaign numbers bodies and levels.
    /// \throws SystemError if they cannot be read
    [[nodiscard]] virtual BlockRows rows(std::int64_t first, std::int64_t count) const = 0;

  protected:
    EarlierRows(std::string place, CampaignInput const& input);
    /// \param ids of the waves, in the order in which they lie
    void index(std::vector<std::int64_t> const& ids);

  private:
    std::string place_;
    std::vector<RecordIdentity> records_;
    CampaignSpec spec_;
    Plan plan_;
    std::vector<std::pair<std::int64_t, std::int64_t>> places_;  ///< by identity
};

/// Rows of a finished file, whose seal is not checked here. HDF5 reads 64 KiB of a column at least, which is a
/// thousand times a wave of few trials: where waves are asked for one after the other, more are read at once.
class FinishedRows : public EarlierRows {
  public:
    explicit FinishedRows(std::filesystem::path const& output);
    [[nodiscard]] BlockRows rows(std::int64_t first, std::int64_t count) const override;

  private:
    FinishedRows(std::filesystem::path const& output, std::unique_ptr<store::ResultsReader> file);
    [[nodiscard]] BlockRows read(std::int64_t first, std::int64_t count) const;
    std::unique_ptr<store::ResultsReader> file_;
    StoredRows rows_;
    mutable BlockRows ahead_;  ///< what was read last, of so many waves
    mutable std::int64_t ahead_first_ = 0, ahead_count_ = 0;
};

/// Rows of blocks that were set aside (ShardFolder::set_aside).
class UnfinishedRows : public EarlierRows {
  public:
    /// \param blocks those that are sound, rising
    UnfinishedRows(store::ShardFolder shards, CampaignInput const& input, std::vector<std::int64_t> blocks);
    [[nodiscard]] BlockRows rows(std::int64_t first, std::int64_t count) const override;

  private:
    store::ShardFolder shards_;
    std::vector<std::int64_t> blocks_, firsts_;  ///< and where the first wave of each lies
};

/// Rows that are kept.
struct KeptCount {
    std::int64_t waves = 0, trials = 0;

    void add(KeptCount const& more) {
        waves += more.waves;
        trials += more.trials;
    }
};

/// Rows of earlier campaigns that a larger one can use.
class KeptRows : public KnownTrials {
  public:
    /// \param spec and `plan` outlive it \param records CampaignInput::record_identities()
    KeptRows(CampaignSpec const& spec, Plan const& plan, std::vector<RecordIdentity> const& records,
             std::vector<std::unique_ptr<EarlierRows>> earlier);

    /// Can all rows of the block be taken, unseen?
    [[nodiscard]] bool has_all(std::int64_t block) const;
    /// Is a trial known of any of its waves?
    [[nodiscard]] bool has_some(std::int64_t block) const;
    /// Trials of its waves that can be kept, and how many waves have one.
    [[nodiscard]] KeptCount count(std::int64_t block) const;
    /// \pre has_all(block)
    [[nodiscard]] BlockRows block(std::int64_t number) const;
    /// Origin of the first of its waves. \pre has_all(block)
    [[nodiscard]] std::string const& origin(std::int64_t block) const;

    [[nodiscard]] std::optional<KnownWave> of(std::int64_t wave) const override;

  private:
    /// One earlier campaign, and where it has the bodies and levels of this one.
    struct Source {
        std::unique_ptr<EarlierRows> rows;
        std::vector<std::optional<std::int64_t>> bodies, levels;
        std::vector<std::optional<std::int64_t>> waves;  ///< where these are records, which may stand elsewhere
        bool whole = false;  ///< all bodies drawn as before, and rows of waves depend on no other body
    };
    /// The last waves that were read of one of them.
    struct Read {
        Source const* of = nullptr;
        std::int64_t first = 0, count = 0;
        BlockRows rows;
    };
    struct Found {
        Source const* source = nullptr;
        std::int64_t place = 0;
    };
    [[nodiscard]] Source source_of(std::unique_ptr<EarlierRows> rows, std::vector<RecordIdentity> const& records) const;
    /// Place of one of this plan's waves.
    [[nodiscard]] std::optional<std::int64_t> place_in(Source const& source, std::int64_t wave) const;
    /// Is it the wave of that number there too, by which bodies are drawn?
    [[nodiscard]] bool keeps_number(Source const& source, std::int64_t wave) const;
    [[nodiscard]] bool draws_as_before(EarlierRows const& rows, std::size_t body, std::int64_t there) const;
    [[nodiscard]] bool has_levels(Source const& source, std::int64_t wave) const;
    [[nodiscard]] Found whole_wave(std::int64_t wave) const;
    /// Trials of a wave that is not there whole.
    [[nodiscard]] std::int64_t trials_of(std::int64_t wave) const;
    void append(BlockRows& block, std::int64_t first_wave, Found const& from, std::int64_t count) const;
    void put(KnownWave& known, std::int64_t wave, Found const& from) const;
    [[nodiscard]] Read const& read(Found const& from) const;
    /// Place of a body's trial at one of the wave's levels among an earlier wave's trials.
    [[nodiscard]] std::optional<std::size_t> trial_in(Source const& source, std::int64_t wave, std::int64_t body,
                                                      std::int64_t level) const;

    CampaignSpec const& spec_;
    Plan const& plan_;
    std::vector<Source> sources_;
    mutable Read read_;
};

}  // namespace overturn

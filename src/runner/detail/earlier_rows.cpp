#include "runner/detail/earlier_rows.hpp"

#include <algorithm>
#include <iterator>

#include "core/error.hpp"
#include "results/recount.hpp"

namespace overturn {
namespace {

constexpr std::int64_t most_rows_read = 1 << 14U;  // trials

// Levels that are equal but for the last digits are computed twice: their scale differs.
std::optional<std::int64_t> level_there(LevelSpec const& there, double value) {
    auto const found = std::ranges::find(there.levels, value, &Level::value);
    return found == there.levels.end() ? std::nullopt : std::optional(found - there.levels.begin());
}

bool any_scatters(std::vector<BodySpec> const& bodies) {
    return std::ranges::any_of(bodies, [](BodySpec const& body) { return !body.scattering().empty(); });
}

template <class Row> void copy_rows(std::vector<Row> const& from, std::int64_t first, std::int64_t count, auto& to) {
    auto const begin = from.begin() + first;
    to.insert(to.end(), begin, begin + count);
}

// Waves from one place on, to the end of others of the same campaign.
void copy_waves(BlockRows const& from, std::int64_t first, std::int64_t count, Plan const& plan, BlockRows& to) {
    auto const trials = plan.trials_per_wave();
    auto const of_trials = trials * plan.extra_bytes();
    copy_rows(from.waves, first, count, to.waves);
    copy_rows(from.measures, first * plan.bodies(), count * plan.bodies(), to.measures);
    copy_rows(from.trials.rows, first * trials, count * trials, to.trials.rows);
    copy_rows(from.trials.extra, first * of_trials, count * of_trials, to.trials.extra);
}

}  // namespace

EarlierRows::EarlierRows(std::string place, CampaignInput const& input)
    : place_(std::move(place)), records_(input.record_identities()), spec_(parse_campaign(input)), plan_(spec_) {}

void EarlierRows::index(std::vector<std::int64_t> const& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
        places_.emplace_back(ids[i], i);
    }
    std::ranges::sort(places_);
}

std::optional<std::int64_t> EarlierRows::find(std::int64_t wave_id) const {
    auto const found = std::ranges::lower_bound(places_, wave_id, {}, &decltype(places_)::value_type::first);
    return found == places_.end() || found->first != wave_id ? std::nullopt : std::optional(found->second);
}

FinishedRows::FinishedRows(std::filesystem::path const& output)
    : FinishedRows(output, std::make_unique<store::ResultsReader>(output, store::Trust::unverified)) {}

FinishedRows::FinishedRows(std::filesystem::path const& output, std::unique_ptr<store::ResultsReader> file)
    : EarlierRows(output.string(), input_of(*file)), file_(std::move(file)), rows_(*file_, spec()) {
    index(file_->integers("waves/id"));
}

BlockRows FinishedRows::read(std::int64_t first, std::int64_t count) const {
    auto const each = plan().trials_per_wave();
    return {rows_.waves(first, count), rows_.measures(first, count), rows_.trials(first * each, count * each)};
}

// A rank takes blocks in a row, but with many ranks few: twice as much is read each time that more is asked for.
BlockRows FinishedRows::rows(std::int64_t first, std::int64_t count) const {
    auto const end = ahead_first_ + ahead_count_;
    if (first < ahead_first_ || first + count > end) {
        bool const goes_on = first <= end && first > ahead_first_;
        auto const most = std::max<std::int64_t>(1, most_rows_read / plan().trials_per_wave());
        auto const wanted = std::max(count, goes_on ? std::min(2 * ahead_count_, most) : 0);
        ahead_count_ = std::min(wanted, this->count() - first);
        ahead_first_ = first;
        ahead_ = read(ahead_first_, ahead_count_);
    }
    BlockRows some;
    copy_waves(ahead_, first - ahead_first_, count, plan(), some);
    return some;
}

UnfinishedRows::UnfinishedRows(store::ShardFolder shards, CampaignInput const& input, std::vector<std::int64_t> blocks)
    : EarlierRows(shards.folder().string(), input), shards_(std::move(shards)), blocks_(std::move(blocks)) {
    std::vector<std::int64_t> ids;
    for (auto const block : blocks_) {
        firsts_.push_back(std::ssize(ids));
        auto const [first, count] = plan().waves_of_block(block);
        for (auto wave = first; wave < first + count; ++wave) {
            ids.push_back(static_cast<std::int64_t>(plan().wave_id(wave)));
        }
    }
    index(ids);
}

BlockRows UnfinishedRows::rows(std::int64_t first, std::int64_t count) const {
    BlockRows all;
    while (count > 0) {
        auto const number = std::ranges::upper_bound(firsts_, first) - firsts_.begin() - 1;
        auto const waves = plan().waves_of_block(blocks_.at(number)).count;
        auto const rows = BlockRows::unpack(shards_.read(blocks_[number]), plan(), waves);
        auto const from = first - firsts_[number];
        auto const taken = std::min(count, waves - from);
        copy_waves(rows, from, taken, plan(), all);
        first += taken;
        count -= taken;
    }
    return all;
}

KeptRows::KeptRows(CampaignSpec const& spec, Plan const& plan, std::vector<RecordIdentity> const& records,
                   std::vector<std::unique_ptr<EarlierRows>> earlier)
    : spec_(spec), plan_(plan) {
    for (auto& rows : earlier) {
        sources_.push_back(source_of(std::move(rows), records));
    }
}

KeptRows::Source KeptRows::source_of(std::unique_ptr<EarlierRows> rows,
                                     std::vector<RecordIdentity> const& records) const {
    Source source;
    auto const& there = rows->spec();
    // Rules look at every body's band, and of a site other bodies are a part.
    bool const bodies_count = spec_.source->about().acceptance.asked() || spec_.site.cask_body.has_value();
    source.whole = !bodies_count || names_of(spec_.bodies) == names_of(there.bodies);
    for (std::size_t b = 0; b < spec_.bodies.size(); ++b) {
        auto const found = std::ranges::find(there.bodies, spec_.bodies[b].name, &BodySpec::name);
        bool const known = found != there.bodies.end();
        source.bodies.push_back(known ? std::optional(found - there.bodies.begin()) : std::nullopt);
        source.whole = source.whole && known && draws_as_before(*rows, b, *source.bodies.back());
    }
    for (auto const& level : spec_.levels.levels) {
        source.levels.push_back(level_there(there.levels, level.value));
    }
    auto const& recorded = rows->records();
    for (std::size_t i = 0; i < records.size(); ++i) {
        auto const found = i < recorded.size() && recorded[i] == records[i]
                               ? recorded.begin() + static_cast<std::ptrdiff_t>(i)
                               : std::ranges::find(recorded, records[i]);
        source.waves.push_back(found == recorded.end() ? std::nullopt : std::optional(found - recorded.begin()));
    }
    source.rows = std::move(rows);
    return source;
}

std::optional<std::int64_t> KeptRows::place_in(Source const& source, std::int64_t wave) const {
    auto const id = static_cast<std::int64_t>(plan_.wave_id(wave));
    auto const there = source.waves.empty() ? std::optional(id) : source.waves.at(id);
    return there ? source.rows->find(*there) : std::nullopt;
}

bool KeptRows::keeps_number(Source const& source, std::int64_t wave) const {
    auto const id = static_cast<std::int64_t>(plan_.wave_id(wave));
    return source.waves.empty() || source.waves.at(id) == id;
}

// What scatters is drawn by the body's place, and where it is sliced by the number of waves.
bool KeptRows::draws_as_before(EarlierRows const& rows, std::size_t body, std::int64_t there) const {
    bool const sliced = spec_.sampling != Sampling::independent && spec_.wave_count != rows.spec().wave_count;
    return spec_.bodies[body].scattering().empty() || (static_cast<std::int64_t>(body) == there && !sliced);
}

bool KeptRows::has_levels(Source const& source, std::int64_t wave) const {
    auto const first = source.levels.begin() + plan_.first_level(wave);
    return std::all_of(first, first + plan_.level_count(), [](auto const& level) { return level.has_value(); });
}

KeptRows::Found KeptRows::whole_wave(std::int64_t wave) const {
    for (auto const& source : sources_) {
        bool const drawn_alike = keeps_number(source, wave) || !any_scatters(spec_.bodies);
        auto const place =
            source.whole && drawn_alike && has_levels(source, wave) ? place_in(source, wave) : std::nullopt;
        if (place) {
            return {&source, *place};
        }
    }
    return {};
}

bool KeptRows::has_all(std::int64_t block) const {
    auto const [first, count] = plan_.waves_of_block(block);
    for (auto wave = first; wave < first + count; ++wave) {
        if (whole_wave(wave).source == nullptr) {
            return false;
        }
    }
    return true;
}

bool KeptRows::has_some(std::int64_t block) const {
    auto const [first, count] = plan_.waves_of_block(block);
    for (auto wave = first; wave < first + count; ++wave) {
        for (auto const& source : sources_) {
            auto const has = [](auto const& place) { return place.has_value(); };
            auto const level = source.levels.begin() + plan_.first_level(wave);
            if (place_in(source, wave) && std::ranges::any_of(source.bodies, has)
                && std::any_of(level, level + plan_.level_count(), has)) {
                return true;
            }
        }
    }
    return false;
}

// Of several sources the first that has a trial is asked for it, as in of().
std::int64_t KeptRows::trials_of(std::int64_t wave) const {
    std::vector<std::optional<bool>> kept(plan_.trials_per_wave());
    for (auto const& source : sources_) {
        if (!place_in(source, wave)) {
            continue;
        }
        for (std::int64_t t = 0; t < plan_.trials_per_wave(); ++t) {
            auto const body = t / plan_.level_count();
            if (!kept[t] && trial_in(source, wave, body, t % plan_.level_count())) {
                bool const alike = keeps_number(source, wave) || spec_.bodies[body].scattering().empty();
                kept[t] = alike && draws_as_before(*source.rows, body, *source.bodies[body]);
            }
        }
    }
    return std::ranges::count(kept, std::optional(true));
}

KeptCount KeptRows::count(std::int64_t block) const {
    KeptCount count;
    auto const [first, waves] = plan_.waves_of_block(block);
    for (auto wave = first; wave < first + waves; ++wave) {
        auto const trials = whole_wave(wave).source != nullptr ? plan_.trials_per_wave() : trials_of(wave);
        count.add({trials > 0 ? 1 : 0, trials});
    }
    return count;
}

std::string const& KeptRows::origin(std::int64_t block) const {
    return whole_wave(plan_.waves_of_block(block).first).source->rows->place();
}

BlockRows KeptRows::block(std::int64_t number) const {
    auto const [first, count] = plan_.waves_of_block(number);
    BlockRows block;
    for (auto wave = first; wave < first + count;) {
        auto const from = whole_wave(wave);
        OVERTURN_EXPECT(from.source != nullptr);
        auto end = wave + 1;
        while (end < first + count) {
            auto const next = whole_wave(end);
            if (next.source != from.source || next.place != from.place + end - wave) {
                break;
            }
            ++end;
        }
        append(block, wave, from, end - wave);
        wave = end;
    }
    return block;
}

std::optional<std::size_t> KeptRows::trial_in(Source const& source, std::int64_t wave, std::int64_t body,
                                              std::int64_t level) const {
    auto const there = source.bodies[body];
    auto const at = source.levels[plan_.first_level(wave) + level];
    if (!there || !at) {
        return std::nullopt;
    }
    auto const& plan = source.rows->plan();
    return *there * plan.level_count() + (plan.groups() > 1 ? 0 : *at);
}

// Waves that lie in an earlier campaign as they do in this one.
void KeptRows::append(BlockRows& block, std::int64_t first_wave, Found const& from, std::int64_t count) const {
    auto const& plan = from.source->rows->plan();
    auto const bytes = plan_.extra_bytes();
    auto const rows = from.source->rows->rows(from.place, count);
    for (std::int64_t w = 0; w < count; ++w) {
        auto const id = static_cast<std::int64_t>(plan_.wave_id(first_wave + w));
        block.waves.push_back(rows.waves[w]);
        block.waves.back().id = id;
        for (std::int64_t b = 0; b < plan_.bodies(); ++b) {
            block.measures.push_back(rows.measures[w * plan.bodies() + *from.source->bodies[b]]);
            for (std::int64_t l = 0; l < plan_.level_count(); ++l) {
                auto const place = w * plan.trials_per_wave()
                                   + static_cast<std::int64_t>(*trial_in(*from.source, first_wave + w, b, l));
                block.trials.rows.push_back(rows.trials.rows[place]);
                block.trials.rows.back().wave = id;
                block.trials.rows.back().body = b;
                block.trials.rows.back().level = plan_.first_level(first_wave + w) + l;
                copy_rows(rows.trials.extra, place * bytes, bytes, block.trials.extra);
            }
        }
    }
}

KeptRows::Read const& KeptRows::read(Found const& from) const {
    auto const place = from.place;
    if (read_.of != from.source || place < read_.first || place >= read_.first + read_.count) {
        auto const& rows = *from.source->rows;
        auto const at_once = std::max<std::int64_t>(1, most_rows_read / rows.plan().trials_per_wave());
        read_ = {};
        auto const first = place / at_once * at_once;
        auto const count = std::min(at_once, rows.count() - first);
        read_ = {from.source, first, count, rows.rows(first, count)};
    }
    return read_;
}

void KeptRows::put(KnownWave& known, std::int64_t wave, Found const& from) const {
    auto const& plan = from.source->rows->plan();
    auto const bytes = plan_.extra_bytes();
    auto const& there = read(from);
    auto const first = (from.place - there.first) * plan.trials_per_wave();
    known.row = there.rows.waves[from.place - there.first];
    known.row.id = static_cast<std::int64_t>(plan_.wave_id(wave));
    for (std::int64_t t = 0; t < plan_.trials_per_wave(); ++t) {
        auto const place = trial_in(*from.source, wave, t / plan_.level_count(), t % plan_.level_count());
        if (!place || known.known[t]) {
            continue;
        }
        known.known[t] = true;
        auto const row = first + static_cast<std::int64_t>(*place);
        known.trials.rows[t] = there.rows.trials.rows[row];
        std::copy_n(there.rows.trials.extra.begin() + (row * bytes), bytes, known.trials.extra.begin() + (t * bytes));
    }
}

std::optional<KnownWave> KeptRows::of(std::int64_t wave) const {
    std::optional<KnownWave> known;
    std::size_t const trials = plan_.trials_per_wave();
    for (auto const& source : sources_) {
        if (auto const place = place_in(source, wave)) {
            if (!known) {
                known.emplace(
                    KnownWave{{},
                              {std::vector<TrialRow>(trials), std::vector<std::byte>(trials * plan_.extra_bytes())},
                              std::vector<bool>(trials)});
            }
            put(*known, wave, {&source, *place});
        }
    }
    return known;
}

}  // namespace overturn

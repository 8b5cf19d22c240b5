#include "runner/detail/rank_workforce.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "core/elapsed.hpp"
#include "core/print_note.hpp"
#include "runner/root_broadcast.hpp"

namespace overturn {

RankWorkforce::RankWorkforce(store::ShardFolder const& shards, StopPolicy& stop_policy,
                             parallel::Communicator const& comm)
    : shards_(shards), stop_policy_(stop_policy), comm_(comm) {
    if (comm_.is_root()) {
        std::vector<std::string> notes;
        auto const sound = shards_.committed({first_shard, std::numeric_limits<std::int64_t>::max()}, notes);
        found_.insert(sound.begin(), sound.end());
        for (auto const& each : notes) {
            print_note("{}\n", each);
        }
    }
}

std::vector<std::byte> RankWorkforce::rows_of(rare::Stage const& stage, Work const& work) {
    std::vector<std::byte> rows;
    rows.reserve(stage.items * stage.row_bytes);
    for (std::int64_t first = 0; first < stage.items; first += portion_items) {
        auto const part = portion(stage, first, std::min(portion_items, stage.items - first), work);
        rows.insert(rows.end(), part.begin(), part.end());
    }
    return rows;
}

// What an earlier run committed; empty if it is not there.
std::string RankWorkforce::committed(std::string const& head, std::size_t bytes) const {
    if (!found_.contains(shard_)) {
        return {};
    }
    auto const found = shards_.read(shard_);
    std::string const text(reinterpret_cast<char const*>(found.data()), found.size());
    return text.starts_with(head) && text.size() == head.size() + bytes ? text.substr(head.size()) : std::string();
}

std::vector<std::byte> RankWorkforce::portion(rare::Stage const& stage, std::int64_t first, std::int64_t count,
                                              Work const& work) {
    auto const head = fmt::format("{}{} {}+{}\n", name_, stage.name, first, count);
    auto const bytes = count * stage.row_bytes;
    auto text = broadcast_from_root(comm_, [&] { return committed(head, bytes); });
    if (text.empty()) {
        auto const begin = Clock::now();
        bool const stops = !stop_policy_.may_begin();
        auto const own = stops ? std::string() : own_rows(stage, first, count, work);
        // One that left early leaves the portion unfinished.
        if (comm_.largest(stops || !stop_policy_.may_go_on() ? 1 : 0) != 0) {
            throw RareStopped();
        }
        auto const of_ranks = comm_.gather(own);
        text = broadcast_from_root(comm_, [&] {
            auto whole = put_together(stage, count, of_ranks);
            auto const shard = head + whole;
            shards_.commit(shard_, std::as_bytes(std::span(shard)));
            return whole;
        });
        computed_ += count;
        stop_policy_.block_took(seconds_since(begin));
    }
    ++shard_;
    std::vector<std::byte> rows(text.size());
    std::memcpy(rows.data(), text.data(), text.size());
    return rows;
}

// Every size-th block of the portion, from the rank's own on.
std::string RankWorkforce::own_rows(rare::Stage const& stage, std::int64_t first, std::int64_t count,
                                    Work const& work) {
    std::string own;
    for (auto from = comm_.rank() * stage.block; from < count; from += comm_.size() * stage.block) {
        if (!stop_policy_.may_go_on()) {
            return own;
        }
        std::vector<std::byte> rows(std::min(stage.block, count - from) * stage.row_bytes);
        work(first + from, rows);
        own.append(reinterpret_cast<char const*>(rows.data()), rows.size());
    }
    return own;
}

std::string RankWorkforce::put_together(rare::Stage const& stage, std::int64_t count,
                                        std::vector<std::string> const& of_ranks) const {
    std::string whole;
    std::vector<std::size_t> taken(of_ranks.size(), 0);
    for (std::int64_t from = 0; from < count; from += stage.block) {
        auto const rank = static_cast<std::size_t>(from / stage.block) % of_ranks.size();
        auto const length = std::min(stage.block, count - from) * stage.row_bytes;
        whole += of_ranks[rank].substr(taken[rank], length);
        taken[rank] += length;
    }
    OVERTURN_ENSURE(whole.size() == count * stage.row_bytes);
    return whole;
}

}  // namespace overturn

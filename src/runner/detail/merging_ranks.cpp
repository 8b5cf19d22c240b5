#include "runner/detail/merging_ranks.hpp"

#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "results/statistics.hpp"

namespace overturn {
namespace {

// How an answer begins.
constexpr char is_done = '+';
constexpr char has_failed = '!';
constexpr char was_interrupted = '?';
constexpr std::size_t digits = 64;

}  // namespace

MergingRanks::MergingRanks(parallel::Communicator const& comm, CampaignSpec const& spec, Plan const& drawn,
                           store::ShardFolder const& shards, std::function<bool()> keep_running)
    : comm_(comm), spec_(spec), drawn_(drawn), shards_(shards), keep_running_(std::move(keep_running)) {
    help_.rows = [this](store::RowPlaces const& places, Plan const& plan) {
        Statistics sum(spec_, TrialsHeld::none);
        for (auto const& of_rank : all_do(Task::rows, fmt::format("{} {}", plan.blocks(), places.serialise()))) {
            std::istringstream in(of_rank);
            std::vector<std::int64_t> counts;
            for (std::int64_t count = 0; in >> count;) {
                counts.push_back(count);
            }
            sum.add_counts(counts);
        }
        return sum.counts();
    };
    help_.hash = [this](std::filesystem::path const& path, std::span<store::Stretch const> stretches) {
        auto text = fmt::format("{}\n", stretches.size());
        for (auto const& stretch : stretches) {
            text += fmt::format("{} {}\n", stretch.at, stretch.bytes);
        }
        std::vector<std::string> hashes;
        for (auto const& of_rank : all_do(Task::hash, text + path.string())) {
            for (std::size_t at = 0; at < of_rank.size(); at += digits) {
                hashes.push_back(of_rank.substr(at, digits));
            }
        }
        OVERTURN_ENSURE(hashes.size() == stretches.size());
        return hashes;
    };
}

void MergingRanks::run(std::function<void()> const& lead) const {
    if (!comm_.is_root()) {
        for (;;) {
            std::string text;
            comm_.broadcast(text);
            auto const task = static_cast<Task>(text.front());
            if (task == Task::leave) {
                return;
            }
            (void)comm_.gather(answer(task, text.substr(1)));
        }
    }
    auto const let_go = [&] {
        auto text = std::string(1, static_cast<char>(Task::leave));
        comm_.broadcast(text);
    };
    try {
        lead();
    } catch (InputError const&) {
        let_go();
        throw;
    } catch (SystemError const&) {
        let_go();
        throw;
    } catch (Interrupted const&) {
        let_go();
        throw;
    }
    let_go();
}

WritingHelp const* MergingRanks::help(store::Layout layout) const {
    bool const together =
        comm_.size() > 1 && layout == store::Layout::plain && !spec_.rare && Statistics::add_up(spec_);
    return together ? &help_ : nullptr;
}

void MergingRanks::remove_blocks() const {
    (void)all_do(Task::remove, {});
    shards_.remove();
}

std::vector<std::byte> MergingRanks::read(std::int64_t block) const {
    if (!keep_running_()) {
        throw Interrupted();
    }
    return shards_.read(block);
}

MergingRanks::Share MergingRanks::share_of(std::int64_t count) const {
    return {count * comm_.rank() / comm_.size(), count * (comm_.rank() + 1) / comm_.size()};
}

std::vector<std::string> MergingRanks::all_do(Task task, std::string const& text) const {
    auto whole = std::string(1, static_cast<char>(task)) + text;
    comm_.broadcast(whole);
    auto answers = comm_.gather(answer(task, text));
    bool is_time_to_go = false;
    for (auto& each : answers) {
        if (each.front() == has_failed) {
            throw SystemError(each.substr(1));
        }
        is_time_to_go = is_time_to_go || each.front() == was_interrupted;
        each.erase(0, 1);
    }
    if (is_time_to_go) {
        throw Interrupted();
    }
    return answers;
}

std::string MergingRanks::answer(Task task, std::string const& text) const {
    try {
        if (task == Task::remove) {
            auto const [first, last] = share_of(drawn_.blocks());
            shards_.remove_blocks({first, last});
            return {is_done};
        }
        return is_done + (task == Task::rows ? rows(text) : hashes(text));
    } catch (Interrupted const&) {
        return {was_interrupted};
    } catch (InputError const& error) {
        return has_failed + std::string(error.what());
    } catch (SystemError const& error) {
        return has_failed + std::string(error.what());
    }
}

std::string MergingRanks::rows(std::string const& text) const {
    auto const blank = text.find(' ');
    auto const [first, last] = share_of(std::stoll(text.substr(0, blank)));
    auto const counts = write_rows_in_place(
        spec_, drawn_, {first, last}, [&](std::int64_t block) { return read(block); },
        store::RowPlaces::deserialise(text.substr(blank + 1)));
    return fmt::format("{}", fmt::join(counts, " "));
}

std::string MergingRanks::hashes(std::string const& text) const {
    std::istringstream in(text);
    std::size_t count = 0;
    in >> count;
    std::vector<store::Stretch> stretches(count);
    for (auto& stretch : stretches) {
        in >> stretch.at >> stretch.bytes;
    }
    in.get();
    auto const path = text.substr(static_cast<std::size_t>(in.tellg()));
    auto const [first, last] = share_of(std::ssize(stretches));
    return fmt::format("{}",
                       fmt::join(store::hash_stretches(path, std::span(stretches).subspan(first, last - first)), ""));
}

}  // namespace overturn

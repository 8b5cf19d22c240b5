#include "runner/detail/merging_ranks.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/print_note.hpp"
#include "parallel/pause.hpp"
#include "results/statistics.hpp"
#include "runner/stop_policy.hpp"

namespace overturn {
namespace {

// How an answer begins.
constexpr char is_done = '+';
constexpr char has_failed = '!';
constexpr char was_interrupted = '?';
constexpr std::size_t digits = 64;
// When a share is done again: as long after the longest as that took, and a moment. The same bytes are written twice.
constexpr double done_again_after_s = 0.2, times_longest = 2;
// When nothing is left to do, all ranks end without one that stays away so many times as long as the longest share.
constexpr double hung_after_shares = 10, shortest_share_s = 1;
constexpr int ends_failed = 1;

// Of "17 text", in its place: trials of curves are hundreds of megabytes, of which no copy is made.
std::int64_t take_number(std::string& text) {
    auto const blank = text.find(' ');
    auto const number = std::stoll(text.substr(0, blank));
    text.erase(0, blank + 1);
    return number;
}

std::string with_number(std::int64_t number, std::string text) {
    text.insert(0, fmt::format("{} ", number));
    return text;
}

// Every so many-th curve: those of one body differ less than those of two.
struct PartOfCurves {
    std::int64_t part = 0, parts = 0;

    [[nodiscard]] bool holds(std::int64_t number) const { return number % parts == part; }
};

std::string fits_of(CampaignCurves const& curves, PartOfCurves const& some) {
    BytesOut fits;
    for (std::int64_t number = 0; number < curves.count(); ++number) {
        if (some.holds(number)) {
            curves.give(number, fits);
        }
    }
    return fits.take();
}

// Counts, and the trials that are held of some bodies.
void give_statistics(Statistics const& statistics, std::function<bool(std::int64_t)> const& wants, BytesOut& text) {
    text(statistics.counts());
    statistics.measured().give(wants,
                               [&](std::string const& piece) { text(std::vector<char>(piece.begin(), piece.end())); });
}

void take_statistics(Statistics& statistics, BytesIn& in) {
    std::vector<std::int64_t> counts;
    in(counts);
    statistics.add_counts(counts);
    while (!in.at_end()) {
        std::vector<char> piece;
        in(piece);
        statistics.take_trials({piece.data(), piece.size()});
    }
}

// Number of the stretch of the file in which it begins.
std::int64_t file_stretch_of(store::Stretch const& stretch) {
    return static_cast<std::int64_t>(stretch.at / store::file_stretch);
}

// The first one that begins in that stretch of the file, or after it.
store::Stretches::const_iterator first_in(store::Stretches const& stretches, std::int64_t number) {
    return stretches.lower_bound({static_cast<std::uint64_t>(number) * store::file_stretch, 0});
}

// "0 17 text"
std::pair<store::BlockRange, std::string> blocks_of(std::string text) {
    auto const first = take_number(text);
    auto const last = take_number(text);
    return {store::BlockRange{first, last}, std::move(text)};
}

}  // namespace

struct MergingRanks::Shares {
    struct Asked {
        std::size_t share;
        Clock::time_point at;
    };

    std::function<std::string(std::size_t)> task;          ///< text of a share
    std::vector<std::optional<std::string>> answers = {};  ///< of all shares
    std::map<std::int64_t, Asked> asked = {};              ///< of other ranks, by number
    double longest_s = 0;                                  ///< that one took
    Clock::time_point handed_out = Clock::now();

    [[nodiscard]] bool are_done() const {
        return std::ranges::all_of(answers, [](auto const& answer) { return answer.has_value(); });
    }
    // The first answer counts.
    void take(std::size_t share, Clock::time_point asked_at, std::string answer) {
        if (!answers[share]) {
            answers[share] = std::move(answer);
            longest_s = std::max(longest_s, seconds_since(asked_at));
        }
    }
};

MergingRanks::MergingRanks(parallel::Communicator const& comm, CampaignSpec const& spec, Plan const& drawn,
                           store::ShardFolder const& shards, std::function<bool()> keep_running)
    : comm_(comm), spec_(spec), drawn_(drawn), shards_(shards), keep_running_(std::move(keep_running)) {
    help_.rows = [this](store::RowPlaces const& places, Plan const& plan, Statistics& statistics) {
        auto const where = places.serialise();
        auto answers = all_do(Task::rows, plan.blocks(),
                              [&](Share blocks) { return fmt::format("{} {} {}", blocks.first, blocks.last, where); });
        for (auto& of_share : answers) {
            auto const text = std::exchange(of_share, {});
            BytesIn in(text);
            take_statistics(statistics, in);
        }
    };
    help_.hash = [this](std::filesystem::path const& path, store::Stretches const& stretches) {
        auto const count = stretches.empty() ? 0 : file_stretch_of(*stretches.rbegin()) + 1;
        auto const answers = all_do(Task::hash, count, [&](Share some) {
            std::vector const share(first_in(stretches, some.first), first_in(stretches, some.last));
            auto text = fmt::format("{}\n", share.size());
            for (auto const& stretch : share) {
                text += fmt::format("{} {}\n", stretch.at, stretch.bytes);
            }
            return text + path.string();
        });
        auto const all = fmt::format("{}", fmt::join(answers, ""));
        OVERTURN_ENSURE(all.size() == digits * stretches.size());
        store::StretchDigests digests_of;
        for (std::size_t at = 0; auto const& stretch : stretches) {
            digests_of.emplace(stretch, all.substr(at, digits));
            at += digits;
        }
        return digests_of;
    };
    help_.curves = [this](CampaignCurves const& curves) { return all_fit(curves); };
}

void MergingRanks::run(std::function<void()> const& lead) {
    if (!comm_.is_root()) {
        for (;;) {
            auto task = letters_.wait().text;
            auto const number = take_number(task);
            if (static_cast<Task>(task.front()) == Task::leave) {
                comm_.wait_for_all({});
                return;
            }
            letters_.send(0, with_number(number, answer(std::move(task))));
        }
    }
    try {
        lead();
    } catch (InputError const& error) {
        let_go(error.what(), ends_failed);
        throw;
    } catch (SystemError const& error) {
        let_go(error.what(), ends_failed);
        throw;
    } catch (Interrupted const&) {
        let_go("Blocks on disk are kept", ends_resumable);
        throw;
    }
    let_go("What is merged is complete", ends_resumable);
}

WritingHelp MergingRanks::help(store::Layout layout) const {
    if (comm_.size() == 1) {
        return {};
    }
    bool const together = layout == store::Layout::plain && !spec_.rare && Statistics::add_up(spec_);
    return together ? help_ : WritingHelp{.curves = help_.curves};
}

void MergingRanks::remove_blocks() {
    (void)all_do(Task::remove, drawn_.blocks(),
                 [](Share blocks) { return fmt::format("{} {} ", blocks.first, blocks.last); });
    shards_.remove();
}

std::vector<std::byte> MergingRanks::read(std::int64_t block) const {
    serve();
    return shards_.read(block);
}

void MergingRanks::serve() const {
    if (comm_.is_root()) {
        comm_.serve();
    }
    if (!keep_running_()) {
        throw Interrupted();
    }
}

// Those that have answered all, rank 0 first.
std::vector<int> MergingRanks::ready() const {
    std::vector<int> ranks;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        if (!asked_.contains(rank)) {
            ranks.push_back(rank);
        }
    }
    return ranks;
}

std::vector<std::string> MergingRanks::all_do(Task task, std::int64_t count, TextOfShare const& text) {
    auto const ranks = ready();
    std::int64_t const parts = std::ssize(ranks);
    Shares shares{[&](std::int64_t part) {
        return static_cast<char>(task) + text({count * part / parts, count * (part + 1) / parts});
    }};
    shares.answers.resize(parts);
    for (std::size_t share = 1; share < ranks.size(); ++share) {
        ask(shares, share, ranks[share]);
    }
    do_here(shares, 0);
    for (parallel::Pause pause; !shares.are_done(); pause()) {
        take_answers(shares);
        hand_out_again(shares);
    }
    longest_s_ = std::max(longest_s_, shares.longest_s);
    std::vector<std::string> answers;
    bool is_time_to_go = false;
    for (auto& each : shares.answers) {
        if (each->front() == has_failed) {
            throw SystemError(each->substr(1));
        }
        is_time_to_go = is_time_to_go || each->front() == was_interrupted;
        answers.push_back(std::move(*each));
        answers.back().erase(0, 1);
    }
    if (is_time_to_go) {
        throw Interrupted();
    }
    return answers;
}

void MergingRanks::ask(Shares& shares, std::size_t share, int rank) {
    asked_[rank] = ++numbers_;
    shares.asked.emplace(numbers_, Shares::Asked{share, Clock::now()});
    letters_.send(rank, with_number(numbers_, shares.task(share)));
}

void MergingRanks::do_here(Shares& shares, std::size_t share) const {
    auto const begin = Clock::now();
    shares.take(share, begin, answer(shares.task(share)));
}

// What a rank answers to an earlier task has a number that no share of this one has.
void MergingRanks::take_answers(Shares& shares) {
    while (auto letter = letters_.take()) {
        auto const number = take_number(letter->text);
        asked_.erase(letter->from);
        if (auto const found = shares.asked.find(number); found != shares.asked.end()) {
            shares.take(found->second.share, found->second.at, std::move(letter->text));
        }
    }
}

// Each to another rank that is ready; what is too much for these rank 0 does.
void MergingRanks::hand_out_again(Shares& shares) {
    if (seconds_since(shares.handed_out) < done_again_after_s + times_longest * shares.longest_s) {
        return;
    }
    auto const ranks = ready();
    std::size_t next = 1;
    for (std::size_t share = 0; share < shares.answers.size(); ++share) {
        if (!shares.answers[share] && next < ranks.size()) {
            ask(shares, share, ranks[next++]);
        } else if (!shares.answers[share]) {
            do_here(shares, share);
        }
    }
    shares.handed_out = Clock::now();
}

// Nothing that is durable depends on a rank which does not come.
void MergingRanks::let_go(std::string const& outcome, int code_without_all) {
    for (int rank = 1; rank < comm_.size(); ++rank) {
        letters_.send(rank, fmt::format("{} {}", ++numbers_, static_cast<char>(Task::leave)));
    }
    auto const begin = Clock::now();
    Shares none{};
    comm_.wait_for_all([&] {
        take_answers(none);
        if (seconds_since(begin) > hung_after_shares * std::max(shortest_share_s, longest_s_)) {
            (void)std::fflush(stdout);
            print_note(
                "overturn: a rank has not answered for {:.0f} s (stopped, or its node is down): all ranks end. {}\n",
                seconds_since(begin), outcome);
            comm_.abort(code_without_all);
        }
    });
    while (!asked_.empty()) {
        take_answers(none);
    }
}

std::string MergingRanks::answer(std::string text) const {
    auto const kind = static_cast<Task>(text.front());
    text.erase(0, 1);
    try {
        switch (kind) {
            case Task::rows:
                return is_done + rows(text);
            case Task::hash:
                return is_done + hashes(text);
            case Task::curves:
                return is_done + curves(text);
            case Task::remove:
            case Task::leave:
                break;
        }
        shards_.remove_blocks(blocks_of(text).first);
        return {is_done};
    } catch (Interrupted const&) {
        return {was_interrupted};
    } catch (InputError const& error) {
        return has_failed + std::string(error.what());
    } catch (SystemError const& error) {
        return has_failed + std::string(error.what());
    }
}

std::string MergingRanks::rows(std::string const& text) const {
    auto const [blocks, places] = blocks_of(text);
    auto const statistics = write_rows_in_place(
        spec_, drawn_, blocks, [&](std::int64_t block) { return read(block); }, store::RowPlaces::deserialise(places));
    BytesOut given;
    give_statistics(
        statistics, [](std::int64_t /*body*/) { return true; }, given);
    return given.take();
}

std::string MergingRanks::hashes(std::string const& text) const {
    std::istringstream in(text);
    std::size_t count = 0;
    in >> count;
    store::Stretches stretches;
    for (store::Stretch stretch; stretches.size() < count && in >> stretch.at >> stretch.bytes;) {
        stretches.insert(stretch);
    }
    in.get();
    auto const path = text.substr(static_cast<std::size_t>(in.tellg()));
    std::string digests;
    for (auto first = stretches.begin(); first != stretches.end();) {
        serve();
        auto const last = first_in(stretches, file_stretch_of(*first) + 1);
        for (auto const& [stretch, digest] : store::hash_stretches(path, {first, last})) {
            digests += digest;
        }
        first = last;
    }
    return digests;
}

// Other ranks fit to what rank 0 holds, and get of it the trials of the bodies whose curves they fit.
std::vector<MeasuredFragility> MergingRanks::all_fit(CampaignCurves const& curves) {
    all_curves_ = &curves;
    std::int64_t const parts = std::ssize(ready());
    auto const answers = all_do(Task::curves, parts, [&](Share share) {
        PartOfCurves const some{share.first, parts};
        BytesOut text;
        text(curves.options(), some);
        std::vector<bool> wanted(spec_.bodies.size());
        for (std::int64_t number = 0; number < curves.count(); ++number) {
            wanted[curves.body_of(number)] = wanted[curves.body_of(number)] || some.holds(number);
        }
        if (some.part > 0) {  // the first is rank 0's own
            give_statistics(
                curves.statistics(), [&](std::int64_t body) { return wanted[body]; }, text);
        }
        return text.take();
    });
    all_curves_ = nullptr;
    std::vector<BytesIn> of_parts(answers.begin(), answers.end());
    std::vector<MeasuredFragility> all;
    for (std::int64_t number = 0; number < curves.count(); ++number) {
        all.push_back(curves.take(number, of_parts[number % parts]));
    }
    return all;
}

std::string MergingRanks::curves(std::string const& text) const {
    AnalysisOptions options;
    PartOfCurves some;
    BytesIn in(text);
    in(options, some);
    if (all_curves_ != nullptr) {
        return fits_of(*all_curves_, some);
    }
    Statistics statistics(spec_);
    take_statistics(statistics, in);
    return fits_of(CampaignCurves(spec_, statistics, options), some);
}

}  // namespace overturn

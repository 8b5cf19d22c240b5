#include "results/rare_replayer.hpp"

#include <algorithm>
#include <complex>

#include <fmt/format.h>

#include "results/rare_results.hpp"
#include "results/stored_names.hpp"

namespace overturn {

RareReplayer::RareReplayer(store::ResultsReader const& file, CampaignSpec const& spec, std::size_t body,
                           std::size_t limit)
    : file_(file), spec_(spec), problem_(spec, body, limit), group_(rare_group(spec, body, limit)) {
    table_ = {group_ + "/rows", sizeof(RareRow), fields_of<RareRow>()};
    rows_ = file.has(group_) ? std::ssize(file.integers(group_ + "/rows/index")) : 0;
}

RareRow RareReplayer::stored(std::int64_t row) const {
    RareRow read;
    file_.rows(table_, rows_, row, std::as_writable_bytes(std::span(&read, 1)));
    return read;
}

std::vector<std::string> RareReplayer::differing(RareRow const& stored, RareRow const& again) const {
    return overturn::differing(held_in(file_, table_).columns, bytes_of(stored), bytes_of(again));
}

RareRow RareReplayer::again(RareRow const& stored, std::int64_t number) const {
    bool const mixture = stored.method == static_cast<std::int64_t>(rare::Method::pulse_mixture);
    return mixture ? again_from_mixture(stored) : again_from_chain(stored, number);
}

std::string RareReplayer::place(RareRow const& row) const {
    bool const mixture = row.method == static_cast<std::int64_t>(rare::Method::pulse_mixture);
    return mixture ? fmt::format("{}/mixture-{}/stage-{}", group_, row.run, row.stage)
                   : fmt::format("{}/subset-{}", group_, row.run);
}

rare::DrawKey RareReplayer::key_of(RareRow const& row) const {
    return {.seed = spec_.seed,
            .problem = static_cast<std::uint64_t>(row.problem),
            .replicate = static_cast<std::uint64_t>(row.replicate),
            .phase = static_cast<rare::Phase>(row.phase)};
}

void RareReplayer::answer(RareRow& row, std::span<double const> normals) const {
    auto const at = factors(row);
    std::vector<rare::Answer> answers(at.size());
    problem_.respond(normals, at, answers);
    row.failed = row.undecided = 0;
    for (std::size_t f = 0; f < answers.size(); ++f) {
        row.failed |= static_cast<std::int64_t>(answers[f].failed) << f;
        row.undecided |= static_cast<std::int64_t>(answers[f].undecided && !answers[f].failed) << f;
    }
    row.driver = answers.front().driver;
}

rare::Mixture RareReplayer::mixture_of(RareRow const& row) const {
    auto const frame = problem_.frame().value();
    auto const shares = file_.reals(place(row) + "/shares");
    auto const lines = file_.reals(place(row) + "/lines");
    auto const arrivals = file_.reals(place(row) + "/arrivals");
    auto const each = shares.size() / spec_.rare->replicates;
    auto const grid = rare::Mixture::grid_of(frame);
    std::vector<rare::Pulse> pulses(each);
    for (std::size_t c = 0; c < each; ++c) {
        auto const place = row.replicate * each + c;
        pulses[c].share = shares.at(place);
        for (std::size_t k = 0; k < frame.lines; ++k) {
            auto const at = 2 * (place * frame.lines + k);
            pulses[c].lines.emplace_back(lines.at(at), lines.at(at + 1));
        }
        auto const own = std::span(arrivals).subspan(place * grid, grid);
        pulses[c].arrival.assign(own.begin(), own.end());
    }
    return {frame, std::move(pulses)};
}

RareRow RareReplayer::again_from_mixture(RareRow row) const {
    auto key = key_of(row);
    // A pilot's draws are named by its stage, the final ones by none.
    key.level = key.phase == rare::Phase::pilot ? static_cast<std::uint64_t>(row.stage) : 0;
    key.index = row.index;
    auto const mixture = mixture_of(row);
    std::vector<double> normals(problem_.normals());
    row.plain = draw_from(mixture, key, normals) ? 1 : 0;
    row.weight = mixture.weight(normals);
    answer(row, normals);
    row.driver = never;  // of several factors none is kept
    return row;
}

std::vector<double> RareReplayer::normals_of_chain(RareRow const& row, std::int64_t number) const {
    std::vector<rare::SubsetNode> descent;
    auto at = row;
    for (auto n = number; n >= 0; n = at.parent) {
        at = stored(n);
        descent.push_back({.level = at.stage, .step = at.step, .index = at.index, .step_size = at.step_size});
    }
    std::reverse(descent.begin(), descent.end());
    for (std::size_t i = 0; i < descent.size(); ++i) {
        descent[i].parent = static_cast<std::int64_t>(i) - 1;
    }
    std::vector<double> normals(problem_.normals());
    rare::normals_of_node(descent, std::ssize(descent) - 1, key_of(row), normals);
    return normals;
}

RareRow RareReplayer::again_from_chain(RareRow row, std::int64_t number) const {
    answer(row, normals_of_chain(row, number));
    row.undecided = 0;  // not kept of chains
    return row;
}

std::vector<double> RareReplayer::factors(RareRow const& row) const { return file_.reals(place(row) + "/factors"); }

}  // namespace overturn

#include "generators/detail/recorded_waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"

namespace overturn {
namespace {

using Samples = std::vector<double>;

WaveDescription description_of(std::span<Record const> records) {
    auto const noun = [&](std::string_view one) { return fmt::format("{}{}", one, records.size() == 1 ? "" : "s"); };
    constexpr std::size_t most = 20;
    WaveDescription about{.text = fmt::format("{} {}", records.size(), noun("record")),
                          .variability = fmt::format("{} recorded {}, as chosen", records.size(), noun("motion")),
                          .available = records.size()};
    for (auto const& record : records) {
        if (about.measured.size() < most) {
            about.text += fmt::format("{} {}", about.measured.empty() ? ":" : ";", record.label);
        }
        auto const has = [&](Samples const& component) { return !record.withheld.empty() || peak_of(component) > 0; };
        about.measured.push_back(
            {record.name, record.drift, has(record.motion.transverse_mps2), has(record.motion.vertical_mps2)});
    }
    std::map<std::string_view, std::int64_t> numbers;
    std::map<std::int64_t, std::int64_t> rows;
    for (auto const& record : records) {
        auto const [at, is_new] = numbers.try_emplace(record.recording, std::ssize(numbers));
        about.shared.of.push_back(at->second);
        about.shared.most = std::max(about.shared.most, ++rows[at->second]);
    }
    if (about.shared.most == 1) {
        about.shared.of.clear();
    } else {
        about.variability =
            fmt::format("{} recorded motions of {} recordings, as chosen", records.size(), numbers.size());
    }
    about.text += records.size() > most ? fmt::format("; and {} more", records.size() - most) : "";
    return about;
}

class Records : public WaveSource {
  public:
    explicit Records(std::vector<Record> records) : WaveSource(description_of(records)), records_(std::move(records)) {}

    [[nodiscard]] GeneratedWave make(std::uint64_t /*seed*/, std::uint64_t wave) const override {
        validate_wave(wave, records_.size());
        validate(records_[wave].withheld.empty(),
                 "record {} (withheld: only its hash is there). Put it beside the file", records_[wave].withheld);
        GeneratedWave made;
        made.motion = records_[wave].motion;
        made.label = records_[wave].label;
        made.turned_rad = records_[wave].turned_rad;
        return made;
    }

  private:
    std::vector<Record> records_;
};

std::ptrdiff_t strongest_of(Samples const& x) {
    return std::ranges::max_element(x, {}, [](double value) { return std::abs(value); }) - x.begin();
}

// By what `of` was multiplied to give `like`, whose samples come `later`; zero outside of either. \param strongest
// sample of `of`, from which on they are compared: two motions that differ do so there at once
std::optional<double> multiple(Samples const& of, std::ptrdiff_t strongest, Samples const& like, std::ptrdiff_t later) {
    auto const at = [](Samples const& x, std::ptrdiff_t i) { return i < 0 || i >= std::ssize(x) ? 0 : x[i]; };
    if (of.empty() || at(of, strongest) == 0) {
        return of.empty() == like.empty() && peak_of(like) == 0 ? std::optional(1.0) : std::nullopt;
    }
    double const there = at(like, strongest + later);
    double const factor = there / at(of, strongest);
    auto const begin = std::min<std::ptrdiff_t>(0, -later);
    auto const count = std::max(std::ssize(of), std::ssize(like) - later) - begin;
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        auto const i = begin + (strongest - begin + k) % count;
        if (std::abs(at(like, i + later) - factor * at(of, i)) > same_motion_share * std::abs(there)) {
            return std::nullopt;
        }
    }
    return factor == 0 ? std::nullopt : std::optional(factor);
}

std::optional<double> multiple(Samples const& of, Samples const& like, std::ptrdiff_t later) {
    return multiple(of, strongest_of(of), like, later);
}

}  // namespace

std::optional<SameMotion> same_motion_twice(std::span<Record const> records) {
    std::vector<std::ptrdiff_t> strongest;
    for (std::size_t second = 0; second < records.size(); ++second) {
        auto const& b = records[second].motion;
        strongest.push_back(strongest_of(b.horizontal_mps2));
        for (std::size_t first = 0; first < second && records[second].withheld.empty(); ++first) {
            auto const& a = records[first].motion;
            if (!records[first].withheld.empty() || a.time_step_s != b.time_step_s) {
                continue;
            }
            auto const later = strongest[second] - strongest[first];
            auto const factor = multiple(a.horizontal_mps2, strongest[first], b.horizontal_mps2, later);
            if (factor && multiple(a.transverse_mps2, b.transverse_mps2, later)
                && multiple(a.vertical_mps2, b.vertical_mps2, later)) {
                return SameMotion{first, second, *factor};
            }
        }
    }
    return std::nullopt;
}

std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records) {
    return std::make_unique<Records>(std::move(records));
}

}  // namespace overturn

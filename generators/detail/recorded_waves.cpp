#include "generators/detail/recorded_waves.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "core/error.hpp"

namespace overturn {
namespace {

WaveDescription description_of(std::span<Record const> records) {
    auto const noun = [&](std::string_view one) { return fmt::format("{}{}", one, records.size() == 1 ? "" : "s"); };
    constexpr std::size_t most = 20;
    WaveDescription about{.text = fmt::format("{} {}", records.size(), noun("record")),
                          .variability = fmt::format("{} measured {}, as chosen", records.size(), noun("motion")),
                          .available = records.size()};
    for (auto const& record : records) {
        if (about.measured.size() < most) {
            about.text += fmt::format("{} {}", about.measured.empty() ? ":" : ";", record.label);
        }
        about.measured.push_back({record.name, record.drift});
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

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> same_motion_twice(std::span<Record const> records) {
    auto const key = [](Record const& record) {
        return std::tie(record.motion.time_step_s, record.motion.horizontal_mps2, record.motion.transverse_mps2,
                        record.motion.vertical_mps2);
    };
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (records[i].withheld.empty()) {
            order.push_back(i);
        }
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return key(records[a]) < key(records[b]); });
    auto const same = std::ranges::adjacent_find(
        order, [&](std::size_t a, std::size_t b) { return key(records[a]) == key(records[b]); });
    return same == order.end() ? std::nullopt : std::optional(std::pair(*same, *std::next(same)));
}

std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records) {
    return std::make_unique<Records>(std::move(records));
}

}  // namespace overturn

#include "generators/detail/recorded_waves.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"

namespace overturn {
namespace {

class Records : public WaveSource {
  public:
    explicit Records(std::vector<Record> records) : records_(std::move(records)) {}

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

    [[nodiscard]] std::optional<std::uint64_t> available() const override { return records_.size(); }

    [[nodiscard]] std::optional<Drift> drift(std::uint64_t wave) const override {
        validate_wave(wave, records_.size());
        return records_[wave].drift;
    }

    [[nodiscard]] std::string name(std::uint64_t wave) const override {
        validate_wave(wave, records_.size());
        return records_[wave].name;
    }

    [[nodiscard]] std::string variability() const override {
        return fmt::format("{} measured motion{}, as chosen", records_.size(), records_.size() == 1 ? "" : "s");
    }
    [[nodiscard]] std::string describe() const override {
        constexpr std::size_t most = 20;
        auto text = fmt::format("{} record{}", records_.size(), records_.size() == 1 ? "" : "s");
        for (std::size_t i = 0; i < std::min(most, records_.size()); ++i) {
            text += fmt::format("{} {}", i == 0 ? ":" : ";", records_[i].label);
        }
        return records_.size() > most ? fmt::format("{}; and {} more", text, records_.size() - most) : text;
    }

  private:
    std::vector<Record> records_;
};

}  // namespace

std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records) {
    return std::make_unique<Records>(std::move(records));
}

}  // namespace overturn

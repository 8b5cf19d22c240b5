#include "generators/detail/recorded_waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

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

// A motion and where it is strongest, by which two of them are laid over each other.
struct Shape {
    GroundMotion const* motion = nullptr;
    std::size_t record = 0;
    std::ptrdiff_t strongest = 0;  // sample
};

Shape shape_of(GroundMotion const& motion, std::size_t record) {
    auto const& h = motion.horizontal_mps2;
    auto const strongest = std::ranges::max_element(h, {}, [](double x) { return std::abs(x); });
    return {&motion, record, strongest - h.begin()};
}

// By what `of` was multiplied to give `like`, whose samples come `later`; zero outside of either. From the strongest
// sample on, where two motions that differ do so at once.
std::optional<double> multiple(std::vector<double> const& of, std::vector<double> const& like, std::ptrdiff_t later) {
    constexpr double same = 1e-3;  // of the strongest: copies are rounded where they are written
    auto const at = [](std::vector<double> const& x, std::ptrdiff_t i) {
        return i < 0 || i >= std::ssize(x) ? 0 : x[static_cast<std::size_t>(i)];
    };
    if (of.empty() || like.empty()) {
        return of.empty() && like.empty() ? std::optional(1.0) : std::nullopt;
    }
    auto const begin = std::min<std::ptrdiff_t>(0, -later);
    auto const end = std::max(std::ssize(of), std::ssize(like) - later);
    auto const peak = std::ranges::max_element(of, {}, [](double x) { return std::abs(x); }) - of.begin();
    if (at(of, peak) == 0) {
        return peak_of(like) == 0 ? std::optional(1.0) : std::nullopt;
    }
    double const factor = at(like, peak + later) / at(of, peak);
    double const slack = same * std::abs(at(like, peak + later));
    auto const differs = [&](std::ptrdiff_t i) { return std::abs(at(like, i + later) - factor * at(of, i)) > slack; };
    for (auto i = peak; i < end; ++i) {
        if (differs(i)) {
            return std::nullopt;
        }
    }
    for (auto i = begin; i < peak; ++i) {
        if (differs(i)) {
            return std::nullopt;
        }
    }
    return factor == 0 ? std::nullopt : std::optional(factor);
}

// Of the horizontal one, where all components are multiples and begin alike.
std::optional<double> factor_between(Shape const& one, Shape const& other) {
    auto const later = other.strongest - one.strongest;
    auto const& a = *one.motion;
    auto const& b = *other.motion;
    if (a.time_step_s != b.time_step_s) {
        return std::nullopt;
    }
    auto const factor = multiple(a.horizontal_mps2, b.horizontal_mps2, later);
    bool const all = factor && multiple(a.transverse_mps2, b.transverse_mps2, later)
                     && multiple(a.vertical_mps2, b.vertical_mps2, later);
    return all ? factor : std::nullopt;
}

}  // namespace

std::optional<SameMotion> same_motion_twice(std::span<Record const> records) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (records[i].withheld.empty()) {
            shapes.push_back(shape_of(records[i].motion, i));
        }
    }
    for (auto one = shapes.begin(); one != shapes.end(); ++one) {
        for (auto other = shapes.begin(); other != one; ++other) {
            if (auto const factor = factor_between(*other, *one)) {
                return SameMotion{other->record, one->record, *factor};
            }
        }
    }
    return std::nullopt;
}

std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records) {
    return std::make_unique<Records>(std::move(records));
}

}  // namespace overturn

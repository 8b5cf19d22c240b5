#include "generators/detail/aftershock.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace overturn {
namespace {

constexpr double longest_s = 3600;
constexpr double strongest = 10;
constexpr config::Keys second_shock_keys{
    config::number_key("pause", Dimension::time, {.low = 0, .high = longest_s},
                       "time without motion before the second shock"),
    config::number_key("scale", Dimension::none, {.low = 0, .high = strongest, .low_open = true},
                       "factor on the second shock")
        .otherwise(1)};
constexpr config::KeyTable second_shock_table{.meaning = "second, independent shock after every wave",
                                              .keys = second_shock_keys.all};
constexpr config::Keys aftershock_keys{
    config::table_key<second_shock_table>("aftershock", "a second shock after every wave").optional()};

struct Aftershock {
    double scale = 1, pause_s = 0;
};

class MainshockAndAftershock : public WaveSource {
  public:
    MainshockAndAftershock(std::unique_ptr<WaveSource> shocks, Aftershock const& second)
        : WaveSource(both(shocks->about(), second)), shocks_(std::move(shocks)), second_(second) {}

    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const override {
        return joined(shocks_->make(seed, wave), shocks_->make(seed, of_aftershock(wave)));
    }
    [[nodiscard]] GeneratedWave make_unjudged(std::uint64_t seed, std::uint64_t wave) const override {
        return joined(shocks_->make_unjudged(seed, wave), shocks_->make_unjudged(seed, of_aftershock(wave)));
    }
    [[nodiscard]] std::string pgd_drift() const override { return shocks_->pgd_drift(); }
    [[nodiscard]] std::string text() const override { return shocks_->text() + text_of(second_); }
    void prepare(ShareRows const& share) const override { shocks_->prepare(share); }

  private:
    static std::string text_of(Aftershock const& second) {
        return fmt::format("; then, after {:g} s of quiet, an independent one times {:g}", second.pause_s,
                           second.scale);
    }
    static WaveDescription both(WaveDescription about, Aftershock const& second) {
        about.text += text_of(second);
        about.stated_sigma.reset();  // of single shocks
        return about;
    }

    // Waves are numbered below this bit: an aftershock's streams are no other wave's.
    static std::uint64_t of_aftershock(std::uint64_t wave) { return wave | std::uint64_t{1} << 63U; }

    [[nodiscard]] GeneratedWave joined(GeneratedWave first, GeneratedWave const& second) const {
        std::size_t const quiet = std::lround(second_.pause_s / first.motion.time_step_s);
        for (auto const component :
             {&GroundMotion::horizontal_mps2, &GroundMotion::transverse_mps2, &GroundMotion::vertical_mps2}) {
            auto& samples = first.motion.*component;
            if (samples.empty()) {
                continue;
            }
            samples.resize(samples.size() + quiet, 0.0);
            for (double const a : second.motion.*component) {
                samples.push_back(second_.scale * a);
            }
        }
        for (std::size_t i = 0; i < first.clauses.size() && i < second.clauses.size(); ++i) {
            if (!second.clauses[i].passed()) {
                first.clauses[i] = second.clauses[i];
            }
        }
        first.label += fmt::format(", with an aftershock: {}", second.label);
        return first;
    }

    std::unique_ptr<WaveSource> shocks_;
    Aftershock second_;
};

}  // namespace

constinit config::KeyTable const aftershock_table{.meaning = "of waves that are drawn", .keys = aftershock_keys.all};

std::unique_ptr<WaveSource> with_aftershock(config::Table const& waves, std::unique_ptr<WaveSource> source) {
    if (!waves.has("aftershock")) {
        return source;
    }
    auto const given = waves.child(aftershock_keys["aftershock"]);
    Aftershock second;
    second.scale = given.number(second_shock_keys["scale"]);
    second.pause_s = given.number(second_shock_keys["pause"]);
    given.finish();
    if (source->about().available) {
        waves.fail("aftershock",
                   "of waves that are not drawn (there is no independent one of the same kind to follow). Use "
                   "spectrum-compatible or filtered-noise, or join records in their files");
    }
    return std::make_unique<MainshockAndAftershock>(std::move(source), second);
}

}  // namespace overturn

#include "campaign/detail/known_rows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace overturn {
namespace {

bool same_bits_of(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

// Two motions of one number that agree in all of these are one.
bool same_motion(WaveRow const& a, WaveRow const& b) {
    constexpr std::array measures{&WaveRow::duration_s,
                                  &WaveRow::pga_mps2,
                                  &WaveRow::pgv_mps,
                                  &WaveRow::pgd_m,
                                  &WaveRow::arias_mps,
                                  &WaveRow::vector_pga_mps2,
                                  &WaveRow::transverse_pga_mps2,
                                  &WaveRow::vertical_pga_mps2,
                                  &WaveRow::turned_rad};
    return a.id == b.id && a.failed == b.failed && a.accepted == b.accepted
           && std::ranges::all_of(measures,
                                  [&](double WaveRow::*measure) { return same_bits_of(a.*measure, b.*measure); });
}

bool same_trial(TrialRow const& a, TrialRow const& b) {
    constexpr std::array values{&TrialRow::amplitude,        &TrialRow::scale,       &TrialRow::mass_kg,
                                &TrialRow::centre_height_m,  &TrialRow::restitution, &TrialRow::static_friction,
                                &TrialRow::kinetic_friction, &TrialRow::v_ereq_mps};
    return std::ranges::all_of(values, [&](double TrialRow::*value) { return same_bits_of(a.*value, b.*value); });
}

}  // namespace

KnownRows::KnownRows(std::optional<KnownWave> known, WaveRow const& wave) : known_(std::move(known)) {
    if (known_ && !same_motion(known_->row, wave)) {
        known_.reset();
    }
}

bool KnownRows::take(std::size_t place, TrialRow& open, std::span<std::byte> extra) const {
    if (!known_ || !known_->known.at(place) || !same_trial(known_->trials.rows[place], open)) {
        return false;
    }
    auto row = known_->trials.rows[place];
    row.wave = open.wave;
    row.body = open.body;
    row.level = open.level;
    open = row;
    std::ranges::copy(std::span(known_->trials.extra).subspan(place * extra.size(), extra.size()), extra.begin());
    return true;
}

}  // namespace overturn

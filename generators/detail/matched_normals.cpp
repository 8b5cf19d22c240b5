#include "generators/detail/matched_normals.hpp"

namespace overturn {
namespace {

std::size_t normals_of(MatchedNormals::Part const& part) { return 2 * (part.matcher->uncalibrated().count() - 1); }

}  // namespace

std::size_t MatchedNormals::normals() const {
    std::size_t all = 0;
    for (auto const& part : parts_) {
        all += normals_of(part);
    }
    return all;
}

GroundMotion MatchedNormals::make(std::span<double const> normals) const {
    GroundMotion motion;
    motion.time_step_s = time_step_s_;
    std::size_t taken = 0;
    for (auto const& part : parts_) {
        motion.*(part.place) = part.matcher->of_normals(normals.subspan(taken, normals_of(part)));
        taken += normals_of(part);
    }
    return motion;
}

std::optional<NormalWaves::LinearLines> MatchedNormals::linear() const {
    auto const& horizontal = *parts_.front().matcher;
    if (horizontal.iterates() || !horizontal.uncalibrated().is_gaussian()) {
        return std::nullopt;
    }
    return LinearLines{horizontal.uncalibrated().count() - 1, horizontal.uncalibrated().spacing_radps()};
}

}  // namespace overturn

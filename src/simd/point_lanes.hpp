/// Lanes of bodies that stand on points: fields of the body, and fields of each point.
#pragma once

#include <array>
#include <cstddef>

#include "simd/lane_fields.hpp"

namespace overturn::simd {

/// \tparam Field, Wave as of LaneFields \tparam Spot an enum of the numbers that each point holds, `count` the last
template <class Field, class Wave, class Spot, int MostPoints, int Lanes> struct PointLanes {
    static constexpr std::size_t spots = static_cast<std::size_t>(Spot::count);

    LaneFields<Field, Wave, Lanes> body;
    alignas(64) std::array<double, MostPoints * spots * Lanes> bed{};  ///< point by point
    int points = 0;                                                    ///< the same in all lanes

    [[nodiscard]] double& at(Spot spot, int point, int lane) { return bed[place(spot, point, lane)]; }
    [[nodiscard]] double at(Spot spot, int point, int lane) const { return bed[place(spot, point, lane)]; }

    void copy_lane(int from, int to) {
        body.copy_lane(from, to);
        for (std::size_t row = 0; row < points * spots; ++row) {
            bed[row * Lanes + to] = bed[row * Lanes + from];
        }
    }

    /// A lane of others, which have as many points or are to give these theirs.
    template <int From>
    void take_lane(PointLanes<Field, Wave, Spot, MostPoints, From> const& from, int from_lane, int to_lane) {
        points = from.points;
        for (int field = 0; field < static_cast<int>(Field::count); ++field) {
            body.at(Field{field}, to_lane) = from.body.at(Field{field}, from_lane);
        }
        for (int wave = 0; wave < static_cast<int>(Wave::count); ++wave) {
            body.at(Wave{wave}, to_lane) = from.body.at(Wave{wave}, from_lane);
        }
        for (int point = 0; point < points; ++point) {
            for (int spot = 0; spot < static_cast<int>(Spot::count); ++spot) {
                at(Spot{spot}, point, to_lane) = from.at(Spot{spot}, point, from_lane);
            }
        }
    }

  private:
    [[nodiscard]] static std::size_t place(Spot spot, int point, int lane) {
        return (static_cast<std::size_t>(point) * spots + static_cast<std::size_t>(spot)) * Lanes
               + static_cast<std::size_t>(lane);
    }
};

}  // namespace overturn::simd

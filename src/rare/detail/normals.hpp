/// Standard normals by identity, thousands at a time.
#pragma once

#include <span>

#include "rare/draw_key.hpp"

namespace overturn::rare {

/// Fills with independent standard normals: the stream of Purpose::rare_normals by Box and Muller (1958), the words of
/// a pair giving radius and angle. Of a radius 52 bits are kept, so that none lies beyond 8.49; the same bits on every
/// machine. Fewer numbers of one key are the first ones of more.
void draw_normals(DrawKey const& key, std::span<double> normals);

}  // namespace overturn::rare

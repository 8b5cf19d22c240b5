/// Time that a body is followed after its motion.
#pragma once

namespace overturn {

/// After the last sample energy decides of a rigid body that only rocks; what has slipped, and every body on points, is
/// followed until it rests, for this long at most [s]. A body that slides at v still slides then where its kinetic
/// friction is below v / (60 s g), 0.0005 for 0.3 m/s; its slip is what it was by then.
inline constexpr double longest_after_s = 60;
/// Interval of the checks for rest, in samples of the motion.
inline constexpr int run_out_samples = 8;

}  // namespace overturn

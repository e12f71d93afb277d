// SPDX-License-Identifier: MIT
//
// Smooth correction of wrong poses: the difference between the rendered pose and the correct one is
// preserved at first, so that nothing jumps, and then decays. Its half-life is 0.1 s. The
// correction moves at most at 1.1 m/s (18 mm per frame at 60 frames per second) and 1.5 rad/s, or
// at 0.35 times the speed of the body if that is more. An error that would take more than 3 s at
// that speed is not smoothed: the body jumps.
#pragma once

#include <array>

#include "jostle/snapshot/quantize.h"

namespace jostle::client {

/// The difference between a rendered and a correct pose.
struct PoseError {
    std::array<double, 3> position{};            ///< m, rendered minus correct
    std::array<double, 4> rotation{0, 0, 0, 1};  ///< from correct to rendered

    /// There is no error.
    bool none() const { return position == std::array<double, 3>{} && rotation[3] == 1; }
};

/// Linear speed (m/s) and angular speed (rad/s) of a body.
struct BodySpeed {
    double speed = 0, spin = 0;
};

/// The error of `rendered` against the correct pose `target`.
PoseError pose_error(const snapshot::Pose& rendered, const snapshot::Pose& target);
/// The pose to render: `target` plus the error.
snapshot::Pose apply_error(const snapshot::Pose& target, const PoseError& error);
/// The remaining error after `seconds`.
PoseError decayed(const PoseError& error, const BodySpeed& body_speed, double seconds);
/// The error, or none if it is too large to be smoothed.
PoseError smoothable_error(const PoseError& error, const BodySpeed& body_speed);

}  // namespace jostle::client

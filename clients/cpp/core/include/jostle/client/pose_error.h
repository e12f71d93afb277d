// SPDX-License-Identifier: MIT
//
// What was shown wrongly, and how it is made good: the difference between a pose that was shown and
// the one that is right stays at first, so that nothing jumps, and is then walked off. Its
// half-life is 0.1 s, and it moves at most at 1.1 m/s (18 mm a picture at 60 a second) and 1.5
// rad/s, or at 0.35 of the speed of its body where that is more. What would take more than 3 s at
// that speed is not walked: the body jumps.
#pragma once

#include <array>

#include "jostle/snapshot/quantize.h"

namespace jostle::client {

struct PoseError {
    std::array<double, 3> position{};            // m, shown less right
    std::array<double, 4> rotation{0, 0, 0, 1};  // from right to shown

    bool none() const { return position == std::array<double, 3>{} && rotation[3] == 1; }
};

// Of a body that moves at so many m/s and turns at so many rad/s.
struct BodySpeed {
    double speed = 0, spin = 0;
};

PoseError pose_error(const wire::Pose& rendered, const wire::Pose& target);
wire::Pose apply_error(const wire::Pose& target, const PoseError& error);
// What is left of it after so many seconds.
PoseError decayed(const PoseError& error, const BodySpeed& body_speed, double seconds);
// The error, or none when it is too great to be walked.
PoseError smoothable_error(const PoseError& error, const BodySpeed& body_speed);

}  // namespace jostle::client

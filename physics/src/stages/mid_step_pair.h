// SPDX-License-Identifier: MIT
//
// Contacts centred in time. Where bodies roll or rock on each other the normal and the point of
// contact go along. Those of the start of the step lag behind the motion by half a step, and a
// force that lags behind the way which it opposes feeds it: what swings with an angular frequency
// of w gains w^2 dt / 4 of its amplitude in a second (a plank on a ball would double its swing in
// 20 s). So what is in touch is looked at where it will be in the middle of the step, which makes
// contacts of second order in dt, as the midpoint rule is.
#pragma once

#include "collision/narrowphase/manifold.h"
#include "state/world_state.h"

namespace jostle::physics {

class MidStepPair {
public:
    // `way`, m: how far the two may move against each other in the step, at most.
    MidStepPair(const WorldState& world, const Contact& contact, double way, double dt);

    // Where they will be, as they move now.
    const Placed& shape_a() const { return a_.shape; }
    const Placed& shape_b() const { return b_.shape; }

    // From a manifold as it will be to its gaps at the start of the step, and to points from which
    // the solver gets to where they will be (BlockBodies::follow).
    void count_back(Manifold& manifold) const;
    // m: how much nearer two points may be at the start of the step.
    double way_ahead() const { return way_ahead_; }

private:
    struct Side {
        Side(const WorldState& world, std::uint32_t body, std::uint32_t shape, double time);
        Vec3 velocity_at(Vec3 point) const;

        Vec3 v, w, center;
        Placed shape;
    };

    double time_;  // s, from the start of the step
    double way_ahead_;
    double share_;
    Side a_, b_;
};

double smallest_gap(const Manifold& manifold);  // m

}  // namespace jostle::physics

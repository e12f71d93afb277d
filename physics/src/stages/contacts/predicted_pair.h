// SPDX-License-Identifier: MIT
//
// A pair as it will be later in the step, if both go on as they move now. Contacts hold for a whole
// step, and those of its start are old when they are needed:
//
// - Where bodies roll or rock on each other, normal and point of contact go along. A force that
//   lags half a step behind the motion that it opposes feeds it: what swings with an angular
//   frequency of w gains w^2 dt / 4 of its amplitude in a second (a plank on a ball would double
//   its swing in 20 s). So what is in touch is looked at in the middle of the step, which makes
//   contacts of second order in dt, as the midpoint rule is.
// - What comes from afar touches elsewhere than where it is nearest now. So it is looked at where
//   it meets.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

class PredictedPair {
public:
    // `time`: s from the start of the step.
    PredictedPair(const WorldState& world, const Contact& contact, double time);

    double time() const { return time_; }
    const TransformedShape& shape_a() const { return a_.shape; }
    const TransformedShape& shape_b() const { return b_.shape; }

    // Takes a manifold of that time back to the start of the step: its gaps become those of the
    // start, its points those from which the solver gets to where they will be
    // (PairBodies::follow). `way`, m: how far the two may move against each other until then, at
    // most; two that do not touch may be nearer by it.
    void rewind_manifold(Manifold& manifold, double displacement) const;

private:
    struct Side {
        Side(const WorldState& world, std::uint32_t body, std::uint32_t shape, double time);
        Vec3 velocity_at(Vec3 point) const;

        Vec3 v, w, center;
        TransformedShape shape;
    };

    double time_;
    double anchor_blend_;
    Side a_, b_;
};

// s from the start of the step: the middle of its forces, for two that touch and move against each
// other by `way`, m; else 0.
double midpoint_time(const WorldState& world, const Contact& contact, double displacement,
                     double dt);

// s from the start of the step: when two meet in it; 0 if they touch now, nothing if they do not.
std::optional<double> time_to_contact(const WorldState& world, const Contact& contact, double dt);

double smallest_gap(const Manifold& manifold);  // m

}  // namespace jostle::physics

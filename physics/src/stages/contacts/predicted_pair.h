// SPDX-License-Identifier: MIT
//
// The predicted poses of a pair later in the step, at the current velocities. Contacts are valid
// for a whole step, and contacts found at its start are outdated when they are used:
//
// - If bodies roll or rock on each other, the normal and the contact point move. A force that lags
//   half a step behind the motion that it opposes adds energy: an oscillation with angular
//   frequency w grows by w^2 dt / 4 of its amplitude per second (a plank on a ball would double
//   its swing in 20 s). Touching pairs are therefore tested at the middle of the step, which makes
//   contacts second-order accurate in dt, like the midpoint rule.
// - A body that approaches from a distance touches at a place other than its current closest
//   point. It is tested at its time of contact.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

class PredictedPair {
public:
    // `time`: s from the start of the step.
    PredictedPair(const ShapedBodies& stores, const Contact& contact, double time);

    double time() const { return time_; }
    const TransformedShape& shape_a() const { return a_.shape; }
    const TransformedShape& shape_b() const { return b_.shape; }

    // Transforms a manifold from that time back to the start of the step. Its gaps become those at
    // the start, and its points those from which the solver reaches the predicted points
    // (PairBodies::follow). `displacement`: upper bound of the relative displacement until then, m.
    // A pair that does not touch may be closer by that distance.
    void rewind_manifold(Manifold& manifold, double displacement) const;

private:
    struct Side {
        Side(const ShapedBodies& stores, std::uint32_t body, std::uint32_t shape, double time);
        Vec3 velocity_at(Vec3 point) const;

        Vec3 v, w, center;
        TransformedShape shape;
    };

    double time_;
    double anchor_blend_;
    Side a_, b_;
};

// s from the start of the step: the mean time of the forces of a touching pair with a relative
// displacement of `displacement` metres; 0 if it is too small to matter.
double time_of_forces(const ContactGraph& stores, const Contact& contact, double displacement,
                      double dt);
// The same; 0 for a pair that does not touch.
double midpoint_time(const ContactGraph& stores, const Contact& contact, double displacement,
                     double dt);

// s from the start of the step: the time of contact in it. 0 if the pair touches now, nullopt if it
// does not touch.
std::optional<double> time_to_contact(const ShapedBodies& stores, const Contact& contact,
                                      double dt);

// A shape as predicted `time` seconds from the start of the step.
TransformedShape predicted_shape(const ShapedBodies& stores, std::uint32_t shape, double time);

double smallest_gap(const Manifold& manifold);  // m

}  // namespace jostle::physics

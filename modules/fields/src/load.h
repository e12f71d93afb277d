// SPDX-License-Identifier: MIT
//
// One body in one sub-step and the impulses of all fields on it. Each field sees the velocities
// changed by the previous fields.
#pragma once

#include "jostle/physics/step_listener.h"
#include "modules/fields/src/body_field_cache.h"

namespace jostle::modules::fields_detail {

struct Load {
    physics::MovingBody body;
    const BodyFieldData& record;
    physics::Vec3 gravity;                             // m/s^2
    double time;                                       // s, in the middle of the sub-step
    double h;                                          // s
    physics::Vec3 impulse = {}, angular_impulse = {};  // N s at the centre of mass, N m s

    void push(physics::Vec3 change) {  // N s
        impulse += change;
        body.linear_velocity += change * (1 / body.mass);
    }
    // Changes the angular velocity by the given amount, assuming free rotation.
    void turn(physics::Vec3 spin_change) {  // rad/s
        using namespace physics;
        const Mat3 axes = to_matrix(body.pose.rotation);
        angular_impulse += axes * (record.inertia * transposed_times(axes, spin_change));
        body.angular_velocity += spin_change;
    }
    physics::Mat3 inertia() const {
        const physics::Mat3 axes = to_matrix(body.pose.rotation);
        return axes * record.inertia * transpose(axes);
    }
    // Quadratic drag in a medium: du/dt = -k |u| u has the solution u / (1 + k |u| h), with u the
    // velocity of the body relative to the medium. Other accelerations of the sub-step are applied
    // half before and half after the drag (G. Strang, "On the construction and comparison of
    // difference schemes", 1968). This is second-order accurate and does not drag a body at rest.
    template <class AreaAlong>
    void drag(physics::Vec3 flow, double density, double coefficient, AreaAlong&& area_along,
              physics::Vec3 acceleration) {
        using namespace physics;
        const Vec3 u = flow - body.linear_velocity - acceleration * (0.5 * h);
        const double speed = length(u);
        if (!(speed > 1e-9) || density == 0 || coefficient == 0) return;
        const double area = area_along(u * (1 / speed));
        const double k = 0.5 * density * coefficient * area / body.mass;
        push(u * (body.mass * (1 - 1 / (1 + k * speed * h))));
    }
};

}  // namespace jostle::modules::fields_detail

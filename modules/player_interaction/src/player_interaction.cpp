// SPDX-License-Identifier: MIT
#include "jostle/modules/player_interaction.h"

#include <algorithm>

namespace jostle::modules {

using namespace physics;

namespace {

constexpr double impulse_speed_max = 20, pushed_speed_max = 50;  // m/s
constexpr double pushed_spin_max = 60;                           // rad/s
constexpr double impulse_reach_max = 2;                          // m

// soft enough to drag without shaking
constexpr JointSpring grab_spring{.hertz = 5, .damping_ratio = 1};
constexpr double acceleration_max = 200;  // m/s^2, limits the force of a grab
constexpr double angular_damping = 4;  // 1/s: damps the spin of a grabbed body about the grab point

Vec3 capped(Vec3 now, Vec3 before, double cap) {
    const double most = std::max(cap, length(before)), size = length(now);
    return size > most ? now * (most / size) : now;
}

}  // namespace

Status apply_player_impulse(World& world, const BodyState& body, Vec3 impulse,
                            std::optional<Vec3> point) {
    const double most = body.mass * impulse_speed_max, size = length(impulse);
    if (size > most) impulse = impulse * (most / size);
    const Vec3 arm = point.value_or(body.center) - body.center;
    const double far = length(arm);
    if (!point || far <= impulse_reach_max)
        return apply_limited_impulse(world, body, impulse, point.value_or(body.center));
    return apply_limited_impulse(world, body, impulse,
                                 body.center + arm * (impulse_reach_max / far));
}

Status apply_limited_impulse(World& world, const BodyState& body, Vec3 impulse, Vec3 point,
                             Vec3 angular_impulse) {
    if (Status s = world.apply_impulse(body.id, impulse, point); !s.ok()) return s;
    if (Status s = world.apply_angular_impulse(body.id, angular_impulse); !s.ok()) return s;
    const BodyState pushed = *world.body(body.id);
    const Vec3 v = capped(pushed.linear_velocity, body.linear_velocity, pushed_speed_max);
    if (!(v == pushed.linear_velocity))
        if (Status s = world.set_linear_velocity(body.id, v); !s.ok()) return s;
    const Vec3 w = capped(pushed.angular_velocity, body.angular_velocity, pushed_spin_max);
    if (w == pushed.angular_velocity) return {};
    return world.set_angular_velocity(body.id, w);
}

JointDef make_grab_joint(const BodyState& body, Vec3 point) {
    return {.body_b = body.id,
            .frame_b = {.position = apply_inverse(body.pose, point)},
            .kind = GrabJoint{.target = point,
                              .spring = grab_spring,
                              .max_force = body.mass * acceleration_max,
                              .angular_damping = angular_damping}};
}

}  // namespace jostle::modules

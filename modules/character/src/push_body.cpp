// SPDX-License-Identifier: MIT
#include "modules/character/src/sweep_parts.h"

namespace jostle::modules::character_detail {
using namespace physics;

namespace {

// Compliance of a point of the body along a unit direction, 1/kg; 0 if the body cannot move. If any
// rotation axis is locked, all are treated as locked.
double compliance(const BodyState& body, Vec3 point, Vec3 direction) {
    if (!(body.mass > 0)) return 0;
    const Vec3 free{(body.locks & lock_x) != 0 ? 0.0 : direction.x,
                    (body.locks & lock_y) != 0 ? 0.0 : direction.y,
                    (body.locks & lock_z) != 0 ? 0.0 : direction.z};
    const double straight = length_squared(free) / body.mass;
    if ((body.locks & (lock_rotation_x | lock_rotation_y | lock_rotation_z)) != 0) return straight;
    const Vec3 arm = cross(point - body.center, direction);
    return straight + dot(arm, inverse(body.inertia) * arm);
}

// The effort of legs acts as a force over the whole step, so that friction can resist it.
// Everything else is an impulse.
bool apply(World& world, const Contact& contact, const PushResult& given, const PushState& push) {
    const double at_once = given.impact + (push.on_ground ? 0 : given.effort);
    const Vec3 n = contact.normal;
    if (push.on_ground && given.effort > 0 &&
        !world.apply_force(contact.body, n * (-given.effort / push.dt), contact.point).ok())
        return false;
    return at_once <= 0 || world.apply_impulse(contact.body, n * -at_once, contact.point).ok();
}

}  // namespace

PushResult push_body(World& world, const Contact& contact, double mass, PushState& push) {
    const Vec3 n = contact.normal;
    const Result<BodyState> body = world.body(contact.body);
    if (!body.ok() || !(body->mass > 0)) return {};
    const double closing = dot(n, contact.velocity - push.velocity);
    const double soft = compliance(*body, contact.point, n);
    if (closing <= 0 || !(soft > 0)) return {};
    PushResult given;
    if (push.is_new_contact)
        given.impact =
            clamp(dot(n, contact.velocity - push.initial_velocity), 0, closing) / (1 / mass + soft);
    const double left = closing - given.impact * (1 / mass + soft);
    given.effort = minimum(left / (push.on_ground ? soft : 1 / mass + soft), push.effort);
    if (!apply(world, contact, given, push)) return {};
    if (push.on_ground) given.velocity_change = given.effort * soft;
    push.effort -= given.effort;
    const double felt = given.impact + (push.on_ground ? 0 : given.effort);
    push.initial_velocity += n * (felt / mass);
    push.velocity += n * (felt / mass);
    return given;
}

}  // namespace jostle::modules::character_detail

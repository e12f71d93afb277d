// SPDX-License-Identifier: MIT
#include "push_body.h"

namespace jostle::modules::character_detail {
using namespace physics;

// Turns that are locked, even some, are taken as all locked.
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

double push_body(World& world, const Contact& contact, double mass, Push& push) {
    const Result<BodyState> body = world.body(contact.body);
    if (!body.ok() || !(body->mass > 0)) return 0;
    const double closing = dot(contact.normal, contact.velocity - push.now);
    if (closing <= 0) return 0;
    const double give = 1 / (1 / mass + compliance(*body, contact.point, contact.normal));
    const double impact =
        give * clamp(dot(contact.normal, contact.velocity - push.before), 0, closing);
    const double effort = minimum(give * closing - impact, push.effort);
    const double impulse = impact + effort;
    if (!world.apply_impulse(contact.body, contact.normal * -impulse, contact.point).ok()) return 0;
    push.effort -= effort;
    push.before += contact.normal * (impulse / mass);
    push.now += contact.normal * (impulse / mass);
    return impulse;
}

}  // namespace jostle::modules::character_detail

// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/group_fields.h"

#include "physics/src/state/force_fields.h"

namespace jostle::physics {

GroupFields::GroupFields(const WorldState& world, const JointGroup& group)
    : world_(world), group_(group) {
    if (world.fields.empty()) return;
    constant_.reserve(2 * group.bodies.size());
    for (const DirectBody& body : group.solver.bodies) {
        constant_.push_back(body.force);
        constant_.push_back(body.torque);
    }
}

bool GroupFields::reach(double dt) const {
    if (world_.fields.empty()) return false;
    const double fall = dt * dt * length(world_.def.gravity);
    for (const DirectBody& body : group_.solver.bodies)
        if (body.pushed && reaches(world_.fields, body.x, 2 * dt * length(velocity(body)) + fall))
            return true;
    return false;
}

void GroupFields::push(std::vector<DirectBody>& bodies, double from, double h, double lookahead) {
    for (std::size_t k = 0; k < bodies.size(); k++) {
        DirectBody& body = bodies[k];
        if (!body.pushed) continue;
        const std::uint32_t index = group_.bodies[k];
        const BodyCold& cold = world_.bodies.cold[index];
        BodyWarm now = warm_of(world_, index);
        now.v = velocity(body);
        now.w = spin(body);
        now.center = body.x + now.v * lookahead;
        now.rotation = normalized(body.q * conjugate(group_.axes[k].frame));
        now.axes = to_matrix(now.rotation);
        const FieldPush field = field_push(world_, now, cold, world_.time + from, h);
        body.force = constant_[2 * k] + scaled(field.force, free_directions(cold));
        body.torque = constant_[2 * k + 1] + field.torque;
    }
}

}  // namespace jostle::physics

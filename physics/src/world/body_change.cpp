// SPDX-License-Identifier: MIT
#include "physics/src/world/body_change.h"

#include "jostle/base/check.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {

BodyWarm& wake_to_change(WorldState& world, std::uint32_t body) {
    wake_body(world, body);
    ASSERT(world.bodies.cold[body].set != BodySet::sleeping);
    return warm_of(world, body);
}

void after_move(WorldState& world, std::uint32_t body) {
    update_motion_bound(world, body, expected_dt(world));
    const BodyWarm& warm = warm_of(world, body);
    for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
         s = world.shapes.shapes[s].next)
        enlarge_proxy(world, s, warm, expected_dt(world));
}

void after_push(WorldState& world, std::uint32_t body) {
    update_motion_bound(world, body, expected_dt(world));
    const BodyWarm& warm = warm_of(world, body);
    for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
         s = world.shapes.shapes[s].next)
        if (!fits_fat_aabb(world.shapes.shapes[s], warm, world.bodies.cold[body].radius,
                           expected_dt(world)))
            enlarge_proxy(world, s, warm, expected_dt(world));
}

void obey_locks(const BodyCold& cold, BodyWarm& warm) {
    if (cold.locks == 0 || cold.type != BodyType::dynamic) return;
    warm.v = scaled(warm.v, free_directions(cold));
    warm.w = scaled(warm.w, free_rotations(cold));
}

Status check_dynamic(const BodyStore& bodies, BodyId id) {
    if (Status s = check_id(bodies, id); !s.ok()) return s;
    if (bodies.cold[id.index].type == BodyType::dynamic) return {};
    return Error{ErrorCode::failed_precondition,
                 "body {" + std::to_string(id.index) + ", " + std::to_string(id.generation) +
                     "} is not dynamic; forces and impulses require a dynamic body"};
}

}  // namespace jostle::physics

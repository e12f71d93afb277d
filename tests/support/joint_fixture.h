// SPDX-License-Identifier: MIT
//
// Two bodies and a joint, for tests of joints.
#pragma once

#include "tests/support/world_builder.h"

namespace jostle::test {

// A static body to which a joint is attached.
inline physics::BodyId anchor(physics::World& world, physics::Vec3 at = {}) {
    return add(world, {.geometry = physics::Sphere{0.05},
                       .position = at,
                       .type = physics::BodyType::static_body});
}

// A body that never sleeps.
inline physics::BodyId block(physics::World& world, BuiltBody part) {
    part.sleep_allowed = false;
    return add(world, part);
}

inline physics::JointId join(physics::World& world, physics::BodyId a, physics::BodyId b,
                             const physics::JointKind& kind, physics::Transform frame_a = {},
                             physics::Transform frame_b = {}) {
    return must(world.create_joint(
        {.body_a = a, .body_b = b, .frame_a = frame_a, .frame_b = frame_b, .kind = kind}));
}

}  // namespace jostle::test

// SPDX-License-Identifier: MIT
//
// 64 boxes fall together in empty space: impulses come in pairs, so the sums stay.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Momentum, is_conserved_by_64_colliding_boxes) {
    // What falls asleep is stopped.
    World world = make_world({.gravity = {}, .sleeping = false});
    Random random(14);
    double sum = 0, angular_sum = 0;
    for (int i = 0; i < 64; i++) {
        const Vec3 place = Vec3{i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5};
        const Vec3 half{random.in(0.1, 0.2), random.in(0.1, 0.2), random.in(0.1, 0.2)};
        const BodyId box = add(world, {.geometry = Box{half},
                                       .position = place,
                                       .rotation = random.rotation(),
                                       .velocity = place * -2 + random.vector(0.5),
                                       .spin = random.vector(3),
                                       .restitution = 0.5});
        const BodyState s = state_of(world, box);
        sum += s.mass * length(s.linear_velocity);
        angular_sum +=
            length(cross(s.center, s.linear_velocity * s.mass) + s.inertia * s.angular_velocity);
    }
    const WorldSummary before = world.summary();
    double linear = 0, angular = 0;
    int contacts = 0;
    for (int i = 0; i < 180; i++) {
        must(world.step(1.0 / 60));
        const WorldSummary now = world.summary();
        contacts += static_cast<int>(world.events().contacts_began.size());
        linear = maximum(linear, length(now.linear_momentum - before.linear_momentum) / sum);
        angular =
            maximum(angular, length(now.angular_momentum - before.angular_momentum) / angular_sum);
    }
    RecordProperty("contacts", contacts);
    RecordProperty("linear_drift", std::to_string(linear * 1e6) + "e-6");
    RecordProperty("angular_drift", std::to_string(angular * 1e6) + "e-6");
    EXPECT_GT(contacts, 100);  // they did collide
    EXPECT_LT(linear, 1e-6);
    EXPECT_LT(angular, 1e-2);  // points and turns are integrated at different times
    EXPECT_LT(world.summary().kinetic_energy, before.kinetic_energy);
}

}  // namespace
}  // namespace jostle::test

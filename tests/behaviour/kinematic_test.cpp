// SPDX-License-Identifier: MIT
//
// Kinematic bodies move by their velocity alone, carry by friction and push without giving way.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId add_platform(World& world, Vec3 velocity, Vec3 spin = {}) {
    return add(world, {.geometry = Box{{10, 0.5, 10}},
                       .position = {0, -0.5, 0},
                       .velocity = velocity,
                       .spin = spin,
                       .type = BodyType::kinematic});
}

TEST(Kinematic, moves_by_its_velocity_alone) {
    World world = make_world();
    const BodyId platform = add_platform(world, {1, 2, -0.5});
    run(world, 3);
    EXPECT_TRUE(near(position_of(world, platform), {3, 5.5, -1.5}, 1e-9));
    EXPECT_EQ(velocity_of(world, platform), (Vec3{1, 2, -0.5}));
}

// The box slips until mu g t has reached the platform's speed: it stays behind by v^2 / (2 mu g).
TEST(Kinematic, platform_carries_a_box_by_friction) {
    World world = make_world();
    const Vec3 v{0.8, 0, 0.6};
    const BodyId platform = add_platform(world, v);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 4);
    EXPECT_TRUE(near(velocity_of(world, box), v, 1e-3));
    const Vec3 behind = position_of(world, platform) - position_of(world, box);
    const double lag = 1 / (2 * 0.5 * 9.81);
    RecordProperty("lag_m", std::to_string(length({behind.x, 0, behind.z})));
    EXPECT_NEAR(length({behind.x, 0, behind.z}), lag, 0.02 * lag + 0.005);
    EXPECT_TRUE(state_of(world, box).awake);  // what is carried does not sleep
}

TEST(Kinematic, lift_carries_a_stack) {
    World world = make_world();
    add_platform(world, {0, 1, 0});
    const BodyId low = add(world, {.position = {0, 0.5, 0}, .velocity = {0, 1, 0}});
    const BodyId high = add(world, {.position = {0, 1.5, 0}, .velocity = {0, 1, 0}});
    run(world, 4);
    EXPECT_TRUE(near(position_of(world, low), {0, 4.5, 0}, 0.01));
    EXPECT_TRUE(near(position_of(world, high), {0, 5.5, 0}, 0.01));
}

TEST(Kinematic, turntable_carries_a_box) {
    World world = make_world();
    add_platform(world, {}, {0, 0.5, 0});  // mu g / r w^2 = 10: holds
    const BodyId box = add(world, {.position = {2, 0.5, 0}, .velocity = {0, 0, -1}});
    run(world, 4);
    const Vec3 p = position_of(world, box);
    EXPECT_NEAR(length({p.x, 0, p.z}), 2, 1e-3);
    const SinCos turned = sin_cos(0.5 * 4);
    EXPECT_TRUE(near({p.x, 0, p.z}, {2 * turned.cos, 0, -2 * turned.sin}, 2e-3));
}

// The displacement of a box relative to the platform that carries it, along its surface.
class Drift {
public:
    Drift(const World& world, BodyId platform, BodyId box)
        : world_(world), platform_(platform), box_(box), start_(place()) {}

    double now() const {
        const Vec3 moved = place() - start_;
        return length({moved.x, 0, moved.z});
    }

private:
    Vec3 place() const {
        const Transform p = state_of(world_, platform_).pose;
        return rotate(conjugate(p.rotation), position_of(world_, box_) - p.position);
    }

    const World& world_;
    BodyId platform_, box_;
    Vec3 start_;
};

// Friction holds four times the centripetal force.
TEST(Kinematic, box_on_a_carousel_stays_in_its_place) {
    for (const double radius : {0.3, 1.0, 5.0, 20.0})
        for (const Vec3 travel : {Vec3{}, Vec3{1, 0, 0.5}}) {
            const double spin = square_root(0.25 * 0.5 * 9.81 / radius);
            World world = make_world();
            const BodyId carousel = add(world, {.geometry = Box{{radius + 1, 0.5, radius + 1}},
                                                .position = {0, -0.5, 0},
                                                .velocity = travel,
                                                .spin = {0, spin, 0},
                                                .type = BodyType::kinematic});
            const BodyId box = add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                                           .position = {radius, 0.2, 0},
                                           .velocity = travel + Vec3{0, 0, -spin * radius},
                                           .spin = {0, spin, 0}});
            const Drift drift(world, carousel, box);
            run(world, 4);
            EXPECT_LT(drift.now(), 1e-3) << "radius " << radius;
        }
}

// The platform tilts by up to 6 degrees about an axis 2 m away from the box.
TEST(Kinematic, box_on_a_tilting_platform_stays_in_its_place) {
    World world = make_world();
    const BodyId platform = add_platform(world, {});
    const BodyId box = add(world, {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {2, 0.2, 0}});
    run(world, 0.5);
    const Drift drift(world, platform, box);
    for (int k = 0; k < 240; k++) {
        const double w = 0.05 * pi * sin_cos(pi * k / 60).sin;
        must(world.set_velocity(platform, {}, {0, 0, w}));
        must(world.step(1.0 / 60));
    }
    EXPECT_LT(drift.now(), 1e-3);
}

TEST(Kinematic, wall_pushes_a_box) {
    World world = make_world();
    add_floor(world);
    const BodyId wall = add(world, {.geometry = Box{{0.1, 1, 1}},
                                    .position = {-1, 1.01, 0},
                                    .velocity = {1, 0, 0},
                                    .type = BodyType::kinematic});
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 4);
    EXPECT_NEAR(position_of(world, wall).x, 3, 1e-9);
    EXPECT_TRUE(near(position_of(world, box), {3.6, 0.5, 0}, 0.01));
    EXPECT_TRUE(near(velocity_of(world, box), {1, 0, 0}, 0.01));
}

TEST(Kinematic, is_not_moved_by_any_impact) {
    World world = make_world();
    const BodyId platform = add_platform(world, {0.25, 0, 0});
    add(world, {.position = {0, 3, 0}, .velocity = {0, -30, 0}, .density = 1e5});
    run(world, 2);
    EXPECT_TRUE(near(position_of(world, platform), {0.5, -0.5, 0}, 1e-9));
}

TEST(Kinematic, starting_to_move_wakes_resting_bodies) {
    World world = make_world();
    const BodyId platform = add_platform(world, {});
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 3);
    ASSERT_FALSE(state_of(world, box).awake);
    must(world.set_velocity(platform, {1, 0, 0}, {}));
    run(world, 3);
    EXPECT_TRUE(near(velocity_of(world, box), {1, 0, 0}, 1e-3));
}

}  // namespace
}  // namespace jostle::test

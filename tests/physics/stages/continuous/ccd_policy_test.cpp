// SPDX-License-Identifier: MIT
//
// Which pairs are swept, and whose impacts the contact solver resolves.
#include "physics/src/stages/continuous/ccd_policy.h"

#include <gtest/gtest.h>

#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Balls of 0.4 m, in flight but for those that leaned on something when the step began.
struct Scene {
    World world = make_world();
    WorldState& state = state_of(world);
    StepScratch scratch;
    StepContext step{state, scratch, *state.thread_pool, 1.0 / 60, {}};

    std::uint32_t ball(double restitution = 0) {
        scratch.contacts.had_contacts.push_back(0);
        return add(world, {.geometry = Sphere{0.4},
                           .position = {3.0 * static_cast<double>(state.bodies.cold.size()), 0, 0},
                           .restitution = restitution})
            .index;
    }
    void leans(std::uint32_t body) { scratch.contacts.had_contacts[body] = 1; }
    double without_sweep(std::uint32_t mover, std::uint32_t other) const {
        return motion_without_sweep(state.bodies.cold[mover], state.bodies.cold[other]);
    }
};

TEST(CcdPolicy, dynamic_bodies_are_swept_only_if_their_cores_could_pass) {
    Scene scene;
    const std::uint32_t a = scene.ball(), b = scene.ball();
    EXPECT_NEAR(scene.without_sweep(a, b), 0.4, 1e-12) << "half of both radii";
    const std::uint32_t wall =
        add_static(scene.world, {.geometry = Box{{9, 9, 9}}, .position = {0, 99, 0}}).index;
    EXPECT_NEAR(scene.without_sweep(a, wall), 0.2, 1e-12) << "half of its radius";
}

TEST(CcdPolicy, supported_inelastic_impacts_use_the_contact_solver) {
    Scene scene;
    const std::uint32_t a = scene.ball(), b = scene.ball(), bouncy = scene.ball(0.5);
    EXPECT_FALSE(uses_speculative_contact(scene.step, a, b)) << "both fly: the sweep's";
    scene.leans(b);
    EXPECT_TRUE(uses_speculative_contact(scene.step, a, b));
    EXPECT_TRUE(uses_speculative_contact(scene.step, b, a));
    EXPECT_FALSE(uses_speculative_contact(scene.step, b, bouncy)) << "it has to go back";
}

// What a bounce gives back depends on its moment, which only a sweep finds.
TEST(CcdPolicy, restitution_bounces_unless_jointed) {
    Scene scene;
    const std::uint32_t dull = scene.ball(), a = scene.ball(0.5), b = scene.ball(0.5),
                        c = scene.ball(0.5);
    EXPECT_TRUE(bounces(scene.state, a, b));
    EXPECT_TRUE(bounces(scene.state, a, dull)) << "the larger restitution counts";
    EXPECT_FALSE(bounces(scene.state, dull, dull));
    must(scene.world.create_joint(
        {.body_a = body_id(scene.state.bodies, b), .body_b = body_id(scene.state.bodies, c)}));
    EXPECT_FALSE(bounces(scene.state, a, b)) << "from a sweep it would leave its joint";
    scene.state.bodies.cold[a].continuous = false;
    EXPECT_TRUE(bounces(scene.state, a, dull)) << "one of the two looks, for both";
    scene.state.bodies.cold[dull].continuous = false;
    EXPECT_FALSE(bounces(scene.state, a, dull));
    scene.state.def.continuous = false;
    EXPECT_FALSE(bounces(scene.state, b, dull));
}

// From a sweep it would leave its joints.
TEST(CcdPolicy, jointed_bodies_use_the_contact_solver) {
    Scene scene;
    const std::uint32_t a = scene.ball(), b = scene.ball(0.5), c = scene.ball();
    must(scene.world.create_joint(
        {.body_a = body_id(scene.state.bodies, b), .body_b = body_id(scene.state.bodies, c)}));
    EXPECT_TRUE(uses_speculative_contact(scene.step, a, b));
}

}  // namespace
}  // namespace jostle::test

// SPDX-License-Identifier: MIT
//
// What a sub-step tells listeners about bodies: their response to impulses, and loops over threads.
#include "physics/src/stages/solver/substep_hooks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/step_listener.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// In one sub-step, compares the response of a body with the effect of an impulse.
struct Probe : StepListener {
    BodyId body;
    Vec3 arm{0.3, 0.4, -0.2}, impulse{1, -2, 3};
    int calls = 0, loops = 0;
    BodyResponse response;  // in the first sub-step
    double error = 0;

    StepHooks hooks() const override { return {.substeps = true}; }
    void before_substep(SubstepContext& substep) override {
        if (!substep.contains(body)) return;
        const BodyResponse now = substep.response(body);
        if (calls++ == 0) response = now;
        const Vec3 point = substep.body(body).center + arm;
        const Vec3 before = substep.velocity_at(body, point);
        substep.add_impulse(body, impulse, point);
        const Vec3 change = substep.velocity_at(body, point) - before;
        error = std::max(error, length(change - point_response(now, arm) * impulse));
        std::vector<int> done(100);
        substep.parallel_for(100, 8, [&](int first, int last) {
            for (int k = first; k < last; k++) done[static_cast<std::size_t>(k)]++;
        });
        for (const int n : done) loops += n;
    }
};

Probe probe(World& world, BodyId body) {
    Probe probe;
    probe.body = body;
    must(world.add_listener(probe));
    must(world.step(1.0 / 60));
    must(world.remove_listener(probe));
    return probe;
}

TEST(SubstepHooks, response_of_a_free_body_is_the_effect_of_an_impulse) {
    World world = make_world({.substeps = 4});
    const BodyId body = add(world, {.geometry = Box{{0.1, 0.5, 0.3}}, .position = {0, 9, 0}});
    const Probe seen = probe(world, body);
    EXPECT_EQ(seen.calls, 4);
    EXPECT_EQ(seen.loops, 400);
    EXPECT_LT(seen.error, 1e-12);
    EXPECT_NEAR(seen.response.inverse_mass.x, 1 / world.body(body)->mass, 1e-12);
    EXPECT_NEAR(seen.response.acceleration.y, world.gravity().y, 1e-12);
}

TEST(SubstepHooks, response_of_a_touching_body_is_the_effect_of_an_impulse) {
    World world = make_world();
    add_floor(world);
    const BodyId body = add(world, {.geometry = Box{{0.4, 0.5, 0.3}}, .position = {0, 0.5, 0}});
    must(world.step(1.0 / 60));
    const Probe seen = probe(world, body);
    EXPECT_GT(seen.calls, 0);
    EXPECT_LT(seen.error, 1e-5);  // single precision
}

TEST(SubstepHooks, locked_axes_do_not_respond) {
    World world = make_world();
    const BodyId body = must(world.create_body(
        {.pose = {{0, 9, 0}, {}},
         .locks = static_cast<AxisLocks>(lock_x | lock_rotation_x | lock_rotation_z)},
        {.geometry = Sphere{0.5}}));
    const Probe seen = probe(world, body);
    EXPECT_EQ(seen.response.inverse_mass.x, 0);
    EXPECT_GT(seen.response.inverse_mass.y, 0);
    EXPECT_LT(length(seen.response.inverse_inertia * Vec3{1, 0, 1}), 1e-12);
    EXPECT_TRUE(std::isinf(effective_mass(seen.response, {}, {1, 0, 0})));
}

TEST(SubstepHooks, effective_mass_at_the_end_of_a_rod_is_a_quarter_of_its_mass) {
    // 1 / (1/m + (L/2)^2 / (m L^2 / 12)) = m / 4 across a thin rod at its end.
    World world = make_world();
    const BodyId rod =
        add(world, {.geometry = Box{{1, 0.01, 0.01}}, .position = {0, 9, 0}, .density = 1000});
    const Probe seen = probe(world, rod);
    const double mass = world.body(rod)->mass;
    EXPECT_NEAR(effective_mass(seen.response, {1, 0, 0}, {0, 1, 0}), mass / 4, 1e-3 * mass);
    EXPECT_NEAR(effective_mass(seen.response, {1, 0, 0}, {1, 0, 0}), mass, 1e-9 * mass);
}

// Counts work before each step.
struct Worker : StepListener {
    std::int64_t amount = 0;
    void before_step(World& world, double) override { world.count_work(amount); }
};

TEST(SubstepHooks, work_of_modules_counts_towards_the_budget) {
    World world = make_world({.step_budget = 1000});
    add(world, {.position = {0, 5, 0}});
    Worker worker;
    must(world.add_listener(worker));
    must(world.step(1.0 / 60));
    const std::int64_t without = world.profile().work;
    EXPECT_EQ(world.profile().module_work, 0);
    worker.amount = 5000;
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.profile().module_work, 5000);
    EXPECT_EQ(world.profile().work, without + 5000);
    EXPECT_EQ(world.overload_level(), 1);
    worker.amount = 0;
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.profile().module_work, 0);
}

}  // namespace
}  // namespace jostle::test

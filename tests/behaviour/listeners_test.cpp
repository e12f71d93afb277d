// SPDX-License-Identifier: MIT
//
// Step listeners: when they are called, what their pushes do, and how what they answer about new
// contacts is obeyed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <thread>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Listener : StepListener {
    StepHooks wanted;
    std::function<void(World&, double)> before = {}, after = {};
    std::function<void(SubstepContext&)> before_sub = {}, after_sub = {};
    std::function<void(PreSolve&)> ask = {};

    StepHooks hooks() const override { return wanted; }
    void before_step(World& world, double dt) override {
        if (before) before(world, dt);
    }
    void after_step(World& world, double dt) override {
        if (after) after(world, dt);
    }
    void before_substep(SubstepContext& substep) override {
        if (before_sub) before_sub(substep);
    }
    void after_substep(SubstepContext& substep) override {
        if (after_sub) after_sub(substep);
    }
    void pre_solve(PreSolve& pair) override {
        if (ask) ask(pair);
    }
};

constexpr StepHooks substeps{.substeps = true}, pre_solve{.pre_solve = true};

TEST(Listeners, are_called_in_insertion_order) {
    World world;
    const BodyId ball = add(world, {.geometry = Sphere{}});
    std::string calls;
    Listener first, second;
    first.wanted = substeps;
    first.before = [&](World& w, double dt) {
        EXPECT_EQ(w.step_count(), 0u);
        EXPECT_EQ(dt, 0.25);
        calls += "a";
    };
    first.before_sub = [&](SubstepContext& s) {
        EXPECT_EQ(s.count(), 8);
        EXPECT_DOUBLE_EQ(s.h(), 0.25 / 8);
        EXPECT_DOUBLE_EQ(s.time(), s.index() * s.h());
        EXPECT_THAT(s.bodies(), testing::ElementsAre(ball));
        calls += std::to_string(s.index());
    };
    first.after = [&](World& w, double) {
        EXPECT_EQ(w.step_count(), 1u);
        calls += "A";
    };
    second.before = [&](World&, double) { calls += "b"; };
    second.after = [&](World&, double) { calls += "B"; };
    second.before_sub = [&](SubstepContext&) { calls += "never asked for"; };
    must(world.add_listener(first));
    must(world.add_listener(second));
    must(world.step(0.25));
    EXPECT_EQ(calls, "ab01234567AB");
    must(world.remove_listener(first));
    must(world.step(0.25));
    EXPECT_EQ(calls, "ab01234567ABbB");
}

TEST(Listeners, can_change_the_world_before_a_step_but_not_step_it) {
    World world;
    Listener listener;
    listener.before = [&](World& w, double) {
        EXPECT_FALSE(w.step(0.01).ok());
        EXPECT_FALSE(w.add_listener(listener).ok());
        EXPECT_FALSE(RestorePoint{}.restore(w).ok());
        if (w.bodies().empty()) add(w, {.velocity = {1, 0, 0}});
    };
    must(world.add_listener(listener));
    run(world, 1);
    ASSERT_EQ(world.bodies().size(), 1u);
    EXPECT_NEAR(position_of(world, world.bodies()[0]).x, 1, 1e-9) << "it took part in all 60 steps";
}

// A spring of 2 Hz by hand, kicked in sub-steps: the period shows.
TEST(Listeners, custom_spring_oscillates_at_its_frequency) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{}, .position = {1, 0, 0}});
    const double mass = state_of(world, ball).mass, k = mass * 16 * pi * pi;
    Listener spring;
    spring.wanted = substeps;
    spring.before_sub = [&](SubstepContext& s) {
        const MovingBody b = s.body(ball);
        EXPECT_TRUE(s.add_impulse(ball, b.center * (-k * s.h()), b.center));
    };
    must(world.add_listener(spring));
    run(world, 10);
    // 20 periods. Symplectic Euler at 480 Hz is ahead by (w h)^2 / 24 of the phase.
    EXPECT_TRUE(near(position_of(world, ball), {1, 0, 0}, 0.03));
    EXPECT_NEAR(length(velocity_of(world, ball)), 0, 0.4);
}

// Gravity taken away by hand, of bodies that the solver holds and of free ones alike.
TEST(Listeners, can_lift_a_jointed_pair_and_a_free_ball) {
    World world;
    const BodyId a = add(world, {.position = {0, 5, 0}, .spin = {0, 3, 0}});
    const BodyId b = add(world, {.position = {1, 5, 0}});
    const BodyId ball =
        add(world, {.geometry = Sphere{}, .position = {5, 5, 0}, .sleep_allowed = false});
    must(world.create_joint(
        {.body_a = a, .body_b = b, .frame_a = {{0.5, 0, 0}, {}}, .frame_b = {{-0.5, 0, 0}, {}}}));
    int in_groups = 0;
    Listener lift;
    lift.wanted = substeps;
    lift.before_sub = [&](SubstepContext& s) {
        if (s.index() == 0) in_groups += static_cast<int>(s.bodies().size());
        for (const BodyId id : s.bodies()) {
            const MovingBody body = s.body(id);
            s.add_impulse(id, {0, 9.81 * body.mass * s.h(), 0}, body.center);
        }
        EXPECT_EQ(s.contains(a), s.contains(b));
        EXPECT_NE(s.contains(a), s.contains(ball));
        EXPECT_EQ(s.add_angular_impulse(ball, {}), s.contains(ball));
    };
    must(world.add_listener(lift));
    run(world, 1);
    EXPECT_EQ(in_groups, 3 * 60);
    EXPECT_NEAR(position_of(world, ball).y, 5, 1e-9);
    const double middle = 0.5 * (position_of(world, a).y + position_of(world, b).y);
    EXPECT_NEAR(middle, 5, 1e-3);
}

TEST(Listeners, are_bit_identical_for_any_thread_count) {
    const auto hash = [](int threads) {
        World world = make_world({.threads = threads});
        add_floor(world);
        for (int k = 0; k < 200; k++)
            add(world, {.position = {1.2 * (k % 10), 0.6 + 1.1 * (k / 40), 1.2 * (k / 10 % 4)}});
        Listener twist;
        twist.wanted = substeps;
        twist.after_sub = [](SubstepContext& s) {
            double sum = 0;
            for (const BodyId id : s.bodies()) {
                sum += s.velocity_at(id, {}).y;
                s.add_angular_impulse(id, {0, 0.1 * sum, 0});
            }
        };
        must(world.add_listener(twist));
        run(world, 1);
        return state_hash(world);
    };
    EXPECT_EQ(hash(1), hash(4));
}

TEST(Listeners, concurrent_listeners_see_each_body_in_one_group) {
    constexpr StepHooks at_once{.substeps = true, .concurrent = true};
    const auto hash = [&](int threads) {
        World world = make_world({.threads = threads});
        add_floor(world);
        for (int k = 0; k < 800; k++)
            add(world, {.position = {2.2 * (k % 20), 0.6 + 1.1 * (k / 400), 2.2 * (k / 20 % 20)}});
        for (int k = 0; k < 600; k++)
            add(world, {.geometry = Sphere{}, .position = {3.0 * k, 50, 100}});
        std::atomic<int> seen = 0, groups = 0;
        Listener twist;
        twist.wanted = at_once;
        twist.before_sub = [&](SubstepContext& s) {
            if (s.index() == 0) seen += static_cast<int>(s.bodies().size()), groups++;
            // What a group sees goes into the bits.
            double sum = 0;
            for (const BodyId id : s.bodies()) {
                sum += s.velocity_at(id, {}).y;
                s.add_angular_impulse(id, {0, 1e-3 * sum, 0});
                EXPECT_TRUE(s.contains(id));
            }
        };
        must(world.add_listener(twist));
        run(world, 0.5);
        EXPECT_EQ(seen, 1400 * 30) << "each body once a step";
        EXPECT_GE(groups, 5 * 30) << "three of balls, at least two of crates";
        return state_hash(world);
    };
    const std::uint64_t one = hash(1);
    EXPECT_EQ(one, hash(2));
    EXPECT_EQ(one, hash(4));
}

TEST(Listeners, one_non_concurrent_listener_disables_concurrency) {
    constexpr StepHooks at_once{.substeps = true, .concurrent = true};
    World world = make_world({.threads = 4});
    add_floor(world);
    for (int k = 0; k < 400; k++) add(world, {.position = {2.2 * (k % 20), 0.6, 2.2 * (k / 20)}});
    const std::thread::id here = std::this_thread::get_id();
    int calls = 0;
    Listener first, second;
    first.wanted = at_once;
    second.wanted = substeps;
    second.before_sub = [&](SubstepContext&) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        calls++;
    };
    must(world.add_listener(first));
    must(world.add_listener(second));
    run(world, 0.2);
    EXPECT_GT(calls, 0);
}

// ---- answers about new contacts ----

TEST(ContactModifiers, one_way_platform_passes_from_below_and_carries_from_above) {
    for (const double thickness : {0.1, 0.002}) {
        for (const double speed : {9.0, 60.0}) {  // the faster one is swept
            World world;
            const BodyId ball = add(
                world, {.geometry = Sphere{0.2}, .position = {0, 1, 0}, .velocity = {0, speed, 0}});
            const BodyId platform =
                add_static(world, {.geometry = Box{{2, thickness, 2}}, .position = {0, 3, 0}});
            int asked = 0;
            Listener one_way;
            one_way.wanted = pre_solve;
            one_way.ask = [&](PreSolve& pair) {
                asked++;
                const double up = pair.body_a == ball ? -pair.velocity.y : pair.velocity.y;
                if (up > 0) pair.enabled = false;
            };
            must(world.add_listener(one_way));
            double highest = 0;
            for (int step = 0; step < 60 * 16; step++) {
                must(world.step(1.0 / 60));
                highest = maximum(highest, position_of(world, ball).y);
            }
            EXPECT_NEAR(highest, 1 + speed * speed / (2 * 9.81), 0.01 * speed) << "unhindered";
            EXPECT_NEAR(position_of(world, ball).y, 3.2 + thickness, 0.01) << speed;
            EXPECT_GT(asked, 1);
            EXPECT_TRUE(world.contains(platform));
        }
    }
}

TEST(ContactModifiers, friction_and_restitution_apply_while_touching) {
    World world = make_world({.gravity = leaning_gravity(0.3, 0)});
    add_floor(world, 0.5);
    const BodyId holds = add(world, {.position = {0, 0.5, 0}});
    const BodyId slides = add(world, {.position = {0, 0.5, 5}});
    const BodyId bounces = add(world, {.geometry = Sphere{0.5}, .position = {0, 2, -5}});
    Listener listener;
    listener.wanted = pre_solve;
    listener.ask = [&](PreSolve& pair) {
        EXPECT_EQ(pair.friction, 0.5);
        if (pair.body_a == slides) pair.friction = 0;
        if (pair.body_a == bounces) pair.restitution = 1;
    };
    must(world.add_listener(listener));
    run(world, 1);
    EXPECT_NEAR(position_of(world, holds).x, 0, 1e-3);
    const double pull = length(world.gravity()) * 0.3 / square_root(1.09);
    EXPECT_NEAR(position_of(world, slides).x, 0.5 * pull, 0.02);
    EXPECT_GT(position_of(world, bounces).y, 1.2) << "most of 1.5 m back up";
    // What was answered is saved, and outlives the listener.
    World loaded = must(load(save(world)));
    run(loaded, 0.5);
    EXPECT_NEAR(position_of(loaded, slides).x, 0.5 * pull * 2.25, 0.05);
}

// A box falls asleep 1 cm beside a plate that creeps by: their manifold ends, and another begins
// when the plate comes. Each is asked about, and the world can be saved and loaded.
TEST(ContactModifiers, are_cleared_when_sleep_ends_a_manifold) {
    World world;
    add_floor(world);
    Listener slippery;
    slippery.wanted = pre_solve;
    slippery.ask = [](PreSolve& pair) { pair.friction = 0.1; };
    must(world.add_listener(slippery));
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    const BodyId plate = add(world, {.geometry = Box{{0.5, 0.2, 0.5}},
                                     .position = {1.01, 0.5, 0},
                                     .velocity = {0, 0.02, 0},
                                     .type = BodyType::kinematic});
    run(world, 2);
    EXPECT_FALSE(state_of(world, box).awake);
    must(world.set_linear_velocity(plate, {-0.5, 0, 0}));
    run(world, 0.5);
    EXPECT_LT(position_of(world, box).x, -0.1) << "the plate pushes it";
    EXPECT_TRUE(load(save(world)).ok());
}

TEST(ContactModifiers, surface_velocity_acts_as_a_conveyor_belt) {
    World world;
    const BodyId floor = add_floor(world);
    const BodyId crate = add(world, {.position = {0, 0.5, 0}});
    Listener belt;
    belt.wanted = pre_solve;
    belt.ask = [&](PreSolve& pair) {
        const double sign = pair.body_b == floor ? 1 : -1;
        pair.surface_velocity = {2 * sign, 0, 0};
    };
    must(world.add_listener(belt));
    run(world, 3);
    EXPECT_NEAR(velocity_of(world, crate).x, 2, 0.01);
}

}  // namespace
}  // namespace jostle::test

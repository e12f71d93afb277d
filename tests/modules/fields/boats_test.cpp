// SPDX-License-Identifier: MIT
//
// Boats on still water: speed, turning, and no thrust from a propeller in the air.
#include "jostle/modules/boats.h"

#include <gtest/gtest.h>

#include "tests/modules/fields/with_fields.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

constexpr double half_length = 2.6, density = 250;

struct Harbour {
    World world;
    BodyId hull;
    Boats* boats = nullptr;

    explicit Harbour(const BoatDef& of = {}, double height = 0.2, int threads = 1)
        : world(test::make_world({.threads = threads})) {
        add_field(world, {.law = Waves{}});
        hull = test::add(world, {.geometry = Box{{1, 0.45, half_length}},
                                 .position = {0, height, 0},
                                 .density = density});
        auto made = std::make_unique<Boats>();
        boats = made.get();
        test::must(world.add_module(std::move(made)));
        BoatDef def = of;
        def.hull = hull;
        test::must(boats->add(world, def));
    }
    BodyState state() const { return test::state_of(world, hull); }
    double speed() const { return length(state().linear_velocity); }
    // rad to the right of -z.
    double course() const {
        const Vec3 forward = rotate(state().pose.rotation, {0, 0, -1});
        return arc_tangent(forward.x, -forward.z);
    }
};

TEST(Boats, stays_at_rest_until_driven) {
    Harbour harbour;
    test::run(harbour.world, 20);
    const Vec3 at = harbour.state().center;
    EXPECT_NEAR(at.x, 0, 1e-6);
    EXPECT_NEAR(at.z, 0, 1e-6);
    EXPECT_TRUE(harbour.boats->states()[0].in_water);
}

// The thrust equals the drag of the wetted front: F (1 - v / v_top) = rho c A v^2 / 2.
TEST(Boats, top_speed_balances_thrust_and_drag) {
    Harbour harbour;
    test::must(harbour.boats->steer(harbour.world, harbour.hull, 1, 0));
    test::run(harbour.world, 40);
    const BoatDef def;
    const double front = 2 * (density / 1000 * 0.9);  // m^2, width times draft
    double v = 0;
    for (int k = 0; k < 200; k++) {
        const double over = def.thrust * (1 - v / def.top_speed) - 0.5 * 1000 * front * v * v;
        v += 1e-4 * over;
    }
    // The raised bow and the wave-making loss (damping) reduce it.
    EXPECT_NEAR(harbour.speed(), v, 0.25 * v);
    EXPECT_LT(harbour.state().linear_velocity.z, -2);
    RecordProperty("speed", std::to_string(harbour.speed()));
}

TEST(Boats, turns_towards_its_rudder_and_opposite_in_reverse) {
    for (const double rudder : {-1.0, 1.0}) {
        Harbour harbour;
        test::must(harbour.boats->steer(harbour.world, harbour.hull, 1, rudder));
        test::run(harbour.world, 2.5);
        EXPECT_GT(rudder * harbour.course(), 0.3);
        EXPECT_LT(rudder * harbour.course(), 2.5);
        RecordProperty("course", std::to_string(harbour.course()));
        // It moves in the direction of its heading, within the drift that the keel allows.
        const BodyState state = harbour.state();
        const Vec3 right = rotate(state.pose.rotation, {1, 0, 0});
        EXPECT_LT(absolute(dot(state.linear_velocity, right)), 0.6 * length(state.linear_velocity));
    }
    Harbour harbour;
    test::must(harbour.boats->steer(harbour.world, harbour.hull, -1, 0));
    test::run(harbour.world, 10);
    EXPECT_GT(harbour.state().linear_velocity.z, 0.5);
}

TEST(Boats, propeller_out_of_the_water_gives_no_thrust) {
    Harbour harbour({}, 30);
    test::must(harbour.boats->steer(harbour.world, harbour.hull, 1, 1));
    test::run(harbour.world, 1);
    EXPECT_FALSE(harbour.boats->states()[0].in_water);
    EXPECT_EQ(harbour.state().linear_velocity.z, 0);
    EXPECT_EQ(harbour.state().angular_velocity, Vec3{});
}

TEST(Boats, boat_is_removed_with_its_hull) {
    Harbour harbour;
    test::must(harbour.world.destroy_body(harbour.hull));
    test::run(harbour.world, 0.1);
    EXPECT_TRUE(harbour.boats->states().empty());
    EXPECT_FALSE(harbour.boats->steer(harbour.world, harbour.hull, 1, 0).ok());
}

TEST(Boats, rejects_numbers_out_of_range_and_names_the_field) {
    Harbour harbour;
    const auto message = [&](const BoatDef& def) {
        return harbour.boats->add(harbour.world, def).error().message;
    };
    EXPECT_EQ(message({.hull = harbour.hull}), "hull is already a boat");
    EXPECT_EQ(message({}), "hull is not a body");
    const BodyId other = test::add(harbour.world, {.position = {9, 0, 0}});
    EXPECT_EQ(message({.hull = other, .propeller = {0, 0, 9}}),
              "propeller is out of range; it must be within 8 m of the hull's origin");
    EXPECT_EQ(message({.hull = other, .thrust = -1}), "thrust is out of range");
    EXPECT_FALSE(harbour.boats->steer(harbour.world, harbour.hull, 2, 0).ok());
}

TEST(Boats, scene_settings_create_boats_that_respond_to_controls) {
    Harbour harbour;
    const BodyId other =
        test::add(harbour.world,
                  {.geometry = Box{{1, 0.45, 2.6}}, .position = {9, 0.2, 0}, .density = density});
    Boats boats;
    test::must(boats.configure(
        harbour.world, {.numbers = {{"thrust", 100}, {"keel", 0}}, .bodies = {{"boat", other}}}));
    ASSERT_TRUE(boats.is_controllable(other));
    Controls controls;
    controls.axes[0] = -0.5, controls.axes[1] = 1;
    boats.control(harbour.world, other, controls);
    boats.before_step(harbour.world, 1);
    EXPECT_EQ(boats.states()[0].throttle, 1);
    EXPECT_EQ(boats.states()[0].rudder, -0.5);
    EXPECT_EQ(boats.configure(harbour.world, {.numbers = {{"thrust", -1}}}).error().message,
              "thrust is -1; it must be from 0 to 10000000");
}

TEST(Boats, continues_bit_identically_after_load_and_for_any_thread_count) {
    static_cast<void>(register_module("boat", [] { return std::make_unique<Boats>(); }));
    Harbour one, many({}, 0.2, 4);
    for (Harbour* harbour : {&one, &many}) {
        test::must(harbour->boats->steer(harbour->world, harbour->hull, 0.8, 0.6));
        test::run(harbour->world, 1);
    }
    World loaded = test::must(load(save(one.world)));
    for (World* world : {&one.world, &many.world, &loaded}) test::run(*world, 2);
    EXPECT_EQ(first_difference(one.world, loaded), std::nullopt);
    EXPECT_EQ(state_hash(one.world), state_hash(many.world));
}

// Any changed byte loads to values in range or is rejected.
TEST(Boats, rejects_corrupted_bytes) {
    Harbour harbour;
    const std::vector<std::byte> good = save_module(*harbour.boats);
    test::Random random(6);
    int refused = 0, taken = 0;
    for (int k = 0; k < 5000; k++) {
        std::vector<std::byte> corrupted = good;
        corrupted[random.below(corrupted.size())] = static_cast<std::byte>(random.below(256));
        if (random.below(10) == 0) corrupted.resize(random.below(corrupted.size()));
        auto victim = std::make_unique<Boats>();
        if (!load_module(*victim, corrupted).ok()) {
            refused++;
            continue;
        }
        taken++;
        ASSERT_EQ(save_module(*victim), corrupted);
        if (taken % 50 != 0) continue;
        World other = test::make_world();
        test::must(other.add_module(std::move(victim)));
        test::must(other.step(1.0 / 60));
    }
    EXPECT_GT(refused, 500);
    EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace jostle::modules

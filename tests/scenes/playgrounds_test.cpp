// SPDX-License-Identifier: MIT
//
// Playable scenes, controlled by driver input: laps of the race track, the parkour course to its
// flag, a boat out of the harbour, a digger into a wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "jostle/modules/cloth.h"
#include "jostle/modules/crowd.h"
#include "jostle/modules/particles.h"
#include "jostle/modules/rope.h"
#include "jostle/physics/module.h"
#include "jostle/scenes/catalog.h"
#include "tests/support/step_time.h"

namespace jostle::scenes {
namespace {

using namespace physics;

using test::dt;

struct Played {
    SceneDescription scene;
    BuiltScene built;

    explicit Played(const char* name) : Played(*find_scene(name)) {}
    explicit Played(SceneDescription described)
        : scene(std::move(described)), built(std::move(*build_scene(scene))) {}

    BodyId named(const std::string& name) const {
        for (std::size_t k = 0; k < scene.bodies.size(); k++)
            if (scene.bodies[k].name == name) return built.bodies[k];
        ADD_FAILURE() << "missing body " << name;
        return {};
    }
    BodyState state(const std::string& name) const { return *built.world.body(named(name)); }
    void hold(const char* module, const std::string& body, const Controls& controls) {
        Module* driven = built.world.module(module);
        ASSERT_NE(driven, nullptr);
        ASSERT_TRUE(driven->is_controllable(named(body))) << body;
        driven->control(built.world, named(body), controls);
    }
    void run(double seconds) {
        for (int step = 0; step < std::lround(seconds / dt); step++)
            ASSERT_TRUE(built.world.step(dt).ok());
    }
};

Controls sticks(double right, double forward, double look = 0, std::uint32_t buttons = 0) {
    Controls controls;
    controls.axes[0] = right, controls.axes[1] = forward, controls.axes[3] = look;
    controls.buttons = buttons;
    return controls;
}

// Time of one counter-clockwise lap around the y axis, s; negative if the car left the road or
// needed more than a minute.
double lap_time(Played& track, const std::string& car) {
    double turned = 0;
    Vec3 previous = track.state(car).center;
    for (int step = 1; step <= 60 * 60; step++) {
        if (!track.built.world.step(dt).ok()) return -1;
        const Vec3 now = track.state(car).center;
        const double radius = std::hypot(now.x, now.z);
        if (radius < 37 || radius > 53) return -1;
        turned += std::atan2(previous.x * now.z - previous.z * now.x,
                             previous.x * now.x + previous.z * now.z);
        previous = now;
        if (turned <= -2 * pi) return step * dt;
    }
    return -1;
}

// The jet turns the mill wheel all the time and rolls balls down the hill; the smoke is simulated
// by clients.
TEST(Fountain, jet_turns_the_mill_wheel) {
    Played fountain("fountain");
    const auto* particles =
        dynamic_cast<const modules::Particles*>(fountain.built.world.module("particles"));
    ASSERT_EQ(particles->groups().size(), 4u);
    fountain.run(3);
    for (int k = 0; k < 4; k++) {
        fountain.run(0.5);
        EXPECT_GT(fountain.state("mill").angular_velocity.z, 1) << "rad/s";
    }
    const auto group = [&](std::size_t k) { return particles->group(particles->groups()[k]); };
    EXPECT_GT(group(0)->size(), 2700u);
    EXPECT_EQ(group(2)->size(), 0u) << "cosmetic";
    EXPECT_EQ(group(3)->size(), 20u) << "the rope";
    double lowest = 1;
    for (const Vec3& p : group(0)->positions()) lowest = minimum(lowest, p.y);
    EXPECT_GT(lowest, 0) << "no drop is below the ground";
}

// Ring of 45 m at 16 m/s: 17.7 s, plus the time to accelerate.
TEST(RaceTrack, pilot_completes_a_lap_on_the_road) {
    Played track("race_track");
    const double seconds = lap_time(track, "car");
    RecordProperty("lap_seconds", std::to_string(seconds));
    EXPECT_GT(seconds, 17.7);
    EXPECT_LT(seconds, 22);
    for (const char* other : {"car2", "car3", "car4", "car5", "car6"}) {
        const Vec3 at = track.state(other).center;
        EXPECT_GT(std::hypot(at.x, at.z), 37) << other;
        EXPECT_LT(std::hypot(at.x, at.z), 53) << other;
    }
}

TEST(RaceTrack, car_at_full_lock_and_full_speed_skids_without_rolling_over) {
    // Removes all obstacles.
    SceneDescription open = *find_scene("race_track");
    for (SceneBody& body : open.bodies)
        if (body.name == "tree" || body.name == "tyre") {
            body.body.type = BodyType::static_body;
            body.body.pose.position.y -= 100;
        }
    Played track(std::move(open));
    track.hold("vehicle", "car", sticks(0, 1));
    track.run(5);
    EXPECT_GT(length(track.state("car").linear_velocity), 18);
    track.hold("vehicle", "car", sticks(-1, 1));
    double lowest = 1;
    for (int step = 0; step < 60 * 5; step++) {
        ASSERT_TRUE(track.built.world.step(dt).ok());
        lowest = std::min(lowest, rotate(track.state("car").pose.rotation, {0, 1, 0}).y);
    }
    EXPECT_GT(lowest, 0.7);
}

// Up the stairs, over each gap with a jump, along the beam, to the flag.
TEST(Parkour, course_can_be_completed) {
    Played parkour("parkour");
    const Vec3 waypoints[] = {{0, 0, -5},     {0, 0, -12},   {16, 0, -12},
                              {17, 0, -11.2}, {17, 0, -2.5}, {17.75, 0, 0.8}};
    const double edges[] = {2, 5, 8.5, 12.5};  // x at which gaps begin
    double seconds = 0;
    for (const Vec3 mark : waypoints)
        for (double left = 1; left > 0.4; seconds += dt) {
            const Vec3 at = parkour.state("walker2").center;
            const double x = mark.x - at.x, z = mark.z - at.z;
            left = std::hypot(x, z);
            ASSERT_LT(seconds, 60) << "on its way to " << mark.x << ", " << mark.z << " it is at "
                                   << at.x << ", " << at.y << ", " << at.z;
            const bool leaps = std::ranges::any_of(
                edges, [&](double edge) { return std::abs(edge - 0.3 - at.x) < 0.2; });
            parkour.hold("character", "walker2",
                         sticks(0, std::min(0.6, left), std::atan2(-x, -z) / pi, leaps ? 1 : 0));
            parkour.run(dt);
        }
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_NEAR(parkour.state("walker2").center.y, 2.2 + 0.9, 0.15);
    EXPECT_LT(seconds, 30);
}

TEST(Harbour, boat_leaves_the_harbour_upright_and_turns_back) {
    Played harbour("harbour");
    harbour.run(2);
    const Vec3 moored = harbour.state("boat").center;
    harbour.hold("boat", "boat", sticks(0, 1));
    harbour.run(6);
    const Vec3 out = harbour.state("boat").center;
    EXPECT_GT(out.z - moored.z, 9);
    harbour.hold("boat", "boat", sticks(1, 1));
    double lowest = 1;
    for (int step = 0; step < 60 * 5; step++) {
        harbour.run(dt);
        lowest = std::min(lowest, rotate(harbour.state("boat").pose.rotation, {0, 1, 0}).y);
    }
    EXPECT_GT(lowest, 0.6);
    // It was facing +z, so -x is to its right.
    const Vec3 forward = rotate(harbour.state("boat").pose.rotation, {0, 0, -1});
    EXPECT_LT(forward.z, 0.9);
    RecordProperty("lowest_up", std::to_string(lowest));
}

TEST(Harbour, everything_still_floats_after_ten_seconds) {
    Played harbour("harbour");
    harbour.run(10);
    for (std::size_t k = 0; k < harbour.scene.bodies.size(); k++) {
        const BodyState body = *harbour.built.world.body(harbour.built.bodies[k]);
        if (body.type != BodyType::dynamic) continue;
        EXPECT_GT(body.center.y, -1.2) << harbour.scene.bodies[k].name;
    }
}

TEST(Demolition, digger_breaks_a_wall) {
    Played yard("demolition");
    yard.run(1);
    const Vec3 began = yard.state("digger").center;
    const auto bodies = [&] {
        std::vector<BodyState> all;
        yard.built.world.copy_bodies(all);
        return all.size();
    };
    const std::size_t previous = bodies();
    yard.hold("vehicle", "digger", sticks(0, 1));
    yard.run(5);
    EXPECT_GT(bodies(), previous + 60);
    EXPECT_LT(yard.state("digger").center.z, began.z - 11);
}

TEST(RagdollStairs, most_figures_reach_the_bottom) {
    Played stairs("ragdoll_stairs");
    stairs.run(10);
    std::vector<BodyState> all;
    stairs.built.world.copy_bodies(all);
    int below = 0, bones = 0;
    for (const BodyState& body : all) {
        if (body.type != BodyType::dynamic) continue;
        bones++;
        below += body.center.y < 4.8 ? 1 : 0;
    }
    EXPECT_EQ(bones, 12 * 11);
    EXPECT_GT(below, bones / 2);
}

// ---- ropes ----

const modules::Ropes& ropes_of(const Played& played) {
    return dynamic_cast<const modules::Ropes&>(*played.built.world.module("rope"));
}

TEST(Playgrounds, rope_bridge_carries_a_walker_and_sacks) {
    Played bridge("rope_bridge");
    bridge.run(3);
    // The ropes were built with a sag of 0.6 m.
    EXPECT_NEAR(6 - bridge.state("plank 10").center.y, 0.6, 0.05);
    bridge.hold("character", "walker1", sticks(1, 0));
    bridge.run(3.2);
    EXPECT_GT(bridge.state("walker1").center.x, 5);
    EXPECT_GT(bridge.state("walker1").center.y, 6);
    EXPECT_EQ(ropes_of(bridge).ropes().size(), 5u);  // none broke
    for (const modules::RopeKey rope : ropes_of(bridge).ropes())
        for (const Vec3 v : ropes_of(bridge).velocities(rope)) EXPECT_LT(length(v), 5);
}

TEST(Playgrounds, swings_swing_and_the_crane_lifts) {
    Played park("swings");
    double most = 0;
    for (int n = 0; n < 60; n++) {
        park.run(0.1);
        most = std::max(most, park.state("seat 3").center.z);
    }
    // Height of the seats: v = 3.5 m/s rises v^2 / 2 g = 0.62 m on ropes of 3.2 m.
    EXPECT_NEAR(most, 1.9, 0.15);
    EXPECT_NEAR(park.state("crate").center.y, 0.5 + 0.2 * 6, 0.05);
}

// ---- cloth ----

const modules::Cloths& cloths_of(const Played& played) {
    return dynamic_cast<const modules::Cloths&>(*played.built.world.module("cloth"));
}

TEST(Playgrounds, flag_waves_in_the_wind) {
    Played yard("flag");
    yard.run(4);
    const modules::Cloths& cloths = cloths_of(yard);
    const modules::ClothKey flag = cloths.cloths()[0];
    double mean = 0, most = 0;
    for (const Vec3 p : cloths.positions(flag))
        mean += p.x / static_cast<double>(cloths.masses(flag).size());
    for (const Vec3 v : cloths.velocities(flag)) most = std::max(most, length(v));
    EXPECT_GT(mean, 0.6);
    EXPECT_LT(most, 30);
    // The sheet lies on the table.
    double highest = 0;
    for (const Vec3 p : cloths.positions(cloths.cloths()[2])) highest = std::max(highest, p.y);
    EXPECT_NEAR(highest, 0.81, 0.03);
}

TEST(Playgrounds, car_drives_through_the_curtain) {
    Played road("curtain");
    road.run(1);
    road.hold("vehicle", "car", sticks(0, 1));
    double most = 0;
    for (int n = 0; n < 40; n++) {
        road.run(0.1);
        for (const modules::ClothKey key : cloths_of(road).cloths())
            for (const Vec3 v : cloths_of(road).velocities(key)) most = std::max(most, length(v));
    }
    EXPECT_LT(road.state("car").center.z, 0);  // the curtain hangs at 6 m
    EXPECT_LT(most, 60);
}

// ---- crowds ----

const modules::Crowd& crowd_of(const Played& played) {
    return dynamic_cast<const modules::Crowd&>(*played.built.world.module("crowd"));
}

TEST(Playgrounds, spectators_leave_the_stadium_through_its_gates) {
    Played stadium("stadium");
    ASSERT_EQ(crowd_of(stadium).counts().agents, 600u);
    stadium.run(25);
    RecordProperty("left_after_25_s", static_cast<int>(crowd_of(stadium).counts().left));
    EXPECT_GT(crowd_of(stadium).counts().left, 60u);
    for (const modules::AgentId id : crowd_of(stadium).ids()) {
        const Vec3 p = crowd_of(stadium).state(stadium.built.world, id)->position;
        const bool inside = std::abs(p.x) < 30 && std::abs(p.z) < 22;
        const bool in_gate = std::abs(p.x) < 1.6 || std::abs(p.z) < 1.6;
        EXPECT_TRUE(inside || in_gate || p.y > 1) << p.x << " " << p.z;
    }
}

TEST(Playgrounds, stampede_flees_from_the_bull) {
    Played square("stampede");
    square.run(8);
    EXPECT_GT(crowd_of(square).counts().panicked, 5u);
    EXPECT_EQ(crowd_of(square).counts().agents, 361u);
    for (const modules::AgentId id : crowd_of(square).ids()) {
        const modules::AgentState state = *crowd_of(square).state(square.built.world, id);
        EXPECT_LT(std::abs(state.position.x), 40);
        EXPECT_GT(state.position.y, 0);
    }
}

}  // namespace
}  // namespace jostle::scenes

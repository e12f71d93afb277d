// SPDX-License-Identifier: MIT
//
// Lifts, turntables and belts carry the characters that stand on them.
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

constexpr double dt = 1 / hz;

Vec3 horizontal_part(Vec3 v) {
    return {v.x, 0, v.z};
}

// m: distance of the feet from the top of a box, and from their initial position on it.
struct Ride {
    double gap = 0, drift = 0;
};

// Moves a box of half height 0.5 m along `pose_at(t)`, with a character that stands on it at
// `spot`.
template <class PoseAt>
Ride ride(CharacterKind kind, Vec3 spot, double seconds, PoseAt&& pose_at) {
    Stage stage;
    const BodyId box = test::add(stage.world, {.geometry = Box{{4, 0.5, 4}},
                                               .position = pose_at(0.0).position,
                                               .rotation = pose_at(0.0).rotation,
                                               .type = BodyType::kinematic});
    const CharacterId hero = stage.add(
        {.kind = kind, .feet = apply(pose_at(0.0), spot + Vec3{0, 0.5, 0}), .filter = {}});
    const auto local = [&] {
        return apply_inverse(test::state_of(stage.world, box).pose, stage.of(hero).feet);
    };
    Vec3 start;
    Ride worst;
    for (int k = 1; k <= seconds * hz; k++) {
        test::must(stage.world.move_to(box, pose_at(k * dt), dt));
        test::must(stage.world.step(dt));
        const Vec3 now = local();
        if (k == 30) start = now;  // it has settled
        if (k <= 30) continue;
        worst.gap =
            maximum(worst.gap, absolute(now.y - (kind == CharacterKind::sweeping ? 0.5 : start.y)));
        worst.drift = maximum(worst.drift, length(horizontal_part(now - start)));
        EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground);
    }
    return worst;
}

TEST(Platform, lift_carries_it_without_a_gap) {
    const Ride worst = ride(CharacterKind::sweeping, {1, 0, 2}, 8, [](double t) {
        return Transform{{0, 3 - 3 * sin_cos(1.5 * t).cos, 0}, {}};
    });
    record("lift_gap_m", worst.gap);
    record("lift_drift_m", worst.drift);
    EXPECT_LE(worst.gap, 0.001);
    EXPECT_LE(worst.drift, 0.001);
}

TEST(Platform, abruptly_starting_and_stopping_lift_carries_it) {
    const Ride worst = ride(CharacterKind::sweeping, {0, 0, 0}, 8, [](double t) {
        const double phase = t - 4 * std::floor(t / 4);
        return Transform{{0, phase < 2 ? 3 * phase : 3 * (4 - phase), 0}, {}};
    });
    record("abrupt_lift_gap_m", worst.gap);
    EXPECT_LE(worst.gap, 0.001);
    EXPECT_LE(worst.drift, 0.001);
}

TEST(Platform, turntable_carries_it_around) {
    for (const double speed : {0.5, 2.0, 5.0}) {
        const Ride worst = ride(CharacterKind::sweeping, {2, 0, 1}, 20, [&](double t) {
            return Transform{{0, 0, 0}, from_axis_angle({0, 1, 0}, speed * t)};
        });
        record("turntable_gap_m", worst.gap);
        record("turntable_drift_m", worst.drift);
        EXPECT_LE(worst.gap, 0.001) << speed;
        EXPECT_LE(worst.drift, 0.001) << speed;
    }
}

TEST(Platform, curving_train_and_rolling_ship_carry_it) {
    const Ride worst = ride(CharacterKind::sweeping, {1, 0, -1}, 10, [](double t) {
        const Quat yaw = from_axis_angle({0, 1, 0}, 0.3 * t);
        const Quat roll = from_axis_angle({1, 0, 0}, 0.2 * sin_cos(t).sin);
        const SinCos course = sin_cos(0.3 * t);
        return Transform{Vec3{course.cos, 0, -course.sin} * 60, yaw * roll};
    });
    record("ship_gap_m", worst.gap);
    record("ship_drift_m", worst.drift);
    // The round end rolls on a tilting deck: by r (1 / cos - 1) upwards and r sin sideways.
    EXPECT_LE(worst.gap, 0.3 * (1 / sin_cos(0.2).cos - 1) + 0.001);
    EXPECT_LE(worst.drift, 0.3 * sin_cos(0.2).sin + 0.01);
}

TEST(Platform, rigid_character_is_carried_too) {
    const Ride lift = ride(CharacterKind::rigid, {1, 0, 2}, 8, [](double t) {
        return Transform{{0, 3 - 3 * sin_cos(1.5 * t).cos, 0}, {}};
    });
    const Ride table = ride(CharacterKind::rigid, {2, 0, 1}, 8, [](double t) {
        return Transform{{0, 0, 0}, from_axis_angle({0, 1, 0}, 0.5 * t)};
    });
    record("rigid_lift_gap_m", lift.gap);
    record("rigid_turntable_drift_m", table.drift);
    EXPECT_LE(lift.gap, 0.001);
    EXPECT_LE(table.drift, 0.001);
}

TEST(Platform, turns_with_the_turntable_and_keeps_its_speed_when_it_jumps_off) {
    Stage stage;
    const BodyId table = test::add(stage.world, {.geometry = Box{{4, 0.5, 4}},
                                                 .position = {0, -0.5, 0},
                                                 .spin = {0, 1, 0},
                                                 .type = BodyType::kinematic});
    const CharacterId hero = stage.add({.feet = {2, 0, 0}});
    stage.run(0.5);
    const double heading = stage.of(hero).heading;
    stage.run(1);
    EXPECT_NEAR(stage.of(hero).heading - heading, 1, 1e-9);
    EXPECT_NEAR(length(stage.of(hero).velocity), 2, 0.001);
    stage.steer(hero, {.jump = true});
    stage.run(1 / hz);
    const Vec3 v = stage.of(hero).velocity;
    EXPECT_NEAR(square_root(v.x * v.x + v.z * v.z), 2, 0.001) << "w r";
    EXPECT_TRUE(stage.world.contains(table));
}

TEST(Platform, conveyor_belt_carries_it) {
    Stage stage;
    test::must(stage.world.create_body({.type = BodyType::static_body},
                                       {.geometry = Box{{50, 1, 5}},
                                        .pose = {{0, -1, 0}, {}},
                                        .material = {.surface_velocity = {2, 0, 0}}}));
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.run(1);
    const double start = stage.of(hero).feet.x;
    stage.run(2);
    EXPECT_NEAR(stage.of(hero).feet.x - start, 4, 1e-6);
}

// In one step, the platform moves by more than the skin.
TEST(Platform, fast_lift_or_wall_pushes_it) {
    for (const double speed : {1.0, 3.0, 10.0}) {
        Stage stage;
        test::add_floor(stage.world);
        test::add(stage.world, {.geometry = Box{{0.5, 2, 3}},
                                .position = {-3, 2.1, 0},
                                .velocity = {speed, 0, 0},
                                .type = BodyType::kinematic});
        test::add(stage.world, {.geometry = Box{{1, 0.2, 1}},
                                .position = {0, -1, 20},
                                .velocity = {0, speed, 0},
                                .type = BodyType::kinematic});
        const CharacterId pushed = stage.add({.feet = {0, 0, 0}}),
                          lifted = stage.add({.feet = {0, 0.5, 20}});
        for (int k = 0; k < 2 * hz; k++) {
            stage.run(1 / hz);
            const double t = (k + 1) / hz;
            EXPECT_GE(stage.of(pushed).feet.x, -2.5 + speed * t + 0.3 - 0.2)
                << speed << " m/s, step " << k;
            EXPECT_GE(stage.of(lifted).feet.y, -0.8 + speed * t - 0.2)
                << speed << " m/s, step " << k;
        }
        EXPECT_NEAR(stage.of(pushed).feet.x, maximum(0, -2.5 + 2 * speed + 0.3), 0.02) << speed;
        EXPECT_NEAR(stage.of(lifted).feet.y, -0.8 + 2 * speed, 0.02) << speed;
    }
}

TEST(Platform, wall_stops_it_while_the_platform_moves_on) {
    Stage stage;
    test::add(stage.world, {.geometry = Box{{20, 0.5, 4}},
                            .position = {0, -0.5, 0},
                            .velocity = {2, 0, 0},
                            .type = BodyType::kinematic});
    test::add_static(stage.world, {.geometry = Box{{0.5, 2, 4}}, .position = {4, 2.2, 0}});
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.run(5);
    EXPECT_NEAR(stage.of(hero).feet.x, 3.2, 0.02);
    EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground);
}

}  // namespace
}  // namespace jostle::modules

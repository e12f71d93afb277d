// SPDX-License-Identifier: MIT
//
// Ropes in a world: loads, swings, contacts, cutting, joining, winches and sleep.
#include "jostle/modules/rope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/modules/rope/rope_world.h"

namespace jostle::modules {
namespace {

using namespace physics;

TEST(Ropes, carry_ten_times_their_mass_without_stretching) {
    RopeWorld w;
    const RopeKey rope =
        w.ropes
            ->add(w.world,
                  {.points = {{0, 20, 0}, {0, 10, 0}}, .links = 100, .mass_per_length = 0.1})
            .value();
    const BodyId load = w.box({0, 9.8, 0}, 10);
    w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 20, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 100, .body = load, .point = {0, 0.2, 0}}).expect();
    double most = 0;
    for (int n = 0; n < 300; n++) {
        w.world.step(dt).expect();
        most = std::max(most, w.length_of(rope) / 10 - 1);
    }
    EXPECT_LT(most, 1e-3);
    EXPECT_NEAR(w.ropes->tension(rope, 99), 10 * g, 1);
    EXPECT_NEAR(w.ropes->tension(rope, 0), 11 * g, 1);
    EXPECT_NEAR(w.world.body(load)->center.y, 9.8, 0.012);
}

TEST(Ropes, swing_a_body_as_a_pendulum) {
    RopeWorld w;
    // 4 m from the pivot to the centre, started 0.1 rad aside: T = 2 pi sqrt(4 / g) (1 + 0.1^2/16).
    const double angle = 0.1;
    const Vec3 direction{std::sin(angle), -std::cos(angle), 0};
    const RopeKey rope = w.ropes
                             ->add(w.world, {.points = {{0, 5, 0}, Vec3{0, 5, 0} + direction * 4},
                                             .links = 40,
                                             .mass_per_length = 1e-3,
                                             .damping = 0})
                             .value();
    const BodyId load = w.world
                            .create_body({.pose = {Vec3{0, 5, 0} + direction * 4, {}}},
                                         {.geometry = Sphere{0.05}, .density = 20000})
                            .value();
    w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 5, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 40, .body = load}).expect();
    int crossings = 0;
    double first = 0, last = 0, before = 1, peak = 0;
    for (int n = 1; n <= 60 * 30; n++) {
        w.world.step(dt).expect();
        const double x = w.world.body(load)->center.x;
        if (n > 60 * 25) peak = std::max(peak, x);
        if (before > 0 && x <= 0) {
            last = (n - x / (x - before)) * dt;
            if (crossings++ == 0) first = last;
        }
        before = x;
    }
    const double period = 2 * pi * std::sqrt(4 / g) * (1 + angle * angle / 16);
    EXPECT_NEAR((last - first) / (crossings - 1), period, 0.002 * period);
    EXPECT_GT(peak, 0.97 * 4 * std::sin(angle));  // after 7 periods
}

TEST(Ropes, conserve_momentum_with_bodies) {
    RopeWorld w({.gravity = {}});
    const BodyId a = w.box({0, 0, 0}, 3), b = w.box({2, 0, 0}, 1);
    const RopeKey rope =
        w.ropes
            ->add(w.world, {.points = {{0.2, 0.1, 0}, {1.8, -0.1, 0}}, .links = 16, .damping = 0})
            .value();
    w.ropes->attach(w.world, rope, {.node = 0, .body = a, .point = {0.2, 0.1, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 16, .body = b, .point = {-0.2, -0.1, 0}}).expect();
    w.world.set_velocity(b, {4, 1, 0.5}, {}).expect();
    const auto momentum = [&](Vec3& linear, Vec3& angular) {
        const WorldSummary sum = w.world.summary();
        linear = sum.linear_momentum;
        angular = sum.angular_momentum;
        const auto x = w.ropes->positions(rope), v = w.ropes->velocities(rope);
        const auto rest = w.ropes->rest_lengths(rope);
        for (std::size_t i = 0; i < x.size(); i++) {
            const double m = 0.1 * ((i > 0 ? rest[i - 1] : 0) + (i < 16 ? rest[i] : 0));
            linear += v[i] * m;
            angular += cross(x[i], v[i]) * m;
        }
    };
    Vec3 p0, l0, p1, l1;
    momentum(p0, l0);
    w.run(3);
    momentum(p1, l1);
    // Bodies have single-precision velocities in the solver.
    EXPECT_LT(length(p1 - p0), 1e-4);
    EXPECT_LT(length(l1 - l0), 0.02 * length(l0) + 0.02);
    EXPECT_GT(w.world.body(a)->linear_velocity.x, 0.2);  // was pulled along
}

TEST(Ropes, hang_over_a_bar_and_rest) {
    RopeWorld w;
    w.world
        .create_body({.type = BodyType::static_body,
                      .pose = {{0, 3, 0}, from_axis_angle({1, 0, 0}, pi / 2)}},
                     {.geometry = Cylinder{.radius = 0.3, .half_length = 1}})
        .value();
    const RopeKey rope = w.ropes
                             ->add(w.world, {.points = {{-1.5, 3.5, 0}, {1.5, 3.5, 0}},
                                             .links = 60,
                                             .damping = 2,
                                             .friction = 0.5})
                             .value();
    w.run(10);
    const auto x = w.ropes->positions(rope);
    EXPECT_LT(x.front().y, 2.4);
    EXPECT_LT(x.back().y, 2.4);
    EXPECT_NEAR(x.front().y, x.back().y, 0.3);
    for (const Vec3 p : x) EXPECT_GT(std::hypot(p.x, p.y - 3), 0.31);
    EXPECT_FALSE(w.ropes->is_awake(rope));
}

TEST(Ropes, lie_on_the_floor_and_sleep) {
    RopeWorld w;
    w.world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    const RopeKey rope =
        w.ropes->add(w.world, {.points = {{0, 2, 0}, {0.5, 0.5, 0.1}}, .links = 30}).value();
    w.run(8);
    for (const Vec3 p : w.ropes->positions(rope)) {
        EXPECT_GT(p.y, 0.0185);
        EXPECT_LT(p.y, 0.1);
    }
    EXPECT_FALSE(w.ropes->is_awake(rope));
}

TEST(Ropes, hold_a_resting_body_asleep_and_wake_with_it) {
    RopeWorld w;
    const RopeKey rope =
        w.ropes->add(w.world, {.points = {{0, 5, 0}, {0, 3, 0}}, .links = 20, .damping = 2})
            .value();
    const BodyId load = w.box({0, 2.8, 0}, 5);
    w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 5, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 20, .body = load, .point = {0, 0.2, 0}}).expect();
    w.run(5);
    EXPECT_FALSE(w.world.body(load)->awake);
    EXPECT_FALSE(w.ropes->is_awake(rope));
    w.world.apply_impulse(load, {10, 0, 0}, w.world.body(load)->center).expect();
    w.run(0.2);
    EXPECT_TRUE(w.ropes->is_awake(rope));
    EXPECT_TRUE(w.world.body(load)->awake);
}

TEST(Ropes, fall_in_two_parts_after_a_cut) {
    RopeWorld w;
    const RopeKey rope =
        w.ropes->add(w.world, {.points = {{0, 5, 0}, {4, 5, 0}}, .links = 40}).value();
    w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 5, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 40, .point = {4, 5, 0}}).expect();
    w.run(1);
    const RopeKey rest = w.ropes->cut(w.world, rope, {1, 5, 0}).value();
    ASSERT_EQ(w.ropes->events().size(), 1u);
    EXPECT_EQ(w.ropes->events()[0].kind, RopeEventKind::cut);
    EXPECT_EQ(w.ropes->events()[0].other, rest);
    EXPECT_EQ(w.ropes->positions(rope).size() + w.ropes->positions(rest).size(), 42u);
    EXPECT_EQ(w.ropes->attachments(rest)[0].node, w.ropes->positions(rest).size() - 1);
    w.run(4);
    EXPECT_LT(w.ropes->positions(rope).back().y, 4.3);
    EXPECT_LT(w.ropes->positions(rest).front().y, 2.5);
    // Joined again after the ends were brought together.
    EXPECT_FALSE(w.ropes->join(w.world, rope, rest).ok());
}

TEST(Ropes, join_end_to_end) {
    RopeWorld w;
    const RopeKey a =
        w.ropes->add(w.world, {.points = {{0, 5, 0}, {1, 5, 0}}, .links = 10}).value();
    const RopeKey b =
        w.ropes->add(w.world, {.points = {{1.05, 5, 0}, {2, 5, 0}}, .links = 10}).value();
    w.ropes->attach(w.world, a, {.node = 0, .point = {0, 5, 0}}).expect();
    w.ropes->attach(w.world, b, {.node = 10, .point = {2, 5, 0}}).expect();
    w.ropes->join(w.world, a, b).expect();
    EXPECT_FALSE(w.ropes->contains(b));
    EXPECT_EQ(w.ropes->positions(a).size(), 22u);
    w.run(5);
    EXPECT_NEAR(w.length_of(a), 2, 0.01);
    EXPECT_NEAR(w.ropes->positions(a).back().x, 2, 1e-9);
}

TEST(Ropes, break_above_their_breaking_load) {
    for (const double mass : {5.0, 15.0}) {
        RopeWorld w;
        const RopeKey rope = w.ropes
                                 ->add(w.world, {.points = {{0, 5, 0}, {0, 3, 0}},
                                                 .links = 20,
                                                 .mass_per_length = 0.05,
                                                 .breaking_load = 100})
                                 .value();
        const BodyId load = w.box({0, 2.8, 0}, mass);
        w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 5, 0}}).expect();
        w.ropes->attach(w.world, rope, {.node = 20, .body = load, .point = {0, 0.2, 0}}).expect();
        w.run(2);
        EXPECT_EQ(w.ropes->ropes().size(), mass * g > 100 ? 2u : 1u);
        EXPECT_EQ(w.world.body(load)->center.y<0, mass * g> 100);
    }
}

TEST(Ropes, lift_a_body_with_a_winch) {
    RopeWorld w;
    const RopeKey rope =
        w.ropes->add(w.world, {.points = {{0, 10, 0}, {0, 2, 0}}, .links = 40}).value();
    const BodyId load = w.box({0, 1.8, 0}, 20);
    w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 10, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 40, .body = load, .point = {0, 0.2, 0}}).expect();
    w.ropes->set_winch(w.world, rope, RopeEnd::first, -1).expect();
    w.run(4);
    EXPECT_NEAR(w.world.body(load)->center.y, 5.8, 0.05);
    EXPECT_NEAR(static_cast<double>(w.ropes->positions(rope).size()), 21, 1);
    w.ropes->set_winch(w.world, rope, RopeEnd::first, 1).expect();
    w.run(2);
    EXPECT_NEAR(w.world.body(load)->center.y, 3.8, 0.05);
}

TEST(Ropes, carry_a_plank_at_both_ends) {
    RopeWorld w;
    const BodyId plank = w.box({0, 2, 0}, 8, {0.5, 0.05, 0.2});
    RopeKey rope[2];
    for (int k = 0; k < 2; k++) {
        const double x = k == 0 ? -0.45 : 0.45;
        rope[k] = w.ropes->add(w.world, {.points = {{x, 5, 0}, {x, 2.05, 0}}, .links = 30}).value();
        w.ropes->attach(w.world, rope[k], {.node = 0, .point = {x, 5, 0}}).expect();
        w.ropes->attach(w.world, rope[k], {.node = 30, .body = plank, .point = {x, 0.05, 0}})
            .expect();
    }
    w.run(4);
    EXPECT_NEAR(w.world.body(plank)->center.y, 2, 0.005);
    for (int k = 0; k < 2; k++)
        EXPECT_NEAR(w.ropes->tension(rope[k], 29), 4 * g, 0.03 * 4 * g) << k;
    EXPECT_NEAR(w.world.body(plank)->pose.rotation.z, 0, 0.002);
}

TEST(Ropes, hold_a_log_in_two_slings) {
    RopeWorld w;
    for (const double z : {-0.5, 0.5}) {
        const RopeKey rope =
            w.ropes->add(w.world, {.points = {{-2, 3, z}, {2, 3, z}}, .links = 40, .friction = 0.8})
                .value();
        w.ropes->attach(w.world, rope, {.node = 0, .point = {-1.8, 3, z}}).expect();
        w.ropes->attach(w.world, rope, {.node = 40, .point = {1.8, 3, z}}).expect();
    }
    // A horizontal log along z of 15 kg.
    const BodyId log =
        w.world
            .create_body({.pose = {{0, 3.2, 0}, from_axis_angle({1, 0, 0}, pi / 2)}},
                         {.geometry = Capsule{.radius = 0.15, .half_length = 1}, .density = 100})
            .value();
    w.run(6);
    // The slings sag by sqrt(2^2 - 1.8^2) = 0.87 m to a point below the log.
    EXPECT_NEAR(w.world.body(log)->center.y, 3 - 0.87 + 0.17, 0.15);
    EXPECT_LT(length(w.world.body(log)->linear_velocity), 0.3);
    double sum = 0;  // vertical pull on the four posts
    for (const RopeKey rope : w.ropes->ropes()) {
        const auto x = w.ropes->positions(rope);
        sum += w.ropes->tension(rope, 0) * normalized(x[0] - x[1]).y;
        sum += w.ropes->tension(rope, 39) * normalized(x[40] - x[39]).y;
    }
    const double weight = (w.world.body(log)->mass + 2 * 0.8) * g;
    EXPECT_NEAR(sum, weight, 0.15 * weight);
}

TEST(Ropes, lean_in_the_wind) {
    // A short stiff pendulum of one link: the drag across it equals its weight across it:
    // rho / 2 c 2 r L (w cos a)^2 = m g sin a, as forces per length.
    RopeWorld w;
    w.world.create_field({.force = UniformWind{.velocity = {10, 0, 0}, .density = 1.2, .drag = 1}})
        .value();
    const RopeKey rope = w.ropes
                             ->add(w.world, {.points = {{0, 5, 0}, {0, 4, 0}},
                                             .links = 1,
                                             .radius = 0.02,
                                             .mass_per_length = 0.4,
                                             .damping = 2})
                             .value();
    w.ropes->attach(w.world, rope, {.node = 0, .point = {0, 5, 0}}).expect();
    w.run(10);
    const Vec3 end = w.ropes->positions(rope)[1];
    const double sine = end.x, cosine = 5 - end.y;
    const double drag = 0.5 * 1.2 * 0.04 * 100 * cosine * cosine;
    EXPECT_NEAR(drag, 0.4 * g * sine, 0.01 * drag);
    EXPECT_TRUE(w.ropes->is_awake(rope));
}

}  // namespace
}  // namespace jostle::modules

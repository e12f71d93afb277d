// SPDX-License-Identifier: MIT
//
// Ropes touch each other and themselves: crossings, momentum, knots and the same bits.
#include "modules/rope/src/rope_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/modules/rope/crossings.h"
#include "tests/modules/rope/rope_world.h"

namespace jostle::modules {
namespace {

using namespace physics;

// A rope that is held at both ends and sags.
RopeKey line(RopeWorld& w, Vec3 from, Vec3 to, std::uint32_t links, double slack = 1.1) {
    const RopeKey rope = w.ropes
                             ->add(w.world, {.points = {from, to},
                                             .links = links,
                                             .length = slack * length(to - from),
                                             .collide_ropes = true})
                             .value();
    w.ropes->attach(w.world, rope, {.node = 0, .point = from}).expect();
    w.ropes->attach(w.world, rope, {.node = links, .point = to}).expect();
    return rope;
}

// The upper one falls on the lower one, across it, and both come to rest.
TEST(RopeContacts, one_rope_carries_another) {
    for (const bool collide : {true, false}) {
        RopeWorld w;
        const RopeKey lower = line(w, {-1, 1, 0}, {1, 1, 0}, 40, 1.01);
        RopeDef def{.points = {{0, 1.3, -0.5}, {0, 1.3, 0.5}}, .links = 21, .damping = 1};
        def.collide_ropes = collide;
        const RopeKey upper = w.ropes->add(w.world, def).value();
        w.run(12);
        double most = -10;
        for (const Vec3 p : w.ropes->positions(upper)) most = std::max(most, p.y);
        if (!collide) {
            EXPECT_LT(most, 0.5);
            continue;
        }
        // It hangs over the lower one, on both sides.
        EXPECT_NEAR(most, w.ropes->positions(lower)[20].y + 0.04, 0.02);
        EXPECT_FALSE(w.ropes->is_awake(upper));
    }
}

// Momentum, angular momentum about the origin, and energy of ropes without gravity.
struct Totals {
    Vec3 momentum, angular;
    double energy = 0;
};

// Ropes of 0.2 kg/m and 1 m with 25 links.
Totals totals(const RopeWorld& w, std::span<const RopeKey> ropes) {
    Totals sum;
    for (const RopeKey rope : ropes) {
        const auto x = w.ropes->positions(rope), v = w.ropes->velocities(rope);
        for (std::size_t k = 0; k < x.size(); k++) {
            const double mass = (k == 0 || k + 1 == x.size() ? 0.5 : 1.0) * 0.2 / 25;
            sum.momentum += v[k] * mass;
            sum.angular += cross(x[k], v[k]) * mass;
            sum.energy += 0.5 * mass * length_squared(v[k]);
            if (k + 1 == x.size()) break;
            const double tension = std::max(0.0, w.ropes->tension(rope, k));
            sum.energy += 0.5 * tension * tension / 1e6 / 25;
        }
    }
    return sum;
}

// Three ropes in different directions; the second and third one fall on the others.
std::vector<RopeKey> falling_ropes(RopeWorld& w, double friction, double bending, double speed) {
    std::vector<RopeKey> ropes;
    for (int k = 0; k < 3; k++) {
        const Vec3 half = normalized(Vec3{std::cos(1.1 * k), 0.04 * k, std::sin(1.1 * k)}) * 0.5;
        const Vec3 center{0.05 * k, 0.1 * k, 0.03 * k};
        ropes.push_back(w.ropes
                            ->add(w.world, {.points = {center - half, center + half},
                                            .links = 25,
                                            .bending_stiffness = bending,
                                            .damping = 0,
                                            .friction = friction,
                                            .collide_ropes = true})
                            .value());
        for (std::uint32_t i = 0; k > 0 && i <= 25; i++)
            w.ropes
                ->push(w.world, {.object = ropes.back().number, .element = i},
                       {0, -speed * k * (i == 0 || i == 25 ? 0.5 : 1.0) * 0.2 / 25, 0})
                .expect();
    }
    return ropes;
}

TEST(RopeContacts, conserve_momentum_and_never_add_energy) {
    for (const double friction : {0.0, 0.5})
        for (const double speed : {1.0, 5.0}) {
            RopeWorld w({.gravity = {}});
            const std::vector<RopeKey> ropes = falling_ropes(w, friction, 0, speed);
            const Totals start = totals(w, ropes);
            double energy = start.energy;
            for (int n = 0; n < 60; n++) {
                w.run(dt);
                const Totals now = totals(w, ropes);
                EXPECT_LT(length(now.momentum - start.momentum), 1e-9 * length(start.momentum));
                // Friction acts at the axes, apart from each other. The rest is the error of
                // strands.
                if (friction == 0) {
                    EXPECT_LT(length(now.angular - start.angular), 1e-3 * length(start.angular));
                }
                EXPECT_LE(now.energy, energy * (1 + (friction > 0 ? 1e-6 : 1e-3)));
                energy = now.energy;
            }
            EXPECT_LT(energy, 0.9 * start.energy);
        }
}

// An overhand knot with tails along y: a trefoil that is opened at an outer point.
std::vector<Vec3> overhand(double size, double tail) {
    const auto at = [size](double t) {
        return Vec3{std::sin(3 * t), std::sin(t) + 2 * std::sin(2 * t),
                    std::cos(t) - 2 * std::cos(2 * t)} *
               size;
    };
    std::vector<Vec3> line;
    constexpr int points = 120;
    for (int k = 0; k <= points; k++) line.push_back(at(pi + 0.15 + (2 * pi - 0.3) * k / points));
    const Vec3 first = line.front(), last = line.back(), out = Vec3{0, 0, -1} * size;
    line.insert(line.begin(),
                {first + out + Vec3{0, tail, 0}, first + out + Vec3{0, 0.2 * size, 0}});
    line.insert(line.end(), {last + out + Vec3{0, -0.2 * size, 0}, last + out + Vec3{0, -tail, 0}});
    return line;
}

std::vector<Vec3> nodes(const RopeWorld& w, RopeKey rope) {
    const auto x = w.ropes->positions(rope);
    return {x.begin(), x.end()};
}

// 100 N pull an overhand knot tight. Rope in the knot is missing between the ends: at least eight
// diameters, of which a knot of an ideal rope takes ten.
TEST(RopeContacts, a_knot_holds_100_n) {
    for (const bool collide : {true, false}) {
        RopeWorld w;
        RopeDef def{.points = overhand(0.03, 0.5), .links = 110, .radius = 0.012, .damping = 1};
        def.collide_self = collide;
        const RopeKey rope = w.ropes->add(w.world, def).value();
        double whole = 0;
        for (std::size_t k = 1; k < def.points.size(); k++)
            whole += length(def.points[k] - def.points[k - 1]);
        const BodyId load = w.box(def.points.back() - Vec3{0, 0.1, 0}, 100 / g, {0.1, 0.1, 0.1});
        w.ropes->attach(w.world, rope, {.node = 0, .point = def.points.front()}).expect();
        w.ropes->attach(w.world, rope, {.node = 110, .body = load, .point = {0, 0.1, 0}}).expect();
        int passes = 0;
        for (int n = 0; n < (collide ? 600 : 120); n++) {
            MovingRope moving{.from = nodes(w, rope), .to = {}};
            w.run(dt);
            moving.to = nodes(w, rope);
            passes += count_passes(moving, 4);
        }
        const auto x = w.ropes->positions(rope);
        const double missing = (whole - length(x.back() - x.front())) / 0.024;
        // In units of 0.1 us: contacts count towards the budget of a step.
        const std::int64_t work = w.world.profile().module_work;
        if (!collide) {
            EXPECT_LT(missing, 1);
            EXPECT_LT(work, 1000);
            continue;
        }
        EXPECT_GT(work, 8000);
        EXPECT_LT(work, 80000);
        EXPECT_EQ(passes, 0);
        EXPECT_GT(missing, 8);
        EXPECT_LT(missing, 14);
        EXPECT_LT(w.length_of(rope) / whole, 1.001);
    }
}

// Of a rope of 0.2 kg/m and 1e6 N without bending, and a load at it. Tensions store it: a slack
// rope buckles within its links.
double energy_of(const RopeWorld& w, RopeKey rope, BodyId load, double whole) {
    const auto x = w.ropes->positions(rope), v = w.ropes->velocities(rope);
    const double link = whole / static_cast<double>(x.size() - 1);
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); k++) {
        const double mass = (k == 0 || k + 1 == x.size() ? 0.5 : 1.0) * 0.2 * link;
        sum += mass * (0.5 * length_squared(v[k]) + g * x[k].y);
        if (k + 1 == x.size()) break;
        const double tension = std::max(0.0, w.ropes->tension(rope, k));
        sum += 0.5 * tension * tension / 1e6 * link;
    }
    const BodyState body = w.world.body(load).value();
    const Vec3 spin = body.angular_velocity;
    return sum + body.mass * (0.5 * length_squared(body.linear_velocity) + g * body.center.y) +
           0.5 * dot(spin, body.inertia * spin);
}

// 10 kg fall 1.1 m until the knot is tight: 100 J, and up to 2 kN. The second load falls without
// friction, and bounces for longer.
TEST(RopeContacts, a_knot_that_is_jerked_tight_gains_no_energy) {
    for (const double friction : {0.5, 0.0}) {
        RopeWorld w;
        RopeDef def{.points = overhand(0.05, 0.8),
                    .links = 150,
                    .radius = 0.012,
                    .damping = 1,
                    .friction = friction,
                    .collide_self = true};
        const RopeKey rope = w.ropes->add(w.world, def).value();
        const BodyId load = w.box(def.points.back() - Vec3{0, 0.1, 0}, 10, {0.1, 0.1, 0.1});
        w.ropes->attach(w.world, rope, {.node = 0, .point = def.points.front()}).expect();
        w.ropes->attach(w.world, rope, {.node = 150, .body = load, .point = {0, 0.1, 0}}).expect();
        int passes = 0;
        const double whole = w.length_of(rope);
        double energy = energy_of(w, rope, load, whole), most = 0;
        for (int n = 0; n < (friction > 0 ? 150 : 100); n++) {
            MovingRope moving{.from = nodes(w, rope), .to = {}};
            w.run(dt);
            moving.to = nodes(w, rope);
            passes += count_passes(moving, 4);
            const double now = energy_of(w, rope, load, whole);
            most = std::max(most, now - energy);
            energy = now;
        }
        EXPECT_EQ(passes, 0);
        EXPECT_LT(most, friction > 0 ? 0.01 : 0.5);
    }
}

// A rope with 5 kg at its end falls across a taut one. Returns the number of passes.
int passes_of_drop(double angle, double speed) {
    RopeWorld w;
    const RopeKey lower = line(w, {-1, 2, 0}, {1, 2, 0}, 40, 1);
    const Vec3 half{std::cos(angle), 0, std::sin(angle)}, center{0.1, 2.3, 0.03};
    const RopeKey upper =
        w.ropes
            ->add(w.world,
                  {.points = {center - half, center + half}, .links = 40, .collide_ropes = true})
            .value();
    w.ropes->attach(w.world, upper, {.node = 0, .point = center - half}).expect();
    const BodyId load = w.box(center + half, 5, {0.08, 0.08, 0.08});
    w.world.set_velocity(load, {0, -speed, 0}, {}).expect();
    w.ropes->attach(w.world, upper, {.node = 40, .body = load}).expect();
    for (std::uint32_t i = 1; i <= 40; i++)
        w.ropes
            ->push(w.world, {.object = upper.number, .element = i},
                   {0, -speed * (i == 40 ? 0.5 : 1.0) * 0.2 * 2 / 40, 0})
            .expect();
    int passes = 0;
    for (int n = 0; n < 60; n++) {
        MovingRope a{.from = nodes(w, lower), .to = {}}, b{.from = nodes(w, upper), .to = {}};
        w.run(dt);
        a.to = nodes(w, lower);
        b.to = nodes(w, upper);
        passes += count_passes(a, b);
    }
    return passes;
}

TEST(RopeContacts, a_falling_rope_does_not_pass_another_one) {
    for (const double degrees : {20.0, 45.0, 90.0})
        for (const double speed : {1.0, 4.4, 20.0})
            EXPECT_EQ(passes_of_drop(degrees * pi / 180, speed), 0) << degrees << " " << speed;
}

// A rope over a thick taut one, with 1 kg at one end and another load at the other one. Returns how
// far it slips in the second after the first half of one.
double slip_over_a_rope(double friction, double load) {
    constexpr double turn = 0.1;
    RopeWorld w;
    const RopeKey bar = w.ropes
                            ->add(w.world, {.points = {{-0.5, 2, 0}, {0.5, 2, 0}},
                                            .links = 1,
                                            .radius = 0.09,
                                            .friction = friction,
                                            .collide_ropes = true})
                            .value();
    w.ropes->attach(w.world, bar, {.node = 0, .point = {-0.5, 2, 0}}).expect();
    w.ropes->attach(w.world, bar, {.node = 1, .point = {0.5, 2, 0}}).expect();
    RopeDef def{.points = {{0, 0.8, -turn}},
                .links = 60,
                .radius = 0.01,
                .mass_per_length = 0.02,
                .damping = 1,
                .friction = friction,
                .collide_ropes = true};
    for (int k = 0; k <= 40; k++)
        def.points.push_back({0, 2 + turn * std::sin(pi * k / 40), -turn * std::cos(pi * k / 40)});
    def.points.push_back({0, 0.8, turn});
    const RopeKey rope = w.ropes->add(w.world, def).value();
    const BodyId light = w.box({0, 0.75, -turn}, 1, {0.05, 0.05, 0.05});
    const BodyId heavy = w.box({0, 0.75, turn}, load, {0.05, 0.05, 0.05});
    w.ropes->attach(w.world, rope, {.node = 0, .body = light, .point = {0, 0.05, 0}}).expect();
    w.ropes->attach(w.world, rope, {.node = 60, .body = heavy, .point = {0, 0.05, 0}}).expect();
    w.run(0.5);
    const double start = w.ropes->positions(rope)[0].y;
    w.run(1);
    return w.ropes->positions(rope)[0].y - start;
}

TEST(RopeContacts, a_rope_holds_on_another_one_as_on_a_capstan) {
    for (const double friction : {0.2, 0.3}) {
        const double most = std::exp(friction * pi);
        EXPECT_LT(slip_over_a_rope(friction, 0.9 * most), 1e-3) << friction;
        EXPECT_GT(slip_over_a_rope(friction, 1.1 * most), 0.05) << friction;
    }
}

// Ends of a cut rope, and ropes at one hook, are closer than their diameter.
TEST(RopeContacts, do_not_push_apart_what_starts_close) {
    RopeWorld w({.gravity = {}});
    const RopeKey rope =
        w.ropes
            ->add(w.world, {.points = {{0, 0, 0}, {1, 0, 0}}, .links = 40, .collide_ropes = true})
            .value();
    const RopeKey rest = w.ropes->cut(w.world, rope, {0.5, 0, 0}).value();
    w.run(1);
    for (const RopeKey part : {rope, rest})
        for (const Vec3 v : w.ropes->velocities(part)) EXPECT_LT(length(v), 1e-9);

    RopeWorld hook;
    std::vector<RopeKey> ropes;
    for (const double z : {-0.4, 0.4}) {
        ropes.push_back(
            hook.ropes
                ->add(hook.world,
                      {.points = {{0, 2, 0}, {0, 1.2, z}}, .links = 30, .collide_ropes = true})
                .value());
        hook.ropes->attach(hook.world, ropes.back(), {.node = 0, .point = {0, 2, 0}}).expect();
    }
    hook.run(10);
    for (const RopeKey each : ropes) {
        EXPECT_LT(std::abs(hook.ropes->positions(each).back().z), 0.05);
        EXPECT_FALSE(hook.ropes->is_awake(each));
    }
}

}  // namespace
}  // namespace jostle::modules

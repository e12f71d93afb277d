// SPDX-License-Identifier: MIT
//
// Ropes touch each other and themselves: crossings, momentum, knots and the same bits.
#include "modules/rope/src/rope_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "jostle/physics/serialization.h"
#include "tests/modules/rope/rope_world.h"

namespace jostle::modules {
namespace {

using namespace physics;

// A rope that is held at both ends and sags.
RopeKey line(RopeWorld& w, Vec3 from, Vec3 to, std::uint32_t links, double slack = 1.1) {
    const RopeKey rope =
        w.ropes
            ->add(w.world,
                  {.points = {from, to}, .links = links, .length = slack * length(to - from)})
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
        w.run(6);
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

Vec3 momentum(const RopeWorld& w, RopeKey rope) {
    Vec3 sum;
    const auto v = w.ropes->velocities(rope);
    for (std::size_t k = 0; k < v.size(); k++)
        sum += v[k] * (k == 0 || k + 1 == v.size() ? 0.5 : 1.0);
    return sum;
}

TEST(RopeContacts, conserve_momentum_when_ropes_meet) {
    RopeWorld w({.gravity = {}});
    const RopeKey a =
        w.ropes->add(w.world, {.points = {{-0.5, 0, 0}, {0.5, 0, 0}}, .links = 25, .damping = 0})
            .value();
    const RopeKey b =
        w.ropes
            ->add(w.world,
                  {.points = {{0.07, 0.2, -0.5}, {0.07, 0.2, 0.5}}, .links = 25, .damping = 0})
            .value();
    for (std::uint32_t k = 0; k <= 25; k++)
        w.ropes
            ->push(w.world, {.object = b.number, .element = k},
                   {0, -3 * (k == 0 || k == 25 ? 0.5 : 1.0) * 0.2 / 25, 0})
            .expect();
    const Vec3 before = momentum(w, a) + momentum(w, b);
    w.run(0.5);
    const Vec3 after = momentum(w, a) + momentum(w, b);
    EXPECT_LT(length(after - before), 1e-6 * length(before));
    EXPECT_LT(momentum(w, a).y, 0.1 * before.y);
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

// A weight pulls an overhand knot tight. Rope in the knot is missing between the ends: at least
// eight diameters, of which a knot of an ideal rope takes ten.
TEST(RopeContacts, a_knot_holds) {
    for (const bool collide : {true, false}) {
        RopeWorld w;
        RopeDef def{.points = overhand(0.05, 0.8), .links = 150, .radius = 0.012, .damping = 1};
        def.collide_self = collide;
        const RopeKey rope = w.ropes->add(w.world, def).value();
        double whole = 0;
        for (std::size_t k = 1; k < def.points.size(); k++)
            whole += length(def.points[k] - def.points[k - 1]);
        const BodyId load = w.box(def.points.back() - Vec3{0, 0.1, 0}, 5, {0.1, 0.1, 0.1});
        w.ropes->attach(w.world, rope, {.node = 0, .point = def.points.front()}).expect();
        w.ropes->attach(w.world, rope, {.node = 150, .body = load, .point = {0, 0.1, 0}}).expect();
        for (int n = 0; n < 4; n++) {
            w.run(2);
            const auto x = w.ropes->positions(rope);
            const double missing = whole - length(x.back() - x.front());
            std::printf("collide %d: missing %.2f diameters, stretch %.4f\n", collide,
                        missing / 0.024, w.length_of(rope) / whole - 1);
        }
        const auto x = w.ropes->positions(rope);
        const double missing = (whole - length(x.back() - x.front())) / 0.024;
        if (collide) {
            EXPECT_GT(missing, 8);
            EXPECT_LT(missing, 14);
        } else {
            EXPECT_LT(missing, 1);
        }
    }
}

}  // namespace
}  // namespace jostle::modules

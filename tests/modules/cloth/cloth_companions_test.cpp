// SPDX-License-Identifier: MIT
//
// Cloths touch each other: no crossings, momentum, rest, and the same bits for any thread count.
#include "modules/cloth/src/cloth_companions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "jostle/physics/serialization.h"
#include "tests/modules/cloth/cloth_world.h"
#include "tests/modules/cloth/crossings.h"

namespace jostle::modules {
namespace {

using namespace physics;

ClothDef square(Vec3 origin, double size = 1, std::uint32_t rows = 21) {
    return {.grid = {.rows = rows,
                     .columns = rows,
                     .origin = origin,
                     .across = {size, 0, 0},
                     .down = {0, 0, size}}};
}

int crossings(const ClothWorld& w, ClothKey a, ClothKey b) {
    return cloth_detail::crossings(w.cloths->positions(a), w.cloths->triangles(a),
                                   w.cloths->positions(b), w.cloths->triangles(b));
}

// The lower one is pinned at its border, the upper one is smaller and turned.
TEST(ClothCompanions, one_rests_on_the_other_and_both_sleep) {
    for (const bool collide : {true, false}) {
        ClothWorld w;
        const ClothKey lower = w.cloths->add(w.world, square({0, 1, 0})).value();
        w.pin_border(lower);
        ClothDef def = square({0.3, 1.2, 0.2}, 0.5, 15);
        def.grid.across = {0.45, 0, 0.2};
        def.grid.down = {-0.2, 0, 0.45};
        def.collide_cloths = collide;
        const ClothKey upper = w.cloths->add(w.world, def).value();
        int crossed = 0;
        for (int n = 0; n < 40; n++) {
            w.run(0.25);
            crossed += crossings(w, lower, upper);
        }
        double least = 10;
        for (const Vec3 p : w.cloths->positions(upper)) least = std::min(least, p.y);
        if (!collide) {
            EXPECT_LT(least, 0);
            continue;
        }
        EXPECT_EQ(crossed, 0);
        EXPECT_GT(least, 0.9);
        EXPECT_FALSE(w.cloths->is_awake(upper));
        EXPECT_FALSE(w.cloths->is_awake(lower));
    }
}

// Strips that hang 1 cm apart, at a thickness of 2 cm, do not push each other.
TEST(ClothCompanions, cloths_that_start_closer_than_their_thickness_stay_there) {
    ClothWorld w;
    std::vector<ClothKey> strips;
    for (int k = 0; k < 3; k++) {
        ClothDef def{.grid = {.rows = 11,
                              .columns = 4,
                              .origin = {0.31 * k, 2, 0},
                              .across = {0.3, 0, 0},
                              .down = {0, -1, 0}},
                     .thickness = 0.02};
        strips.push_back(w.cloths->add(w.world, def).value());
        for (std::uint32_t c = 0; c < 4; c++) w.pin(strips.back(), c);
    }
    w.run(3);
    for (int k = 0; k < 3; k++)
        for (std::uint32_t v = 0; v < 44; v++) {
            EXPECT_NEAR(w.cloths->positions(strips[k])[v].x, 0.31 * k + 0.1 * (v % 4), 0.003);
            EXPECT_LT(length(w.cloths->velocities(strips[k])[v]), 0.05);
        }
}

TEST(ClothCompanions, conserve_momentum_when_they_meet) {
    ClothWorld w({.gravity = {}});
    ClothDef def = square({0, 0, 0}, 0.6, 13);
    def.damping = 0;
    const ClothKey a = w.cloths->add(w.world, def).value();
    def.grid.origin = {0.13, 0.2, 0.21};
    def.mass_per_area = 0.5;
    const ClothKey b = w.cloths->add(w.world, def).value();
    for (std::uint32_t v = 0; v < 13 * 13; v++)
        w.cloths->apply_impulse(w.world, b, v, {0, -3 * w.cloths->masses(b)[v], 0}).expect();
    const Vec3 before = w.momentum(a) + w.momentum(b);
    w.run(0.5);
    const Vec3 after = w.momentum(a) + w.momentum(b);
    EXPECT_LT(length(after - before), 1e-6 * length(before));
    EXPECT_LT(w.momentum(a).y, 0.15 * before.y);
    EXPECT_EQ(crossings(w, a, b), 0);
}

// A triangle mesh, flat, in the shape of a disc.
ClothDef disc(Vec3 center, double radius) {
    ClothDef def;
    def.vertices.push_back(center);
    constexpr std::uint32_t spokes = 12, rings = 4;
    for (std::uint32_t r = 1; r <= rings; r++)
        for (std::uint32_t s = 0; s < spokes; s++) {
            const double angle = 2 * pi * s / spokes, size = radius * r / rings;
            def.vertices.push_back(center +
                                   Vec3{size * std::cos(angle), 0, size * std::sin(angle)});
        }
    const auto at = [](std::uint32_t r, std::uint32_t s) {
        return 1 + (r - 1) * spokes + s % spokes;
    };
    for (std::uint32_t s = 0; s < spokes; s++) {
        def.triangles.insert(def.triangles.end(), {0, at(1, s), at(1, s + 1)});
        for (std::uint32_t r = 1; r < rings; r++)
            def.triangles.insert(def.triangles.end(), {at(r, s), at(r + 1, s), at(r + 1, s + 1),
                                                       at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
    return def;
}

// 2 to 40 thicknesses in a step; grids and meshes, thin and thick.
TEST(ClothCompanions, fast_cloth_does_not_pass) {
    for (const double speed : {1.0, 6.0, 20.0})
        for (const bool is_mesh : {false, true})
            for (const double thickness : {0.003, 0.02}) {
                ClothWorld w;
                const ClothKey net = w.cloths->add(w.world, square({0, 1, 0})).value();
                w.pin_border(net);
                ClothDef def =
                    is_mesh ? disc({0.45, 1.3, 0.5}, 0.25) : square({0.25, 1.3, 0.2}, 0.5, 11);
                def.thickness = thickness;
                const ClothKey fast = w.cloths->add(w.world, def).value();
                const std::vector<double> masses = w.cloths->masses(fast);
                for (std::uint32_t v = 0; v < masses.size(); v++)
                    w.cloths->apply_impulse(w.world, fast, v, {0, -speed * masses[v], 0}).expect();
                int crossed = 0;
                for (int n = 0; n < 40; n++) {
                    w.run(1.0 / 60);
                    crossed += crossings(w, net, fast);
                }
                EXPECT_EQ(crossed, 0) << speed << " m/s, mesh " << is_mesh << ", " << thickness;
            }
}

TEST(ClothCompanions, a_sleeping_cloth_wakes_when_another_one_falls_on_it) {
    ClothWorld w;
    const ClothKey lower = w.cloths->add(w.world, square({0, 1, 0}, 1, 11)).value();
    w.pin_border(lower);
    w.run(8);
    ASSERT_FALSE(w.cloths->is_awake(lower));
    w.cloths->add(w.world, square({0.3, 1.5, 0.3}, 0.4, 9)).value();
    w.run(0.2);
    EXPECT_FALSE(w.cloths->is_awake(lower));
    w.run(0.2);
    EXPECT_TRUE(w.cloths->is_awake(lower));
}

// Bodies hang on both cloths, so one group of sub-steps must own all of them.
World two_loaded_cloths(int threads) {
    ClothWorld w({.threads = threads});
    for (int k = 0; k < 2; k++) {
        const ClothKey cloth =
            w.cloths->add(w.world, square({0.1 * k, 1 + 0.2 * k, 0}, 1, 11)).value();
        if (k == 0) w.pin_border(cloth);
        const BodyId box = w.box({0.1 * k - 0.1, 1 + 0.2 * k, -0.1}, 0.05, {0.05, 0.05, 0.05});
        if (k == 0) continue;
        w.cloths->attach(w.world, cloth, {.vertex = 0, .body = box, .point = {0.05, 0, 0.05}})
            .expect();
        w.ball({0.5, 1.6, 0.5}, 0.1, 0.05);
    }
    w.run(0.6);
    return std::move(w.world);
}

TEST(ClothCompanions, have_the_same_bits_for_any_thread_count_and_after_loading) {
    register_cloths();
    World one = two_loaded_cloths(1);
    EXPECT_EQ(state_hash(one), state_hash(two_loaded_cloths(4)));
    World loaded = load(save(one)).value();
    for (int n = 0; n < 20; n++) {
        one.step(dt).expect();
        loaded.step(dt).expect();
    }
    EXPECT_EQ(state_hash(one), state_hash(loaded));
}

TEST(ClothCompanions, one_can_be_removed) {
    ClothWorld w;
    const ClothKey lower = w.cloths->add(w.world, square({0, 1, 0}, 1, 9)).value();
    w.pin_border(lower);
    const ClothKey upper = w.cloths->add(w.world, square({0.2, 1.05, 0.2}, 0.5, 9)).value();
    w.run(1);
    w.cloths->remove(w.world, lower).expect();
    w.run(0.5);
    double most = -10;
    for (const Vec3 p : w.cloths->positions(upper)) most = std::max(most, p.y);
    EXPECT_LT(most, 0.5);
}

}  // namespace
}  // namespace jostle::modules

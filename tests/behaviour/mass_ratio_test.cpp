// SPDX-License-Identifier: MIT
//
// A ton on kilograms: a box of a hundred to a thousand times their mass is let down on light ones
// by 2 cm, and they bear it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Light {
    std::vector<BodyId> bodies;
    double size = 1, load_half = 0.5;  // m
};

Light add_stack(World& world, int count) {
    Light light;
    for (int i = 0; i < count; i++)
        light.bodies.push_back(add(world, {.position = {0.02 * (i % 2), 0.5 + i, 0}}));
    return light;
}

Light add_heap(World& world) {
    Light light{.size = 0.5, .load_half = 1};
    Random random(3);
    for (int i = 0; i < 60; i++)
        light.bodies.push_back(
            add(world,
                {.geometry = Box{{0.25, 0.25, 0.25}},
                 .position = {-1 + 0.52 * (i % 5), 0.26 + 0.52 * (i / 25), -1 + 0.52 * (i / 5 % 5)},
                 .rotation = from_axis_angle({0, 1, 0}, random.in(0, 0.3))}));
    return light;
}

Light add_balls(World& world) {
    Light light{.load_half = 1.4};
    for (int i = 0; i < 9; i++)
        light.bodies.push_back(
            add(world, {.geometry = Sphere{0.5},
                        .position = {-1 + 1.001 * (i % 3), 0.5, -1 + 1.001 * (i / 3)}}));
    return light;
}

// Deepest overlap in six seconds, over the size of what bears the load.
double deepest_under(World& world, const Light& light, double ratio) {
    run(world, 1.5);
    double top = 0;
    for (const BodyId body : light.bodies) top = maximum(top, position_of(world, body).y);
    const double half = light.load_half, volume = light.size * light.size * light.size;
    add(world, {.geometry = Box{{half, half, half}},
                .position = {0, top + light.size / 2 + half + 0.02, 0},
                .density = 1000 * volume * ratio / (8 * half * half * half)});
    double deepest = 0;
    for (int k = 0; k < 360; k++) {
        must(world.step(1.0 / 60));
        deepest = maximum(deepest, world.summary().max_penetration);
    }
    return deepest / light.size;
}

// The load sank for up to eight steps before anybody looked: by 0.07 and 0.10 at a ratio of 100,
// and at 1000 through a stack, a box, and nine balls.
TEST(MassRatio, light_bodies_carry_1000_times_their_mass) {
    for (const double ratio : {100.0, 1000.0}) {
        const std::string name = ", ratio " + std::to_string(ratio);
        for (const int count : {1, 5}) {
            World world = make_world();
            add_floor(world);
            const double deepest = deepest_under(world, add_stack(world, count), ratio);
            RecordProperty("stack of " + std::to_string(count) + name, std::to_string(deepest));
            EXPECT_LT(deepest, 0.03) << "stack of " << count << name;
        }
        World heap = make_world(), balls = make_world();
        add_floor(heap);
        add_floor(balls);
        const double in_heap = deepest_under(heap, add_heap(heap), ratio);
        const double on_balls = deepest_under(balls, add_balls(balls), ratio);
        RecordProperty("heap" + name, std::to_string(in_heap));
        RecordProperty("balls" + name, std::to_string(on_balls));
        // 0.05 while the floor held the heap with friction for its push-out.
        EXPECT_LT(in_heap, 0.06) << name;
        EXPECT_LT(on_balls, 0.01) << name;
    }
}

// How far a body of a stack of boxes moves in three seconds, over the size of a box.
double largest_motion(const std::vector<double>& densities, double offset, double rate) {
    World world = make_world();
    add_floor(world);
    std::vector<BodyId> boxes;
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < densities.size(); k++) {
        places.push_back({k % 2 == 0 ? 0 : offset, 0.5 + static_cast<double>(k), 0});
        boxes.push_back(add(world, {.position = places.back(), .density = densities[k]}));
    }
    double largest = 0;
    for (int n = 0; n < static_cast<int>(3 * rate); n++) {
        must(world.step(1 / rate));
        for (std::size_t k = 0; k < boxes.size(); k++)
            largest = maximum(largest, length(position_of(world, boxes[k]) - places[k]));
    }
    return largest;
}

TEST(MassRatio, two_boxes_of_any_ratio_stand) {
    for (const double ratio : {3.0, 10.0, 31.6, 90.0, 110.0, 1000.0, 1e5})
        EXPECT_LT(largest_motion({1, ratio}, 0, 60), 1e-7) << "ratio " << ratio;
    EXPECT_LT(largest_motion({1, 31.6, 1000}, 0, 60), 1e-7);
    EXPECT_LT(largest_motion({1, 1000, 1, 1000}, 0, 60), 1e-7);
}

// By at most a factor of 1000 from box to box, up or down.
TEST(MassRatio, stacks_of_random_masses_stand) {
    Random random(7);
    for (int stack = 0; stack < 24; stack++) {
        std::vector<double> densities{1};
        const int count = 2 + static_cast<int>(random.in(0, 11));
        while (static_cast<int>(densities.size()) < count)
            densities.push_back(
                minimum(1e6, maximum(1e-6, densities.back() * std::pow(1000, random.in(-1, 1)))));
        const double rate = stack % 3 == 0 ? 30 : 60;
        EXPECT_LT(largest_motion(densities, random.in(0, 0.1), rate), 0.01)
            << "stack " << stack << " of " << count << " at " << rate << " Hz";
    }
}

TEST(MassRatio, tall_stacks_of_graded_and_alternating_masses_stand) {
    std::vector<double> graded, alternating, growing;
    for (int k = 0; k < 30; k++) {
        graded.push_back(std::pow(1000, 1 - absolute(k - 14.5) / 14.5));
        alternating.push_back(k % 2 == 0 ? 1 : 30);
    }
    for (int k = 0; k < 12; k++) growing.push_back(std::pow(3, k));
    EXPECT_LT(largest_motion(graded, 0, 60), 0.01);
    EXPECT_LT(largest_motion(alternating, 0, 60), 0.01);
    EXPECT_LT(largest_motion(growing, 0, 60), 0.01);
}

// Up to twelve boxes and cylinders, by up to a factor of 1000 from one to the next. Returns the
// largest displacement after 3 s, m. `overlapping`: cylinders are as high as they should be wide.
double moved_in_mixed_stack(std::uint64_t seed, double rate, bool overlapping) {
    Random random(seed);
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<std::pair<BodyId, Vec3>> bodies;
    double top = 0, density = 1000;
    const int count = 2 + static_cast<int>(random.in(0, 10));
    for (int k = 0; k < count; k++) {
        const double half = random.in(0.1, 0.5), radius = random.in(0.4, 0.8);
        const Vec3 place{random.in(-0.05, 0.05), top + half, random.in(-0.05, 0.05)};
        Geometry geometry = Box{{radius, half, random.in(0.4, 0.8)}};
        if (random.in(0, 1) < 0.5)
            geometry = overlapping ? Cylinder{half, radius} : Cylinder{radius, half};
        bodies.emplace_back(
            add(world, {.geometry = geometry, .position = place, .density = density}), place);
        top += 2 * half;
        density = minimum(1e6, maximum(1, density * std::pow(1000, random.in(-1, 1))));
    }
    for (int k = 0; k < 3 * rate; k++) must(world.step(1 / rate));
    double furthest = 0;
    for (const auto& [body, place] : bodies)
        furthest = maximum(furthest, length(position_of(world, body) - place));
    return furthest;
}

TEST(MassRatio, stacks_of_boxes_and_cylinders_stand) {
    for (std::uint64_t seed = 1; seed <= 12; seed++)
        EXPECT_LT(moved_in_mixed_stack(seed, 60, false), 0.01) << "seed " << seed;
}

// Islands that are pushed out of overlaps of 0.3 m leave the direct solver. Sweeps that kept its
// impulses threw light bodies by hundreds of metres. How far a body goes is chaotic: of 300 stacks
// the mean is 5 to 6 m, one in a hundred is thrown by more than 60 m, and the worst by 120 to 170
// m. More than four of a hundred happen by chance in one of 270 cases.
TEST(MassRatio, overlapping_stacks_are_not_thrown_far) {
    double sum = 0;
    int far = 0;
    constexpr int stacks = 100;
    for (std::uint64_t seed = 0; seed < stacks; seed++) {
        const double moved = moved_in_mixed_stack(7 * seed + 3, 30, true);
        EXPECT_LT(moved, 200) << "seed " << 7 * seed + 3;
        sum += moved;
        if (moved > 60) far++;
    }
    EXPECT_LT(sum / stacks, 10);
    EXPECT_LE(far, 4);
}

}  // namespace
}  // namespace jostle::test

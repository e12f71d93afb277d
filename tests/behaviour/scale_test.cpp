// SPDX-License-Identifier: MIT
//
// A scene whose lengths are scaled by s does the same when gravity is scaled by s, too, or when
// gravity stays and the steps are scaled by the root of s (Froude): no length of the solver is
// absolute. From plates of 2 by 2 by 0.2 mm to cubes of 100 m.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double usual_gravity = 9.81;

// A scene at 60 Hz at scale 1; lengths in units of the scale.
struct Scaled {
    double s;
    bool gravity_too;

    double gravity() const { return gravity_too ? usual_gravity * s : usual_gravity; }
    double hz() const { return gravity_too ? 60 : 60 / square_root(s); }
    double speed() const { return gravity_too ? s : square_root(s); }  // m/s, of one unit a second
    World world() const { return make_world({.gravity = {0, -gravity(), 0}}); }
    std::string name() const {
        return "scale " + std::to_string(s) + (gravity_too ? ", gravity scaled" : ", rate scaled");
    }
};

std::vector<Scaled> all_scales() {
    std::vector<Scaled> all;
    for (const double s : {0.002, 0.01, 0.1, 1.0, 10.0, 100.0})
        for (const bool gravity_too : {true, false}) all.push_back({s, gravity_too});
    return all;
}

struct Outcome {
    double overlap = 0, tilt = 0, drift = 0, fastest = 0, speed_at_end = 0;  // units, rad, units/s
    double top = 0;
};

Outcome run_scene(const Scaled& scale, World& world, const std::vector<BodyId>& bodies,
                  double seconds) {
    const auto up = [&](BodyId body) {
        return rotate(state_of(world, body).pose.rotation, {0, 1, 0});
    };
    std::vector<Vec3> place, upright;
    for (const BodyId body : bodies) {
        place.push_back(position_of(world, body));
        upright.push_back(up(body));
    }
    Outcome out;
    for (int k = 0; k < static_cast<int>(60 * seconds); k++) {
        must(world.step(1 / scale.hz()));
        out.speed_at_end = 0;
        for (const BodyId body : bodies)
            out.speed_at_end = maximum(out.speed_at_end, length(velocity_of(world, body)));
        out.speed_at_end /= scale.speed();
        out.fastest = maximum(out.fastest, out.speed_at_end);
    }
    out.overlap = world.summary().max_penetration / scale.s;
    for (std::size_t i = 0; i < bodies.size(); i++) {
        const Vec3 now = position_of(world, bodies[i]), way = now - place[i];
        out.tilt = maximum(out.tilt, length(cross(upright[i], up(bodies[i]))));
        out.drift = maximum(out.drift, length(Vec3{way.x, 0, way.z}) / scale.s);
        out.top = maximum(out.top, now.y / scale.s);
    }
    return out;
}

std::vector<BodyId> add_stack(World& world, double s, Vec3 half, int count) {
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; i++)
        boxes.push_back(
            add(world, {.geometry = Box{half * s},
                        .position = Vec3{0.03 * (i % 2), half.y * (1 + 2.002 * i), 0} * s}));
    return boxes;
}

// Cubes overlapped by 2.6 % of their size at 2 mm and by 0.04 % at 1 m, and ten leaned by 0.8 deg.
TEST(Scale, stacks_of_cubes_stand_at_any_scale) {
    for (const Scaled& scale : all_scales())
        for (const int count : {5, 10}) {
            World world = scale.world();
            add_floor(world);
            const Outcome out =
                run_scene(scale, world, add_stack(world, scale.s, {.5, .5, .5}, count), 10);
            RecordProperty("overlap, " + scale.name(), std::to_string(out.overlap));
            EXPECT_LT(out.overlap, 1.6e-3) << scale.name();
            EXPECT_LT(out.tilt, 2e-4) << scale.name();
            EXPECT_LT(out.drift, 2e-3) << scale.name();
            EXPECT_LT(out.speed_at_end, 1e-3) << scale.name();
            EXPECT_NEAR(out.top, count - 0.5, 0.012) << scale.name();
        }
}

// Plates of 100 m sank 0.9 of their thickness into each other.
TEST(Scale, stacks_of_plates_stand_at_any_scale) {
    for (const Scaled& scale : all_scales()) {
        World world = scale.world();
        add_floor(world);
        const Outcome out =
            run_scene(scale, world, add_stack(world, scale.s, {.5, .05, .5}, 10), 10);
        RecordProperty("overlap, " + scale.name(), std::to_string(out.overlap));
        EXPECT_LT(out.overlap, 2e-3) << scale.name();
        EXPECT_LT(out.tilt, 4e-4) << scale.name();
        EXPECT_LT(out.drift, 2e-3) << scale.name();
        EXPECT_LT(out.speed_at_end, 1e-3) << scale.name();
    }
}

// Small ones fell asleep as they were poured: a domino in the fall, with 0.1 and less.
TEST(Scale, dominoes_fall_at_any_scale) {
    for (const Scaled& scale : all_scales()) {
        const double s = scale.s;
        World world = scale.world();
        add_floor(world);
        std::vector<BodyId> row;
        for (int i = 0; i < 12; i++)
            row.push_back(add(world, {.geometry = Box{Vec3{.1, .5, .25} * s},
                                      .position = Vec3{.5 * i, .5, 0} * s,
                                      .spin = {0, 0, i == 0 ? -3 * scale.speed() / s : 0}}));
        run_scene(scale, world, row, 8);
        for (const BodyId body : row) {
            const Vec3 up = rotate(state_of(world, body).pose.rotation, {0, 1, 0});
            EXPECT_LT(up.y, 0.6) << scale.name();
        }
    }
}

// At 2 mm they were asleep on the points of each other after half a second.
TEST(Scale, balls_settle_in_a_bin_at_any_scale) {
    double least = 1e9, most = 0;
    for (const Scaled& scale : all_scales()) {
        const double s = scale.s;
        World world = scale.world();
        add_floor(world);
        for (int side = 0; side < 4; side++) {
            const Vec3 out = side == 0   ? Vec3{1, 0, 0}
                             : side == 1 ? Vec3{0, 0, 1}
                             : side == 2 ? Vec3{-1, 0, 0}
                                         : Vec3{0, 0, -1};
            add_static(world,
                       {.geometry = Box{(side % 2 == 0 ? Vec3{.5, 8, 4} : Vec3{4, 8, .5}) * s},
                        .position = out * 2.7 * s});
        }
        Random random(7);
        std::vector<BodyId> balls;
        for (int i = 0; i < 64; i++)
            balls.push_back(
                add(world, {.geometry = Sphere{.5 * s},
                            .position = (Vec3{-1.5 + 1.02 * (i % 4), .6 + 1.05 * (i / 16),
                                              -1.5 + 1.02 * (i / 4 % 4)} +
                                         random.vector(.02)) *
                                        s}));
        const Outcome out = run_scene(scale, world, balls, 10);
        EXPECT_LT(out.overlap, 1e-3) << scale.name();
        EXPECT_LT(out.speed_at_end, 0.05) << scale.name();
        EXPECT_NEAR(out.fastest, 2.126, 0.01) << scale.name();
        least = minimum(least, out.top);
        most = maximum(most, out.top);
    }
    EXPECT_LT(most - least, 0.2);
}

// What was put into each other left at 47 units a second where it was small, and had not parted
// after ten seconds where it was large.
TEST(Scale, overlapping_bodies_separate_at_any_scale) {
    for (const Scaled& scale : all_scales()) {
        World world = scale.world();
        add_floor(world);
        std::vector<BodyId> boxes;
        for (int i = 0; i < 5; i++)
            boxes.push_back(add(world, {.geometry = Box{Vec3{.5, .5, .5} * scale.s},
                                        .position = Vec3{0, .5 + .5 * i, 0} * scale.s}));
        const Outcome out = run_scene(scale, world, boxes, 10);
        RecordProperty("fastest, " + scale.name(), std::to_string(out.fastest));
        EXPECT_LT(out.fastest, 8) << scale.name();
        EXPECT_LT(out.overlap, 2e-3) << scale.name();
        EXPECT_NEAR(out.top, 4.5, 0.01) << scale.name();
    }
}

// --- at the usual rate ---

struct Small {
    double size, gravity;

    std::string name() const {
        return std::to_string(size) + " m at " + std::to_string(gravity) + " m/s^2";
    }
};
constexpr Small smalls[] = {{0.002, 9.81}, {0.01, 9.81}, {0.1, 981}, {1, 981}};

// Stacks of ten fell within half a second at 60 Hz; dice bounced through the floor at 100 g.
TEST(SmallBodies, stacks_of_ten_stand_at_60_hz) {
    for (const Small& small : smalls) {
        World world = make_world({.gravity = {0, -small.gravity, 0}, .sleeping = false});
        add_floor(world);
        const auto boxes = add_stack(world, small.size, {.5, .5, .5}, 10);
        std::vector<Vec3> places;
        for (const BodyId box : boxes) places.push_back(position_of(world, box));
        run(world, 10);
        for (std::size_t i = 0; i < boxes.size(); i++)
            EXPECT_LT(length(position_of(world, boxes[i]) - places[i]), 0.04 * small.size)
                << small.name() << ", box " << i;
    }
}

TEST(SmallBodies, thrown_dice_come_to_rest_on_a_face) {
    for (const Small& small : smalls)
        for (const double restitution : {0.0, 0.3, 0.6}) {
            World world = make_world({.gravity = {0, -small.gravity, 0}});
            add_floor(world, 0.4, restitution);
            Random random(11);
            const double unit = square_root(small.size * small.gravity);  // m/s
            std::vector<BodyId> dice;
            for (int i = 0; i < 16; i++)
                dice.push_back(add(
                    world,
                    {.geometry = Box{Vec3{.5, .5, .5} * small.size},
                     .position = Vec3{4.0 * (i % 4), random.in(3, 7), 4.0 * (i / 4)} * small.size,
                     .rotation = random.rotation(),
                     .velocity = random.vector(3) * unit,
                     .spin = random.vector(4) * (unit / small.size),
                     .friction = 0.4,
                     .restitution = restitution}));
            run(world, 5);
            for (const BodyId die : dice) {
                const BodyState state = state_of(world, die);
                const Mat3 axes = to_matrix(state.pose.rotation);
                const double upright =
                    maximum(absolute(axes.x.y), maximum(absolute(axes.y.y), absolute(axes.z.y)));
                EXPECT_GT(upright, 0.9999) << small.name() << ", restitution " << restitution;
                EXPECT_NEAR(state.pose.position.y / small.size, 0.5, 0.01) << small.name();
            }
        }
}

}  // namespace
}  // namespace jostle::test

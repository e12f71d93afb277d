// SPDX-License-Identifier: MIT
//
// Steps and stairs.
#include <array>
#include <vector>

#include "jostle/physics/mesh.h"
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

// Height of the feet after walking at a step for twice the time that the distance takes.
double height_after(double step, double speed, double limit, double angle) {
    Stage stage;
    test::add_floor(stage.world);
    test::add_static(stage.world, {.geometry = Box{{50, 1, 50}}, .position = {51, step - 1, 0}});
    const CharacterId hero =
        stage.add({.feet = {-0.5, 0, 0}, .abilities = {.step_height = limit, .floor_snap = limit}});
    const SinCos direction = sin_cos(radians(angle));
    stage.walk(hero, Vec3{direction.cos, 0, direction.sin} * speed);
    stage.run(2.4 / speed + 0.5);
    return stage.of(hero).feet.y;
}

TEST(Climb, climbs_steps_up_to_its_limit_at_any_speed) {
    int tried = 0;
    for (const double limit : {0.2, 0.3, 0.4, 0.6})
        for (double step = 0.05; step < limit + 1e-9; step += 0.05)
            for (const double speed : {0.5, 1.0, 2.0, 3.5, 5.0, 7.0, 10.0})
                for (const double angle : {0.0, 30.0}) {
                    EXPECT_NEAR(height_after(step, speed, limit, angle), step, 0.002)
                        << "step " << step << " limit " << limit << " speed " << speed << " angle "
                        << angle;
                    tried++;
                }
    record("steps_climbed", tried);
}

TEST(Climb, does_not_climb_steps_one_centimetre_above_its_limit) {
    for (const double limit : {0.2, 0.3, 0.4, 0.6})
        for (const double speed : {0.5, 1.0, 2.0, 3.5, 5.0, 7.0, 10.0})
            for (const double angle : {0.0, 30.0})
                EXPECT_NEAR(height_after(limit + 0.01, speed, limit, angle), 0, 0.002)
                    << "limit " << limit << " speed " << speed << " angle " << angle;
}

// Includes slender and stout characters, and other step rates.
TEST(Climb, climbs_at_any_size_and_step_rate) {
    for (const double radius : {0.15, 0.3, 0.5})
        for (const double rate : {30.0, 120.0, 240.0})
            for (const double speed : {0.5, 3.0, 10.0})
                for (const double step : {0.1, 0.25, 0.4, 0.41}) {
                    Stage stage;
                    test::add_floor(stage.world);
                    test::add_static(stage.world,
                                     {.geometry = Box{{50, 1, 50}}, .position = {51, step - 1, 0}});
                    const CharacterId hero = stage.add({.feet = {-0.6, 0, 0}, .radius = radius});
                    stage.walk(hero, {speed, 0, 0});
                    stage.run(2.4 / speed + 0.5, rate);
                    EXPECT_NEAR(stage.of(hero).feet.y, step > 0.4 ? 0 : step, 0.002)
                        << "radius " << radius << " rate " << rate << " speed " << speed << " step "
                        << step;
                }
}

// 20 steps of 0.2 m from x = 4.925 m, up and down again.
void add_stairs_of_boxes(World& world) {
    test::add_floor(world);
    for (int k = 0; k < 20; k++)
        test::add_static(world, {.geometry = Box{{0.15 * (41 - 2 * k) / 2.0, 0.1, 2}},
                                 .position = {8, 0.2 * k + 0.1, 0}});
}
// The same stairs as one surface.
void add_stairs_of_triangles(World& world) {
    std::vector<Vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto line = [&](double x, double y) {
        corners.push_back({x, y, -2});
        corners.push_back({x, y, 2});
    };
    line(-20, 0);
    for (int k = 0; k < 20; k++)
        for (const double y : {0.2 * k, 0.2 * (k + 1)}) line(8 - 0.15 * (41 - 2 * k) / 2.0, y);
    for (int k = 19; k >= 0; k--)
        for (const double y : {0.2 * (k + 1), 0.2 * k}) line(8 + 0.15 * (41 - 2 * k) / 2.0, y);
    line(40, 0);
    for (std::uint32_t k = 0; k + 3 < corners.size(); k += 2) {
        triangles.push_back({k, k + 1, k + 2});
        triangles.push_back({k + 1, k + 3, k + 2});
    }
    test::add_static(world, {.geometry = Mesh{test::must(build_mesh(corners, triangles))}});
}

class Stairs : public testing::TestWithParam<void (*)(World&)> {};

// The walking speed must not drop.
TEST_P(Stairs, climbs_and_descends_at_full_speed) {
    for (const double speed : {1.0, 3.0, 6.0}) {
        Stage stage;
        GetParam()(stage.world);
        const CharacterId hero = stage.add({.feet = {0, 0, 0}});
        stage.walk(hero, {speed, 0, 0});
        stage.run(0.2);
        const double start = stage.of(hero).feet.x;
        double highest = 0;
        const double seconds = 15 / speed;
        for (int k = 0; k < seconds * hz; k++) {
            stage.run(1 / hz);
            highest = maximum(highest, stage.of(hero).feet.y);
            EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground)
                << speed << " m/s at x " << stage.of(hero).feet.x;
        }
        EXPECT_NEAR(highest, 4, 0.002) << speed;
        EXPECT_NEAR(stage.of(hero).feet.y, 0, 0.002) << speed;
        EXPECT_NEAR((stage.of(hero).feet.x - start) / 15, 1, 0.01) << speed;
    }
}

INSTANTIATE_TEST_SUITE_P(Made, Stairs,
                         testing::Values(add_stairs_of_boxes, add_stairs_of_triangles));

TEST(Climb, does_not_stand_by_its_side_on_a_cliff_edge) {
    Stage stage;
    test::add_static(stage.world, {.geometry = Box{{2, 5, 2}}, .position = {0, -5, 0}});
    const CharacterId hero = stage.add({.feet = {2.28, -0.1, 0}});
    stage.run(1);
    EXPECT_LT(stage.of(hero).feet.y, -1);
}

}  // namespace
}  // namespace jostle::modules

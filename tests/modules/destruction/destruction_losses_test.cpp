// SPDX-License-Identifier: MIT
//
// A failure in one destructible does not affect the others: deleted bodies, deleted shapes, and
// diverging states.
#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/serialization.h"
#include "physics/src/state/world_access.h"
#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

// Three walls in a row, each with a ball flying at it.
struct Row {
    Stage stage;
    DestructibleId walls[3];

    Row() {
        stage.floor();
        for (int k = 0; k < 3; k++) {
            DestructibleDef def = standing();
            def.pose.position.z = 10.0 * k;
            walls[k] = stage.add(wall(), def);
            stage.ball({-2, 1.2, 10.0 * k}, {20, 0, 0});
        }
    }
    std::size_t pieces(int k) { return stage.destruction->bodies(walls[k])->size(); }
    // After saving and loading, both worlds must continue identically.
    void expect_sound() {
        World loaded = std::move(*load(save(stage.world)));
        for (int k = 0; k < 30; k++) loaded.step(1.0 / 60).expect();
        stage.step(30);
        EXPECT_EQ(state_hash(loaded), state_hash(stage.world));
    }
};

TEST(DestructionLosses, wall_with_deleted_bodies_is_removed_and_other_walls_still_break) {
    ASSERT_TRUE(registered);
    for (const int step : {0, 8}) {
        Row row;
        row.stage.step(step);
        row.stage.world.destroy_bodies(*row.stage.destruction->bodies(row.walls[1])).expect();
        row.stage.step(30);
        EXPECT_EQ(row.pieces(1), 0u);
        EXPECT_GT(row.pieces(0), 5u);
        EXPECT_GT(row.pieces(2), 5u);
        row.expect_sound();
        row.stage.destruction->remove(row.stage.world, row.walls[1]).expect();
        EXPECT_EQ(row.stage.destruction->size(), 2u);
    }
}

// Deletes every third shape of the middle wall, including its foot.
TEST(DestructionLosses, wall_with_deleted_shapes_still_breaks) {
    Row row;
    row.stage.step(3);
    World& world = row.stage.world;
    const BodyId body = row.stage.destruction->bodies(row.walls[1])->front();
    const std::vector<ShapeId> shapes = world.shapes_of(body);
    for (std::size_t k = 0; k < shapes.size(); k += 3) world.destroy_shape(shapes[k]).expect();
    row.stage.step(30);
    row.stage.destruction->break_near(world, row.walls[1], {0, 1, 10}, 100).value();
    row.stage.step(2);
    EXPECT_EQ(row.pieces(1), shapes.size() - (shapes.size() + 2) / 3);
    EXPECT_GT(row.pieces(0), 5u);
    row.expect_sound();
}

// Deletes all shapes: the piece is removed too.
TEST(DestructionLosses, wall_without_shapes_is_removed) {
    Row row;
    row.stage.step(3);
    const BodyId body = row.stage.destruction->bodies(row.walls[1])->front();
    row.stage.world.set_shapes(body, {}).value();
    row.stage.destruction->break_near(row.stage.world, row.walls[1], {0, 1, 10}, 100).value();
    row.stage.step(30);
    EXPECT_EQ(row.pieces(1), 0u);
    EXPECT_GT(row.pieces(2), 5u);
    row.expect_sound();
}

// Quarantines the ball in front of the middle wall, and later a piece of the wall.
TEST(DestructionLosses, quarantined_body_does_not_break_its_wall) {
    for (const int step : {4, 5, 6, 9}) {
        Row row;
        row.stage.step(step);
        World& world = row.stage.world;
        const auto run_away = [&](BodyId body) {
            warm_of(state_of(world), body.index).v.x = std::nan("");
        };
        run_away(world.bodies()[4]);  // floor, wall, ball, wall, ball
        if (row.pieces(1) > 3) run_away(row.stage.destruction->bodies(row.walls[1])->at(2));
        row.stage.step(30);
        EXPECT_GT(row.pieces(0), 5u) << step;
        EXPECT_GT(row.pieces(2), 5u) << step;
        const WorldSummary sum = world.summary();
        EXPECT_TRUE(std::isfinite(sum.kinetic_energy));
        for (const BodyId body : world.bodies()) EXPECT_TRUE(is_finite(world.body(body)->center));
        EXPECT_TRUE(
            load_module(*std::make_unique<Destruction>(), save_module(*row.stage.destruction))
                .ok());
    }
}

}  // namespace
}  // namespace jostle::modules

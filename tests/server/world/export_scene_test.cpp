// SPDX-License-Identifier: MIT
//
// A world that is exported and built again is as it was: bodies where they were and as fast, joints
// that hold, what clients spawned.
#include "server/world/export_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/modules/island_coupling.h"
#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using test::dt;

struct Hosted {
    explicit Hosted(const char* name) : scene(*scenes::find_scene(name)) {}

    void step(int times) {
        for (int i = 0; i < times; i++) ASSERT_TRUE(world.step(dt).ok());
    }
    EntityId apply(Action action) {
        const InputResult result = world.apply(
            {.client = 1, .sequence = ++sequence, .action = std::move(action), .reply = {}}, 1);
        EXPECT_TRUE(result.status.ok()) << result.status.error().message;
        return result.entity;
    }
    EntityId named(const std::string& name) {
        Frame frame;
        world.copy_into(frame);
        for (const auto& entity : *frame.entity_list)
            if (entity->name == name) return entity->id;
        return 0;
    }

    scenes::SceneDescription scene;
    HostedWorld world = std::move(*HostedWorld::create(scene, {}, 1));
    std::uint32_t sequence = 0;
};

TEST(ExportScene, round_trips_every_small_scene) {
    int scenes_seen = 0;
    for (const auto& entry : scenes::catalog()) {
        const std::string name(entry.name);
        if (scenes::find_scene(name)->bodies.size() > 250) continue;
        scenes_seen++;
        Hosted hosted(name.c_str());
        hosted.step(40);
        const ExportedScene exported = hosted.world.exported(hosted.scene);
        const auto built = scenes::build_scene(exported.scene);
        ASSERT_TRUE(built.ok()) << name << ": " << built.error().message;
        const physics::WorldSummary was = hosted.world.world().summary(),
                                    is = built->world.summary();
        // Modules create their bodies again, as the export reports.
        if (was.bodies > static_cast<int>(hosted.scene.bodies.size())) {
            EXPECT_TRUE(std::ranges::any_of(exported.omitted, [](const std::string& sentence) {
                return sentence.find("create them again") != std::string::npos;
            })) << name;
            continue;
        }
        EXPECT_EQ(is.bodies, was.bodies) << name;
        EXPECT_EQ(is.shapes, was.shapes) << name;
        // Modules couple bodies again in the first step.
        const auto joints = hosted.world.world().joints();
        const auto couplings = std::ranges::count_if(joints, [&](physics::JointId id) {
            return modules::is_island_coupling(hosted.world.world().joint(id)->def.kind);
        });
        EXPECT_EQ(is.joints, was.joints - couplings) << name;
        EXPECT_EQ(exported.scene.modules.size(), hosted.scene.modules.size()) << name;
        EXPECT_TRUE(exported.omitted.empty()) << name << ": " << exported.omitted.front();
        EXPECT_NEAR(is.kinetic_energy, was.kinetic_energy, 1e-9 * (1 + was.kinetic_energy)) << name;
        EXPECT_NEAR(is.potential_energy, was.potential_energy,
                    1e-9 * (1 + std::abs(was.potential_energy)))
            << name;
    }
    EXPECT_GT(scenes_seen, 15);
}

TEST(ExportScene, includes_spawned_and_excludes_deleted_bodies) {
    Hosted hosted("stack");
    const std::size_t before = hosted.scene.bodies.size();
    SpawnCommand spawn;
    spawn.shape.geometry = physics::Sphere{0.3};
    spawn.pose.position = {5, 20, 0};
    spawn.linear_velocity = {1, 2, 3};
    spawn.color = 0x00ff00;
    hosted.apply(spawn);
    const EntityId gone = hosted.apply(spawn);
    hosted.apply(DeleteCommand{gone});
    const ExportedScene exported = hosted.world.exported(hosted.scene);
    ASSERT_EQ(exported.scene.bodies.size(), before + 1);
    const scenes::SceneBody& ball = exported.scene.bodies.back();
    EXPECT_EQ(ball.color, 0x00ff00u);
    EXPECT_EQ(ball.body.linear_velocity, (physics::Vec3{1, 2, 3}));
    EXPECT_EQ(std::get<physics::Sphere>(ball.shapes[0].geometry).radius, 0.3);
    EXPECT_EQ(exported.scene.name, "stack");
    EXPECT_EQ(exported.scene.hz, hosted.scene.hz);
    EXPECT_EQ(exported.scene.precision.position, hosted.scene.precision.position);
}

// A hand is a joint of the world that no scene has.
TEST(ExportScene, omits_grabs_and_reports_it) {
    Hosted hosted("stack");
    SpawnCommand spawn;
    spawn.shape.geometry = physics::Sphere{0.3};
    spawn.pose.position = {5, 20, 0};
    const EntityId ball = hosted.apply(spawn);
    hosted.apply(GrabCommand{ball, {5, 20, 0}});
    const ExportedScene exported = hosted.world.exported(hosted.scene);
    ASSERT_EQ(exported.omitted.size(), 1u);
    EXPECT_NE(exported.omitted[0].find("grabs of clients"), std::string::npos)
        << exported.omitted[0];
    EXPECT_TRUE(scenes::build_scene(exported.scene).ok());
}

}  // namespace
}  // namespace jostle::server

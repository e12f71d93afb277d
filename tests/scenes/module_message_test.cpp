// SPDX-License-Identifier: MIT
//
// Modules of a scene: reading, creation, settings, saved state and writing.
#include "scenes/src/module_message.h"

#include <gtest/gtest.h>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/scene.pb.h"
#include "tests/scenes/turntable.h"
#include "tests/support/step_time.h"

namespace jostle::scenes {
namespace {

using test::Turntable;

using test::dt;

// The module uses the second disc.
std::string turntable(const std::string& module) {
    return R"({"name": "a", "bodies": [{"name": "disc", "type": "BODY_TYPE_KINEMATIC",
  "shapes": [{"cylinder": {"radius": 1, "half_length": 0.1}}],
  "repeat": [{"count": 2, "offset": {"x": 5}}]}],
 "modules": [{"tag": "turntable", )" +
           module + "}]}";
}

class ModuleMessage : public testing::Test {
protected:
    void SetUp() override { test::register_turntable(); }

    static SceneDescription read(const std::string& text) {
        auto scene = read_scene_json(text);
        EXPECT_TRUE(scene.ok()) << scene.error().message;
        return scene.ok() ? *scene : SceneDescription{};
    }
    static const Turntable& module_of(const BuiltScene& built) {
        return dynamic_cast<const Turntable&>(*built.world.module("turntable"));
    }
};

}  // namespace

TEST_F(ModuleMessage, module_receives_settings_in_name_order_and_bodies_by_name) {
    const auto built = build_scene(
        read(turntable(R"("settings": {"speed": 2, "gain": 0}, "bodies": {"disc": "disc[1]"})")));
    ASSERT_TRUE(built.ok()) << built.error().message;
    EXPECT_EQ(module_of(*built).order, "gain speed ");
    EXPECT_EQ(module_of(*built).disc(), built->bodies[1]);
    EXPECT_FALSE(module_of(*built).restored_in_world) << "a new module is not restored";
}

TEST_F(ModuleMessage, module_acts_on_the_world) {
    auto built = build_scene(
        read(turntable(R"("settings": {"speed": 2, "gain": 0.6}, "bodies": {"disc": "disc[1]"})")));
    ASSERT_TRUE(built.ok()) << built.error().message;
    for (int tick = 0; tick < 60; tick++) ASSERT_TRUE(built->world.step(dt).ok());
    EXPECT_NEAR(built->world.body(built->bodies[1])->angular_velocity.y, 2.6, 1e-9);
    EXPECT_EQ(built->world.body(built->bodies[0])->angular_velocity.y, 0);
}

TEST_F(ModuleMessage, saved_module_state_is_read_after_its_settings) {
    SceneDescription scene =
        read(turntable(R"("settings": {"speed": 2, "gain": 0.6}, "bodies": {"disc": "disc[1]"})"));
    auto first = build_scene(scene);
    ASSERT_TRUE(first.ok());
    for (int tick = 0; tick < 60; tick++) ASSERT_TRUE(first->world.step(dt).ok());
    scene.modules[0].state = physics::save_module(*first->world.module("turntable"));

    const auto after = build_scene(read(write_scene_json(scene)));
    ASSERT_TRUE(after.ok()) << after.error().message;
    EXPECT_EQ(module_of(*after).speed(), module_of(*first).speed());
    EXPECT_EQ(module_of(*after).disc(), after->bodies[1]);
    EXPECT_TRUE(module_of(*after).restored_in_world);
}

TEST_F(ModuleMessage, module_round_trips) {
    const SceneDescription scene =
        read(turntable(R"("settings": {"speed": 0.1, "gain": -3}, "bodies": {"disc": "disc[1]"})"));
    v1::Module message;
    write_module(message, scene, scene.modules[0]);
    EXPECT_EQ(message.tag(), "turntable");
    EXPECT_EQ(message.bodies().at("disc"), "disc[1]");
    EXPECT_EQ(message.settings().at("gain"), -3);
    const SceneDescription back = read(write_scene_json(scene));
    const auto a = build_scene(scene), b = build_scene(back);
    ASSERT_TRUE(a.ok() && b.ok());
    EXPECT_EQ(physics::first_difference(a->world, b->world).value_or(""), "");
}

TEST_F(ModuleMessage, rejects_more_than_64_modules) {
    v1::Module message;
    message.set_tag("turntable");
    SceneDescription scene;
    for (std::size_t k = 0; k < modules_max; k++)
        scene.modules.push_back({.tag = "m" + std::to_string(k)});
    FieldReader in;
    read_module(in, scene, "modules[64]", message);
    ASSERT_TRUE(in.failed());
    EXPECT_EQ(in.errors().front().path, "modules[64]");
    EXPECT_EQ(in.errors().front().what, "exceeds the maximum of 64 modules in a scene");
}

}  // namespace jostle::scenes

// SPDX-License-Identifier: MIT
//
// Errors of calls, scene settings, driver input and client channels.
#include "tests/modules/character/stage.h"
#include "tests/support/error_of.h"

namespace jostle::modules {
namespace {

using namespace physics;

std::string error_of(const CharacterDef& def) {
    Stage stage;
    return test::error_of(stage.crowd->add(stage.world, def)).message;
}

TEST(Calls, errors_name_values_out_of_range) {
    EXPECT_EQ(error_of({.radius = 0}), "radius is 0; it must be from 0.05 to 5");
    EXPECT_EQ(error_of({.skin = 0.2}), "skin is 0.2; it must be from 0.002 to 0.15");
    EXPECT_EQ(error_of({.abilities = {.mass = 0}}), "mass is 0; it must be from 1 to 10000");
    EXPECT_EQ(error_of({.height = 0.6}), "height is 0.6; it must be from 0.6002 to 20");
    Stage stage;
    const CharacterId hero = stage.add({});
    EXPECT_EQ(test::error_of(stage.crowd->set_controls(hero, {.walk = {0, 0, 1e4}})).message,
              "walk is 10000; it must be from -1000 to 1000");
    EXPECT_EQ(test::error_of(stage.crowd->set_controls({}, {})).code, ErrorCode::not_found);
}

TEST(Calls, ids_expire_with_the_character_and_indices_are_reused) {
    Stage stage;
    const CharacterId first = stage.add({});
    const CharacterId second = stage.add({.feet = {5, 0, 0}});
    test::must(stage.crowd->remove(stage.world, first));
    EXPECT_FALSE(stage.crowd->contains(first));
    EXPECT_FALSE(stage.crowd->state(stage.world, first).ok());
    const CharacterId third = stage.add({.feet = {9, 0, 0}});
    EXPECT_EQ(third.index, first.index);
    EXPECT_NE(third, first);
    test::must(stage.world.destroy_body(stage.of(second).body));
    stage.run(0.1);
    EXPECT_FALSE(stage.crowd->contains(second)) << "it is removed with its body";
    EXPECT_EQ(stage.crowd->ids(), std::vector<CharacterId>{third});
}

struct Cast {
    World world;
    BodyId walker, runner;
    Characters characters;

    Cast() {
        test::add_floor(world);
        walker = test::add(
            world,
            {.geometry = Capsule{0.28, 0.6}, .position = {0, 0.9, 0}, .type = BodyType::kinematic});
        runner = test::add(world, {.geometry = Capsule{0.3, 0.6}, .position = {3, 0.9, 0}});
    }
    std::string error_of(const ModuleSettings& settings) {
        return test::error_of(characters.configure(world, settings)).message;
    }
};

TEST(Scene, scene_bodies_become_characters_of_matching_kind) {
    Cast cast;
    test::must(cast.characters.configure(
        cast.world, {.numbers = {{"stroll", 2}, {"stroll_turn", 0.5}, {"jump_speed", 6}},
                     .bodies = {{"walker", cast.walker}, {"runner", cast.runner}}}));
    const CharacterState walker =
        test::must(cast.characters.state(cast.world, cast.characters.character_of(cast.walker)));
    EXPECT_EQ(walker.kind, CharacterKind::sweeping);
    EXPECT_NEAR(walker.feet.y, 0, 1e-9) << "below the body by the skin";
    EXPECT_TRUE(cast.characters.is_controllable(cast.runner));
    EXPECT_EQ(
        test::must(cast.characters.abilities(cast.characters.character_of(cast.runner))).jump_speed,
        6);
    EXPECT_FALSE(cast.characters.is_controllable({}));
}

// 2 m/s at 0.5 rad/s: circles with a radius of 4 m.
TEST(Scene, strolls_in_circles_until_controlled) {
    Cast cast;
    auto module = std::make_unique<Characters>();
    Characters& characters = *module;
    test::must(characters.configure(cast.world, {.numbers = {{"stroll", 2}, {"stroll_turn", 0.5}},
                                                 .bodies = {{"walker", cast.walker}}}));
    test::must(cast.world.add_module(std::move(module)));
    test::run(cast.world, 1);
    const Vec3 start = test::position_of(cast.world, cast.walker);
    test::run(cast.world, 2 * pi);
    EXPECT_NEAR(length(test::position_of(cast.world, cast.walker) - start), 8, 0.1);
    Controls stick;
    stick.axes[1] = 1;
    stick.axes[3] = -0.5;  // views along +x
    characters.control(cast.world, cast.walker, stick);
    test::run(cast.world, 0.5);
    EXPECT_TRUE(test::near(test::velocity_of(cast.world, cast.walker), {5, 0, 0}, 1e-6));
}

TEST(Scene, errors_name_the_invalid_setting) {
    Cast cast;
    const BodyId crate = test::add(cast.world, {.position = {9, 0.5, 0}});
    EXPECT_EQ(cast.error_of({.bodies = {{"crate", crate}}}),
              "crate has the wrong first shape; it must be an upright capsule");
    EXPECT_EQ(cast.error_of({.numbers = {{"mass", 0}}, .bodies = {{"walker", cast.walker}}}),
              "mass is 0; it must be from 1 to 10000");
    EXPECT_EQ(cast.error_of({}), "has no body; name at least one body that becomes a character");
    EXPECT_EQ(cast.error_of({.bodies = {{"ghost", BodyId{99, 1}}}}), "ghost is not a body");
    EXPECT_EQ(cast.error_of({.numbers = {{"sped", 1}}}).substr(0, 23), "unknown setting sped; m");
}

TEST(Scene, publishes_each_character_in_eight_bytes) {
    Stage stage;
    test::add_floor(stage.world);
    stage.add({.feet = {0, 0, 0}});
    const CharacterId low = stage.add({.feet = {3, 0, 0}});
    stage.steer(low, {.walk = {0, 0, -10}, .crouch = true});
    stage.run(1);
    ChannelWriter writer([](BodyId body) { return body.index + 1; });
    stage.crowd->publish(stage.world, writer);
    ASSERT_EQ(writer.channels().size(), 2u);
    EXPECT_EQ(writer.channels()[0].values[0], 0);
    EXPECT_EQ(writer.channels()[1].values[0], 2) << "crouched, on the ground";
    EXPECT_EQ(writer.channels()[1].values[2], 128) << "10 of 20 m/s";
}

}  // namespace
}  // namespace jostle::modules

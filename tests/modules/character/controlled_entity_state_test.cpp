// SPDX-License-Identifier: MIT
//
// Applies the state of a character to another world (jostle/modules/controlled_entity_state.h), as
// a client does to predict its own character.
#include "jostle/modules/controlled_entity_state.h"

#include "tests/modules/character/stage.h"
#include "tests/modules/corrupted_words.h"

namespace jostle::modules {
namespace {

using namespace physics;

struct TwoWorlds {
    Stage server, client;
    CharacterId hero;
    BodyId body, copy;

    explicit TwoWorlds(CharacterKind kind) {
        for (Stage* stage : {&server, &client}) {
            test::add_floor(stage->world);
            for (int k = 1; k < 4; k++)  // stairs
                test::add_static(stage->world, {.geometry = Box{{0.5, 0.1 * k, 2}},
                                                .position = {2.0 + k, 0.1 * k, 0}});
        }
        test::add(client.world, {.position = {20, 3, 0}});  // so that ids differ
        hero = server.add({.kind = kind, .feet = {0, 0.02, 0}});
        body = server.of(hero).body;
        copy = test::must(client.world.create_body(
            {.type = kind == CharacterKind::rigid ? BodyType::dynamic : BodyType::kinematic,
             .pose = {.position = {5, 5, 5}}},
            def_of(test::must(server.world.shape(server.world.shapes_of(body)[0])))));
    }
    std::vector<std::uint32_t> encode() {
        return encode_controlled_entity(server.world, *server.crowd, body,
                                        [&](BodyId id) { return id == body ? 3u : 0u; })
            .value();
    }
    bool apply(std::span<const std::uint32_t> words) {
        return apply_controlled_entity(
            client.world, *client.crowd, copy, words,
            [&](std::uint32_t name) { return name == 3 ? copy : BodyId{}; });
    }
    double distance() {
        return length(test::must(client.world.body(copy)).pose.position -
                      test::must(server.world.body(body)).pose.position);
    }
};

TEST(ControlledCharacter, walks_up_stairs_identically_in_another_world) {
    for (const CharacterKind kind : {CharacterKind::sweeping, CharacterKind::rigid}) {
        TwoWorlds of(kind);
        of.server.walk(of.hero, {4, 0, 0.5});
        of.server.run(0.25);
        ASSERT_TRUE(of.apply(of.encode()));
        of.server.run(0.5);
        of.client.run(0.5);
        EXPECT_LT(of.distance(), 1e-4) << static_cast<int>(kind);
        EXPECT_GT(test::must(of.server.world.body(of.body)).pose.position.x, 2);
        // In the client world, it jumps and crouches with other input.
        of.client.crowd->control(of.client.world, of.copy, {.axes = {1, 0}, .buttons = 1});
        of.server.steer(of.hero, {.walk = {0, 0, 0}, .crouch = true});
        of.server.run(0.3);
        of.client.run(0.3);
        EXPECT_GT(of.distance(), 0.4);
        ASSERT_TRUE(of.apply(of.encode()));
        EXPECT_LT(of.distance(), 1e-5);
        EXPECT_TRUE(of.client.of(of.client.crowd->character_of(of.copy)).crouched);
        of.server.run(0.2);
        of.client.run(0.2);
        // A rigid character retains the contacts of its previous position: 0.3 mm until these
        // settle.
        EXPECT_LT(of.distance(), 5e-4);
    }
}

TEST(ControlledCharacter, words_that_make_no_sense_change_nothing) {
    TwoWorlds of(CharacterKind::sweeping);
    of.server.walk(of.hero, {3, 0, 0});
    of.server.run(0.3);
    const std::vector<std::uint32_t> good = of.encode();
    ASSERT_TRUE(of.apply(good));
    test::Random random(6);
    int refused = 0;
    for (int k = 0; k < 3000; k++) {
        const Transform before = test::must(of.client.world.body(of.copy)).pose;
        if (!of.apply(test::corrupted(good, random))) {
            refused++;
            EXPECT_EQ(test::must(of.client.world.body(of.copy)).pose, before);
        }
        of.client.run(1.0 / 60);
        ASSERT_TRUE(of.apply(good)) << k;
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace jostle::modules

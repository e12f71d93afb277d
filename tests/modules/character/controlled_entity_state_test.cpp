// SPDX-License-Identifier: MIT
//
// A character that goes on in another world (jostle/modules/controlled_entity_state.h): what a
// client foresees of the one that it walks with.
#include "jostle/modules/controlled_entity_state.h"

#include "tests/modules/character/stage.h"
#include "tests/modules/corrupted_words.h"

namespace jostle::modules {
namespace {

using namespace physics;

struct TwoWorlds {
    Stage there, here;
    CharacterId hero;
    BodyId body, copy;

    explicit TwoWorlds(CharacterKind kind) {
        for (Stage* stage : {&there, &here}) {
            test::add_floor(stage->world);
            for (int k = 1; k < 4; k++)  // stairs
                test::add_static(stage->world, {.geometry = Box{{0.5, 0.1 * k, 2}},
                                                .position = {2.0 + k, 0.1 * k, 0}});
        }
        test::add(here.world, {.position = {20, 3, 0}});  // so that ids differ
        hero = there.add({.kind = kind, .feet = {0, 0.02, 0}});
        body = there.of(hero).body;
        copy = test::must(here.world.create_body(
            {.type = kind == CharacterKind::rigid ? BodyType::dynamic : BodyType::kinematic,
             .pose = {.position = {5, 5, 5}}},
            def_of(test::must(there.world.shape(there.world.shapes_of(body)[0])))));
    }
    std::vector<std::uint32_t> encode() {
        return encode_controlled_entity(there.world, *there.crowd, body,
                                        [&](BodyId id) { return id == body ? 3u : 0u; })
            .value();
    }
    bool apply(std::span<const std::uint32_t> words) {
        return apply_controlled_entity(
            here.world, *here.crowd, copy, words,
            [&](std::uint32_t name) { return name == 3 ? copy : BodyId{}; });
    }
    double distance() {
        return length(test::must(here.world.body(copy)).pose.position -
                      test::must(there.world.body(body)).pose.position);
    }
};

TEST(ControlledCharacter, walks_up_stairs_identically_in_another_world) {
    for (const CharacterKind kind : {CharacterKind::sweeping, CharacterKind::rigid}) {
        TwoWorlds of(kind);
        of.there.walk(of.hero, {4, 0, 0.5});
        of.there.run(0.25);
        ASSERT_TRUE(of.apply(of.encode()));
        of.there.run(0.5);
        of.here.run(0.5);
        EXPECT_LT(of.distance(), 1e-4) << static_cast<int>(kind);
        EXPECT_GT(test::must(of.there.world.body(of.body)).pose.position.x, 2);
        // It jumps and crouches here, by its own stick.
        of.here.crowd->control(of.here.world, of.copy, {.axes = {1, 0}, .buttons = 1});
        of.there.steer(of.hero, {.walk = {0, 0, 0}, .crouch = true});
        of.there.run(0.3);
        of.here.run(0.3);
        EXPECT_GT(of.distance(), 0.4);
        ASSERT_TRUE(of.apply(of.encode()));
        EXPECT_LT(of.distance(), 1e-5);
        EXPECT_TRUE(of.here.of(of.here.crowd->character_of(of.copy)).crouched);
        of.there.run(0.2);
        of.here.run(0.2);
        // A rigid one has the contacts of where it was before: .3 mm until these have settled.
        EXPECT_LT(of.distance(), 5e-4);
    }
}

TEST(ControlledCharacter, words_that_make_no_sense_change_nothing) {
    TwoWorlds of(CharacterKind::sweeping);
    of.there.walk(of.hero, {3, 0, 0});
    of.there.run(0.3);
    const std::vector<std::uint32_t> good = of.encode();
    ASSERT_TRUE(of.apply(good));
    test::Random random(6);
    int refused = 0;
    for (int k = 0; k < 3000; k++) {
        const Transform before = test::must(of.here.world.body(of.copy)).pose;
        if (!of.apply(test::corrupted(good, random))) {
            refused++;
            EXPECT_EQ(test::must(of.here.world.body(of.copy)).pose, before);
        }
        of.here.run(1.0 / 60);
        ASSERT_TRUE(of.apply(good)) << k;
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace jostle::modules

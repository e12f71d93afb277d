// SPDX-License-Identifier: MIT
//
// Many characters among crates between walls: speeds stay limited, and no character escapes.
#include "tests/modules/character/stage.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

using namespace physics;

void add_arena(World& world, double half) {
    test::add_floor(world);
    for (const double side : {-1.0, 1.0}) {
        test::add_static(
            world, {.geometry = Box{{0.5, 2, half + 1}}, .position = {side * (half + 0.5), 2, 0}});
        test::add_static(
            world, {.geometry = Box{{half + 1, 2, 0.5}}, .position = {0, 2, side * (half + 0.5)}});
    }
}

TEST(Crowd, dense_crowd_stays_stable) {
    constexpr double half = 7;
    Stage stage;
    add_arena(stage.world, half);
    for (int k = 0; k < 64; k++)
        test::add(stage.world, {.geometry = Box{{0.3, 0.3, 0.3}},
                                .position = {-6.0 + k % 8 * 1.7, 0.3, -6.0 + k / 8 * 1.7},
                                .density = k % 3 == 0 ? 300.0 : 60.0});
    for (int k = 0; k < 36; k++)
        stage.add({.kind = k % 6 == 0 ? CharacterKind::rigid : CharacterKind::sweeping,
                   .feet = {-5.15 + k % 6 * 1.7, 0, -5.15 + k / 6 * 1.7}});
    test::Random random(4);
    double fastest = 0;
    int outside = 0;
    for (int k = 0; k < 20 * hz; k++) {
        if (k % 40 == 0)
            for (const CharacterId id : stage.crowd->ids()) {
                const SinCos direction = sin_cos(random.in(-pi, pi));
                stage.steer(id, {.walk = Vec3{direction.cos, 0, direction.sin} * 5,
                                 .jump = random.below(4) == 0});
            }
        stage.run(1 / hz);
        for (const BodyId body : stage.world.bodies())
            fastest = maximum(fastest, length(test::velocity_of(stage.world, body)));
        for (const CharacterId id : stage.crowd->ids()) {
            const Vec3 feet = stage.of(id).feet;
            if (maximum(absolute(feet.x), absolute(feet.z)) > half || feet.y < -0.05) outside++;
        }
    }
    record("fastest_in_crowd_m_s", fastest);
    EXPECT_EQ(outside, 0);
    EXPECT_LE(fastest, 12) << "a jump plus a run, and the impact of a light crate";
}

}  // namespace
}  // namespace jostle::modules

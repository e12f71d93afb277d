// SPDX-License-Identifier: MIT
//
// Random walks at 50 m/s over rough ground, which no character may penetrate. JOSTLE_WALKS sets the
// number of walks.
#include <cstdlib>
#include <optional>

#include "tests/modules/character/rough_ground.h"
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

int walk_count() {
    const char* text = std::getenv("JOSTLE_WALKS");
    return text != nullptr ? std::atoi(text) : 200;
}

// m: height of the ground directly below or above a point.
std::optional<double> ground_at(const Queries& queries, BodyId ground, Vec3 p) {
    const auto hits = test::must(queries.cast_ray_all({{p.x, 100, p.z}, {0, -200, 0}}));
    for (const RayHit& hit : hits)
        if (hit.body == ground) return hit.point.y;
    return std::nullopt;
}

CharacterControls at_random(test::Random& random) {
    const SinCos direction = sin_cos(random.in(-pi, pi));
    return {.walk = Vec3{direction.cos, 0, direction.sin} * 50,
            .jump = random.below(3) == 0,
            .crouch = random.below(4) == 0};
}

// A walk has ten random controls of six steps each.
int escapes_of(const Geometry& geometry, int walks, std::uint64_t seed) {
    Stage stage;
    const BodyId ground = test::add_static(stage.world, {.geometry = geometry});
    test::Random random(seed);
    const CharacterId hero = stage.add(
        {.feet = {0, 8, 0}, .abilities = {.ground_acceleration = 1e4, .air_acceleration = 1e3}});
    int escapes = 0;
    for (int walk = 0; walk < walks; walk++) {
        test::must(
            stage.crowd->set_feet(stage.world, hero, {random.in(-25, 25), 8, random.in(-25, 25)}));
        Vec3 velocity = random.vector(50);
        velocity.y = -absolute(velocity.y);  // not over the rim
        test::must(stage.crowd->set_velocity(stage.world, hero, velocity));
        for (int mind = 0; mind < 10; mind++) {
            stage.steer(hero, at_random(random));
            stage.run(0.1);
        }
        // The centre of the capsule must be above the ground.
        const Vec3 middle = stage.of(hero).feet + Vec3{0, 0.5, 0};
        const auto height = ground_at(stage.world.queries(), ground, middle);
        if (!height || *height > middle.y) escapes++;
    }
    return escapes;
}

TEST(Escape, cannot_pass_through_a_mesh) {
    const int walks = walk_count();
    const int escapes = escapes_of(rough_mesh(1), walks, 11);
    record("mesh_walks", walks);
    record("mesh_escapes", escapes);
    EXPECT_EQ(escapes, 0);
}

TEST(Escape, cannot_pass_through_a_height_field) {
    const int walks = walk_count();
    const int escapes = escapes_of(rough_field(2), walks, 12);
    record("height_field_walks", walks);
    record("height_field_escapes", escapes);
    EXPECT_EQ(escapes, 0);
}

}  // namespace
}  // namespace jostle::modules

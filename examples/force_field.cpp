// SPDX-License-Identifier: MIT
//
// Force fields: a raft floats in water, the wind of a street blows a balloon along, and a planet
// attracts its moon.
//
// Shows: create_field, BuoyancyField, UniformWind, RadialField, regions.
// Run:   build/dev/bin/jostle-force-field
#include <cstdio>

#include "jostle/physics/physics.h"

using namespace jostle::physics;

namespace {

BodyId create(World& world, Vec3 position, const Geometry& geometry, double density) {
    return world
        .create_body({.pose = {.position = position}}, {.geometry = geometry, .density = density})
        .value();
}

void run(World& world, double seconds) {
    for (int step = 0; step < static_cast<int>(60 * seconds); step++) world.step(1.0 / 60).expect();
}

}  // namespace

int main() {
    // Water below y = 0. A box of 400 kg/m^3 floats with 40 % of its height of 1 m under water.
    World lake;
    lake.create_field({.force = BuoyancyField{.density = 1000}}).value();
    const BodyId raft = create(lake, {0, 0.5, 0}, Box{{1, 0.5, 1}}, 400);
    lake.set_damping(raft, 1, 1).expect();  // 1/s: the field itself damps small waves little
    run(lake, 20);
    const double draught = 0.5 - lake.body(raft)->center.y;
    std::printf("the raft floats %.3f m deep\n", draught);

    // Wind of 15 m/s along x, in a box of 10 m about the origin.
    World street({.gravity = {0, 0, 0}});
    street
        .create_field({.force = UniformWind{.velocity = {15, 0, 0}, .drag = 0.5},
                       .region = Aabb{{-5, -5, -5}, {5, 5, 5}}})
        .value();
    const BodyId balloon = create(street, {0, 0, 0}, Sphere{0.3}, 2);
    const BodyId outside = create(street, {0, 0, 8}, Sphere{0.3}, 2);
    run(street, 1);
    std::printf("the balloon drifts at %.1f m/s, a balloon outside at %.1f m/s\n",
                street.body(balloon)->linear_velocity.x, street.body(outside)->linear_velocity.x);

    // Gravity towards the origin: a body at 10 m with 10 m/s moves on a circle.
    World space({.gravity = {0, 0, 0}});
    space.create_field({.force = RadialField{.strength = -1000, .per_mass = true}}).value();
    const BodyId moon = create(space, {10, 0, 0}, Sphere{0.2}, 1000);
    space.set_linear_velocity(moon, {0, 0, 10}).expect();
    run(space, 60);
    const double radius = length(space.body(moon)->center);
    std::printf("after a minute the moon is %.2f m from the planet\n", radius);

    return draught > 0.39 && draught < 0.41 && radius > 9.9 && radius < 10.1 ? 0 : 1;
}

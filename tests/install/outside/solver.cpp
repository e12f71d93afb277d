// SPDX-License-Identifier: MIT
//
// A crate slides down a ramp: what a user of the solver writes, against installed headers alone.
#include <jostle/physics/physics.h>
#include <cstdio>

int main() {
    using namespace jostle::physics;
    World world({.gravity = {-1, -9.81, 0}});
    world
        .create_body({.type = BodyType::static_body},
                     {.geometry = Plane{}, .material = {.friction = 0}})
        .value();
    const BodyId crate =
        world.create_body({.pose = {.position = {0, 0.5, 0}}}, {.geometry = Box{{0.5, 0.5, 0.5}}})
            .value();
    for (int step = 0; step < 60; step++) world.step(1.0 / 60).expect();
    const double way = world.body(crate)->center.x;
    std::printf("%.3f m in one second without friction (-0.500 by a t^2 / 2)\n", way);
    return way < -0.47 && way > -0.53 ? 0 : 1;
}

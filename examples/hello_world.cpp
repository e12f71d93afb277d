// SPDX-License-Identifier: MIT
//
// Hello world: a ball falls onto a floor. The smallest program that uses the solver.
//
// Shows: World, create_body, step, body.
// Run:   build/dev/bin/jostle-hello-world
#include <cstdio>

#include "jostle/physics/physics.h"

int main() {
    using namespace jostle::physics;
    World world;  // gravity (0, -9.81, 0) m/s^2, y points up
    world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    const BodyId ball =
        world.create_body({.pose = {.position = {0, 3, 0}}}, {.geometry = Sphere{0.5}}).value();
    for (int step = 1; step <= 120; step++) {
        world.step(1.0 / 60).expect();
        if (step % 20 == 0)
            std::printf("%.2f s: height %.3f m\n", step / 60.0, world.body(ball)->center.y);
    }
}

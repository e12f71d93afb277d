// SPDX-License-Identifier: MIT
//
// A ball falls on a floor: the smallest program that uses the library.
#include <cstdio>

#include "jostle/physics/physics.h"

int main() {
    using namespace jostle::physics;
    World world;
    const auto floor =
        world.create_body(BodyDef{.type = BodyType::static_body}, ShapeDef{.geometry = Plane{}});
    const auto ball = world.create_body(BodyDef{.pose = {.position = {0, 3, 0}}},
                                        ShapeDef{.geometry = Sphere{.radius = 0.5}});
    if (!floor.ok() || !ball.ok()) return 1;
    for (int step = 0; step < 120; step++) {
        if (const Status stepped = world.step(1.0 / 60); !stepped.ok()) {
            std::fprintf(stderr, "%s\n", stepped.error().message.c_str());
            return 1;
        }
        if (step % 20 == 19)
            std::printf("%.2f s: height %.3f m\n", (step + 1) / 60.0,
                        world.body(*ball)->pose.position.y);
    }
    return 0;
}

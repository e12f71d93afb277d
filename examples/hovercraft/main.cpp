// SPDX-License-Identifier: MIT
//
// Module: a hovercraft flies over waves for 20 s. The world is saved after 10 s and loaded again;
// both worlds end with the same state hash.
//
// Shows: register_module, add_module, save and load of a module's state (hovercraft.h).
// Run:   build/dev/bin/jostle-hovercraft
#include <cmath>
#include <cstdio>

#include "hovercraft.h"
#include "jostle/physics/physics.h"

using namespace jostle::physics;
using jostle::examples::Hovercraft;

namespace {

// 80 m square, waves 20 m long and 0.8 m high.
Geometry waves() {
    HeightGrid grid{.columns = 81, .rows = 81};
    for (int row = 0; row < 81; row++)
        for (int column = 0; column < 81; column++)
            grid.heights.push_back(0.4 * sin_cos(0.314 * column + 0.1 * row).sin);
    return HeightField{build_height_field(std::move(grid)).value()};
}

void run(World& world, int seconds) {
    for (int step = 0; step < 60 * seconds; step++) world.step(1.0 / 60).expect();
}

}  // namespace

int main() {
    register_module("hovercraft", [] { return std::make_unique<Hovercraft>(); }).expect();

    World world;
    world.create_body({.type = BodyType::static_body}, {.geometry = waves()}).value();
    const BodyId craft =
        world
            .create_body({.pose = {.position = {16, 2, 0}}, .sleep_allowed = false},
                         {.geometry = Box{{1, 0.3, 1.6}}, .density = 150})
            .value();
    world.add_module(std::make_unique<Hovercraft>(craft)).expect();

    for (int second = 0; second < 10; second += 2) {
        run(world, 2);
        const BodyState state = world.body(craft).value();
        std::printf("%2d s: at (%.1f, %.1f, %.1f) m, %.1f m/s\n", second + 2, state.center.x,
                    state.center.y, state.center.z, length(state.linear_velocity));
    }
    World loaded = load(save(world)).value();
    run(world, 10);
    run(loaded, 10);
    const bool same = state_hash(world) == state_hash(loaded);
    std::printf("the saved and loaded world has %s state hash\n", same ? "the same" : "ANOTHER");
    return same ? 0 : 1;
}

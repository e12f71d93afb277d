// SPDX-License-Identifier: MIT
//
// A hovercraft over waves: rides for 20 s, is saved on the way, and comes to the same end in a
// world that is loaded from what was saved. Exits with 1 if it does not.
#include <cmath>
#include <cstdio>

#include "examples/hovercraft/hovercraft.h"
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

void ride(World& world, int seconds) {
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
        ride(world, 2);
        const BodyState state = world.body(craft).value();
        std::printf("%2d s: at (%.1f, %.1f, %.1f) m, %.1f m/s\n", second + 2, state.center.x,
                    state.center.y, state.center.z, length(state.linear_velocity));
    }
    World again = load(save(world)).value();
    ride(world, 10);
    ride(again, 10);
    const bool same = state_hash(world) == state_hash(again);
    std::printf("saved, loaded and ridden on: %s state hash\n", same ? "the same" : "ANOTHER");
    return same ? 0 : 1;
}

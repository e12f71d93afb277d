// SPDX-License-Identifier: MIT
//
// Determinism check: the same world and the same calls give the same bits. A pile of boxes is
// simulated with one thread, with four threads, and in a world that was saved and loaded halfway.
//
// Shows: state_hash, save, load, RestorePoint, set_threads, first_difference.
// Run:   build/dev/bin/jostle-determinism-check
#include <cinttypes>
#include <cstdio>

#include "jostle/physics/physics.h"

using namespace jostle::physics;

namespace {

World create_pile(int threads) {
    World world({.threads = threads});
    world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    for (int k = 0; k < 300; k++) {
        const double x = 0.6 * (k % 5), y = 1 + 0.7 * (k / 25), z = 0.6 * (k / 5 % 5);
        world
            .create_body({.pose = {.position = {x + 0.01 * (k % 7), y, z}}},
                         {.geometry = Box{{0.25, 0.25, 0.25}}})
            .value();
    }
    return world;
}

void run(World& world, int steps) {
    for (int step = 0; step < steps; step++) world.step(1.0 / 60).expect();
}

bool report(const char* name, const World& world, const World& reference) {
    const bool same = state_hash(world) == state_hash(reference);
    std::printf("%-22s %016" PRIx64 "  %s\n", name, state_hash(world), same ? "same" : "DIFFERENT");
    // Names the first field that differs, such as "bodies.awake[3].center.y: 0.5 against 0.49".
    if (const auto difference = first_difference(world, reference))
        std::printf("  %s\n", difference->c_str());
    return same;
}

}  // namespace

int main() {
    World one = create_pile(1), four = create_pile(4);
    run(one, 60);
    run(four, 60);
    World loaded = load(save(one)).value();  // bytes, for files and networks
    RestorePoint halfway;                    // memory of this process, for rollback
    halfway.capture(one);

    run(one, 60);
    run(four, 60);
    run(loaded, 60);
    World rolled_back = create_pile(1);
    halfway.restore(rolled_back).expect();
    run(rolled_back, 60);

    bool same = report("one thread", one, one);
    same = report("four threads", four, one) && same;
    same = report("saved and loaded", loaded, one) && same;
    same = report("restored and repeated", rolled_back, one) && same;
    return same ? 0 : 1;
}

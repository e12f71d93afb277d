// SPDX-License-Identifier: MIT
//
// A hash of all that the next step depends on, and of nothing else.
#include <gtest/gtest.h>

#include <set>

#include "jostle/physics/serialization.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

World scene(int threads = 1, BroadPhase broad_phase = BroadPhase::dynamic_tree) {
    World world = make_world({.threads = threads, .broad_phase = broad_phase});
    add_floor(world);
    for (int k = 0; k < 3; k++) add(world, {.position = {0, 0.5 + k, 0}});
    run(world, 0.25);
    return world;
}

TEST(StateHash, is_identical_for_identical_calls) {
    const std::uint64_t hash = state_hash(scene());
    EXPECT_EQ(state_hash(scene()), hash);
    EXPECT_EQ(state_hash(scene(2)), hash) << "threads are no part of the state";
    EXPECT_EQ(state_hash(scene(1, BroadPhase::uniform_grid)), hash) << "nor is the broad phase";
    World asked = scene();
    must(asked.queries().cast_ray({.origin = {0, 9, 0}, .motion = {0, -9, 0}}));
    EXPECT_EQ(state_hash(asked), hash) << "nor what was asked";
}

// The last bit of one number in each kind of store.
TEST(StateHash, detects_the_last_bit_of_every_store) {
    std::set<std::uint64_t> hashes{state_hash(scene())};
    const auto changed = [&](auto&& change) {
        World world = scene();
        change(state_of(world));
        EXPECT_TRUE(hashes.insert(state_hash(world)).second) << hashes.size();
    };
    const auto nudge = [](double& x) { x = std::nextafter(x, 1e300); };
    changed([&](WorldState& s) { nudge(s.bodies.awake[1].center.y); });
    changed([&](WorldState& s) { nudge(s.bodies.cold[2].linear_damping); });
    changed([&](WorldState& s) { nudge(s.bodies.motion[1].travel); });
    changed([&](WorldState& s) { nudge(s.shapes.shapes[0].material.friction); });
    changed([&](WorldState& s) { s.contacts.contacts[0].touching ^= true; });
    changed([&](WorldState& s) { nudge(s.def.gravity.x); });
    changed([&](WorldState& s) { nudge(s.islands.islands[s.bodies.cold[1].island].mass); });
    changed([&](WorldState& s) { s.steps++; });
    changed([&](WorldState& s) {
        for_each_colour(s.graph.sets, [&](GraphColour& colour) {
            for (ContactConstraintWide& block : colour.blocks)
                block.lambda[0][0] = std::nextafter(block.lambda[0][0], 1e30f);
        });
    });
    EXPECT_EQ(hashes.size(), 10u);
}

}  // namespace
}  // namespace jostle::test

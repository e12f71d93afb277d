// SPDX-License-Identifier: MIT
//
// A world with a module steps to the same bits with any number of threads, with any instruction
// set, and after it was saved or restored. `make` returns a world with a number of threads.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>

#include "tests/support/world_builder.h"

namespace jostle::test {

using MakeWorld = std::function<physics::World(int threads)>;

inline void expect_same_for_threads(const MakeWorld& make, double seconds) {
    physics::share_short_steps(true);
    physics::World one = make(1);
    run(one, seconds);
    for (const int threads : {2, 3, 4, 8}) {
        physics::World many = make(threads);
        run(many, seconds);
        EXPECT_EQ(physics::state_hash(one), physics::state_hash(many)) << threads << " threads";
    }
    physics::share_short_steps(false);
}

inline void expect_same_for_instruction_sets(const MakeWorld& make, double seconds) {
    const physics::InstructionSet own = physics::instruction_set();
    std::optional<std::uint64_t> first;
    for (const physics::InstructionSet set : physics::available_instruction_sets()) {
        must(physics::use_instruction_set(set));
        physics::World world = make(2);
        run(world, seconds);
        if (!first) first = physics::state_hash(world);
        EXPECT_EQ(physics::state_hash(world), *first) << physics::instruction_set_name(set);
    }
    must(physics::use_instruction_set(own));
}

// After `before` seconds the world is saved and captured; loaded and restored worlds then take
// `after` seconds.
inline void expect_continues(const MakeWorld& make, double before, double after) {
    physics::World world = make(1);
    run(world, before);
    physics::World loaded = must(physics::load(physics::save(world)));
    EXPECT_EQ(physics::first_difference(world, loaded), std::nullopt);
    physics::RestorePoint point;
    point.capture(world);
    run(world, after);
    run(loaded, after);
    EXPECT_EQ(physics::first_difference(world, loaded), std::nullopt);
    const std::uint64_t hash = physics::state_hash(world);
    EXPECT_EQ(physics::state_hash(loaded), hash);
    run(world, 0.4);
    must(point.restore(world));
    run(world, after);
    EXPECT_EQ(physics::state_hash(world), hash);
    physics::World other = make_world();
    must(point.restore(other));
    run(other, after);
    EXPECT_EQ(physics::state_hash(other), hash);
}

}  // namespace jostle::test

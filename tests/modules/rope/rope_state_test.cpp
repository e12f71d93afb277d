// SPDX-License-Identifier: MIT
//
// Ropes are state: bit-identical for any number of threads and instruction set, and after saving,
// loading and restoring. Definitions and untrusted bytes are checked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/modules/rope.h"
#include "jostle/physics/instruction_set.h"
#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "tests/modules/module_determinism.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;
using testing::HasSubstr;

Ropes& ropes_of(World& world) {
    return dynamic_cast<Ropes&>(*world.module("rope"));
}

// Every feature at once: loads, a bar, a winch, a rod that is held at one end, a rope that breaks,
// a rope that falls onto bodies, ropes that fall onto each other and themselves, and one between
// two bodies.
World lively(int threads) {
    register_ropes();
    World world = test::make_world({.threads = threads});
    test::add_floor(world);
    test::must(world.add_module(std::make_unique<Ropes>()));
    Ropes& ropes = ropes_of(world);
    const auto attach = [&](RopeKey rope, RopeAttachment attachment) {
        test::must(ropes.attach(world, rope, attachment));
    };
    for (int k = 0; k < 4; k++) {
        const double x = 1.5 * k - 3;
        const BodyId load = test::add(
            world, {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {x, 2, 0}, .density = 200});
        const RopeKey rope = test::must(ropes.add(world, {.points = {{x + 0.5, 5, 0}, {x, 2.2, 0}},
                                                          .links = 30,
                                                          .bending_stiffness = k == 1 ? 0.05 : 0,
                                                          .breaking_load = k == 2 ? 180.0 : 0}));
        attach(rope, {.node = 0, .point = {x + 0.5, 5, 0}});
        attach(rope, {.node = 30, .body = load, .point = {0, 0.2, 0}});
        if (k == 3) test::must(ropes.set_winch(world, rope, RopeEnd::first, -0.5));
    }
    const RopeKey rod = test::must(
        ropes.add(world, {.points = {{4, 2, 0}, {5, 2, 0}}, .links = 12, .bending_stiffness = 1}));
    attach(rod, {.node = 0, .point = {4, 2, 0}, .direction = {1, 0, 0}});
    for (int k = 0; k < 6; k++)
        test::add(world,
                  {.geometry = k % 2 == 0 ? Geometry(Sphere{0.3}) : Geometry(Box{{0.3, 0.2, 0.3}}),
                   .position = {0.7 * k - 2, 0.4, 2},
                   .density = 80});
    test::must(ropes.add(
        world,
        {.points = {{-2.5, 1.6, 1.9}, {2.5, 1.7, 2.1}}, .links = 50, .collide_ropes = true}));
    // It falls on the last one, and the next one on itself.
    test::must(ropes.add(
        world, {.points = {{0, 1.8, 1.2}, {0.3, 1.9, 2.8}}, .links = 20, .collide_ropes = true}));
    RopeDef coil{.links = 60, .radius = 0.015, .collide_self = true};
    for (int k = 0; k <= 40; k++)
        coil.points.push_back(
            {3 + 0.12 * std::cos(0.6 * k), 0.3 + 0.03 * k, 2 + 0.12 * std::sin(0.6 * k)});
    test::must(ropes.add(world, coil));
    const BodyId a = test::add(world, {.geometry = Sphere{0.2}, .position = {-1, 3, -2}});
    const BodyId b = test::add(world, {.geometry = Sphere{0.2}, .position = {1, 3, -2}});
    const RopeKey between = test::must(
        ropes.add(world, {.points = {{-1, 3, -2}, {1, 3, -2}}, .links = 20, .length = 2.2}));
    attach(between, {.node = 0, .body = a});
    attach(between, {.node = 20, .body = b});
    return world;
}

TEST(RopeState, has_work_for_all_parts) {
    World world = lively(1);
    test::run(world, 1.5);
    EXPECT_GT(ropes_of(world).ropes().size(), 7u);  // one broke
}

TEST(RopeState, result_is_bit_identical_for_any_thread_count) {
    test::expect_same_for_threads(lively, 1.5);
}

TEST(RopeState, result_is_bit_identical_for_any_instruction_set) {
    test::expect_same_for_instruction_sets(lively, 1);
}

TEST(RopeState, continues_bit_identically_after_load_and_restore) {
    test::expect_continues(lively, 0.6, 0.7);
}

TEST(RopeState, definitions_out_of_range_are_rejected_by_field) {
    World world = test::make_world();
    Ropes ropes;
    const auto error_of = [&](RopeDef def) {
        if (def.points.empty()) def.points = {{0, 0, 0}, {1, 0, 0}};
        const Result<RopeKey> key = ropes.add(world, def);
        return key.ok() ? std::string("accepted") : key.error().message;
    };
    EXPECT_EQ(error_of({}), "accepted");
    EXPECT_EQ(error_of({.points = {{0, 0, 0}}}),
              "number of points: 1 is out of range; must be between 2 and 256");
    EXPECT_EQ(error_of({.points = {{0, 0, 0}, {2e6, 0, 0}}}),
              "points[1].x: 2e+06 is out of range; must be between -1e+06 and 1e+06");
    EXPECT_THAT(error_of({.points = {{0, 0, 0}, {0, 0, 0}}}), HasSubstr("more than 1 mm per link"));
    EXPECT_THAT(error_of({.links = 0}), HasSubstr("links: 0 is out of range"));
    EXPECT_THAT(error_of({.length = std::numeric_limits<double>::quiet_NaN()}),
                HasSubstr("length: nan is out of range"));
    EXPECT_THAT(error_of({.radius = 0}), HasSubstr("radius: 0 is out of range"));
    EXPECT_THAT(error_of({.mass_per_length = -1}), HasSubstr("mass_per_length: -1"));
    EXPECT_THAT(error_of({.stretch_stiffness = 0}), HasSubstr("stretch_stiffness: 0"));
    EXPECT_THAT(error_of({.substeps = 65}), HasSubstr("substeps: 65"));
    const RopeKey rope = ropes.ropes()[0];
    EXPECT_THAT(ropes.attach(world, rope, {.node = 21}).error().message, HasSubstr("node: 21"));
    EXPECT_THAT(ropes.attach(world, rope, {.node = 3, .direction = {1, 0, 0}}).error().message,
                HasSubstr("direction: node 3 is not an end"));
    EXPECT_EQ(ropes.attach(world, {99}, {}).error().code, ErrorCode::not_found);
    EXPECT_EQ(ropes.set_winch(world, rope, RopeEnd::last, 1).error().code,
              ErrorCode::failed_precondition);
    EXPECT_EQ(ropes.remove(world, {99}).error().message, "no rope has the key 99");
}

TEST(RopeState, damaged_bytes_are_rejected_with_a_reason) {
    World world = lively(1);
    test::run(world, 0.3);
    const std::vector<std::byte> bytes = save_module(ropes_of(world));
    Ropes intact;
    EXPECT_TRUE(load_module(intact, bytes).ok());
    EXPECT_EQ(save_module(intact), bytes);
    for (std::size_t size = 0; size < bytes.size(); size += 37) {
        Ropes ropes;
        EXPECT_FALSE(load_module(ropes, std::span(bytes).first(size)).ok()) << size;
    }
    // Any damage is either rejected with a reason or stepped.
    for (std::size_t at = 0; at < bytes.size(); at += 11) {
        std::vector<std::byte> damaged = bytes;
        damaged[at] ^= std::byte{0x41};
        auto ropes = std::make_unique<Ropes>();
        if (const Status s = load_module(*ropes, damaged); !s.ok()) {
            EXPECT_FALSE(s.error().message.empty());
            continue;
        }
        World other;
        test::must(other.add_module(std::move(ropes)));
        test::must(other.step(1.0 / 60));
    }
}

}  // namespace
}  // namespace jostle::modules

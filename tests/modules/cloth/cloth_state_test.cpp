// SPDX-License-Identifier: MIT
//
// Cloth is state: bit-identical for any number of threads and instruction set, and after saving,
// loading and restoring. Definitions and untrusted bytes are checked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "jostle/modules/cloth.h"
#include "jostle/physics/instruction_set.h"
#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "tests/modules/module_determinism.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;
using testing::HasSubstr;

Cloths& cloths_of(World& world) {
    return dynamic_cast<Cloths&>(*world.module("cloth"));
}

// Every feature at once: a flag in the wind, sheets that carry bodies, one that tears, one that
// falls onto bodies and itself, and a mesh.
World lively(int threads) {
    register_cloths();
    World world = test::make_world({.threads = threads});
    test::add_floor(world);
    test::must(world.add_module(std::make_unique<Cloths>()));
    test::must(world.create_field({.force = UniformWind{.velocity = {6, 0, 2}, .gust = {3, 0, 0}},
                                   .region = Aabb{{-20, 3, -20}, {20, 20, 20}}}));
    Cloths& cloths = cloths_of(world);
    const auto attach = [&](ClothKey cloth, ClothAttachment attachment) {
        test::must(cloths.attach(world, cloth, attachment));
    };
    const ClothKey flag = test::must(cloths.add(
        world, {.grid = {.rows = 9, .columns = 13, .origin = {0, 6, 0}, .down = {0, -0.6, 0}}}));
    for (std::uint32_t r = 0; r < 9; r++)
        attach(flag, {.vertex = 13 * r, .point = {0, 6 - 0.075 * r, 0}});
    for (int k = 0; k < 3; k++) {
        const double x = 2.0 * k - 3;
        const BodyId load = test::add(
            world,
            {.geometry = Box{{0.3, 0.1, 0.1}}, .position = {x + 0.3, 1.9, 0}, .density = 400});
        const ClothKey cloth = test::must(cloths.add(world, {.grid = {.rows = 11,
                                                                      .columns = 7,
                                                                      .origin = {x, 3, 0},
                                                                      .across = {0.6, 0, 0},
                                                                      .down = {0, -1, 0}},
                                                             .breaking_load = k == 1 ? 100.0 : 0}));
        for (std::uint32_t c = 0; c < 7; c++) {
            attach(cloth, {.vertex = c, .point = {x + 0.1 * c, 3, 0}});
            attach(cloth, {.vertex = 70 + c, .body = load, .point = {0.1 * c - 0.3, 0.1, 0}});
        }
    }
    for (int k = 0; k < 4; k++)
        test::add(world,
                  {.geometry = k % 2 == 0 ? Geometry(Sphere{0.2}) : Geometry(Box{{0.2, 0.2, 0.2}}),
                   .position = {0.5 * k - 0.8, 0.3, 2.1},
                   .density = 80});
    test::must(cloths.add(world, {.grid = {.rows = 17,
                                           .columns = 17,
                                           .origin = {-0.6, 0.8, 1.5},
                                           .across = {1.2, 0.1, 0},
                                           .down = {0, 0, 1.2}},
                                  .thickness = 0.01,
                                  .collide_self = true}));
    ClothDef mesh{.bending_stiffness = 1e-4};
    mesh.vertices = {{3, 1, 2},     {3.3, 1, 2},     {3.6, 1.1, 2},
                     {3.1, 1, 2.3}, {3.4, 1.1, 2.3}, {3.2, 1, 2.6}};
    mesh.triangles = {0, 3, 1, 1, 3, 4, 1, 4, 2, 3, 5, 4};
    test::must(cloths.add(world, mesh));
    return world;
}

TEST(ClothState, has_work_for_all_parts) {
    World world = lively(1);
    test::run(world, 1.2);
    EXPECT_LT(cloths_of(world).triangles({3}).size(), 120u);  // one tore
}

TEST(ClothState, result_is_bit_identical_for_any_thread_count) {
    test::expect_same_for_threads(lively, 1.2);
}

TEST(ClothState, result_is_bit_identical_for_any_instruction_set) {
    test::expect_same_for_instruction_sets(lively, 0.8);
}

TEST(ClothState, continues_bit_identically_after_load_and_restore) {
    test::expect_continues(lively, 0.6, 0.6);
}

// The same bits for every compiler, optimisation level and processor. Changes only with the solver
// of cloth.
TEST(ClothState, result_is_the_recorded_one) {
    World world = test::make_world();
    test::must(world.create_body({.type = BodyType::static_body}, {.geometry = Sphere{0.3}}));
    test::must(world.add_module(std::make_unique<Cloths>()));
    Cloths& cloths = cloths_of(world);
    const ClothKey cloth = test::must(cloths.add(world, {.grid = {.rows = 13,
                                                                  .columns = 13,
                                                                  .origin = {-0.5, 0.4, -0.4},
                                                                  .across = {1, 0, 0},
                                                                  .down = {0, 0.1, 1}},
                                                         .wind = {3, 0, 1},
                                                         .gust = {2, 0, 0},
                                                         .thickness = 0.01,
                                                         .collide_self = true}));
    test::run(world, 1);
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const auto& vectors : {cloths.positions(cloth), cloths.velocities(cloth)})
        for (const Vec3 v : vectors)
            for (const double number : {v.x, v.y, v.z})
                hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211u;
    EXPECT_EQ(hash, 3532759902775806461u);
}

TEST(ClothState, definitions_out_of_range_are_rejected_by_field) {
    World world = test::make_world();
    Cloths cloths;
    const auto error_of = [&](const ClothDef& def) {
        const Result<ClothKey> key = cloths.add(world, def);
        return key.ok() ? std::string("accepted") : key.error().message;
    };
    EXPECT_EQ(error_of({}), "accepted");
    EXPECT_EQ(error_of({.grid = {.rows = 1}}),
              "grid.rows: 1 is out of range; must be between 2 and 1000");
    EXPECT_THAT(error_of({.grid = {.rows = 500, .columns = 500}}),
                HasSubstr("grid.rows * grid.columns: 250000"));
    EXPECT_THAT(error_of({.grid = {.origin = {0, 2e6, 0}}}), HasSubstr("grid.origin.y: 2e+06"));
    EXPECT_THAT(error_of({.grid = {.across = {0, 1, 0}}}), HasSubstr("are parallel or zero"));
    EXPECT_THAT(error_of({.grid = {.width = 0.001}}), HasSubstr("must be at least 1 mm"));
    EXPECT_THAT(error_of({.mass_per_area = std::numeric_limits<double>::quiet_NaN()}),
                HasSubstr("mass_per_area: nan is out of range"));
    EXPECT_THAT(error_of({.stretch_stiffness = 0}), HasSubstr("stretch_stiffness: 0"));
    EXPECT_THAT(error_of({.thickness = 0}), HasSubstr("thickness: 0"));
    EXPECT_THAT(error_of({.substeps = 65}), HasSubstr("substeps: 65"));
    ClothDef mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    EXPECT_THAT(error_of(mesh), HasSubstr("a mesh needs triangles"));
    mesh.triangles = {0, 1, 3};
    EXPECT_THAT(error_of(mesh), HasSubstr("triangle 0: vertex 3 does not exist"));
    mesh.triangles = {0, 1, 1};
    EXPECT_THAT(error_of(mesh), HasSubstr("triangle 0: is degenerate"));
    mesh.triangles = {0, 1, 2, 0, 1, 2, 0, 1, 2};
    EXPECT_THAT(error_of(mesh), HasSubstr("has more than two triangles"));
    mesh.vertices.push_back({5, 5, 5});
    mesh.triangles = {0, 1, 2};
    EXPECT_THAT(error_of(mesh), HasSubstr("vertices[3]: has no triangle"));
    const ClothKey cloth = cloths.cloths()[0];
    EXPECT_THAT(cloths.attach(world, cloth, {.vertex = 400}).error().message,
                HasSubstr("vertex: 400 is out of range; must be between 0 and 399"));
    EXPECT_EQ(cloths.attach(world, {99}, {}).error().code, ErrorCode::not_found);
    EXPECT_EQ(cloths.detach(world, cloth, 3).error().message, "vertex 3 is not attached");
    EXPECT_EQ(cloths.remove(world, {99}).error().message, "no cloth has the key 99");
}

TEST(ClothState, damaged_bytes_are_rejected_with_a_reason) {
    World world = test::make_world();
    test::must(world.add_module(std::make_unique<Cloths>()));
    const ClothKey key = test::must(
        cloths_of(world).add(world, {.grid = {.rows = 4, .columns = 5}, .breaking_load = 3}));
    test::must(cloths_of(world).attach(world, key, {.vertex = 0}));
    test::run(world, 0.3);
    const std::vector<std::byte> bytes = save_module(cloths_of(world));
    Cloths intact;
    EXPECT_TRUE(load_module(intact, bytes).ok());
    EXPECT_EQ(save_module(intact), bytes);
    for (std::size_t size = 0; size < bytes.size(); size += 7) {
        Cloths cloths;
        EXPECT_FALSE(load_module(cloths, std::span(bytes).first(size)).ok()) << size;
    }
    // Any damage is either rejected with a reason or stepped.
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::vector<std::byte> damaged = bytes;
        damaged[at] ^= std::byte{0x41};
        auto cloths = std::make_unique<Cloths>();
        if (const Status s = load_module(*cloths, damaged); !s.ok()) {
            EXPECT_FALSE(s.error().message.empty());
            continue;
        }
        World other;
        test::must(other.add_module(std::move(cloths)));
        test::must(other.step(1.0 / 60));
    }
}

}  // namespace
}  // namespace jostle::modules

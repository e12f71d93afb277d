// SPDX-License-Identifier: MIT
#include "tools/mesh/fracture_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <sstream>

#include "jostle/modules/destruction.h"
#include "jostle/modules/fracture_file.h"
#include "tests/modules/convex_decomposition/solids.h"

namespace jostle::mesh {
namespace {

using namespace physics;

std::string obj_of(const test::Solid& solid) {
    std::ostringstream out;
    out.precision(17);
    for (const Vec3 p : solid.vertices) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (std::size_t k = 0; k < solid.indices.size(); k += 3)
        out << "f " << solid.indices[k] + 1 << ' ' << solid.indices[k + 1] + 1 << ' '
            << solid.indices[k + 2] + 1 << '\n';
    return out.str();
}

double volume_of(const modules::FracturedShape& shape) {
    double sum = 0;
    for (const modules::FractureChunk& chunk : shape.chunks) sum += chunk.volume;
    return sum;
}

// Size of the largest group of connected chunks.
std::size_t largest_group(const modules::FracturedShape& shape) {
    std::vector<std::size_t> group(shape.chunks.size()), count(shape.chunks.size());
    std::iota(group.begin(), group.end(), 0u);
    for (bool changed = true; changed;) {
        changed = false;
        for (const modules::FractureBond& bond : shape.bonds) {
            const std::size_t least = std::min(group[bond.a], group[bond.b]);
            changed = changed || group[bond.a] != group[bond.b];
            group[bond.a] = group[bond.b] = least;
        }
    }
    for (const std::size_t g : group) count[g]++;
    return *std::max_element(count.begin(), count.end());
}

TEST(FractureSolid, preserves_the_volume_of_a_box_and_a_hull) {
    const FracturedSolid box =
        fracture_solid({.box = Vec3{4, 3, 0.3}}, {.count = 150}, Vec3{0, -1, 0}).value();
    EXPECT_EQ(box.shape.chunks.size(), 150u);
    EXPECT_LT(std::abs(volume_of(box.shape) / 3.6 - 1), 1e-12);
    const auto anchored = std::count_if(box.shape.chunks.begin(), box.shape.chunks.end(),
                                        [](const auto& chunk) { return chunk.anchored; });
    EXPECT_GT(anchored, 5);
    EXPECT_LT(anchored, 40);
    const FracturedSolid corner =
        fracture_solid({.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {.count = 40})
            .value();
    EXPECT_LT(std::abs(6 * volume_of(corner.shape) - 1), 1e-12);
}

// An L of 3 m^3 is not convex; its parts form one body.
TEST(FractureSolid, fractures_a_concave_mesh_into_bonded_convex_parts) {
    const std::string obj = obj_of(test::l_shape());
    const FracturedSolid made = fracture_solid({.obj = obj}, {.count = 80}).value();
    const double error = std::abs((volume_of(made.shape) + made.lost_volume) / 3 - 1);
    RecordProperty("volume_error", std::to_string(error * 1e15) + "e-15");
    EXPECT_GT(made.parts, 1u);
    EXPECT_LT(error, 1e-12);
    EXPECT_LT(made.lost_volume, 1e-6);
    EXPECT_EQ(largest_group(made.shape), made.shape.chunks.size());
}

// Almost no volume of a ring is lost in splinters, and the result can be written, read and added.
TEST(FractureSolid, fractures_a_ring_into_one_breakable_body) {
    const std::string obj = obj_of(test::torus(1, 0.3, 24, 12));
    for (const auto pattern : {modules::SeedPattern::uniform, modules::SeedPattern::radial,
                               modules::SeedPattern::clustered, modules::SeedPattern::grid}) {
        const FracturedSolid made =
            fracture_solid({.obj = obj}, {.pattern = pattern, .count = 120}).value();
        EXPECT_LT(std::abs((volume_of(made.shape) + made.lost_volume) / made.volume - 1), 1e-12);
        EXPECT_LT(made.lost_volume, 1e-6 * made.volume) << static_cast<int>(pattern);
        EXPECT_EQ(largest_group(made.shape), made.shape.chunks.size()) << static_cast<int>(pattern);
        const auto bytes = modules::write_fracture(made.shape).value();
        const auto shape = modules::read_fracture(bytes);
        ASSERT_TRUE(shape.ok()) << shape.error().message;
        World world;
        auto module = std::make_unique<modules::Destruction>();
        modules::Destruction& destruction = *module;
        world.add_module(std::move(module)).expect();
        const auto id = destruction.add(world, *shape, {}).value();
        world.step(1.0 / 60).expect();
        EXPECT_EQ(destruction.bodies(id)->size(), 1u);
        EXPECT_GT(*destruction.break_near(world, id, {}, 10), 100u);
        world.step(1.0 / 60).expect();
        EXPECT_EQ(destruction.bodies(id)->size(), shape->chunks.size());
    }
}

TEST(FractureSolid, reports_invalid_solids) {
    EXPECT_EQ(fracture_solid({.obj = "f 1 2 3\n"}, {}).error().message,
              "line 1: vertex index 1 is out of range; there are 0 vertices up to this line");
    EXPECT_FALSE(fracture_solid({.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {}).ok());
    EXPECT_FALSE(fracture_solid({.box = Vec3{1, 1, 0}}, {}).ok());
    EXPECT_FALSE(fracture_solid({.box = Vec3{1, 1, 1}}, {.count = 20001}).ok());
}

}  // namespace
}  // namespace jostle::mesh

// SPDX-License-Identifier: MIT
#include "jostle/modules/fractured_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

Vec3 first_moment(const FracturedShape& shape) {
    Vec3 sum;
    for (const FractureChunk& chunk : shape.chunks) sum += chunk.center * chunk.volume;
    return sum;
}

TEST(FracturedShape, box_cells_sum_to_box_volume) {
    const Vec3 half{3, 1.5, 0.15};
    const FracturedShape shape = fracture_box(half, random_seeds(half, 400, 7)).value();
    EXPECT_EQ(shape.chunks.size(), 400u);
    const double volume = 8 * half.x * half.y * half.z;
    const double error = std::abs(volume_of(shape) / volume - 1);
    RecordProperty("volume_error", std::to_string(error * 1e15) + "e-15");
    EXPECT_LT(error, 1e-12);
    EXPECT_LT(length(first_moment(shape)) / volume, 1e-12);
}

TEST(FracturedShape, hull_cells_sum_to_hull_volume) {
    const std::vector<Vec3> points = random_seeds({1, 0.7, 0.5}, 40, 11);
    const auto hull = build_hull(points).value();
    const FracturedShape shape =
        fracture_hull(*hull, random_seeds({0.6, 0.4, 0.3}, 100, 5)).value();
    const double error = std::abs(volume_of(shape) / hull->volume - 1);
    RecordProperty("volume_error", std::to_string(error * 1e15) + "e-15");
    EXPECT_LT(error, 1e-12);
    double solver = 0;
    for (const FractureChunk& chunk : shape.chunks)
        solver += std::get<Hull>(chunk.geometry).data->volume;
    RecordProperty("hull_error",
                   std::to_string(std::abs(solver / hull->volume - 1) * 1e12) + "e-12");
    EXPECT_NEAR(solver, hull->volume, 1e-6 * hull->volume);
}

// Seeds in a grid: four cells share each edge, eight each corner.
TEST(FracturedShape, grid_seeds_produce_grid_boxes) {
    const Vec3 half{2, 1, 0.5};
    const FracturedShape boxes = split_box(half, 8, 4, 2).value();
    std::vector<Vec3> seeds;
    for (const FractureChunk& chunk : boxes.chunks) seeds.push_back(chunk.center);
    const FracturedShape cells = fracture_box(half, seeds).value();
    ASSERT_EQ(cells.chunks.size(), boxes.chunks.size());
    ASSERT_EQ(cells.bonds.size(), boxes.bonds.size());
    for (std::size_t k = 0; k < boxes.chunks.size(); k++) {
        EXPECT_NEAR(cells.chunks[k].volume, boxes.chunks[k].volume, 1e-13);
        EXPECT_LT(length(cells.chunks[k].center - boxes.chunks[k].center), 1e-13);
        const Mat3 off = cells.chunks[k].unit_inertia - boxes.chunks[k].unit_inertia;
        EXPECT_LT(length(off.x) + length(off.y) + length(off.z), 1e-13);
    }
    double area = 0, moments = 0;
    for (const FractureBond& bond : cells.bonds)
        area += bond.area, moments += bond.moment_u + bond.moment_v;
    for (const FractureBond& bond : boxes.bonds)
        area -= bond.area, moments -= bond.moment_u + bond.moment_v;
    EXPECT_NEAR(area, 0, 1e-11);
    EXPECT_NEAR(moments, 0, 1e-11);
}

TEST(FracturedShape, bond_faces_lie_between_their_chunks) {
    const Vec3 half{1, 1, 1};
    const FracturedShape shape = fracture_box(half, random_seeds(half, 50, 2)).value();
    EXPECT_GT(shape.bonds.size(), 150u);
    for (const FractureBond& bond : shape.bonds) {
        EXPECT_GT(dot(bond.center - shape.chunks[bond.a].center, bond.normal), 0);
        EXPECT_GT(dot(shape.chunks[bond.b].center - bond.center, bond.normal), 0);
        EXPECT_NEAR(dot(bond.normal, bond.axis), 0, 1e-12);
        EXPECT_GE(bond.moment_v, bond.moment_u * (1 - 1e-9));  // u is the long axis
    }
}

TEST(FracturedShape, errors_name_the_seed) {
    const std::vector<Vec3> twice = {{0, 0, 0}, {0.1, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(fracture_box({1, 1, 1}, twice).error().message, "seeds[2] is a duplicate");
    const std::vector<Vec3> wild = {{0, 0, std::nan("")}};
    EXPECT_EQ(fracture_box({1, 1, 1}, wild).error().message,
              "seeds[0] is out of range; it must be finite and within 10 km");
    EXPECT_FALSE(fracture_box({1, 1, 0}, random_seeds({1, 1, 1}, 3, 1)).ok());
    EXPECT_FALSE(split_box({1, 1, 1}, 0, 1, 1).ok());
}

TEST(FracturedShape, anchors_chunks_that_reach_the_offset_plane) {
    FracturedShape shape = split_box({2, 1, 0.5}, 8, 4, 2).value();
    EXPECT_EQ(anchor(shape, {0, -1, 0}, 1 - 1e-9), 16u);
}

}  // namespace
}  // namespace jostle::modules

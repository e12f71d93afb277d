// SPDX-License-Identifier: MIT
//
// Solids of several hulls: the volume is complete and counted once, and parts are bonded.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "jostle/modules/seed_patterns.h"
#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

using Part = std::shared_ptr<const ConvexHull>;

Part box_hull(Vec3 low, Vec3 high) {
    std::vector<Vec3> points;
    for (int k = 0; k < 8; k++)
        points.push_back({(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                          (k & 4) != 0 ? high.z : low.z});
    return build_hull(points).value();
}

// Number of chunks connected with the first one.
std::size_t reached(const FracturedShape& shape) {
    std::vector<std::size_t> group(shape.chunks.size());
    std::iota(group.begin(), group.end(), 0u);
    for (std::size_t round = 0; round < shape.chunks.size(); round++)
        for (const FractureBond& bond : shape.bonds)
            group[bond.a] = group[bond.b] = std::min(group[bond.a], group[bond.b]);
    return static_cast<std::size_t>(std::count(group.begin(), group.end(), 0u));
}

// An L of 2 x 1 x 1 and 1 x 1 x 1 on top; the parts touch in 1 m^2.
TEST(FractureParts, touching_parts_are_bonded_over_their_common_face) {
    const std::vector<Part> parts = {box_hull({0, 0, 0}, {2, 1, 1}),
                                     box_hull({0, 1, 0}, {1, 2, 1})};
    const std::vector<Vec3> seeds =
        generate_seeds({{0, 0, 0}, {2, 2, 1}}, {.count = 60, .seed = 3}, [](Vec3 p) {
            return p.y < 1 || p.x < 1;
        }).value();
    const FractureResult made = fracture_parts(parts, seeds).value();
    EXPECT_LT(std::abs(volume_of(made.shape) / 3 - 1), 1e-12);
    EXPECT_LT(std::abs(made.volume / 3 - 1), 1e-12);
    EXPECT_EQ(made.lost_volume, 0);
    EXPECT_EQ(reached(made.shape), made.shape.chunks.size());
    double across = 0;
    for (const FractureBond& bond : made.shape.bonds)
        if (std::abs(bond.center.y - 1) < 1e-12 && std::abs(std::abs(bond.normal.y) - 1) < 1e-12)
            across += bond.area;
    RecordProperty("area_error", std::to_string((across - 1) * 1e15) + "e-15");
    EXPECT_NEAR(across, 1, 1e-9);
    // It can be added and is one body.
    Stage stage;
    const DestructibleId id = stage.add(made.shape);
    stage.step(3);
    EXPECT_EQ(stage.destruction->bodies(id)->size(), 1u);
}

// Two crossing boxes: the union of 3 x 1 x 1 and 1 x 3 x 1 is 5 m^3.
TEST(FractureParts, overlapping_volume_is_counted_once) {
    const std::vector<Part> parts = {box_hull({-1.5, -0.5, 0}, {1.5, 0.5, 1}),
                                     box_hull({-0.5, -1.5, 0}, {0.5, 1.5, 1})};
    const FractureResult made = fracture_parts(parts, random_seeds({1.5, 1.5, 0.9}, 80, 5)).value();
    const double error = std::abs((volume_of(made.shape) + made.lost_volume) / 5 - 1);
    RecordProperty("volume_error", std::to_string(error * 1e15) + "e-15");
    EXPECT_LT(error, 1e-12);
    EXPECT_EQ(reached(made.shape), made.shape.chunks.size());
    for (const FractureBond& bond : made.shape.bonds) {
        EXPECT_GT(dot(bond.center - made.shape.chunks[bond.a].center, bond.normal), 0);
        EXPECT_GT(dot(made.shape.chunks[bond.b].center - bond.center, bond.normal), 0);
    }
}

TEST(FractureParts, reports_progress_from_zero_to_all_seeds) {
    std::size_t last = 1, all = 0;
    const std::vector<Part> parts = {box_hull({-1, -1, -1}, {1, 1, 1})};
    const auto made = fracture_parts(parts, random_seeds({1, 1, 1}, 120, 1),
                                     [&](std::size_t done, std::size_t count) {
                                         EXPECT_TRUE(all > 0 || done == 0);
                                         last = done, all = count;
                                     });
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(last, 120u);
    EXPECT_EQ(all, 120u);
    EXPECT_FALSE(fracture_parts({}, random_seeds({1, 1, 1}, 2, 1)).ok());
}

TEST(SeedPatterns, every_pattern_produces_about_the_requested_chunk_count) {
    const Vec3 half{2, 1, 0.1};
    for (const SeedPattern pattern :
         {SeedPattern::uniform, SeedPattern::radial, SeedPattern::grid, SeedPattern::clustered}) {
        const std::vector<Vec3> seeds =
            generate_seeds({-half, half}, {.pattern = pattern, .count = 200, .seed = 4}).value();
        const FracturedShape shape = fracture_box(half, seeds).value();
        EXPECT_GT(shape.chunks.size(), 80u) << static_cast<int>(pattern);
        EXPECT_LT(shape.chunks.size(), 320u) << static_cast<int>(pattern);
        EXPECT_LT(std::abs(volume_of(shape) / (8 * half.x * half.y * half.z) - 1), 1e-12);
        EXPECT_EQ(reached(shape), shape.chunks.size()) << static_cast<int>(pattern);
    }
}

// Chunks of a cluster are small near its centre.
TEST(SeedPatterns, clustered_pattern_makes_smaller_chunks_near_its_centre) {
    const Vec3 half{2, 1, 0.1}, center{1, 0.5, 0};
    for (const SeedPattern pattern : {SeedPattern::radial, SeedPattern::clustered}) {
        const SeedPatternOptions plan{.pattern = pattern, .count = 200, .center = center};
        const FracturedShape shape =
            fracture_box(half, generate_seeds({-half, half}, plan).value()).value();
        double near = 0, far = 0, near_count = 0, far_count = 0;
        for (const FractureChunk& chunk : shape.chunks) {
            const bool is_near = length(chunk.center - center) < 0.4;
            (is_near ? near : far) += chunk.volume;
            (is_near ? near_count : far_count)++;
        }
        EXPECT_LT(4 * near / near_count, far / far_count) << static_cast<int>(pattern);
    }
}

TEST(SeedPatterns, rejects_invalid_options_and_names_the_field) {
    const Aabb bounds{{0, 0, 0}, {1, 1, 1}};
    EXPECT_EQ(generate_seeds(bounds, {.count = 0}).error().message,
              "count is 0; it must be from 1 to 20000");
    EXPECT_EQ(generate_seeds({{0, 0, 0}, {1, 0, 1}}, {}).error().message,
              "a side of bounds is out of range; it must be from 2e-4 to 2e4 m");
    EXPECT_FALSE(generate_seeds(bounds, {.center = Vec3{std::nan(""), 0, 0}}).ok());
    EXPECT_FALSE(generate_seeds(bounds, {.spread = 2}).ok());
    EXPECT_FALSE(generate_seeds(bounds, {.count = 5}, [](Vec3) { return false; }).ok());
}

}  // namespace
}  // namespace jostle::modules

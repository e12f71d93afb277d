// SPDX-License-Identifier: MIT
//
// A tree finds what a loop over all boxes finds, and never grows high.
#include "physics/src/geometry/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Bvh, finds_exactly_the_overlapping_boxes) {
    Random random(1);
    for (const int count : {0, 1, 3, 5, 200, 3000}) {
        std::vector<Aabb> boxes;
        for (int i = 0; i < count; i++) {
            const Vec3 at = random.vector(10), half = abs(random.vector(i % 10 == 0 ? 3 : 0.3));
            boxes.push_back(i % 50 == 49 ? boxes.back() : Aabb{at - half, at + half});
        }
        const Bvh tree(boxes);
        EXPECT_LE(tree.height(), 40);
        for (int q = 0; q < 50; q++) {
            const Vec3 at = random.vector(10);
            const Aabb box = grow({at, at}, random.in(0, 3));
            std::vector<std::uint32_t> found, expected;
            tree.query(box, [&](std::uint32_t item) {
                if (overlap(boxes[item], box)) found.push_back(item);
            });
            std::sort(found.begin(), found.end());
            for (std::uint32_t i = 0; i < boxes.size(); i++)
                if (overlap(boxes[i], box)) expected.push_back(i);
            ASSERT_EQ(found, expected);
        }
    }
}

// Ten thousand boxes in one place: no plane parts them, and the tree does not become a chain.
TEST(Bvh, handles_identical_boxes) {
    const Bvh tree(std::vector<Aabb>(10000, Aabb{{0, 0, 0}, {1, 1, 1}}));
    EXPECT_LE(tree.height(), 20);
    int met = 0;
    tree.query({{0, 0, 0}, {1, 1, 1}}, [&](std::uint32_t) { met++; });
    EXPECT_EQ(met, 10000);
}

// A ray that stops at the first box it enters finds the one that a loop over all finds.
TEST(Bvh, ray_cast_finds_the_first_box) {
    Random random(3);
    std::vector<Aabb> boxes;
    for (int i = 0; i < 2000; i++) {
        const Vec3 at = random.vector(10), half = abs(random.vector(0.3));
        boxes.push_back({at - half, at + half});
    }
    const Bvh tree(boxes);
    int hits = 0, asked = 0;
    for (int ray = 0; ray < 500; ray++) {
        const Vec3 origin = random.vector(12), motion = random.vector(12);
        double first = 2;
        for (const Aabb& box : boxes) first = std::min(first, ray_enters(box, origin, motion, 1));
        double found = 2;
        tree.cast_ray(origin, motion, 1, [&](std::uint32_t item, double limit) {
            asked++;
            found = std::min(found, ray_enters(boxes[item], origin, motion, limit));
            return std::min(limit, found);
        });
        ASSERT_EQ(found, first) << "ray " << ray;
        hits += first <= 1 ? 1 : 0;
    }
    EXPECT_GT(hits, 50);
    EXPECT_LT(asked, 500 * 2000 / 20) << "a loop would ask two thousand each";
}

TEST(Bvh, empty_tree_finds_nothing) {
    const Bvh tree;
    EXPECT_TRUE(tree.empty());
    int met = 0;
    tree.query({{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}}, [&](std::uint32_t) { met++; });
    tree.cast_ray({}, {1, 0, 0}, 1, [&](std::uint32_t, double limit) {
        met++;
        return limit;
    });
    EXPECT_EQ(met, 0);
}

}  // namespace
}  // namespace jostle::test

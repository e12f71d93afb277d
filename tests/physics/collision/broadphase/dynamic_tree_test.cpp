// SPDX-License-Identifier: MIT
#include "physics/src/collision/broadphase/dynamic_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

Aabb random_box(Random& random) {
    const Vec3 low = random.vector(20);
    return {low, low + Vec3{random.in(0, 6), random.in(0, 6), random.in(0, 6)}};
}

std::vector<std::uint32_t> asked(const DynamicTree& tree, const Aabb& box) {
    std::vector<std::uint32_t> found;
    tree.query(box, 1, [&](std::uint32_t item) { found.push_back(item); });
    std::sort(found.begin(), found.end());
    return found;
}

TEST(DynamicTree, matches_a_list_under_random_changes) {
    Random random(1);
    DynamicTree tree;
    std::map<std::uint32_t, std::pair<std::int32_t, Aabb>> list;  // item to leaf and box
    std::uint32_t next = 0;
    std::size_t found = 0;
    for (int change = 0; change < 6000; change++) {
        // Grows for the first half, then shrinks to nothing.
        const bool grow = random.below(100) < (change < 3000 ? 60u : 15u);
        if (grow || list.empty()) {
            const Aabb box = random_box(random);
            list[next] = {tree.insert(box, next), box};
            next++;
        } else {
            auto at =
                std::next(list.begin(), static_cast<std::ptrdiff_t>(random.below(list.size())));
            if (random.below(2) == 0) {
                at->second.second = random_box(random);
                tree.move(at->second.first, at->second.second);
            } else {
                tree.remove(at->second.first);
                list.erase(at);
            }
        }
        // Now and then a third of all moves at once.
        if (change % 97 == 0) {
            for (auto& [item, entry] : list) {
                if (item % 3 != 0) continue;
                entry.second = random_box(random);
                tree.change(entry.first, entry.second);
            }
            tree.rebuild();
        }
        ASSERT_EQ(tree.leaf_count(), static_cast<int>(list.size()));
        if (change % 5 != 0) continue;
        const Aabb probe = random_box(random);
        std::vector<std::uint32_t> expected;
        for (const auto& [item, entry] : list)
            if (overlap(entry.second, probe)) expected.push_back(item);
        ASSERT_EQ(asked(tree, probe), expected) << "change " << change;
        found += expected.size();
    }
    EXPECT_GT(found, 300u);
}

TEST(DynamicTree, ray_cast_visits_every_box_on_its_path) {
    Random random(2);
    DynamicTree tree;
    std::vector<Aabb> boxes;
    for (std::uint32_t i = 0; i < 500; i++) {
        boxes.push_back(random_box(random));
        tree.insert(boxes.back(), i);
    }
    for (int k = 0; k < 300; k++) {
        const Vec3 origin = random.vector(25), motion = random.vector(40);
        std::vector<std::uint32_t> met, expected;
        tree.cast_ray(origin, motion, 1, [&](std::uint32_t item, double limit) {
            met.push_back(item);
            return limit;
        });
        // Independent of the slab test: points along the segment, 2 mm apart in the worst case.
        for (std::uint32_t i = 0; i < boxes.size(); i++) {
            bool inside = false;
            for (int s = 0; s <= 4000 && !inside; s++) {
                const Vec3 p = origin + motion * (s / 4000.0);
                inside = overlap({p, p}, boxes[i]);
            }
            if (inside) expected.push_back(i);
        }
        std::sort(met.begin(), met.end());
        EXPECT_TRUE(std::includes(met.begin(), met.end(), expected.begin(), expected.end()));
        EXPECT_LE(met.size(), expected.size() + 3);  // corners cut between two sampled points
    }
}

TEST(DynamicTree, moving_a_leaf_keeps_its_handle) {
    DynamicTree tree;
    const Aabb unit{{0, 0, 0}, {1, 1, 1}}, far{{9, 9, 9}, {10, 10, 10}};
    const std::int32_t leaf = tree.insert(unit, 7);
    tree.insert(far, 8);
    tree.move(leaf, far);
    EXPECT_EQ(tree.box(leaf), far);
    EXPECT_TRUE(asked(tree, unit).empty());
    EXPECT_EQ(asked(tree, far), (std::vector<std::uint32_t>{7, 8}));
}

// A line of boxes inserted in order is the worst case of a tree without rotations: it would be a
// list.
TEST(DynamicTree, stays_balanced) {
    DynamicTree tree;
    for (std::uint32_t i = 0; i < 4096; i++)
        tree.insert({{1.0 * i, 0, 0}, {1.0 * i + 0.5, 1, 1}}, i);
    RecordProperty("height", tree.height());
    EXPECT_LE(tree.height(), 3 * 12);
    tree.rebuild();
    EXPECT_EQ(tree.height(), 12);
}

// Boxes that cannot be told apart, and such that lie ever farther away.
TEST(DynamicTree, rebuilds_from_any_boxes) {
    DynamicTree same, far;
    for (std::uint32_t i = 0; i < 1000; i++) {
        same.add({{1, 2, 3}, {2, 3, 4}}, i);
        far.add({{std::pow(1.05, i), 0, 0}, {std::pow(1.05, i) + 1, 1, 1}}, i);
    }
    same.rebuild();
    far.rebuild();
    EXPECT_EQ(same.height(), 10);
    EXPECT_EQ(asked(same, {{2, 3, 4}, {9, 9, 9}}).size(), 1000u);
    EXPECT_EQ(asked(far, {{0, 0, 0}, {1e30, 1, 1}}).size(), 1000u);
    EXPECT_LE(far.height(), 400);
    // What is in no category is found by nobody, and stays.
    const std::int32_t nobody = same.insert({{1, 2, 3}, {2, 3, 4}}, 1000, 0);
    same.rebuild();
    EXPECT_EQ(same.leaf_count(), 1001);
    EXPECT_EQ(asked(same, {{2, 3, 4}, {9, 9, 9}}).size(), 1000u);
    same.remove(nobody);
    DynamicTree empty;
    empty.rebuild();
    EXPECT_TRUE(asked(empty, {{0, 0, 0}, {1, 1, 1}}).empty());
}

// What a forged state holds: boxes that no float reaches, to one side and to both.
TEST(DynamicTree, rebuilds_from_boxes_beyond_float_range) {
    DynamicTree tree;
    for (std::uint32_t i = 0; i < 100; i++) {
        const double x = std::pow(10, 3.0 * i);
        tree.add({{i % 2 == 0 ? 0 : -x, 0, 0}, {x, 1, 1}}, i);
    }
    tree.rebuild();
    EXPECT_EQ(asked(tree, {{0, 0, 0}, {1, 1, 1}}).size(), 100u);
}

// At a thousand kilometres a float is off by 6 cm; what is answered is exact.
TEST(DynamicTree, queries_use_exact_boxes) {
    DynamicTree tree;
    tree.insert({{1e6, 0, 0}, {1e6 + 1e-3, 1, 1}}, 1);
    tree.insert({{1e6 + 2e-3, 0, 0}, {1e6 + 3e-3, 1, 1}}, 2);
    EXPECT_EQ(asked(tree, {{1e6 + 1.5e-3, 0, 0}, {1e6 + 2.5e-3, 1, 1}}),
              (std::vector<std::uint32_t>{2}));
    EXPECT_TRUE(asked(tree, {{1e6 + 1.2e-3, 0, 0}, {1e6 + 1.8e-3, 1, 1}}).empty());
}

}  // namespace
}  // namespace jostle::test

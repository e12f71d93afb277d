// SPDX-License-Identifier: MIT
//
// The ways of fast bodies, found by box.
#include "physics/src/stages/continuous/swept_aabb_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace jostle::test {
namespace {
using namespace physics;

// A box of 1 m whose low corner is at x.
Aabb at(double x) {
    return {{x, 0, 0}, {x + 1, 1, 1}};
}
std::vector<std::uint64_t> found(const SweptAabbTree& tree, double x) {
    std::vector<std::uint64_t> bodies;
    tree.query(at(x), [&](auto body) { bodies.push_back(body); });
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}
using Bodies = std::vector<std::uint64_t>;

TEST(SweptAabbTree, finds_boxes_added_in_bulk_or_one_by_one) {
    SweptAabbTree tree;
    EXPECT_TRUE(tree.empty());
    tree.set_all({2, 7, 30}, [](std::uint32_t body) { return at(10.0 * body); });
    EXPECT_FALSE(tree.empty());
    EXPECT_TRUE(tree.has(7));
    EXPECT_FALSE(tree.has(3));
    EXPECT_FALSE(tree.has(1000));
    EXPECT_EQ(found(tree, 70.5), Bodies{7});
    tree.set(50, at(70.9));
    EXPECT_EQ(found(tree, 70.5), (Bodies{7, 50}));
    EXPECT_EQ(found(tree, 5), Bodies{});
}

TEST(SweptAabbTree, deflected_body_keeps_one_box) {
    SweptAabbTree tree;
    tree.set(4, at(0));
    tree.set(4, at(100));
    EXPECT_EQ(found(tree, 0), Bodies{});
    EXPECT_EQ(found(tree, 100), Bodies{4});
}

}  // namespace
}  // namespace jostle::test

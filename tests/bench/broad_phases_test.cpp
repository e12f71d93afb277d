// SPDX-License-Identifier: MIT
//
// The broad phases of the benchmark return the same results as those of worlds.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/broadphase/kd_tree.h"
#include "bench/broadphase/loose_octree.h"
#include "tests/support/broad_phase_oracle.h"

namespace jostle::test {
namespace {
using namespace physics;

template <class Index>
std::unique_ptr<BroadPhaseIndex> make() {
    return std::make_unique<Index>();
}

TEST(BenchBroadPhases, match_a_brute_force_loop) {
    expect_matches_brute_force(make<bench::LooseOctree>);
    expect_matches_brute_force(make<bench::KdTree>);
}

// Boxes with integer coordinates: touching sides lie in the planes of cells. All boxes move in one
// call, as in a step, and some return to an empty tree.
void expect_pairs_of_touching_boxes(std::unique_ptr<BroadPhaseIndex> (*make)()) {
    Random random(3);
    const auto index = make();
    for (int round = 0; round < 5; round++) {
        std::vector<Aabb> boxes;
        std::vector<std::int32_t> handles;
        const auto box = [&] {
            const auto whole = [&] { return static_cast<double>(random.below(17)) - 8; };
            const Vec3 low{whole(), whole(), whole()};
            const auto side = [&] { return static_cast<double>(random.below(3)); };
            return Aabb{low, low + Vec3{side(), side(), side()}};
        };
        for (std::uint32_t k = 0; k < 600; k++) {
            boxes.push_back(box());
            handles.push_back(index->insert(boxes[k], k, 1));
        }
        for (int step = 0; step < 4; step++) {
            std::vector<BroadPhaseIndex::Move> moves;
            for (std::size_t k = 0; k < boxes.size(); k++)
                if (step % 2 == 0 || random.below(20) == 0) {
                    boxes[k] = box();
                    moves.push_back({handles[k], boxes[k]});
                }
            index->move_all(moves);
            index->flush();
            for (std::uint32_t k = 0; k < boxes.size(); k++) {
                std::vector<std::uint32_t> found, expected;
                index->query(boxes[k], 1, found);
                std::sort(found.begin(), found.end());
                for (std::uint32_t j = 0; j < boxes.size(); j++)
                    if (overlap(boxes[j], boxes[k])) expected.push_back(j);
                ASSERT_EQ(found, expected) << "each box must be found once";
            }
            for (int ray = 0; ray < 200; ray++) {
                // Rays along planes and edges of boxes, and across them.
                const Vec3 from = box().low, motion = box().low;
                std::vector<std::uint32_t> visited;
                index->cast_ray(from, motion, 1, [&](std::uint32_t item, double limit) {
                    visited.push_back(item);
                    return limit;
                });
                std::sort(visited.begin(), visited.end());
                visited.erase(std::unique(visited.begin(), visited.end()), visited.end());
                std::vector<std::uint32_t> expected;
                for (std::uint32_t j = 0; j < boxes.size(); j++)
                    if (ray_enters(boxes[j], from, motion, 1) <= 1) expected.push_back(j);
                ASSERT_EQ(visited, expected);
            }
            std::vector<Aabb> cells;
            index->cells(cells);
            ASSERT_GT(cells.size(), 10u);
        }
        for (const std::int32_t handle : handles) index->remove(handle);
        std::vector<std::uint32_t> found;
        index->query(grow({}, 100), 1, found);
        ASSERT_TRUE(found.empty());
    }
}

TEST(BenchBroadPhases, report_each_touching_pair_once) {
    expect_pairs_of_touching_boxes(make<bench::LooseOctree>);
    expect_pairs_of_touching_boxes(make<bench::KdTree>);
}

}  // namespace
}  // namespace jostle::test

// SPDX-License-Identifier: MIT
//
// Requirements of every broad phase: the same results as a loop over all boxes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "jostle/physics/queries.h"
#include "physics/src/collision/broadphase/broad_phase.h"
#include "tests/support/random.h"

namespace jostle::test {

// Inserts, moves and removes boxes. After each round, compares every query with a loop over all
// boxes.
inline void expect_matches_brute_force(std::unique_ptr<physics::BroadPhaseIndex> (*make)()) {
    using namespace physics;
    struct Item {
        Aabb box;
        std::uint32_t category;
        std::int32_t handle;
    };
    const auto index = make();
    OwnedBroadPhase copy = make();
    std::map<std::uint32_t, Item> items;
    Random random(12);
    const auto random_box = [&] {
        const Vec3 at = random.vector(20);
        const double size = random.below(30) == 0 ? 15 : random.in(0.1, 1.5);
        return grow({at, at}, size);
    };
    for (std::uint32_t round = 0; round < 40; round++) {
        for (std::uint32_t k = 0; k < 12; k++) {
            const std::uint32_t id = round * 100 + k;
            const Aabb box = random_box();
            const std::uint32_t category = 1u << random.below(3);
            items[id] = {box, category, index->insert(box, id, category)};
        }
        for (auto& [id, item] : items)
            if (random.below(3) == 0) {
                const Vec3 displacement = random.vector(random.below(4) == 0 ? 30 : 0.5);
                item.box = {item.box.low + displacement, item.box.high + displacement};
                index->move(item.handle, item.box);
            }
        for (auto it = items.begin(); it != items.end();)
            if (random.below(6) == 0) {
                index->remove(it->second.handle);
                it = items.erase(it);
            } else {
                ++it;
            }
        if (round % 4 != 1) index->flush();  // without flush() a query is slower but correct
        if (round % 2 == 0)
            copy->assign(*index);
        else
            copy = index->clone();
        for (int q = 0; q < 20; q++) {
            const Aabb box = random_box();
            const std::uint32_t mask = 1 + static_cast<std::uint32_t>(random.below(7));
            std::vector<std::uint32_t> found, expected;
            copy->query(box, mask, found);
            std::sort(found.begin(), found.end());
            const Ray ray{random.vector(25), random.vector(40)};
            std::vector<std::uint32_t> hit, expected_hit;
            copy->cast_ray(ray.origin, ray.motion, mask, [&](std::uint32_t item, double limit) {
                hit.push_back(item);
                return limit;
            });
            std::sort(hit.begin(), hit.end());
            hit.erase(std::unique(hit.begin(), hit.end()), hit.end());
            for (const auto& [id, item] : items) {
                if ((item.category & mask) == 0) continue;
                if (overlap(item.box, box)) expected.push_back(id);
                if (ray_enters(item.box, ray.origin, ray.motion, 1) <= 1)
                    expected_hit.push_back(id);
            }
            ASSERT_EQ(found, expected) << "round " << round;
            ASSERT_EQ(hit, expected_hit) << "round " << round;
        }
    }
}

}  // namespace jostle::test

// SPDX-License-Identifier: MIT
//
// Tree, sort and sweep, grid: the same answers, and the same worlds to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "collision/broadphase/broad_phase.h"
#include "support/random.h"
#include "support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

class EveryBroadPhase : public testing::TestWithParam<BroadPhase> {};

// Inserts, moves, removes; after each round every question is compared with a loop over all boxes.
TEST_P(EveryBroadPhase, answers_as_a_loop_over_all_boxes_does) {
    struct Item {
        Aabb box;
        std::uint32_t category;
        std::int32_t handle;
    };
    const auto index = make_broad_phase(GetParam());
    OwnedBroadPhase copy = make_broad_phase(GetParam());
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
                const Vec3 way = random.vector(random.below(4) == 0 ? 30 : 0.5);
                item.box = {item.box.low + way, item.box.high + way};
                index->move(item.handle, item.box);
            }
        for (auto it = items.begin(); it != items.end();)
            if (random.below(6) == 0) {
                index->remove(it->second.handle);
                it = items.erase(it);
            } else {
                ++it;
            }
        if (round % 4 != 1) index->flush();  // unsettled it is slower, not wrong
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
            std::vector<std::uint32_t> met, expected_met;
            copy->cast_ray(ray.origin, ray.motion, mask, [&](std::uint32_t item, double limit) {
                met.push_back(item);
                return limit;
            });
            std::sort(met.begin(), met.end());
            met.erase(std::unique(met.begin(), met.end()), met.end());
            for (const auto& [id, item] : items) {
                if ((item.category & mask) == 0) continue;
                if (overlap(item.box, box)) expected.push_back(id);
                if (ray_enters(item.box, ray.origin, ray.motion, 1) <= 1)
                    expected_met.push_back(id);
            }
            ASSERT_EQ(found, expected) << "round " << round;
            ASSERT_EQ(met, expected_met) << "round " << round;
        }
    }
}

// The world that comes of it is the same to the last bit.
TEST_P(EveryBroadPhase, makes_the_same_world) {
    const auto hash_with = [](BroadPhase kind) {
        World world = make_world({.broad_phase = kind});
        add_floor(world);
        add_walls(world, 3);
        Random random(2);
        for (int i = 0; i < 80; i++)
            add(world, {.geometry = random_round_or_box(random),
                        .position = {random.in(-2, 2), 1 + 0.2 * i, random.in(-2, 2)}});
        run(world, 4);
        return state_hash(world);
    };
    static const std::uint64_t tree = hash_with(BroadPhase::dynamic_tree);
    EXPECT_EQ(hash_with(GetParam()), tree);
}

INSTANTIATE_TEST_SUITE_P(kinds, EveryBroadPhase,
                         testing::Values(BroadPhase::dynamic_tree, BroadPhase::sort_and_sweep,
                                         BroadPhase::uniform_grid));

// No fixed number of pairs anywhere: a plate that rests on 400 pillars touches all of them, each
// with its share of the weight.
TEST(BroadPhase, plate_on_400_pillars_has_400_contacts) {
    World world = make_world();
    for (int i = 0; i < 400; i++)
        add(world, {.geometry = Box{{0.1, 0.5, 0.1}},
                    .position = {(i % 20) * 0.5 - 4.75, 0.5, (i / 20) * 0.5 - 4.75},
                    .type = BodyType::static_body});
    const BodyId plate = add(world, {.geometry = Box{{5, 0.05, 5}}, .position = {0, 1.05, 0}});
    run(world, 2);
    int touching = 0;
    for (const ContactInfo& c : world.contacts()) touching += c.touching ? 1 : 0;
    EXPECT_EQ(touching, 400);
    EXPECT_NEAR(position_of(world, plate).y, 1.05, 1e-3);
}

}  // namespace
}  // namespace jostle::test

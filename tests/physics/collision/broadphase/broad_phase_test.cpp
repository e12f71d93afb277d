// SPDX-License-Identifier: MIT
//
// Tree, sort and sweep, grid: the same answers, and the same worlds to the bit.
#include <gtest/gtest.h>

#include "tests/support/broad_phase_oracle.h"
#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

class EveryBroadPhase : public testing::TestWithParam<BroadPhase> {};

template <BroadPhase kind>
std::unique_ptr<BroadPhaseIndex> make() {
    return make_broad_phase(kind);
}

TEST(BroadPhase, every_kind_matches_brute_force) {
    expect_matches_brute_force(make<BroadPhase::dynamic_tree>);
    expect_matches_brute_force(make<BroadPhase::sort_and_sweep>);
    expect_matches_brute_force(make<BroadPhase::uniform_grid>);
}

// The world that comes of it is the same to the last bit.
TEST_P(EveryBroadPhase, produces_the_same_world) {
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
TEST(BroadPhase, finds_400_contacts_of_a_plate_on_400_pillars) {
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

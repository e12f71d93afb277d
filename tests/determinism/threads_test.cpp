// SPDX-License-Identifier: MIT
//
// 600 steps give the same bits with 1, 2 and 4 threads, including events. The thread sanitizer is
// about fifteen times slower and only looks for races, so it runs fewer steps.
#include <gtest/gtest.h>

#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

#ifdef __SANITIZE_THREAD__
constexpr int steps = 150;
#else
constexpr int steps = 600;
#endif

class Threads : public testing::TestWithParam<TestScene> {};

TEST_P(Threads, do_not_change_results) {
    std::vector<World> worlds;
    for (const int threads : {1, 2, 4}) worlds.push_back(GetParam().make(threads));
    for (int step = 0; step < steps; step++) {
        for (World& world : worlds) {
            disturb(world, step);
            must(world.step(1.0 / 60));
        }
        const Events first = worlds[0].events();
        for (std::size_t k = 1; k < worlds.size(); k++) {
            const Events other = worlds[k].events();
            ASSERT_EQ(first.contacts_began.size(), other.contacts_began.size()) << "step " << step;
            for (std::size_t i = 0; i < first.contacts_began.size(); i++) {
                ASSERT_EQ(first.contacts_began[i].shape_a, other.contacts_began[i].shape_a);
                ASSERT_EQ(first.contacts_began[i].shape_b, other.contacts_began[i].shape_b);
                ASSERT_EQ(first.contacts_began[i].point, other.contacts_began[i].point);
            }
            ASSERT_EQ(first.contacts_ended.size(), other.contacts_ended.size()) << "step " << step;
        }
        if (step % 50 != 49) continue;
        for (std::size_t k = 1; k < worlds.size(); k++)
            ASSERT_EQ(state_hash(worlds[0]), state_hash(worlds[k]))
                << "step " << step << ": " << first_difference(worlds[0], worlds[k]).value_or("");
    }
}

// Choosing the threads of a step by the work of the previous one does not change results either.
TEST_P(Threads, choice_of_threads_does_not_change_results) {
    World one = GetParam().make(1), two = GetParam().make(2);
    share_short_steps(false);
    for (int step = 0; step < steps / 3; step++)
        for (World* world : {&one, &two}) {
            disturb(*world, step);
            must(world->step(1.0 / 60));
        }
    share_short_steps(true);
    EXPECT_EQ(state_hash(one), state_hash(two)) << first_difference(one, two).value_or("");
}

// The thread count can change while a world runs, because it is not part of its state.
TEST_P(Threads, can_change_between_steps) {
    World steady = GetParam().make(1), changing = GetParam().make(1);
    for (int step = 0; step < steps / 3; step++) {
        must(changing.set_threads(1 + step % 3));
        must(steady.step(1.0 / 60));
        must(changing.step(1.0 / 60));
    }
    EXPECT_EQ(state_hash(steady), state_hash(changing));
}

INSTANTIATE_TEST_SUITE_P(scenes, Threads, testing::ValuesIn(test_scenes()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace jostle::test

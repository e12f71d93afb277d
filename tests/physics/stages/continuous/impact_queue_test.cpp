// SPDX-License-Identifier: MIT
//
// The order in which impacts and ends of legs are processed.
#include "physics/src/stages/continuous/impact_queue.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/physics/stages/continuous/toi_scene.h"

namespace jostle::test {
namespace {
using namespace physics;

// Three moving balls that may hit a fourth one at rest.
struct Queue {
    ToiScene scene;
    std::vector<std::uint32_t> balls{scene.ball(0), scene.ball(1), scene.ball(2), scene.ball(3)};
    ToiState& state = scene.begin();
    ImpactQueue queue;

    Queue() {
        for (std::uint32_t k = 0; k < 3; k++) scene.moving(balls[k], 4);
    }
    void impact(std::size_t index, double at, double closing) {
        ToiBody& t = state.bodies[index];
        t.fraction = at;
        t.closing = closing;
        t.own_shape = balls[index];
        t.other_shape = balls[3];
        queue.update(state, index);
    }
    std::vector<std::size_t> dependents_of_target() {
        std::vector<std::size_t> found;
        queue.take_dependents(balls[3], [&](std::size_t k) { found.push_back(k); });
        return found;
    }
};

TEST(ImpactQueue, returns_the_earliest_impact) {
    Queue q;
    EXPECT_FALSE(q.queue.next());
    q.impact(0, 0.5, 9);
    q.impact(1, 0.3, 1);
    q.impact(2, 0.4, 5);
    EXPECT_EQ(q.queue.next(), 1u);
    EXPECT_EQ(q.queue.next(), 1u) << "it stays until its body is updated";
}

TEST(ImpactQueue, returns_the_hardest_of_simultaneous_impacts_first) {
    Queue q;
    q.impact(0, 0.5, 1);
    q.impact(1, 0.5, 3);
    q.impact(2, 0.5, 3);
    EXPECT_EQ(q.queue.next(), 1u) << "equal ones by index";
}

TEST(ImpactQueue, update_replaces_the_previous_event) {
    Queue q;
    q.impact(0, 0.2, 1);
    q.impact(1, 0.4, 1);
    q.impact(0, 0.6, 1);
    EXPECT_EQ(q.queue.next(), 1u);
    q.impact(1, Impact::never, 0);
    EXPECT_EQ(q.queue.next(), 0u);
    q.impact(0, Impact::never, 0);
    EXPECT_FALSE(q.queue.next()) << "nothing happens in the rest of the step";
}

TEST(ImpactQueue, end_of_a_leg_is_an_event_before_the_end_of_the_step) {
    Queue q;
    q.state.bodies[0].sweep.until = 0.25;
    q.impact(0, Impact::never, 0);
    q.impact(1, 0.5, 1);
    EXPECT_EQ(q.queue.next(), 0u);
    q.state.bodies[0].sweep.until = 1;
    q.impact(0, Impact::never, 0);
    EXPECT_EQ(q.queue.next(), 1u);
}

TEST(ImpactQueue, returns_each_dependent_once) {
    Queue q;
    q.impact(0, 0.5, 1);
    q.impact(1, Impact::never, 0);
    q.impact(2, 0.7, 1);
    EXPECT_EQ(q.dependents_of_target(), (std::vector<std::size_t>{2, 0}));
    EXPECT_TRUE(q.dependents_of_target().empty());
}

}  // namespace
}  // namespace jostle::test

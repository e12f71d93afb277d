// SPDX-License-Identifier: MIT
//
// Requests are applied in order of bodies; those that have become void are forgotten.
#include "physics/src/state/wake.h"

#include <gtest/gtest.h>

#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Boxes that lie about on a floor, 3 m apart, asleep each on its own.
struct Sleepers {
    World world = make_world();
    WorldState& state = state_of(world);
    std::vector<BodyId> boxes;
    std::vector<BodyId> woke;

    explicit Sleepers(int count) {
        add_floor(world);
        for (int k = 0; k < count; k++)
            boxes.push_back(add(world, {.position = {3.0 * k, 0.5, 0}}));
        run(world, 2);
        EXPECT_TRUE(state.bodies.awake.empty());
    }
    bool sleeps(std::size_t box) const {
        return state.bodies.cold[boxes[box].index].set == BodySet::sleeping;
    }
    void request(std::size_t box) { state.wake_requests.push_back({boxes[box].index}); }
    std::string fault() const { return find_fault(state).value_or(""); }
};

TEST(Wake, requests_are_applied_once_in_body_order) {
    Sleepers sleepers(5);
    for (const std::size_t box : {3u, 1u, 3u, 4u}) sleepers.request(box);
    apply_wake_requests(sleepers.state, sleepers.woke);
    EXPECT_EQ(sleepers.woke,
              (std::vector{sleepers.boxes[1], sleepers.boxes[3], sleepers.boxes[4]}));
    EXPECT_TRUE(sleepers.state.wake_requests.empty());
    EXPECT_TRUE(sleepers.sleeps(0));
    EXPECT_TRUE(sleepers.sleeps(2));
    EXPECT_EQ(sleepers.fault(), "");
}

TEST(Wake, requests_for_destroyed_and_awake_bodies_are_dropped) {
    Sleepers sleepers(3);
    sleepers.request(0);
    sleepers.request(1);
    must(sleepers.world.destroy_body(sleepers.boxes[0]));
    must(sleepers.world.wake(sleepers.boxes[1]));
    warm_of(sleepers.state, sleepers.boxes[1].index).sleep_time = 0.25;
    apply_wake_requests(sleepers.state, sleepers.woke);
    EXPECT_TRUE(sleepers.woke.empty());
    EXPECT_TRUE(sleepers.state.wake_requests.empty());
    EXPECT_EQ(warm_of(sleepers.state, sleepers.boxes[1].index).sleep_time, 0.25)
        << "its rest goes on";
    EXPECT_TRUE(sleepers.sleeps(2));
    EXPECT_EQ(sleepers.fault(), "");
}

// A column of twenty sleeps as one island. A request with mass wakes the island, and of that so
// much as it stirs: the rest sleeps on in place.
TEST(Wake, wakes_the_requested_mass_of_a_large_island) {
    for (const auto& [mass, expected] : {std::pair{0.0, 1u}, {2500.0, 3u}, {1e9, 20u}}) {
        World world = make_world();
        add_floor(world);
        std::vector<BodyId> column;
        for (int k = 0; k < 20; k++) column.push_back(add(world, {.position = {0, 0.5 + k, 0}}));
        run(world, 10);
        WorldState& state = state_of(world);
        ASSERT_TRUE(state.bodies.awake.empty());
        state.wake_requests.push_back({column[10].index, mass});
        std::vector<BodyId> woke;
        apply_wake_requests(state, woke);
        EXPECT_EQ(woke.size(), expected) << mass << " kg";
        EXPECT_EQ(state.bodies.asleep_in_place, 20 - expected);
        EXPECT_FALSE(state.bodies.cold[column[10].index].asleep_in_place);
        EXPECT_EQ(find_fault(state), std::nullopt);
    }
}

// 10 kg m/s are slow, a tenth of a metre per second, in 100 kg.
TEST(Wake, impact_wakes_mass_in_proportion_to_momentum) {
    EXPECT_NEAR(mass_to_wake(10), 100, 1e-12);
    EXPECT_LT((WakeRequest{1, 5, true}), (WakeRequest{2, 0, false})) << "bodies count first";
}

TEST(Wake, waking_resets_the_rest_time_and_defers_the_event_to_the_step) {
    Sleepers sleepers(2);
    wake_body(sleepers.state, sleepers.boxes[1].index);
    EXPECT_EQ(sleepers.state.events.pending.woke, std::vector{sleepers.boxes[1]});
    EXPECT_EQ(warm_of(sleepers.state, sleepers.boxes[1].index).sleep_time, 0);
    EXPECT_TRUE(sleepers.sleeps(0));
    wake_body(sleepers.state, 0);
    EXPECT_EQ(sleepers.state.events.pending.woke.size(), 1u) << "the floor does not wake";
}

TEST(Wake, contact_and_joint_neighbours_wake_and_others_do_not) {
    Sleepers sleepers(4);
    must(sleepers.world.create_joint({.body_a = sleepers.boxes[0],
                                      .body_b = sleepers.boxes[1],
                                      .frame_a = {.position = {1.5, 0, 0}},
                                      .frame_b = {.position = {-1.5, 0, 0}}}));
    run(sleepers.world, 2);
    ASSERT_TRUE(sleepers.sleeps(0) && sleepers.sleeps(1));
    wake_neighbours(sleepers.state, sleepers.boxes[1].index);
    EXPECT_FALSE(sleepers.sleeps(0));
    EXPECT_TRUE(sleepers.sleeps(2));
    wake_neighbours(sleepers.state, 0);
    EXPECT_FALSE(sleepers.sleeps(2)) << "it lies on the floor";
    EXPECT_FALSE(sleepers.sleeps(3));
    EXPECT_EQ(sleepers.fault(), "");
}

}  // namespace
}  // namespace jostle::test

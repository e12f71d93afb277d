// SPDX-License-Identifier: MIT
#include "server/world/body_limits.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

constexpr double tick_hz = 60;

Command spawn_of(ClientId client, AccountId account) {
    return {.client = client,
            .account = account,
            .sequence = 1,
            .action = SpawnCommand{},
            .reply = nullptr};
}

// Ticks that use `share` of their period.
void run_busy(BodyLimits& limits, double share, double seconds) {
    for (int k = 0; k < seconds * tick_hz; k++) limits.end_tick(share / tick_hz, true);
}

TEST(BodyLimits, clients_of_one_account_share_an_allowance) {
    BodyLimits limits({.account_bodies_max = 6}, tick_hz);
    Ownership ownership;
    EntityId entity = 0;
    for (ClientId client = 1; client <= 3; client++) {
        EXPECT_FALSE(limits.refusal(spawn_of(client, 77), ownership).has_value());
        ownership.add(client, ++entity), ownership.add(client, ++entity);
    }
    const auto refused = limits.refusal(spawn_of(4, 77), ownership);
    ASSERT_TRUE(refused.has_value());
    EXPECT_EQ(refused->code, ErrorCode::resource_exhausted);
    EXPECT_EQ(
        refused->message,
        "the clients of this player or network own 6 bodies; client.account_bodies_max allows "
        "6; delete a body first");
    EXPECT_FALSE(limits.refusal(spawn_of(5, 78), ownership).has_value()) << "another account";
    EXPECT_FALSE(limits.refusal(spawn_of(4, 0), ownership).has_value()) << "no account";
    ownership.remove(1);
    EXPECT_FALSE(limits.refusal(spawn_of(4, 77), ownership).has_value());
}

TEST(BodyLimits, a_busy_world_refuses_spawns_but_nothing_else) {
    BodyLimits limits({.spawn_load_max = 0.7}, tick_hz);
    const Ownership ownership;
    run_busy(limits, 0.6, 5);
    EXPECT_NEAR(limits.load(), 0.6, 0.01);
    EXPECT_FALSE(limits.refusal(spawn_of(1, 7), ownership).has_value());
    run_busy(limits, 0.9, 1);
    const auto refused = limits.refusal(spawn_of(1, 7), ownership);
    ASSERT_TRUE(refused.has_value());
    EXPECT_EQ(refused->retry_after_ms, 1000);
    Command impulse = spawn_of(1, 7);
    impulse.action = ImpulseCommand{};
    EXPECT_FALSE(limits.refusal(impulse, ownership).has_value());
}

TEST(BodyLimits, an_overloaded_world_loses_the_oldest_bodies_of_whoever_owns_most) {
    BodyLimits limits({}, tick_hz);
    Ownership ownership;
    for (ClientId client = 1; client <= 3; client++)
        static_cast<void>(limits.refusal(spawn_of(client, client == 3 ? 8 : 7), ownership));
    for (EntityId k = 0; k < 60; k++) ownership.add(1 + k % 2, 100 + k);  // of account 7
    for (EntityId k = 0; k < 40; k++) ownership.add(3, 200 + k);          // of account 8
    run_busy(limits, 1.5, 0.5);
    EXPECT_TRUE(limits.take_removals(ownership, {}).excess.empty()) << "for half a second only";
    run_busy(limits, 1.5, 1.5);
    const BodyLimits::Removal removal = limits.take_removals(ownership, {});
    EXPECT_EQ(removal.account, 7u);
    EXPECT_EQ(removal.excess, (std::vector<EntityId>{100, 101, 102, 103, 104, 105}));
    for (const EntityId entity : removal.excess) ownership.remove(entity);
    int more = 0;
    for (int k = 0; k < 40; k++) {
        run_busy(limits, 1.5, 0.25);
        for (const EntityId entity : limits.take_removals(ownership, {}).excess) {
            ownership.remove(entity);
            more++;
        }
    }
    EXPECT_EQ(more, 74) << "each account keeps ten bodies";
    run_busy(limits, 0.5, 2);
    EXPECT_TRUE(limits.take_removals(ownership, {}).excess.empty());
}

TEST(BodyLimits, a_paused_world_loses_no_bodies) {
    BodyLimits limits({}, tick_hz);
    Ownership ownership;
    static_cast<void>(limits.refusal(spawn_of(1, 7), ownership));
    for (EntityId k = 1; k < 60; k++) ownership.add(1, k);
    for (int k = 0; k < 300; k++) limits.end_tick(2 / tick_hz, false);
    EXPECT_TRUE(limits.take_removals(ownership, {}).excess.empty());
}

TEST(BodyLimits, retained_bodies_expire) {
    BodyLimits limits({.retained_seconds = 10}, tick_hz);
    const Clock::time_point start{};
    limits.on_retained({4, 5}, start);
    limits.on_retained({6}, start + 5s);
    const Ownership ownership;
    EXPECT_TRUE(limits.take_removals(ownership, start + 9s).expired.empty());
    EXPECT_EQ(limits.take_removals(ownership, start + 10s).expired, (std::vector<EntityId>{4, 5}));
    EXPECT_EQ(limits.take_removals(ownership, start + 20s).expired, std::vector<EntityId>{6});
    EXPECT_TRUE(limits.take_removals(ownership, start + 30s).expired.empty());
}

}  // namespace
}  // namespace jostle::server

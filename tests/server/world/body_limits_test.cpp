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

TEST(BodyLimits, bodies_arrive_more_slowly_the_busier_the_world_is) {
    const Ownership ownership;
    const auto accepted_per_second = [&](double load) {
        BodyLimits limits({}, tick_hz);
        run_busy(limits, load, 5);
        int accepted = 0;
        for (int second = 0; second < 4; second++)
            for (int tick = 0; tick < tick_hz; tick++) {
                for (int k = 0; k < 20; k++)
                    accepted += limits.refusal(spawn_of(1, 7), ownership) ? 0 : 1;
                limits.end_tick(load / tick_hz, true);
            }
        return accepted / 4;
    };
    EXPECT_NEAR(accepted_per_second(0), 240 + 30, 5) << "and half a second's at once";
    EXPECT_NEAR(accepted_per_second(0.35), 120 + 30, 5);
    EXPECT_EQ(accepted_per_second(0.9), 0);
}

TEST(BodyLimits, an_overloaded_world_loses_the_oldest_bodies_of_whoever_owns_most) {
    BodyLimits limits({}, tick_hz);
    Ownership ownership;
    for (ClientId client = 1; client <= 4; client++)
        static_cast<void>(limits.refusal(spawn_of(client, client == 3 ? 8 : 7), ownership));
    // Of account 7, one client has a few.
    for (EntityId k = 0; k < 56; k++) ownership.add(1 + k % 2, 104 + k);
    for (EntityId k = 0; k < 4; k++) ownership.add(4, 100 + k);
    for (EntityId k = 0; k < 40; k++) ownership.add(3, 200 + k);  // of account 8
    run_busy(limits, 1.5, 0.5);
    EXPECT_TRUE(limits.take_removals(ownership, {}).excess.empty()) << "for half a second only";
    run_busy(limits, 1.5, 1.5);
    const BodyLimits::Removal removal = limits.take_removals(ownership, {});
    EXPECT_EQ(removal.excess, (std::vector<EntityId>{104, 105, 106, 107, 108, 109}));
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
    EXPECT_EQ(ownership.count(4), 4) << "of clients with few bodies";
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

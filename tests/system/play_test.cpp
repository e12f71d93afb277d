// SPDX-License-Identifier: MIT
//
// Acceptance test: the real server with 20 players over gRPC and one over WebSocket for 20 s.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <random>
#include <set>
#include <thread>

#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;

constexpr int grpc_players = 20;
constexpr auto play_time = 6s;       // at least
constexpr auto play_time_max = 60s;  // a busy machine sends fewer snapshots per second
constexpr int snapshots_of_each = 120;
constexpr auto batch_period = 33ms;

// The inputs of one batch: sometimes a new box, otherwise an impulse on a known body, sometimes a
// delete of an own body. Seeded, so that a failure can be reproduced.
std::vector<v1::Input> next_inputs(const PlayState& state, std::minstd_rand& random) {
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::vector<std::uint32_t> own, loose;
    for (const auto& [id, entity] : state.entities) {
        if (entity.owner() == state.client_id) own.push_back(id);
        if (entity.type() == v1::BODY_TYPE_DYNAMIC) loose.push_back(id);
    }
    const auto one_of = [&](const auto& ids) {
        return ids[static_cast<std::size_t>(pick(static_cast<int>(ids.size())))];
    };
    const int choice = pick(30);
    if (choice == 0) return {spawn_box(pick(9) - 4, 3 + pick(3), pick(9) - 4)};
    if (choice == 1 && !own.empty()) return {remove_body(one_of(own))};
    if (loose.empty()) return {};
    if (choice == 2) return {impulse(one_of(loose), 1, 2, 0), impulse(one_of(loose), 0, 2, 1)};
    return {impulse(one_of(loose), pick(3) - 1, pick(3), pick(3) - 1)};
}

void play(Player& player, const std::atomic<bool>& done, unsigned seed) {
    std::minstd_rand random(seed);
    auto next = std::chrono::steady_clock::now();
    while (!done) {
        player.send_inputs(
            player.with_state([&](const PlayState& s) { return next_inputs(s, random); }));
        next += batch_period;
        std::this_thread::sleep_until(next);
    }
}

// Checks that each accepted input was applied exactly once, as far as a client can observe it.
void check_inputs(const PlayState& state, const std::map<std::uint32_t, v1::Input>& sent,
                  const std::string& who) {
    EXPECT_EQ(state.results.size(), sent.size()) << who << ": each input must have one result";
    std::set<std::uint32_t> spawned, deleted, owned;
    for (const auto& [sequence, result] : state.results) {
        ASSERT_TRUE(sent.contains(sequence))
            << who << ": a result for an unknown input " << sequence;
        const v1::Input& input = sent.at(sequence);
        // Other players delete bodies that this player pushes. No other rejection is possible.
        EXPECT_TRUE(result.code() == v1::INPUT_CODE_APPLIED ||
                    (input.has_impulse() && result.code() == v1::INPUT_CODE_NOT_FOUND) ||
                    (input.has_delete_() && deleted.contains(input.delete_().entity())))
            << who << " input " << sequence << ": " << result.message();
        if (result.code() != v1::INPUT_CODE_APPLIED) continue;
        EXPECT_GT(result.tick(), 0u) << who;
        if (input.has_spawn()) {
            EXPECT_TRUE(spawned.insert(result.entity()).second) << who;
        }
        if (input.has_delete_()) {
            EXPECT_TRUE(deleted.insert(input.delete_().entity()).second) << who;
        }
    }
    for (const auto& [id, entity] : state.entities) {
        if (entity.owner() == state.client_id) owned.insert(id);
    }
    for (const std::uint32_t id : deleted) spawned.erase(id);
    EXPECT_EQ(owned, spawned)
        << who << ": the player must own the bodies that it spawned and did not delete";
}

TEST(Play, twenty_bots_and_a_browser_play_together) {
    ServerProcess server(
        {"--scene", "sandbox", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"});
    ASSERT_TRUE(server.is_running()) << server.log();
    std::vector<std::unique_ptr<Player>> players;
    for (int i = 0; i < grpc_players; ++i) players.push_back(grpc_player(server.grpc_address()));
    players.push_back(websocket_player(server.http_port()));
    for (const auto& player : players) {
        player->hello();
        ASSERT_TRUE(player->wait_until([](const PlayState& s) { return s.snapshots > 0; }))
            << player->end().value_or("no snapshot");
    }

    std::atomic<bool> done = false;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < players.size(); ++i) {
        threads.emplace_back([&, i] { play(*players[i], done, static_cast<unsigned>(i) + 1); });
    }
    const auto begin = std::chrono::steady_clock::now();
    std::this_thread::sleep_until(begin + play_time);
    for (const auto& player : players)
        player->wait_until([](const PlayState& s) { return s.snapshots > snapshots_of_each; },
                           std::chrono::duration_cast<std::chrono::milliseconds>(
                               begin + play_time_max - std::chrono::steady_clock::now()));
    done = true;
    for (std::thread& thread : threads) thread.join();

    for (const auto& player : players) {
        EXPECT_TRUE(player->wait_until(
            [&](const PlayState& s) { return s.results.size() >= player->inputs_sent().size(); }));
    }
    // All players have a snapshot newer than the last result, so their entities reflect all
    // results.
    std::uint32_t last_tick = 0;
    for (const auto& player : players) {
        player->with_state([&](const PlayState& s) {
            for (const auto& [sequence, result] : s.results)
                last_tick = std::max(last_tick, result.tick());
        });
    }
    for (const auto& player : players) {
        player->send_inputs({});
        EXPECT_TRUE(
            player->wait_until([&](const PlayState& s) { return s.newest_frame > last_tick; }));
    }

    std::map<std::uint32_t, std::uint32_t> crc_of;
    std::vector<double> ages;
    std::size_t applied = 0;
    for (std::size_t i = 0; i < players.size(); ++i) {
        const std::string who = "player " + std::to_string(i);
        EXPECT_FALSE(players[i]->end()) << who << ": " << *players[i]->end();
        players[i]->with_state([&](const PlayState& s) {
            EXPECT_EQ(s.violations, 0) << who << ": " << s.first_violation;
            EXPECT_TRUE(s.notices.empty()) << who << ": " << s.notices[0].message();
            check_inputs(s, players[i]->inputs_sent(), who);
            EXPECT_GT(s.snapshots, snapshots_of_each) << who << " skipped " << s.skipped;
            // Every client has the same state for the same frame.
            for (const auto& [frame, crc] : s.crc_of) {
                EXPECT_EQ(crc_of.emplace(frame, crc).first->second, crc)
                    << who << " frame " << frame;
            }
            ages.insert(ages.end(), s.ages_ms.begin(), s.ages_ms.end());
            applied += s.count(v1::INPUT_CODE_APPLIED);
        });
    }
    std::ranges::sort(ages);
    std::printf(
        "%zu inputs applied, %zu snapshots, age p50 %.2f ms, p99 %.2f ms, server CPU %.2f s\n",
        applied, ages.size(), ages[ages.size() / 2], ages[ages.size() * 99 / 100],
        server.cpu_seconds());

    for (const auto& player : players) player->leave();
    for (const auto& player : players) EXPECT_TRUE(player->wait_for_end());
    server.signal(SIGTERM);
    EXPECT_EQ(server.wait(10s), 0) << server.log();
}

}  // namespace
}  // namespace jostle::test

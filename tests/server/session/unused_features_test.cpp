// SPDX-License-Identifier: MIT
//
// Rooms, players, attributes and messages cost a world nothing while they are not used: bytes of
// snapshots and time of ticks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "jostle/scenes/catalog.h"
#include "server/util/thread_cpu_time.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;

enum class Kind { plain, room };

std::shared_ptr<WorldHost> host(TestServer& server, const scenes::SceneDescription& scene,
                                Kind kind) {
    const bool is_room = kind == Kind::room;
    return *server.worlds.create("yard", scene, {},
                                 is_room ? std::optional(RoomProperties{}) : std::nullopt);
}

// The sizes of the messages that a client receives in each of `ticks` ticks.
std::vector<std::size_t> bytes_per_tick(Kind kind, const client::ClientOptions& options,
                                        int ticks) {
    TestServer server;
    const std::shared_ptr<WorldHost> world = host(server, test::small_scene(), kind);
    SessionHarness client(server, options);
    std::vector<std::size_t> bytes;
    std::size_t sum = 0;
    client.tamper = [&](const std::string& message) { sum += message.size(); };
    test::play(server, *world, {&client}, ticks,
               [&](int) { bytes.push_back(std::exchange(sum, 0)); });
    EXPECT_GT(client.conversation.stats().snapshots, 0u);
    return bytes;
}

TEST(UnusedFeatures, add_no_bytes_to_snapshots) {
    constexpr int ticks = 200, first = 30;  // the first snapshots carry complete lists
    const auto plain = bytes_per_tick(Kind::plain, {}, ticks);
    EXPECT_EQ(plain, bytes_per_tick(Kind::room, {}, ticks));
    const auto subscribed =
        bytes_per_tick(Kind::plain, {.attributes = true, .topics = {"*"}}, ticks);
    EXPECT_TRUE(std::equal(plain.begin() + first, plain.end(), subscribed.begin() + first));
}

// Without changes a frame shares the lists of the previous one.
TEST(UnusedFeatures, share_their_lists_between_frames) {
    TestServer server;
    const std::shared_ptr<WorldHost> world = host(server, test::small_scene(), Kind::room);
    SessionHarness client(server, {});
    test::play(server, *world, {&client}, 10);
    const FramePtr before = world->frame();
    test::play(server, *world, {&client}, 60);
    const FramePtr after = world->frame();
    EXPECT_EQ(after->players, before->players);
    EXPECT_EQ(after->attributes, before->attributes);
    EXPECT_EQ(after->messages, before->messages);
    EXPECT_EQ(after->room, before->room);
    EXPECT_FALSE(after->has_new_data);
    EXPECT_TRUE(after->restorable_ticks->empty());
}

// The least processor time of the ticks, us. The machine can only add to it.
class Ticks {
public:
    explicit Ticks(Kind kind)
        : world_(host(server_, *scenes::find_scene("pyramid"), kind)), client_(server_, {}) {
        cpu_.use_this_thread();
        test::play(server_, *world_, {&client_}, 30);
    }
    void measure() {
        constexpr int ticks = 15;
        const auto began = *cpu_.now();
        test::play(server_, *world_, {&client_}, ticks);
        const std::chrono::duration<double, std::micro> spent = *cpu_.now() - began;
        least_us_ = std::min(least_us_, spent.count() / ticks);
    }
    double least_us() const { return least_us_; }

private:
    TestServer server_;
    std::shared_ptr<WorldHost> world_;
    SessionHarness client_;
    ThreadCpuTime cpu_;
    double least_us_ = 1e9;
};

TEST(UnusedFeatures, add_no_time_to_ticks) {
    Ticks plain(Kind::plain), room(Kind::room);
    for (int round = 0; round < 12; round++) {
        plain.measure();
        room.measure();
    }
    std::printf("least time of a tick and its snapshot: %.1f us, in a room %.1f us\n",
                plain.least_us(), room.least_us());
    EXPECT_LT(room.least_us(), 1.1 * plain.least_us() + 2);
}

}  // namespace
}  // namespace jostle::server

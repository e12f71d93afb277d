// SPDX-License-Identifier: MIT
//
// A bit of what the server says is not what it was when it arrives. The client sees that what it
// decoded is not what the server has, counts it once, asks for a keyframe and is right again.
#include <gtest/gtest.h>

#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;

double furthest_off_mm(const client::WorldView& view, const Frame& frame) {
    double off = view.frame().entities.size() == frame.entities.size() ? 0 : 1e9;
    for (const EntityPose& truth : frame.entities) {
        const auto seen = view.pose_of(truth.id);
        if (!seen) return 1e9;
        const physics::Vec3 p{seen->position[0], seen->position[1], seen->position[2]};
        off = std::max(off, 1000 * length(p - truth.pose.position));
    }
    return off;
}

struct Flipped {
    std::uint64_t errors = 0;
    int keyframes = 0, flips = 0;
    double off_mm = 0;
};

// Flips one bit of the poses of one snapshot.
Flipped flip_a_bit(client::ClientOptions options, std::size_t bit) {
    TestServer server;
    const auto world = server.host(test::small_scene());
    SessionHarness player(server, std::move(options));
    Flipped seen;
    bool due = false;
    player.tamper = [&](std::string& bytes) {
        v1::ServerMessage message;
        if (!message.ParseFromString(bytes) || !message.has_snapshot()) return;
        v1::Snapshot& snapshot = *message.mutable_snapshot();
        const bool absolute = snapshot.cells_size() == 0 ? snapshot.baselines() == 0
                                                         : snapshot.cells(0).baselines() == 0;
        seen.keyframes += absolute ? 1 : 0;
        std::string& packed = snapshot.cells_size() == 0
                                  ? *snapshot.mutable_packed()
                                  : *snapshot.mutable_cells(0)->mutable_packed();
        if (!due || packed.empty()) return;
        due = false;
        seen.flips++;
        packed[bit / 8 % packed.size()] ^= static_cast<char>(1 << bit % 8);
        bytes = message.SerializeAsString();
    };
    test::play(server, *world, {&player}, 90, [&](int tick) { due = due || tick == 20; });
    seen.errors = player.conversation.stats().decode_errors;
    seen.off_mm = furthest_off_mm(player.conversation.view(), *world->frame());
    return seen;
}

// The last bits of the range coder's bytes say nothing: where such a bit is flipped, the frame is
// right all the same.
TEST(FlippedBit, is_counted_once_and_repaired_by_a_keyframe) {
    for (const std::uint32_t codec : {1u, 2u}) {
        std::uint64_t errors = 0;
        for (std::size_t bit = 0; bit < 24; bit++) {
            const Flipped seen = flip_a_bit({.codec = codec}, bit);
            EXPECT_EQ(seen.flips, 1);
            EXPECT_LE(seen.errors, 1u) << "codec " << codec << ", bit " << bit;
            EXPECT_EQ(seen.keyframes, 1 + static_cast<int>(seen.errors))
                << "the first snapshot, and the one it asked for";
            EXPECT_LT(seen.off_mm, 2);
            errors += seen.errors;
        }
        EXPECT_GE(errors, codec == 1 ? 24u : 8u);
    }
}

TEST(FlippedBit, is_repaired_with_area_of_interest) {
    const Flipped seen =
        flip_a_bit({.codec = 1, .interest = client::AreaOfInterest{.radius = 100}}, 3);
    EXPECT_EQ(seen.flips, 1);
    EXPECT_EQ(seen.errors, 1u);
    EXPECT_LT(seen.off_mm, 2);
}

TEST(FlippedBit, counts_nothing_without_corruption) {
    TestServer server;
    const auto world = server.host(test::small_scene());
    SessionHarness player(server, {.name = "player"});
    test::play(server, *world, {&player}, 90);
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
    EXPECT_LT(furthest_off_mm(player.conversation.view(), *world->frame()), 2);
}

}  // namespace
}  // namespace jostle::server

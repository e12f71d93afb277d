// SPDX-License-Identifier: MIT
#include "replication/snapshot_cache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <random>
#include <thread>

#include "replication/baseline_tracker.h"
#include "session/flow_control.h"

namespace jostle::server {
namespace {

// Forty bodies that move evenly, one of them asleep.
FramePtr frame_at(std::uint32_t tick) {
    auto frame = std::make_shared<Frame>();
    frame->tick = tick;
    for (EntityId id = 1; id <= 40; ++id) {
        EntityPose entity{.id = id, .pose = {}, .awake = id != 7};
        if (entity.awake) entity.pose.position = {0.01 * tick * id, 1.0 * id, -0.02 * tick};
        frame->entities.push_back(entity);
    }
    return frame;
}

// Our bytes for the test: four numbers, then the packed frame.
std::string serialize(const EncodedSnapshot& s) {
    const std::uint32_t head[] = {s.frame, s.bases.base, s.bases.base2, s.bases.base3, s.crc};
    std::string bytes(sizeof head + s.packed.size(), '\0');
    std::memcpy(bytes.data(), head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, s.packed.data(), s.packed.size());
    return bytes;
}

// A client that decodes what it is sent and keeps its last 32 frames.
struct Receiver {
    void take(const std::string& bytes) {
        std::uint32_t head[5];
        ASSERT_GE(bytes.size(), sizeof head);
        std::memcpy(head, bytes.data(), sizeof head);
        const auto base = [&](std::uint32_t number) -> const wire::QuantizedFrame* {
            for (const auto& frame : ring) {
                if (frame.frame == number) return &frame;
            }
            EXPECT_EQ(number, 0u) << "refers to a frame that was not sent";
            return nullptr;
        };
        bases = {head[1], head[2], head[3]};
        const auto packed = std::as_bytes(std::span(bytes)).subspan(sizeof head);
        auto frame =
            wire::decode_frame(head[0], packed, {base(head[1]), base(head[2]), base(head[3])}, {});
        ASSERT_TRUE(frame.ok()) << frame.error().message;
        EXPECT_EQ(wire::frame_crc(*frame), head[4]);
        ring.push_back(std::move(*frame));
        if (ring.size() > 32) ring.pop_front();
    }
    std::deque<wire::QuantizedFrame> ring;
    BaseNumbers bases;
};

TEST(SnapshotCache, clients_of_one_cadence_share_one_encoding) {
    SnapshotCache cache({}, serialize);
    BaselineTracker one, two;
    for (std::uint32_t tick = 1; tick <= 50; ++tick) {
        const FramePtr frame = frame_at(tick);
        const SharedBytes a = cache.encoding(frame, one.bases_for(tick));
        const SharedBytes b = cache.encoding(frame, two.bases_for(tick));
        EXPECT_EQ(a, b) << "the same bytes, not equal ones";
        one.on_sent(tick);
        two.on_sent(tick);
    }
    EXPECT_EQ(cache.encodings_made(), 50u);
}

TEST(SnapshotCache, every_cadence_decodes_to_the_servers_state) {
    SnapshotCache cache({}, serialize);
    BaselineTracker trackers[3];
    Receiver receivers[3];
    const std::uint32_t every[] = {1, 3, 7};
    for (std::uint32_t tick = 1; tick <= 200; ++tick) {
        const FramePtr frame = frame_at(tick);
        for (int c = 0; c < 3; ++c) {
            if (tick % every[c] != 0) continue;
            receivers[c].take(*cache.encoding(frame, trackers[c].bases_for(tick)));
            trackers[c].on_sent(tick);
        }
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(receivers[c].bases.base, receivers[c].ring.rbegin()[1].frame)
            << "the last one sent";
        EXPECT_NE(receivers[c].bases.base3, 0u);
    }
}

TEST(SnapshotCache, a_base_that_fell_off_the_ring_makes_it_absolute) {
    SnapshotCache cache({}, serialize);
    BaselineTracker slow;
    Receiver receiver;
    receiver.take(*cache.encoding(frame_at(1), slow.bases_for(1)));
    slow.on_sent(1);
    for (std::uint32_t tick = 2; tick < 2 + SnapshotCache::ring; ++tick)
        cache.encoding(frame_at(tick), {});
    EXPECT_FALSE(cache.holds(1));
    receiver.take(*cache.encoding(frame_at(60), slow.bases_for(60)));
    EXPECT_EQ(receiver.bases, BaseNumbers{});
}

TEST(SnapshotCache, a_tracker_that_forgot_asks_for_an_absolute_frame) {
    BaselineTracker baselines;
    EXPECT_EQ(baselines.bases_for(5), BaseNumbers{});
    baselines.on_sent(5);
    baselines.on_sent(6);
    baselines.on_sent(7);
    EXPECT_EQ(baselines.bases_for(8), (BaseNumbers{7, 6, 5}));
    EXPECT_EQ(baselines.bases_for(1000), BaseNumbers{}) << "too far apart to predict from";
    baselines.reset();
    EXPECT_EQ(baselines.bases_for(8), BaseNumbers{});
}

TEST(SnapshotCache, bodies_at_rest_are_silent) {
    std::size_t packed = 0;
    SnapshotCache cache({}, [&](const EncodedSnapshot& s) {
        packed = s.packed.size();
        return serialize(s);
    });
    BaselineTracker baselines;
    for (std::uint32_t tick = 1; tick <= 5; ++tick) {
        auto frame = std::make_shared<Frame>();
        frame->tick = tick;
        for (EntityId id = 1; id <= 1000; ++id)
            frame->entities.push_back({.id = id, .pose = {{1.0 * id, 0.5, 0}, {}}, .awake = false});
        cache.encoding(frame, baselines.bases_for(tick));
        baselines.on_sent(tick);
    }
    EXPECT_LE(packed, 8u) << "a thousand bodies that do not move";
}

// The chunks of the newest encoding: "tag=text", or "tag-" for one that ended.
struct ChunkTeller {
    std::vector<std::string> told;
    SnapshotCache cache{{}, [this](const EncodedSnapshot& s) {
                            told.clear();
                            for (const ModuleChunk& chunk : s.chunks) {
                                told.push_back(chunk.tag + (chunk.bytes ? "=" : "-"));
                                if (!chunk.bytes) continue;
                                for (const std::byte b : *chunk.bytes)
                                    told.back() += static_cast<char>(b);
                            }
                            return serialize(s);
                        }};

    static ModuleChunk chunk(const std::string& tag, std::string_view text) {
        std::vector<std::byte> bytes;
        for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
        return {tag, std::make_shared<const std::vector<std::byte>>(std::move(bytes))};
    }
    std::vector<std::string> encode(std::uint32_t tick, std::vector<ModuleChunk> chunks,
                                    BaseNumbers bases) {
        auto frame = std::make_shared<Frame>();
        frame->tick = tick;
        frame->chunks = std::move(chunks);
        cache.encoding(frame, bases);
        return told;
    }
};

TEST(SnapshotCache, an_absolute_snapshot_has_all_chunks_and_a_delta_those_that_changed) {
    using Told = std::vector<std::string>;
    ChunkTeller teller;
    const ModuleChunk still = ChunkTeller::chunk("still", "s");
    const auto chunk = ChunkTeller::chunk;
    EXPECT_EQ(teller.encode(1, {still, chunk("craft", "1")}, {}), (Told{"still=s", "craft=1"}));
    EXPECT_EQ(teller.encode(2, {still, chunk("craft", "2")}, {1, 0, 0}), Told{"craft=2"});
    EXPECT_EQ(teller.encode(3, {still, chunk("craft", "1")}, {2, 1, 0}), Told{"craft=1"});
    EXPECT_EQ(teller.encode(4, {still, chunk("craft", "1")}, {3, 2, 1}), Told{})
        << "other bytes of the same content";
    EXPECT_EQ(teller.encode(5, {still, chunk("craft", "1")}, {2, 1, 0}), Told{"craft=1"})
        << "against an older base";
    EXPECT_EQ(teller.encode(6, {still, chunk("craft", "1")}, {}), (Told{"still=s", "craft=1"}));
}

TEST(SnapshotCache, a_chunk_that_ended_is_told_once_and_may_begin_again) {
    using Told = std::vector<std::string>;
    ChunkTeller teller;
    const auto chunk = ChunkTeller::chunk;
    teller.encode(1, {chunk("craft", "1"), chunk("crane", "2")}, {});
    EXPECT_EQ(teller.encode(2, {chunk("crane", "3")}, {1, 0, 0}), (Told{"crane=3", "craft-"}));
    EXPECT_EQ(teller.encode(3, {chunk("crane", "3")}, {2, 1, 0}), Told{});
    EXPECT_EQ(teller.encode(4, {chunk("crane", "3")}, {1, 0, 0}), (Told{"crane=3", "craft-"}))
        << "to whom was not told yet";
    EXPECT_EQ(teller.encode(5, {chunk("craft", "1")}, {4, 0, 0}), (Told{"craft=1", "crane-"}));
}

TEST(SnapshotCache, chunks_against_a_base_that_fell_off_the_ring_are_all_there) {
    ChunkTeller teller;
    const ModuleChunk still = ChunkTeller::chunk("still", "s");
    teller.encode(1, {still}, {});
    for (std::uint32_t tick = 2; tick < 2 + SnapshotCache::ring; ++tick)
        teller.encode(tick, {still}, {});
    EXPECT_EQ(teller.encode(60, {still}, {1, 0, 0}), std::vector<std::string>{"still=s"});
}

TEST(SnapshotCache, windows_skips_and_lost_tracks_all_decode_to_the_servers_state) {
    using namespace std::chrono_literals;
    constexpr std::uint32_t clients = 12, ticks = 600;
    struct Client {
        BaselineTracker baselines;
        Receiver receiver;
        FlowControl flow{{}, 60, 1};
        std::deque<std::uint32_t> unacked;
        int received = 0;
    };
    SnapshotCache cache({}, serialize);
    std::vector<Client> all(clients);
    std::minstd_rand random(5);  // the same everywhere
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        const FramePtr frame = frame_at(tick);
        const Clock::time_point now{tick * 16667us};
        for (std::uint32_t c = 0; c < clients; ++c) {
            Client& client = all[c];
            // The higher its number, the more rarely a client finds time to acknowledge.
            if (random() % (c + 1) == 0) {
                for (const std::uint32_t acked : client.unacked) client.flow.on_ack(acked, now);
                client.unacked.clear();
            }
            if (random() % 400 == 0) client.baselines.reset();  // a CRC that did not match
            if (c > 5 && random() % 10 == 0) continue;          // a write is pending
            if (!client.flow.may_send(tick, now)) continue;
            client.receiver.take(*cache.encoding(frame, client.baselines.bases_for(tick)));
            client.baselines.on_sent(tick);
            client.flow.on_sent(tick, now);
            client.unacked.push_back(tick);
            client.received++;
        }
    }
    EXPECT_EQ(all[0].received, static_cast<int>(ticks)) << "one that keeps up misses nothing";
    EXPECT_GT(all[clients - 1].flow.skipped(), 0u) << "one that does not is spared";
    for (const Client& client : all) EXPECT_GT(client.received, 50);
}

TEST(SnapshotCache, network_threads_may_ask_at_once) {
    SnapshotCache cache({}, serialize);
    std::vector<FramePtr> frames;
    for (std::uint32_t tick = 1; tick <= 200; ++tick) frames.push_back(frame_at(tick));
    std::vector<std::thread> threads;
    for (std::uint32_t t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            BaselineTracker baselines;
            Receiver receiver;
            for (std::uint32_t tick = 1 + t; tick <= 200; tick += t + 1) {
                receiver.take(*cache.encoding(frames[tick - 1], baselines.bases_for(tick)));
                baselines.on_sent(tick);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GE(cache.encodings_made(), 200u);
}

}  // namespace
}  // namespace jostle::server

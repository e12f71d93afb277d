// SPDX-License-Identifier: MIT
#include "server/replication/snapshot_cache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <deque>
#include <map>
#include <random>
#include <thread>

#include "server/limits/flow_control.h"
#include "server/replication/baseline_tracker.h"

namespace jostle::server {
namespace {

// Forty bodies that move uniformly; one of them sleeps.
FramePtr frame_at(std::uint32_t tick) {
    auto frame = std::make_shared<Frame>();
    frame->tick = tick;
    std::vector<EntityPose> poses;
    for (EntityId id = 1; id <= 40; ++id) {
        EntityPose entity{.id = id, .awake = id != 7, .pose = {}};
        if (entity.awake) entity.pose.position = {0.01 * tick * id, 1.0 * id, -0.02 * tick};
        poses.push_back(entity);
    }
    frame->entities = PoseList(poses);
    return frame;
}

// Serialization for the test: four numbers, then the packed frame.
std::string serialize(const EncodedSnapshot& s) {
    const std::uint32_t head[] = {s.frame, s.baselines.baseline, s.baselines.baseline2,
                                  s.baselines.baseline3, s.crc};
    std::string bytes(sizeof head + s.packed.size(), '\0');
    std::memcpy(bytes.data(), head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, s.packed.data(), s.packed.size());
    return bytes;
}

// A client that decodes its snapshots and retains the last 32 frames.
struct Receiver {
    void take(const std::string& bytes) {
        std::uint32_t head[5];
        ASSERT_GE(bytes.size(), sizeof head);
        std::memcpy(head, bytes.data(), sizeof head);
        const auto baseline = [&](std::uint32_t number) -> const snapshot::QuantizedFrame* {
            for (const auto& frame : ring) {
                if (frame.frame == number) return &frame;
            }
            EXPECT_EQ(number, 0u) << "the snapshot refers to a frame that was not sent";
            return nullptr;
        };
        baselines = {head[1], head[2], head[3]};
        const auto packed = std::as_bytes(std::span(bytes)).subspan(sizeof head);
        auto frame = snapshot::decode_frame(
            head[0], packed, {baseline(head[1]), baseline(head[2]), baseline(head[3])}, {});
        ASSERT_TRUE(frame.ok()) << frame.error().message;
        EXPECT_EQ(snapshot::frame_crc(*frame), head[4]);
        ring.push_back(std::move(*frame));
        if (ring.size() > 32) ring.pop_front();
    }
    std::deque<snapshot::QuantizedFrame> ring;
    snapshot::BaselineFrames baselines;
};

TEST(SnapshotCache, clients_with_equal_rate_share_one_encoding) {
    SnapshotCache cache({}, serialize);
    BaselineTracker one, two;
    for (std::uint32_t tick = 1; tick <= 50; ++tick) {
        const FramePtr frame = frame_at(tick);
        const SharedBytes a = cache.encoding(frame, one.baselines_for(tick));
        const SharedBytes b = cache.encoding(frame, two.baselines_for(tick));
        EXPECT_EQ(a, b) << "clients with equal baselines must share the bytes";
        one.on_sent(tick);
        two.on_sent(tick);
    }
    EXPECT_EQ(cache.encodings_made(), 50u);
}

TEST(SnapshotCache, encodes_each_codec_once) {
    SnapshotCache cache({}, serialize);
    using snapshot::Codec;
    const SharedBytes bits = cache.encoding(frame_at(1), {}, 0, Codec::bits),
                      range = cache.encoding(frame_at(1), {}, 0, Codec::range);
    EXPECT_LT(range->size(), bits->size());
    EXPECT_EQ(cache.encoding(frame_at(1), {}, 0, Codec::bits), bits);
    EXPECT_EQ(cache.encoding(frame_at(1), {}, 0, Codec::range), range);
    EXPECT_EQ(cache.encodings_made(), 2u);
    const auto decoded = [](const SharedBytes& bytes, Codec codec) {
        return snapshot::decode_frame(1, std::as_bytes(std::span(*bytes)).subspan(20), {}, {},
                                      snapshot::default_entities_max, codec);
    };
    EXPECT_EQ(*decoded(bits, Codec::bits), *decoded(range, Codec::range));
}

TEST(SnapshotCache, every_rate_decodes_to_the_server_state) {
    SnapshotCache cache({}, serialize);
    BaselineTracker trackers[3];
    Receiver receivers[3];
    const std::uint32_t every[] = {1, 3, 7};
    for (std::uint32_t tick = 1; tick <= 200; ++tick) {
        const FramePtr frame = frame_at(tick);
        for (int c = 0; c < 3; ++c) {
            if (tick % every[c] != 0) continue;
            receivers[c].take(*cache.encoding(frame, trackers[c].baselines_for(tick)));
            trackers[c].on_sent(tick);
        }
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(receivers[c].baselines.baseline, receivers[c].ring.rbegin()[1].frame)
            << "the baseline must be the last sent frame";
        EXPECT_NE(receivers[c].baselines.baseline3, 0u);
    }
}

// Of 700 bodies a few move, wake and fall asleep, and frames share blocks of poses. Decoded frames
// match the poses at every snapshot rate, also beyond the end of the ring.
TEST(SnapshotCache, mostly_resting_world_decodes_exactly) {
    SnapshotCache cache({}, serialize);
    const auto list = std::make_shared<const EntityList>();
    std::vector<EntityPose> poses;
    for (EntityId id = 1; id <= 700; id++)
        poses.push_back({id, false, {.position = {2.0 * id, 0, 0}, .rotation = {}}});
    PoseEditor editor;
    editor.assign(poses);
    BaselineTracker trackers[2];
    Receiver receivers[2];
    std::mt19937 random(9);
    for (std::uint32_t tick = 1; tick <= 150; tick++) {
        for (unsigned k = 0; k < random() % 4; k++) {
            EntityPose& pose = poses[tick % 20 < 10 ? random() % 700 : 130 + random() % 5];
            pose.pose.position.y += random() % 2 == 0 ? 0.3 : 0;
            pose.awake = random() % 3 != 0;
            editor.set(pose.id - 1, pose.pose, pose.awake);
        }
        const auto frame = std::make_shared<Frame>();
        frame->tick = tick;
        frame->entity_list = list;
        bool changed = false;
        frame->entities = editor.take(changed);
        for (const std::uint32_t every : {1u, 4u}) {
            if (tick % every != 0) continue;
            const std::size_t c = every == 1 ? 0 : 1;
            receivers[c].take(*cache.encoding(frame, trackers[c].baselines_for(tick)));
            trackers[c].on_sent(tick);
            const snapshot::QuantizedFrame& has = receivers[c].ring.back();
            ASSERT_EQ(has, cache.quantized(frame));
            for (std::size_t k = 0; k < poses.size(); k++) {
                ASSERT_EQ(has.entities[k].at_rest, !poses[k].awake) << tick << ' ' << k;
                ASSERT_EQ(has.entities[k].position[1], std::lround(512 * poses[k].pose.position.y));
            }
        }
    }
}

TEST(SnapshotCache, evicted_baseline_forces_a_keyframe) {
    SnapshotCache cache({}, serialize);
    BaselineTracker slow;
    Receiver receiver;
    receiver.take(*cache.encoding(frame_at(1), slow.baselines_for(1)));
    slow.on_sent(1);
    for (std::uint32_t tick = 2; tick < 2 + SnapshotCache::ring; ++tick)
        cache.encoding(frame_at(tick), {});
    EXPECT_FALSE(cache.holds(1));
    receiver.take(*cache.encoding(frame_at(60), slow.baselines_for(60)));
    EXPECT_EQ(receiver.baselines, snapshot::BaselineFrames{});
}

TEST(SnapshotCache, reset_tracker_forces_a_keyframe) {
    BaselineTracker baselines;
    EXPECT_EQ(baselines.baselines_for(5), snapshot::BaselineFrames{});
    baselines.on_sent(5);
    baselines.on_sent(6);
    baselines.on_sent(7);
    EXPECT_EQ(baselines.baselines_for(8), (snapshot::BaselineFrames{7, 6, 5}));
    EXPECT_EQ(baselines.baselines_for(1000), snapshot::BaselineFrames{})
        << "the frames are too far apart for prediction";
    baselines.reset();
    EXPECT_EQ(baselines.baselines_for(8), snapshot::BaselineFrames{});
}

TEST(SnapshotCache, resting_bodies_add_no_bytes) {
    std::size_t packed = 0;
    SnapshotCache cache({}, [&](const EncodedSnapshot& s) {
        packed = s.packed.size();
        return serialize(s);
    });
    BaselineTracker baselines;
    for (std::uint32_t tick = 1; tick <= 5; ++tick) {
        auto frame = std::make_shared<Frame>();
        frame->tick = tick;
        std::vector<EntityPose> poses;
        for (EntityId id = 1; id <= 1000; ++id)
            poses.push_back({.id = id, .awake = false, .pose = {{1.0 * id, 0.5, 0}, {}}});
        frame->entities = PoseList(poses);
        cache.encoding(frame, baselines.baselines_for(tick));
        baselines.on_sent(tick);
    }
    EXPECT_LE(packed, 8u) << "1,000 bodies at rest must need at most 8 bytes";
}

// The channels that a client with subscriptions receives, frame by frame.
struct ChannelPublisher {
    snapshot::PackedChannels packed;
    SnapshotCache cache{{}, [this](const EncodedSnapshot& s) {
                            packed = s.channels;
                            return serialize(s);
                        }};
    std::map<std::uint32_t, FramePtr> frames;

    static Channel channel(std::uint32_t kind, std::int32_t value) {
        return {kind, 5, std::make_shared<const std::vector<std::int32_t>>(1, value)};
    }
    SharedBytes encode(std::uint32_t tick, snapshot::BaselineFrames baselines,
                       std::uint64_t kinds) {
        packed = {};
        return cache.encoding(frames.at(tick), baselines, kinds);
    }
    void frame(std::uint32_t tick, Channels channels) {
        auto frame = std::make_shared<Frame>();
        frame->tick = tick;
        frame->channels = std::make_shared<const Channels>(std::move(channels));
        frames[tick] = std::move(frame);
    }
    // The channels of a client after this snapshot; `baseline` are its previous channels.
    snapshot::Channels decoded(const snapshot::Channels& baseline) const {
        const auto channels = snapshot::decode_channels(packed.bytes, packed.crc, baseline);
        EXPECT_TRUE(channels.ok());
        return channels.ok() ? *channels : snapshot::Channels{};
    }
};

TEST(SnapshotCache, keyframe_has_all_channels_and_delta_only_changed_ones) {
    ChannelPublisher publisher;
    const auto channel = ChannelPublisher::channel;
    const Channel unchanged = channel(0, 7);
    publisher.frame(1, {unchanged, channel(1, 1)});
    publisher.frame(2, {unchanged, channel(1, 2)});
    publisher.frame(3, {unchanged, channel(1, 2)});
    publisher.frame(4, {channel(0, 7)});
    publisher.encode(1, {}, 3);
    const snapshot::Channels first = publisher.decoded({});
    ASSERT_EQ(first.size(), 2u);
    publisher.encode(2, {1, 0, 0}, 3);
    EXPECT_LE(publisher.packed.bytes.size(), 3u) << "expected one number of one channel";
    const snapshot::Channels second = publisher.decoded(first);
    EXPECT_EQ(*second[1].values, std::vector<std::int32_t>{2});
    publisher.encode(3, {2, 1, 0}, 3);
    EXPECT_TRUE(publisher.packed.bytes.empty())
        << "lists with equal content must not be sent again";
    publisher.encode(4, {2, 1, 0}, 3);
    EXPECT_EQ(publisher.decoded(second).size(), 1u) << "one channel has ended";
    publisher.encode(4, {}, 3);
    EXPECT_EQ(publisher.decoded({}).size(), 1u);
}

TEST(SnapshotCache, clients_with_equal_channel_kinds_share_bytes) {
    ChannelPublisher publisher;
    const auto channel = ChannelPublisher::channel;
    publisher.frame(1, {channel(0, 1), channel(1, 1)});
    publisher.frame(2, {channel(0, 1), channel(1, 2)});
    const SharedBytes both = publisher.encode(1, {}, 3), none = publisher.encode(1, {}, 0);
    EXPECT_NE(both, none);
    EXPECT_EQ(publisher.encode(1, {}, 3), both);
    const SharedBytes first_only = publisher.encode(2, {1, 0, 0}, 1);
    EXPECT_EQ(first_only, publisher.encode(2, {1, 0, 0}, 0))
        << "the subscribed channels did not change";
    EXPECT_NE(first_only, publisher.encode(2, {1, 0, 0}, 2));
    EXPECT_EQ(publisher.cache.encodings_made(), 2u) << "poses must be packed once for all clients";
}

TEST(SnapshotCache, evicted_baseline_sends_all_channels) {
    ChannelPublisher publisher;
    for (std::uint32_t tick = 1; tick < 2 + SnapshotCache::ring; ++tick) {
        publisher.frame(tick, {ChannelPublisher::channel(0, 7)});
        publisher.encode(tick, {}, 1);
    }
    publisher.frame(60, {ChannelPublisher::channel(0, 7)});
    publisher.encode(60, {1, 0, 0}, 1);
    EXPECT_EQ(publisher.decoded({}).size(), 1u);
}

TEST(SnapshotCache, skips_and_resets_decode_to_the_server_state) {
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
    std::minstd_rand random(5);  // deterministic
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        const FramePtr frame = frame_at(tick);
        const Clock::time_point now{tick * 16667us};
        for (std::uint32_t c = 0; c < clients; ++c) {
            Client& client = all[c];
            // The higher its number, the less often a client acknowledges.
            if (random() % (c + 1) == 0) {
                for (const std::uint32_t acked : client.unacked) client.flow.on_ack(acked, {}, now);
                client.unacked.clear();
            }
            if (random() % 400 == 0) client.baselines.reset();  // a CRC that did not match
            if (c > 5 && random() % 10 == 0) continue;          // a write is pending
            if (!client.flow.may_send(tick, now)) continue;
            client.receiver.take(*cache.encoding(frame, client.baselines.baselines_for(tick)));
            client.baselines.on_sent(tick);
            client.flow.on_sent(tick, now);
            client.unacked.push_back(tick);
            client.received++;
        }
    }
    EXPECT_EQ(all[0].received, static_cast<int>(ticks)) << "a fast client must receive every tick";
    EXPECT_GT(all[clients - 1].flow.skipped(), 0u)
        << "flow control must skip snapshots for a slow client";
    for (const Client& client : all) EXPECT_GT(client.received, 50);
}

// Two clients of a class; one of them missed a snapshot.
TEST(SnapshotCache, a_client_that_missed_a_frame_shares_the_encoding_of_its_class) {
    SnapshotCache cache({}, serialize);
    BaselineTracker regular, irregular;
    Receiver receiver;
    for (std::uint32_t tick = 2; tick <= 60; tick += 2) {
        const FramePtr frame = frame_at(tick);
        const SnapshotCache::Shared first = cache.shared_encoding(frame, regular);
        ASSERT_NE(first.bytes, nullptr);
        EXPECT_TRUE(first.fresh);
        regular.on_sent(tick);
        if (tick == 30) continue;
        const SnapshotCache::Shared second = cache.shared_encoding(frame, irregular);
        // It lacks one of the baselines of the class in three frames.
        const bool lacks_one = tick > 30 && tick <= 36;
        EXPECT_EQ(second.fresh, lacks_one) << tick;
        EXPECT_EQ(first.bytes != second.bytes, lacks_one) << tick;
        receiver.take(*second.bytes);
        irregular.on_sent(tick);
    }
    EXPECT_EQ(cache.encodings_made(), 33u);
}

// 200 clients at ten rates, each of which misses a tenth of its snapshots.
TEST(SnapshotCache, irregular_clients_share_encodings) {
    constexpr std::uint32_t ticks = 600;
    constexpr std::uint32_t steps[] = {1, 2, 3, 4, 5, 6, 10, 12, 15, 20};
    const auto encodings = [&](double missed, bool shares = true) {
        SnapshotCache cache({}, serialize);
        std::vector<BaselineTracker> clients(200);
        std::vector<Receiver> receivers(20);  // of the first clients
        std::minstd_rand random(3);
        for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
            const FramePtr frame = frame_at(tick);
            for (std::size_t c = 0; c < clients.size(); ++c) {
                if (tick % steps[c % 10] != 0 ||
                    static_cast<double>(random() % 1000) < 1000 * missed)
                    continue;
                const SharedBytes bytes =
                    shares ? cache.shared_encoding(frame, clients[c]).bytes
                           : cache.encoding(frame, clients[c].baselines_for(tick));
                if (!bytes) continue;  // no more encodings of this frame
                if (c < receivers.size()) receivers[c].take(*bytes);
                clients[c].on_sent(tick);
            }
        }
        return static_cast<double>(cache.encodings_made()) / ticks;
    };
    const double regular = encodings(0), irregular = encodings(0.1), own = encodings(0.1, false);
    RecordProperty("encodings_per_tick_regular", std::to_string(regular));
    RecordProperty("encodings_per_tick_irregular", std::to_string(irregular));
    RecordProperty("encodings_per_tick_own", std::to_string(own));
    EXPECT_LT(regular, 3);
    EXPECT_LT(irregular, 8);
    EXPECT_LT(irregular, 0.85 * own) << "with its own baselines for each client";
}

TEST(SnapshotCache, limits_the_encodings_of_a_frame) {
    SnapshotCache cache({}, serialize);
    for (std::uint32_t tick = 1; tick <= 30; ++tick) cache.encoding(frame_at(tick), {});
    // Each client has a single frame, and all of these differ.
    int served = 0;
    for (std::uint32_t only = 1; only <= 30; ++only) {
        BaselineTracker client;
        client.on_sent(only);
        served += cache.shared_encoding(frame_at(31), client).bytes ? 1 : 0;
    }
    EXPECT_EQ(served, SnapshotCache::encodings_per_frame_max);
    EXPECT_NE(cache.shared_encoding(frame_at(31), {}).bytes, nullptr) << "keyframes do not count";
}

TEST(SnapshotCache, supports_concurrent_requests) {
    SnapshotCache cache({}, serialize);
    std::vector<FramePtr> frames;
    for (std::uint32_t tick = 1; tick <= 200; ++tick) frames.push_back(frame_at(tick));
    std::vector<std::thread> threads;
    for (std::uint32_t t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            BaselineTracker baselines;
            Receiver receiver;
            for (std::uint32_t tick = 1 + t; tick <= 200; tick += t + 1) {
                receiver.take(*cache.encoding(frames[tick - 1], baselines.baselines_for(tick)));
                baselines.on_sent(tick);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GE(cache.encodings_made(), 200u);
}

}  // namespace
}  // namespace jostle::server

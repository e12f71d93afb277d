// SPDX-License-Identifier: MIT
//
// The client side of the play stream without a network: messages that it sends, their timing, and
// the handling of received messages.
#include "clients/cpp/core/src/play_protocol.h"
#include "jostle/snapshot/baseline_frames.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

using std::chrono::milliseconds;

struct Stream {
    PlayProtocol protocol{ClientOptions{.world = "yard", .name = "me"}};
    Clock::time_point now{std::chrono::seconds(1000)};

    void hear(const v1::ServerMessage& message) {
        protocol.receive(message.SerializeAsString(), now);
    }
    std::optional<v1::ClientMessage> next() {
        const auto bytes = protocol.take_message(now);
        if (!bytes) return std::nullopt;
        v1::ClientMessage message;
        EXPECT_TRUE(message.ParseFromString(*bytes));
        return message;
    }
    void welcome() {
        protocol.begin(now);
        EXPECT_EQ(next()->hello().world(), "yard");
        v1::ServerMessage message;
        message.mutable_welcome()->set_client_id(7);
        message.mutable_welcome()->mutable_quant()->set_units_per_meter(512);
        message.mutable_welcome()->mutable_quant()->set_rotation_component(511);
        hear(message);
        EXPECT_TRUE(next()->has_ping());
    }
    // A snapshot with one body at x m.
    v1::ServerMessage snapshot(std::uint32_t frame, double x,
                               const snapshot::QuantizedFrame* base) {
        quantized = {.frame = frame,
                     .entities = {snapshot::quantize(1, {{x, 0, 0}, {0, 0, 0, 1}}, false, {})}};
        const auto packed = snapshot::encode_frame(quantized, {base, nullptr, nullptr}, {});
        v1::ServerMessage message;
        v1::Snapshot& s = *message.mutable_snapshot();
        s.set_frame(frame);
        s.set_baselines(base ? snapshot::encode_baseline_frames(frame, {.baseline = base->frame})
                             : 0);
        s.set_packed(packed.data(), packed.size());
        s.set_crc(snapshot::frame_crc(quantized));
        return message;
    }
    snapshot::QuantizedFrame quantized;
};

}  // namespace

TEST(PlayProtocol, sends_only_hello_before_the_welcome) {
    Stream stream;
    stream.protocol.begin(stream.now);
    stream.protocol.send({});
    EXPECT_TRUE(stream.next()->has_hello());
    EXPECT_FALSE(stream.next());
}

TEST(PlayProtocol, numbers_inputs_from_one_and_sends_thirty_batches_per_second) {
    Stream stream;
    stream.welcome();
    for (std::uint32_t i = 1; i <= 40; i++) EXPECT_EQ(stream.protocol.send({}), i);
    const auto first = stream.next();
    EXPECT_EQ(first->input().first_sequence(), 1u);
    EXPECT_EQ(first->input().inputs_size(), 32);
    EXPECT_FALSE(stream.next());  // not within 1/30 s
    stream.now += milliseconds(34);
    const auto second = stream.next();
    EXPECT_EQ(second->input().first_sequence(), 33u);
    EXPECT_EQ(second->input().inputs_size(), 8);
}

TEST(PlayProtocol, rejects_inputs_beyond_the_queue_limit_and_keeps_accepted_ones) {
    Stream stream;
    stream.welcome();
    std::uint32_t last = 0;
    while (const std::uint32_t sequence = stream.protocol.send({})) last = sequence;
    EXPECT_EQ(last, 4096u);
    EXPECT_EQ(stream.next()->input().inputs_size(), 32);
    EXPECT_EQ(stream.protocol.send({}), 4097u);
}

TEST(PlayProtocol, limits_unread_results) {
    Stream stream;
    stream.welcome();
    for (std::uint32_t i = 1; i <= 5000; i++) {
        v1::ServerMessage message;
        v1::InputResult& result =
            *message.mutable_snapshot()->mutable_client_update()->add_results();
        result.set_sequence(i);
        result.set_code(v1::INPUT_CODE_APPLIED);
        stream.hear(message);
    }
    EXPECT_EQ(stream.protocol.stats().inputs_applied, 5000u);
    const auto results = stream.protocol.take_results();
    ASSERT_EQ(results.size(), 4096u);
    EXPECT_EQ(results.back().sequence(), 5000u);
    EXPECT_TRUE(stream.protocol.take_results().empty());
}

TEST(PlayProtocol, rejects_an_out_of_range_quantization) {
    Stream stream;
    stream.welcome();
    v1::ServerMessage welcome;
    welcome.mutable_welcome()->mutable_quant()->set_units_per_meter(0);
    welcome.mutable_welcome()->mutable_quant()->set_rotation_component(0xffffffff);
    stream.hear(welcome);
    stream.hear(stream.snapshot(10, 1, nullptr));
    EXPECT_EQ(stream.protocol.stats().decode_errors, 1u);
    EXPECT_NE(stream.protocol.stats().last_error.find("quantization"), std::string::npos);
    EXPECT_FALSE(stream.protocol.view().pose_of(1));
}

TEST(PlayProtocol, renumbers_unsent_inputs_after_a_reconnect) {
    Stream stream;
    stream.welcome();
    for (int i = 0; i < 40; i++) stream.protocol.send({});
    EXPECT_EQ(stream.next()->input().inputs_size(), 32);
    stream.protocol.ended(Error{ErrorCode::unavailable, "gone"});
    EXPECT_FALSE(stream.next());
    stream.now += milliseconds(500);
    stream.protocol.begin(stream.now);
    EXPECT_TRUE(stream.next()->has_hello());
    v1::ServerMessage welcome;
    welcome.mutable_welcome()->set_client_id(8);
    stream.hear(welcome);
    const auto batch = stream.next();
    EXPECT_EQ(batch->input().first_sequence(), 1u);
    EXPECT_EQ(batch->input().inputs_size(), 8);
    EXPECT_EQ(stream.protocol.send({}), 9u);
    EXPECT_EQ(stream.protocol.stats().stream_failures, 1u);
}

TEST(PlayProtocol, decodes_a_chain_of_snapshots_and_acknowledges_each_one) {
    Stream stream;
    stream.welcome();
    snapshot::QuantizedFrame base;
    for (std::uint32_t frame = 10; frame < 60; frame++) {
        stream.hear(stream.snapshot(frame, 0.1 * frame, frame == 10 ? nullptr : &base));
        base = stream.quantized;
        const auto ack = stream.next();
        ASSERT_TRUE(ack && ack->has_ack());
        EXPECT_EQ(ack->ack().frame(), frame);
        EXPECT_FALSE(ack->ack().need_keyframe());
    }
    EXPECT_EQ(stream.protocol.stats().snapshots, 50u);
    EXPECT_NEAR(stream.protocol.view().pose_of(1)->position[0], 5.9, 0.001);
    EXPECT_FALSE(stream.protocol.view().pose_of(2));
}

TEST(PlayProtocol, decodes_a_snapshot_with_an_extreme_time) {
    Stream stream;
    stream.welcome();
    v1::ServerMessage pong;
    pong.mutable_pong()->set_client_time_us(to_us(stream.now) - 10);
    pong.mutable_pong()->set_server_time_us(5'000'000);
    stream.hear(pong);
    v1::ServerMessage snapshot = stream.snapshot(1, 2, nullptr);
    snapshot.mutable_snapshot()->set_late_us(std::numeric_limits<std::int64_t>::min());
    stream.hear(snapshot);
    EXPECT_EQ(stream.protocol.stats().snapshots, 1u);
    const auto times = stream.protocol.view().times_of(snapshot.snapshot());
    EXPECT_GE(times.due_us, -static_cast<std::int64_t>(latest_time_us))
        << "lower bound of the due time";
}

TEST(PlayProtocol, requests_one_keyframe_after_a_crc_mismatch_or_unknown_baseline) {
    Stream stream;
    stream.welcome();
    stream.hear(stream.snapshot(10, 1, nullptr));
    stream.next();
    auto wrong = stream.snapshot(11, 2, nullptr);
    wrong.mutable_snapshot()->set_crc(wrong.snapshot().crc() ^ 1);
    stream.hear(wrong);
    const auto ack = stream.next();
    EXPECT_TRUE(ack->ack().need_keyframe());
    EXPECT_EQ(ack->ack().frame(), 10u);  // the last valid frame
    const snapshot::QuantizedFrame unknown{.frame = 9, .entities = {}};
    stream.hear(stream.snapshot(12, 3, &unknown));
    EXPECT_EQ(stream.protocol.stats().decode_errors, 1u);
    stream.hear(stream.snapshot(13, 4, nullptr));
    EXPECT_EQ(stream.protocol.view().frame().frame, 13u);
}

TEST(PlayProtocol, requests_a_keyframe_on_demand) {
    Stream stream;
    stream.welcome();
    stream.protocol.request_keyframe();
    stream.hear(stream.snapshot(10, 1, nullptr));
    EXPECT_TRUE(stream.next()->ack().need_keyframe())
        << "a snapshot sent before the request does not satisfy it";
    const snapshot::QuantizedFrame base = stream.quantized;
    stream.hear(stream.snapshot(11, 2, &base));
    EXPECT_FALSE(stream.next()->ack().need_keyframe()) << "once";
    stream.protocol.request_keyframe();
    EXPECT_TRUE(stream.next()->ack().need_keyframe()) << "also without received messages";
    EXPECT_FALSE(stream.next());
    EXPECT_EQ(stream.protocol.stats().decode_errors, 0u);
}

TEST(PlayProtocol, passes_each_message_to_on_message_unchanged) {
    std::vector<std::string> seen;
    PlayProtocol listener{ClientOptions{
        .on_message = [&](const std::string& bytes, Clock::time_point) { seen.push_back(bytes); }}};
    listener.begin({});
    listener.receive("\xff no message", {});
    listener.receive("", {});
    EXPECT_EQ(seen, (std::vector<std::string>{"\xff no message", ""}));
}

TEST(PlayProtocol, subscribes_to_events_and_returns_them_in_order) {
    Stream stream;
    stream.protocol.begin(stream.now);
    EXPECT_FALSE(stream.next()->hello().events()) << "only on request";
    PlayProtocol listener{ClientOptions{.events = true}};
    listener.begin(stream.now);
    v1::ClientMessage hello;
    ASSERT_TRUE(hello.ParseFromString(*listener.take_message(stream.now)));
    EXPECT_TRUE(hello.hello().events());
    for (std::uint32_t tick = 5; tick < 8; tick++) {
        v1::ServerMessage message;
        v1::Events& events = *message.mutable_snapshot()->add_events();
        events.set_tick(tick);
        events.add_woke(tick * 10);
        listener.receive(message.SerializeAsString(), stream.now);
    }
    const auto events = listener.take_events();
    ASSERT_EQ(events.size(), 3u);
    for (std::uint32_t i = 0; i < 3; i++) {
        EXPECT_EQ(events[i].tick(), 5 + i);
        EXPECT_EQ(events[i].woke(0), 50 + 10 * i);
    }
    EXPECT_TRUE(listener.take_events().empty());
}

TEST(PlayProtocol, limits_unread_events_and_counts_dropped_ones_as_missed) {
    Stream stream;
    stream.welcome();
    for (std::uint32_t tick = 1; tick <= 1030; tick++) {
        v1::ServerMessage message;
        v1::Events& told = *message.mutable_snapshot()->add_events();
        told.set_tick(tick);
        if (tick == 2) told.set_missed(7);  // by the server
        stream.hear(message);
    }
    const auto events = stream.protocol.take_events();
    ASSERT_EQ(events.size(), 1024u);
    EXPECT_EQ(events.front().tick(), 7u);
    EXPECT_EQ(events.front().missed(), 6u + 7u);
    EXPECT_EQ(events[1].missed(), 0u);
}

TEST(PlayProtocol, counts_malformed_messages_without_changing_state) {
    Stream stream;
    stream.welcome();
    stream.protocol.receive(std::string("\xff\xff\xff\xff", 4), stream.now);
    EXPECT_EQ(stream.protocol.stats().decode_errors, 1u);
    EXPECT_TRUE(stream.protocol.stats().connected);
}

TEST(PlayProtocol, sends_leave_after_the_last_input) {
    Stream stream;
    stream.welcome();
    stream.protocol.send({});
    stream.protocol.leave();
    EXPECT_TRUE(stream.next()->has_input());
    EXPECT_FALSE(stream.protocol.leave_sent());
    EXPECT_TRUE(stream.next()->has_leave());
    EXPECT_TRUE(stream.protocol.leave_sent());
    EXPECT_FALSE(stream.next());
}

}  // namespace jostle::client

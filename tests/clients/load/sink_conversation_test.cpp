// SPDX-License-Identifier: MIT
#include "load/sink_conversation.h"

#include <gtest/gtest.h>

#include <random>

#include "clients/load/framing_bytes.h"

namespace jostle::load {
namespace {

using namespace std::chrono_literals;

const Clock::time_point noon = Clock::time_point(1000s);

struct Talk {
    explicit Talk(SinkWishes wishes = {}) : sink(std::move(wishes), figures) {
        said();  // hello
    }
    // All that it has to say.
    std::vector<v1::ClientMessage> said(Clock::time_point now = noon) {
        std::vector<v1::ClientMessage> messages;
        while (const auto bytes = sink.take_message(now))
            EXPECT_TRUE(messages.emplace_back().ParseFromString(std::string(*bytes)));
        return messages;
    }
    void hear(const v1::ServerMessage& message, Clock::time_point now = noon) {
        sink.receive(as_bytes(message.SerializeAsString()), now);
    }
    void welcome(std::uint32_t window) {
        v1::ServerMessage message;
        message.mutable_welcome()->set_client_id(7);
        message.mutable_welcome()->set_ack_window(window);
        hear(message);
        said();  // a ping
    }
    // Due `age` ago.
    void snapshot(std::uint32_t frame, Clock::time_point now = noon, Clock::duration age = 0ms) {
        v1::ServerMessage message;
        message.mutable_snapshot()->set_frame(frame);
        message.mutable_snapshot()->set_server_time_us(client::to_us(now - age));
        hear(message, now);
    }

    Figures figures;
    SinkConversation sink;
};

int count_acks(const std::vector<v1::ClientMessage>& messages) {
    int acks = 0;
    for (const auto& message : messages) acks += message.has_ack() ? 1 : 0;
    return acks;
}

}  // namespace

TEST(SinkConversation, says_hello_first_and_waits_for_the_welcome) {
    Figures figures;
    SinkConversation sink({.world = "sandbox", .name = "load 1"}, figures);
    v1::ClientMessage hello;
    ASSERT_TRUE(hello.ParseFromString(std::string(sink.take_message(noon).value())));
    EXPECT_EQ(hello.hello().world(), "sandbox");
    EXPECT_TRUE(hello.hello().spectator());
    EXPECT_FALSE(sink.take_message(noon));
    EXPECT_FALSE(sink.joined());
}

TEST(SinkConversation, acknowledges_every_sixth_snapshot_when_the_window_has_room_for_it) {
    Talk talk;
    talk.welcome(30);
    int acks = 0;
    for (std::uint32_t frame = 1; frame <= 12; frame++) {
        talk.snapshot(frame);
        const auto said = talk.said();
        if (count_acks(said) > 0) {
            EXPECT_EQ(said[0].ack().frame(), frame);
        }
        acks += count_acks(said);
    }
    EXPECT_EQ(acks, 2);
}

TEST(SinkConversation, acknowledges_half_of_a_narrow_window_and_as_it_was_told) {
    Talk narrow;
    narrow.welcome(4);
    narrow.snapshot(1);
    EXPECT_EQ(count_acks(narrow.said()), 0);
    narrow.snapshot(2);
    EXPECT_EQ(count_acks(narrow.said()), 1);
    Talk told({.ack_every = 3});
    told.welcome(4);
    for (std::uint32_t frame = 1; frame <= 3; frame++) told.snapshot(frame);
    EXPECT_EQ(count_acks(told.said()), 1);
}

TEST(SinkConversation, a_snapshot_waits_150_ms_for_its_ack_at_most) {
    Talk talk;
    talk.welcome(30);
    talk.snapshot(1);
    EXPECT_EQ(count_acks(talk.said(noon + 149ms)), 0);
    EXPECT_EQ(count_acks(talk.said(noon + 150ms)), 1);
}

TEST(SinkConversation, age_and_gap_of_snapshots_that_come_every_20_ms_and_are_5_ms_old) {
    Talk talk;
    talk.welcome(30);
    v1::ServerMessage pong;
    pong.mutable_pong()->set_client_time_us(client::to_us(noon));
    pong.mutable_pong()->set_server_time_us(client::to_us(noon));
    talk.hear(pong, noon + 80ms);  // it waited: a clock of half a round trip would be 40 ms off
    for (int k = 0; k < 10; k++)
        talk.snapshot(static_cast<std::uint32_t>(k + 1), noon + 100ms + k * 20ms, 5ms);
    EXPECT_NEAR(percentiles_of(talk.figures.age).p50, 5, 0.15);
    EXPECT_NEAR(percentiles_of(talk.figures.gap).p50, 20, 0.6);
    EXPECT_EQ(talk.figures.gap.count(), 9u);
}

TEST(SinkConversation, an_input_of_tick_40_took_30_ms_to_its_snapshot_and_50_to_its_result) {
    Talk talk({.spectator = false});
    talk.welcome(30);
    v1::Input push;
    push.mutable_impulse()->set_entity(3);
    talk.sink.play({push});
    const auto said = talk.said();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].input().first_sequence(), 1u);
    talk.snapshot(39, noon + 20ms);
    talk.snapshot(40, noon + 30ms);
    v1::ServerMessage results;
    auto* const result = results.mutable_input_results()->add_results();
    result->set_sequence(1);
    result->set_code(v1::INPUT_CODE_APPLIED);
    result->set_tick(40);
    talk.hear(results, noon + 50ms);
    EXPECT_EQ(percentiles_of(talk.figures.effect_delay).max, 30);
    EXPECT_EQ(percentiles_of(talk.figures.result_delay).max, 50);
    EXPECT_EQ(talk.figures.inputs_applied, 1u);
}

TEST(SinkConversation, bytes_that_are_no_message_are_an_error_each_and_no_more) {
    Talk talk({.decodes = true});
    std::mt19937 random(3);
    for (int k = 0; k < 2000; k++) {
        std::string bytes(random() % 60, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random());
        if (!bytes.empty()) bytes[0] = static_cast<char>((1 + random() % 9) << 3 | 2);
        if (bytes.size() > 1) bytes[1] = static_cast<char>(bytes.size() - 2);
        talk.sink.receive(as_bytes(bytes), noon);
        talk.said(noon);
    }
    EXPECT_EQ(talk.figures.messages, 2000u);
    EXPECT_GT(talk.figures.errors, 100u);
}

}  // namespace jostle::load

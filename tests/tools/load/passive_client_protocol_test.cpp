// SPDX-License-Identifier: MIT
#include "tools/load/passive_client_protocol.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/tools/load/framing_bytes.h"
#include "tools/load/data_traffic.h"

namespace jostle::load {
namespace {

using namespace std::chrono_literals;

const Clock::time_point noon = Clock::time_point(1000s);

struct Talk {
    explicit Talk(PassiveClientOptions options = {}) : sink(std::move(options), metrics) {
        said();  // the Hello
    }
    // All due messages.
    std::vector<v1::ClientMessage> said(Clock::time_point now = noon) {
        std::vector<v1::ClientMessage> messages;
        while (const auto bytes = sink.take_message(now))
            EXPECT_TRUE(messages.emplace_back().ParseFromString(std::string(*bytes)));
        return messages;
    }
    void hear(const v1::ServerMessage& message, Clock::time_point now = noon) {
        sink.receive(as_bytes(message.SerializeAsString()), now);
    }
    // Tick 0 was due at noon; a tick is 10 ms.
    void welcome(std::uint32_t ack_interval_ms = 0) {
        v1::ServerMessage message;
        message.mutable_welcome()->set_client_id(7);
        message.mutable_welcome()->set_ack_interval_ms(ack_interval_ms);
        message.mutable_welcome()->set_tick_hz(100);
        message.mutable_welcome()->set_epoch_us(client::to_us(noon));
        hear(message);
        said();  // a ping
    }
    void snapshot(std::uint32_t frame, Clock::time_point now = noon, int late_us = 0) {
        v1::ServerMessage message;
        message.mutable_snapshot()->set_frame(frame);
        message.mutable_snapshot()->set_late_us(late_us);
        hear(message, now);
    }

    LoadMetrics metrics;
    PassiveClientProtocol sink;
};

int count_acks(const std::vector<v1::ClientMessage>& messages) {
    int acks = 0;
    for (const auto& message : messages) acks += message.has_ack() ? 1 : 0;
    return acks;
}

}  // namespace

TEST(PassiveClientProtocol, counts_user_messages_and_their_delay) {
    Talk talk({.receives_data = true});
    talk.welcome();
    DataTraffic traffic({.messages_per_second = 1, .attributes = 20}, 0);
    const std::vector<v1::Input> first = traffic.take(noon, 7);
    ASSERT_EQ(first.size(), 1u) << "all attributes at once";
    EXPECT_EQ(first[0].set_attributes().set().player(), 7u);
    EXPECT_EQ(first[0].set_attributes().set().attributes_size(), 20);
    EXPECT_TRUE(traffic.take(noon + 500ms, 7).empty());
    const std::vector<v1::Input> later = traffic.take(noon + 1s, 7);
    ASSERT_EQ(later.size(), 2u) << "a message and a changed attribute";
    v1::ServerMessage message;
    message.mutable_snapshot()->set_frame(100);
    message.mutable_snapshot()->set_messages_missed(3);
    v1::UserMessage& chat = *message.mutable_snapshot()->add_messages();
    chat.set_data(later[0].send_message().data());
    message.mutable_snapshot()->add_messages()->set_data("another sender");
    talk.hear(message, noon + 1s + 20ms);
    EXPECT_EQ(talk.metrics.user_messages, 2u);
    EXPECT_EQ(talk.metrics.messages_missed, 3u);
    const Percentiles delay = percentiles_of(talk.metrics.message_delay);
    EXPECT_EQ(delay.count, 1u);
    EXPECT_NEAR(delay.p50, 20, 1);
}

TEST(PassiveClientProtocol, sends_hello_first_and_waits_for_the_welcome) {
    LoadMetrics metrics;
    PassiveClientProtocol sink({.world = "sandbox", .name = "load 1"}, metrics);
    v1::ClientMessage hello;
    ASSERT_TRUE(hello.ParseFromString(std::string(sink.take_message(noon).value())));
    EXPECT_EQ(hello.hello().world(), "sandbox");
    EXPECT_TRUE(hello.hello().spectator());
    EXPECT_EQ(hello.hello().codec(), 2u) << "the codec of the clients of players";
    EXPECT_FALSE(sink.take_message(noon));
    EXPECT_FALSE(sink.joined());
}

TEST(PassiveClientProtocol, acknowledges_after_the_interval_requested_by_the_server) {
    Talk talk;
    talk.welcome(100);
    int acks = 0;
    for (int k = 0; k <= 60; k++) {  // a snapshot every 10 ms; acks at 0, 100, ..., 600 ms
        const auto now = noon + k * 10ms;
        talk.snapshot(static_cast<std::uint32_t>(k + 1), now);
        acks += count_acks(talk.said(now));
    }
    EXPECT_EQ(acks, 7);
    EXPECT_EQ(count_acks(talk.said(noon + 10s)), 0) << "no new snapshot";
}

TEST(PassiveClientProtocol, acknowledges_every_third_snapshot_when_configured) {
    Talk talk({.ack_every = 3});
    talk.welcome(1000);
    talk.snapshot(1);
    EXPECT_EQ(count_acks(talk.said()), 1) << "the first snapshot is acknowledged immediately";
    int acks = 0;
    for (std::uint32_t frame = 2; frame <= 13; frame++) {
        talk.snapshot(frame);
        const auto said = talk.said();
        if (count_acks(said) > 0) {
            EXPECT_EQ(said[0].ack().frame(), frame);
        }
        acks += count_acks(said);
    }
    EXPECT_EQ(acks, 4);
}

TEST(PassiveClientProtocol, acknowledges_after_150_ms_by_default) {
    Talk talk;
    talk.welcome();
    talk.snapshot(1);
    EXPECT_EQ(count_acks(talk.said(noon)), 1);
    talk.snapshot(2, noon + 10ms);
    EXPECT_EQ(count_acks(talk.said(noon + 149ms)), 0);
    EXPECT_EQ(count_acks(talk.said(noon + 150ms)), 1);
}

TEST(PassiveClientProtocol, measures_snapshot_age_and_gap) {
    Talk talk;
    talk.welcome();
    v1::ServerMessage pong;
    pong.mutable_pong()->set_client_time_us(client::to_us(noon));
    pong.mutable_pong()->set_server_time_us(client::to_us(noon));
    // it was delayed: half a round trip would give a clock error of 40 ms
    talk.hear(pong, noon + 80ms);
    for (int k = 5; k < 15; k++)  // due at 100 ms, 120 ms, ..., started 1 ms early
        talk.snapshot(static_cast<std::uint32_t>(2 * k), noon + k * 20ms + 4ms, -1000);
    EXPECT_NEAR(percentiles_of(talk.metrics.age).p50, 5, 0.15);
    EXPECT_NEAR(percentiles_of(talk.metrics.gap).p50, 20, 0.6);
    EXPECT_EQ(talk.metrics.gap.count(), 9u);
}

TEST(PassiveClientProtocol, measures_effect_delay_and_result_delay) {
    Talk talk({.spectator = false});
    talk.welcome();
    v1::Input push;
    push.mutable_impulse()->set_entity(3);
    talk.sink.play({push});
    const auto said = talk.said();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].input().first_sequence(), 1u);
    talk.snapshot(39, noon + 20ms);
    talk.snapshot(40, noon + 30ms);
    v1::ServerMessage results;
    results.mutable_snapshot()->set_frame(41);
    auto* const result = results.mutable_snapshot()->mutable_client_update()->add_results();
    result->set_sequence(1);
    result->set_code(v1::INPUT_CODE_APPLIED);
    result->set_tick(40);
    talk.hear(results, noon + 50ms);
    EXPECT_EQ(percentiles_of(talk.metrics.effect_delay).max, 30);
    EXPECT_EQ(percentiles_of(talk.metrics.result_delay).max, 50);
    EXPECT_EQ(talk.metrics.inputs_applied, 1u);
}

TEST(PassiveClientProtocol, counts_each_malformed_message_as_one_error) {
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
    EXPECT_EQ(talk.metrics.messages, 2000u);
    EXPECT_GT(talk.metrics.errors, 100u);
}

}  // namespace jostle::load

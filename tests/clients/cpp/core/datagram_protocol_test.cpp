// SPDX-License-Identifier: MIT
//
// The client side of a stream with datagrams, without a network: the choice of transport and the
// handling of late messages.
#include <gtest/gtest.h>

#include "clients/cpp/core/src/play_protocol.h"
#include "jostle/snapshot/baseline_frames.h"

namespace jostle::client {
namespace {

using namespace std::chrono_literals;

struct DatagramProtocolTest : testing::Test {
    void SetUp() override {
        protocol.begin(now);
        v1::ClientMessage hello;
        ASSERT_TRUE(hello.ParseFromString(*protocol.take_message(now)));
        EXPECT_TRUE(hello.hello().datagrams());
        v1::ServerMessage message;
        v1::Welcome& welcome = *message.mutable_welcome();
        welcome.mutable_quant()->set_units_per_meter(512);
        welcome.mutable_quant()->set_rotation_component(511);
        welcome.set_ack_interval_ms(100);
        welcome.mutable_datagrams()->set_port(7);
        protocol.receive(message.SerializeAsString(), now);
        ASSERT_TRUE(protocol.datagram_ticket());
        EXPECT_TRUE(by_stream()->has_ping());
    }

    // An empty world.
    static std::string snapshot(std::uint32_t frame, std::uint32_t received = 0) {
        const snapshot::QuantizedFrame state{.frame = frame, .entities = {}};
        const auto packed = snapshot::encode_frame(state, {}, {});
        v1::ServerMessage message;
        v1::Snapshot& s = *message.mutable_snapshot();
        s.set_frame(frame);
        s.set_packed(packed.data(), packed.size());
        s.set_crc(snapshot::frame_crc(state));
        s.mutable_client_update()->set_input_received(received);
        return message.SerializeAsString();
    }
    std::optional<v1::ClientMessage> parsed(const std::optional<std::string>& bytes) {
        if (!bytes) return std::nullopt;
        v1::ClientMessage message;
        EXPECT_TRUE(message.ParseFromString(*bytes));
        return message;
    }
    std::optional<v1::ClientMessage> by_stream() { return parsed(protocol.take_message(now)); }
    std::optional<v1::ClientMessage> by_datagram() { return parsed(protocol.take_datagram(now)); }

    Clock::time_point now{1000s};
    PlayProtocol protocol{ClientOptions{.datagrams = true}};
};

}  // namespace

TEST_F(DatagramProtocolTest, acknowledges_each_snapshot_immediately_together_with_earlier_ones) {
    protocol.set_datagrams(true, false);
    by_datagram();
    for (const std::uint32_t frame : {5u, 6u, 8u}) protocol.receive_datagram(snapshot(frame), now);
    const auto ack = by_datagram();
    ASSERT_TRUE(ack && ack->has_ack());
    EXPECT_EQ(ack->ack().frame(), 8u);
    EXPECT_EQ(ack->ack().ack_bits(), 0b110u) << "frames 6 and 5";
    EXPECT_FALSE(by_datagram()) << "once";
    EXPECT_EQ(protocol.stats().datagram_snapshots, 3u);
}

TEST_F(DatagramProtocolTest, skips_an_overtaken_snapshot_without_an_error) {
    protocol.receive_datagram(snapshot(8), now);
    protocol.receive(snapshot(7), now);
    protocol.receive_datagram(snapshot(8), now);
    EXPECT_EQ(protocol.view().frame().frame, 8u);
    EXPECT_EQ(protocol.stats().stale_snapshots, 2u);
    EXPECT_EQ(protocol.stats().decode_errors, 0u);
}

TEST_F(DatagramProtocolTest, resends_inputs_by_datagram_until_confirmed) {
    protocol.set_datagrams(true, false);
    protocol.send({});
    now += 40ms;
    EXPECT_FALSE(by_stream()) << "the datagram carries the input";
    EXPECT_EQ(by_datagram()->input().inputs_size(), 1);
    now += 40ms;
    EXPECT_EQ(by_datagram()->input().first_sequence(), 1u)
        << "sent again, because the datagram may be lost";
    protocol.receive_datagram(snapshot(5, 1), now);
    now += 40ms;
    EXPECT_TRUE(by_datagram()->has_ack()) << "an ack without inputs";
    EXPECT_EQ(protocol.stats().inputs_sent, 1u);
}

TEST_F(DatagramProtocolTest, sends_inputs_on_the_stream_after_one_second_without_confirmation) {
    protocol.set_datagrams(true, false);
    protocol.send({});
    now += 40ms;
    ASSERT_TRUE(by_datagram()->has_input());
    now += 1100ms;
    const auto said = by_stream();
    ASSERT_TRUE(said && said->has_input());
    EXPECT_EQ(said->input().first_sequence(), 1u);
}

// The server waits for the lost acks and has stopped sending.
TEST_F(DatagramProtocolTest, repeats_the_last_ack_on_the_stream_when_datagrams_fail) {
    protocol.set_datagrams(true, false);
    protocol.receive(snapshot(5), now);
    ASSERT_EQ(by_datagram()->ack().frame(), 5u);
    now += 500ms;
    protocol.set_datagrams(false, true);
    EXPECT_TRUE(by_stream()->has_ping());
    const auto ack = by_stream();
    ASSERT_TRUE(ack && ack->has_ack());
    EXPECT_EQ(ack->ack().frame(), 5u);
    EXPECT_NE(protocol.stats().last_error.find("no datagrams received"), std::string::npos);
}

TEST_F(DatagramProtocolTest, accepts_input_results_without_a_frame) {
    v1::ServerMessage message;
    v1::InputResult& result = *message.mutable_snapshot()->mutable_client_update()->add_results();
    result.set_sequence(1);
    result.set_code(v1::INPUT_CODE_APPLIED);
    protocol.receive(message.SerializeAsString(), now);
    EXPECT_EQ(protocol.take_results().size(), 1u);
    EXPECT_EQ(protocol.stats().decode_errors, 0u);
    EXPECT_EQ(protocol.stats().snapshots, 0u);
}

}  // namespace jostle::client

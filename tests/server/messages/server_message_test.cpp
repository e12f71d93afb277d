// SPDX-License-Identifier: MIT
#include "server/messages/server_message.h"

#include <gtest/gtest.h>

#include "jostle/v1/play.pb.h"

namespace jostle::server {
namespace {

v1::ServerMessage parse(const std::string& bytes) {
    v1::ServerMessage message;
    EXPECT_TRUE(message.ParseFromString(bytes));
    return message;
}

TEST(ServerMessage, snapshot_is_the_concatenation_of_its_pieces) {
    const EncodedSnapshot encoded{.frame = 300,
                                  .baselines = {299, 298, 297},
                                  .packed = {std::byte{1}, std::byte{0}, std::byte{255}},
                                  .crc = 0xdeadbeef,
                                  .late_us = -123456,
                                  .unchanged_ticks = 3};
    const std::string shared = encode_shared_snapshot(encoded);
    for (const ClientUpdate own :
         {ClientUpdate{}, ClientUpdate{0xffffffff, 0xffffffff, 0xffffffff, {}, -1'000'000'000}}) {
        const auto message = parse(encode_snapshot_header(own, "", shared.size()) + shared);
        ASSERT_TRUE(message.has_snapshot());
        const v1::Snapshot& snapshot = message.snapshot();
        EXPECT_EQ(snapshot.frame(), 300u);
        EXPECT_EQ(snapshot.baselines(), 1u)
            << "each baseline precedes the previous one by one frame";
        EXPECT_EQ(snapshot.packed(), std::string("\x01\x00\xff", 3));
        EXPECT_EQ(snapshot.crc(), 0xdeadbeef);
        EXPECT_EQ(snapshot.late_us(), -123456);
        EXPECT_EQ(snapshot.unchanged_ticks(), 3u);
        EXPECT_EQ(snapshot.client_update().input_sequence(), own.input_sequence);
        EXPECT_EQ(snapshot.client_update().echo_client_time_us(), own.echo_client_time_us);
        EXPECT_EQ(snapshot.client_update().snapshots_skipped(), own.snapshots_skipped);
        EXPECT_EQ(snapshot.client_update().input_margin_us(), own.input_margin_us);
    }
}

TEST(ServerMessage, minimal_snapshot_header_has_17_bytes) {
    const EncodedSnapshot encoded{.frame = 1'000'000,
                                  .baselines = {999'999, 999'998, 999'997},
                                  .packed = {},
                                  .crc = 0xdeadbeef};
    EncodedSnapshot with_body = encoded;
    with_body.packed.resize(1000, std::byte{7});
    const auto size = [](const EncodedSnapshot& snapshot) {
        const std::string shared = encode_shared_snapshot(snapshot);
        return encode_snapshot_header({}, "", shared.size()).size() + shared.size();
    };
    EXPECT_EQ(size(with_body) - 1000, 17u);
    EXPECT_EQ(size(encoded), 13u) << "an unchanged frame has no body";
}

TEST(ServerMessage, statistics_are_outside_the_shared_piece) {
    Frame frame;
    frame.tick = 77;
    const std::string shared = encode_shared_snapshot({.frame = 77});
    const auto message =
        parse(encode_snapshot_header({}, encode_stats_field(frame, 3), shared.size()) + shared);
    EXPECT_EQ(message.snapshot().stats().tick(), 77u);
    EXPECT_EQ(message.snapshot().stats().clients(), 3u);
    EXPECT_EQ(message.snapshot().frame(), 77u);
    EXPECT_FALSE(message.snapshot().has_client_update()) << "an empty update must be omitted";
}

TEST(ServerMessage, channel_delta_and_crc_are_in_the_shared_piece) {
    EncodedSnapshot encoded{.frame = 300};
    const std::string without = encode_shared_snapshot(encoded);
    encoded.channels = {.bytes = {std::byte{0}, std::byte{255}}, .crc = 0xdeadbeef};
    const std::string shared = encode_shared_snapshot(encoded);
    EXPECT_EQ(shared.substr(0, without.size()), without) << "all other fields must be unchanged";
    const auto message = parse(encode_snapshot_header({}, "", shared.size()) + shared);
    EXPECT_EQ(message.snapshot().channels(), std::string("\x00\xff", 2));
    EXPECT_EQ(message.snapshot().channels_crc(), 0xdeadbeef);
    EXPECT_EQ(channels_size(shared), shared.size() - without.size());
    EXPECT_EQ(channels_size(without), 0u);
}

TEST(ServerMessage, welcome_lists_channel_kinds) {
    const auto message = parse(encode_welcome(
        {.channels = {{"craft"}, {"fields.waves", physics::ChannelForm::seed, 60}}}));
    ASSERT_EQ(message.welcome().channels_size(), 2);
    EXPECT_EQ(message.welcome().channels(0).form(), v1::CHANNEL_FORM_PARAMS);
    EXPECT_EQ(message.welcome().channels(1).name(), "fields.waves");
    EXPECT_EQ(message.welcome().channels(1).form(), v1::CHANNEL_FORM_SEED);
    EXPECT_EQ(message.welcome().channels(1).divisor(), 60u);
}

TEST(ServerMessage, welcome_contains_step_parameters) {
    const auto message =
        parse(encode_welcome({.tick_hz = 50, .gravity = {0, -1.6, 0}, .substeps = 12}));
    EXPECT_EQ(message.welcome().tick_hz(), 50);
    EXPECT_EQ(message.welcome().gravity().y(), -1.6);
    EXPECT_EQ(message.welcome().substeps(), 12u);
}

TEST(ServerMessage, results_and_notices_preserve_code_and_text) {
    const InputResult refused{.sequence = 5,
                              .status = Error{ErrorCode::permission_denied, "not yours"},
                              .tick = 77,
                              .entity = 6};
    const auto message = parse(encode_snapshot_header({.results = std::span(&refused, 1)}, "", 0));
    const v1::InputResult& result = message.snapshot().client_update().results(0);
    EXPECT_EQ(result.sequence(), 5u);
    EXPECT_EQ(result.code(), v1::INPUT_CODE_NOT_ALLOWED);
    EXPECT_EQ(result.tick(), 77u);
    EXPECT_EQ(result.entity(), 6u);
    EXPECT_EQ(result.message(), "not yours");
    const auto notice = parse(encode_notice(NoticeKind::world_closed, "bye"));
    EXPECT_EQ(notice.notice().code(), v1::NOTICE_CODE_WORLD_CLOSED);
    EXPECT_EQ(notice.notice().message(), "bye");
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "tools/load/http2_framing.h"

#include <gtest/gtest.h>

#include "tests/tools/load/framing_bytes.h"

namespace jostle::load::http2_test {
namespace {

// Frame types of RFC 9113, section 6.
enum Type : unsigned {
    data = 0,
    headers = 1,
    reset = 3,
    settings = 4,
    ping = 6,
    goaway = 7,
    update = 8
};
constexpr unsigned none = 0, ack = 1, end_headers = 4, end_stream_and_headers = 5, padded = 8;

std::string frame(unsigned type, unsigned flags, unsigned stream, const std::string& payload) {
    return big_endian(payload.size(), 3) + big_endian(type, 1) + big_endian(flags, 1) +
           big_endian(stream, 4) + payload;
}

std::string message(const std::string& text) {
    return std::string(1, '\0') + big_endian(text.size(), 4) + text;
}

Http2Framing make(std::uint32_t window = Http2Request::window_max) {
    return Http2Framing({.authority = "localhost:1", .token = {}, .window = window});
}

std::string why_not(const std::string& bytes) {
    Http2Framing framing = make();
    MessageList list;
    const Status status = framing.take(as_bytes(bytes), list);
    return status.ok() ? "" : status.error().message;
}

}  // namespace

TEST(Http2Framing, starts_a_call_with_the_preface_settings_and_one_header_block) {
    Http2Framing framing({.authority = "localhost:50051", .token = "abc"});
    const std::string& out = framing.outgoing();
    EXPECT_TRUE(out.starts_with("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"));
    // ":path", a literal whose name has index 4 of the static table (RFC 7541, section 6.2.2).
    EXPECT_NE(out.find("\x04\x1b/jostle.v1.PlayService/Play"), std::string::npos);
    EXPECT_NE(out.find("\x01\x0flocalhost:50051"), std::string::npos);
    // "authorization" has index 23: 15, which fills the prefix, plus 8.
    EXPECT_NE(out.find("\x0f\x08\x0a"
                       "Bearer abc"),
              std::string::npos);
}

TEST(Http2Framing, reassembles_messages_split_at_any_byte) {
    const std::string two = message("first") + message("");
    const std::string bytes =
        frame(settings, none, 0, "") + frame(headers, end_headers, 1, "\x88") +
        frame(data, none, 1, two) + frame(data, none, 1, message("cut in three").substr(0, 3)) +
        frame(data, none, 1, message("cut in three").substr(3, 6)) +
        frame(data, padded, 1, "\x02" + message("cut in three").substr(9) + "xx");
    for (std::size_t place = 0; place <= bytes.size(); place++)
        ASSERT_EQ(take_cut_at(place, bytes, [] { return make(); }),
                  (std::vector<std::string>{"first", "", "cut in three"}))
            << "cut at " << place;
}

TEST(Http2Framing, acknowledges_pings_and_settings) {
    Http2Framing framing = make();
    framing.outgoing().clear();
    MessageList list;
    ASSERT_TRUE(framing.take(as_bytes(frame(ping, none, 0, "12345678")), list));
    EXPECT_EQ(framing.outgoing(), frame(ping, ack, 0, "12345678"));
    framing.outgoing().clear();
    ASSERT_TRUE(framing.take(as_bytes(frame(ping, ack, 0, "12345678")), list));
    EXPECT_EQ(framing.outgoing(), "");
    ASSERT_TRUE(framing.take(as_bytes(frame(settings, none, 0, "")), list));
    EXPECT_EQ(framing.outgoing(), frame(settings, ack, 0, ""));
}

TEST(Http2Framing, replenishes_the_window_at_half_and_rejects_an_overrun) {
    Http2Framing framing = make(Http2Request::default_window);
    framing.outgoing().clear();
    MessageList list;
    const std::string one = frame(data, none, 1, message(std::string(10'000, 'x')));
    for (int k = 0; k < 3; k++) {
        ASSERT_TRUE(framing.take(as_bytes(one), list));
        framing.consume(10'000);
        EXPECT_EQ(framing.outgoing(), "") << k;
    }
    ASSERT_TRUE(framing.take(as_bytes(one), list));
    framing.consume(10'000);
    EXPECT_EQ(framing.outgoing(), frame(update, none, 0, big_endian(40'020, 4)) +
                                      frame(update, none, 1, big_endian(40'020, 4)));
    // From here on the client reads nothing: six more messages fit.
    for (int k = 0; k < 6; k++) ASSERT_TRUE(framing.take(as_bytes(one), list)) << k;
    EXPECT_FALSE(framing.take(as_bytes(one), list));
}

TEST(Http2Framing, receives_a_message_larger_than_the_window) {
    Http2Framing framing = make(Http2Request::default_window);
    MessageList list;
    const std::string large = message(std::string(200'000, 'x'));
    for (std::size_t at = 0; at < large.size(); at += 16'000)
        ASSERT_TRUE(framing.take(as_bytes(frame(data, none, 1, large.substr(at, 16'000))), list));
    ASSERT_EQ(list.texts.size(), 1u);
    EXPECT_EQ(list.texts[0].size(), 200'000u);
}

TEST(Http2Framing, queues_data_until_the_server_window_opens) {
    Http2Framing framing = make();
    MessageList list;
    // A stream window of 8 bytes: a message of 3 bytes has 8 with its header.
    ASSERT_TRUE(framing.take(
        as_bytes(frame(settings, none, 0, big_endian(4, 2) + big_endian(8, 4))), list));
    framing.outgoing().clear();
    framing.send("abc");
    framing.send("def");
    EXPECT_EQ(framing.outgoing(), frame(data, none, 1, message("abc")));
    framing.outgoing().clear();
    ASSERT_TRUE(framing.take(as_bytes(frame(update, none, 1, big_endian(8, 4))), list));
    EXPECT_EQ(framing.outgoing(), frame(data, none, 1, message("def")));
}

TEST(Http2Framing, reports_why_a_stream_ended) {
    EXPECT_EQ(why_not(frame(headers, end_stream_and_headers, 1, "\x88")),
              "the server ended the stream");
    EXPECT_EQ(why_not(frame(reset, none, 1, big_endian(8, 4))),
              "the server reset the stream, code 8");
    EXPECT_EQ(
        why_not(frame(goaway, none, 0, big_endian(1, 4) + big_endian(11, 4) + "too_many_pings")),
        "the server sent GOAWAY, code 11");
}

TEST(Http2Framing, rejects_hostile_bytes) {
    EXPECT_NE(why_not(std::string(64, '\xff')), "");
    EXPECT_NE(why_not(frame(data, none, 1, std::string(1, '\1') + big_endian(0, 4))), "");
    EXPECT_NE(why_not(frame(data, none, 1, std::string(1, '\0') + big_endian(0x7fff'ffff, 4))), "");
    EXPECT_NE(why_not(frame(data, padded, 1, "\x09short")), "");
    EXPECT_NE(why_not(frame(data, none, 3, "of no stream")), "");
    EXPECT_NE(why_not(frame(update, none, 1, big_endian(0, 4))), "");
    EXPECT_NE(why_not(frame(settings, none, 0, "12345")), "");
    const std::string good = frame(settings, none, 0, "") + frame(headers, end_headers, 1, "\x88") +
                             frame(data, none, 1, message("first") + message("second"));
    EXPECT_GT(count_refused_of_spoilt(good, [] { return make(); }), 300);
}

}  // namespace jostle::load::http2_test

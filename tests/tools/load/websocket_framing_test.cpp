// SPDX-License-Identifier: MIT
#include "tools/load/websocket_framing.h"

#include <gtest/gtest.h>

#include "tests/tools/load/framing_bytes.h"

namespace jostle::load::websocket_test {
namespace {

// Opcodes of RFC 6455, section 5.2.
enum Opcode : unsigned { go_on = 0, text = 1, binary = 2, close = 8, ping = 9, pong = 10 };
constexpr unsigned final_bit = 0x80, masked_bit = 0x80;

const std::string answer =
    "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: upgrade\r\n"
    "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n";

std::string frame(unsigned first, const std::string& payload) {
    std::string head = big_endian(first, 1);
    if (payload.size() < 126)
        head += big_endian(payload.size(), 1);
    else
        head += big_endian(126, 1) + big_endian(payload.size(), 2);
    return head + payload;
}

WebSocketFraming make() {
    return WebSocketFraming("localhost:8080");
}

std::string why_not(const std::string& bytes) {
    WebSocketFraming framing = make();
    MessageList list;
    const Status status = framing.take(as_bytes(bytes), list);
    return status.ok() ? "" : status.error().message;
}

}  // namespace

TEST(WebSocketFraming, reassembles_messages_split_at_any_byte) {
    const std::string bytes = answer + frame(final_bit | binary, "first") + frame(binary, "in ") +
                              frame(final_bit | ping, "there?") + frame(go_on, "three ") +
                              frame(final_bit | go_on, "frames") +
                              frame(final_bit | binary, std::string(300, 'x'));
    for (std::size_t place = 0; place <= bytes.size(); place++)
        ASSERT_EQ(take_cut_at(place, bytes, make),
                  (std::vector<std::string>{"first", "in three frames", std::string(300, 'x')}))
            << "cut at " << place;
}

TEST(WebSocketFraming, sends_messages_queued_before_the_handshake_after_it) {
    WebSocketFraming framing = make();
    EXPECT_TRUE(framing.outgoing().starts_with("GET /play HTTP/1.1\r\nHost: localhost:8080\r\n"));
    framing.outgoing().clear();
    framing.send("hello");
    EXPECT_EQ(framing.outgoing(), "");
    MessageList list;
    ASSERT_TRUE(framing.take(as_bytes(answer), list));
    const std::string key(4, '\0');
    EXPECT_EQ(framing.outgoing(),
              big_endian(final_bit | binary, 1) + big_endian(masked_bit | 5, 1) + key + "hello");
    framing.outgoing().clear();
    framing.send(std::string(200, 'y'));
    EXPECT_EQ(framing.outgoing(), big_endian(final_bit | binary, 1) +
                                      big_endian(masked_bit | 126, 1) + big_endian(200, 2) + key +
                                      std::string(200, 'y'));
}

TEST(WebSocketFraming, reports_the_reason_of_a_close_frame) {
    EXPECT_EQ(why_not(answer + frame(final_bit | close, big_endian(1008, 2) + "no ticket")),
              "the server closed the WebSocket, code 1008: no ticket");
    EXPECT_EQ(why_not("HTTP/1.1 429 Too Many Requests\r\n\r\n"),
              "the server rejected the WebSocket: HTTP/1.1 429 Too Many Requests");
}

TEST(WebSocketFraming, rejects_hostile_bytes) {
    EXPECT_NE(why_not(std::string(20'000, 'x')), "");
    EXPECT_NE(why_not("HTTP/1.1 101 Switching Protocols\r\n\r\n"), "");
    EXPECT_NE(why_not(answer + frame(final_bit | text, "words")), "");
    EXPECT_NE(why_not(answer + frame(final_bit | go_on, "of nothing")), "");
    EXPECT_NE(why_not(answer + frame(0xf0 | binary, "reserved bits")), "");
    EXPECT_NE(why_not(answer + big_endian(final_bit | binary, 1) + big_endian(masked_bit | 1, 1)),
              "");
    EXPECT_NE(why_not(answer + big_endian(final_bit | binary, 1) + big_endian(127, 1) +
                      big_endian(~std::uint64_t{0}, 8)),
              "");
    EXPECT_GT(count_refused_of_spoilt(
                  answer + frame(final_bit | binary, "first") + frame(binary, "second"), make),
              100);
}

}  // namespace jostle::load::websocket_test

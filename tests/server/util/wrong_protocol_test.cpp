// SPDX-License-Identifier: MIT
#include "server/util/wrong_protocol.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace jostle::server {
namespace {

FirstBytes protocol_of(std::string_view text) {
    return server::protocol_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(WrongProtocol, recognizes_protocols_by_their_first_bytes) {
    EXPECT_EQ(protocol_of("\x16\x03\x01"), FirstBytes::tls);
    EXPECT_EQ(protocol_of("\x16"), FirstBytes::tls);
    EXPECT_EQ(protocol_of("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"), FirstBytes::http2);
    EXPECT_EQ(protocol_of("GET / HTTP/1.1"), FirstBytes::http1);
    EXPECT_EQ(protocol_of("PUT"), FirstBytes::http1);
    for (const char* text : {"", " GET", "get /", "\x80\x2e", "SSH-2.0-a", "\xff\xff"})
        EXPECT_EQ(protocol_of(text), FirstBytes::unknown) << text;
}

TEST(WrongProtocol, replies_with_an_alert_or_a_response) {
    EXPECT_EQ(wrong_protocol_reply(FirstBytes::tls, "hint"),
              std::string("\x15\x03\x01\0\x02\x02\x28", 7));
    EXPECT_EQ(wrong_protocol_reply(FirstBytes::http1, "hint"),
              "HTTP/1.1 400 Bad Request\r\nContent-Type: text/plain; charset=utf-8\r\n"
              "Content-Length: 5\r\nConnection: close\r\n\r\nhint\n");
    EXPECT_EQ(wrong_protocol_reply(FirstBytes::http2, "hint"),
              wrong_protocol_reply(FirstBytes::http1, "hint"))
        << "gRPC clients report the status";
    EXPECT_EQ(wrong_protocol_reply(FirstBytes::unknown, "hint"), "");
}

}  // namespace
}  // namespace jostle::server

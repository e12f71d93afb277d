// SPDX-License-Identifier: MIT
#include "server/grpc_web/grpc_web_framing.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using enum GrpcWebForm;

std::string bytes(const char* text, std::size_t size) {
    return {text, size};
}

TEST(GrpcWebFraming, recognizes_content_types) {
    EXPECT_EQ(grpc_web_form("application/grpc-web"), binary);
    EXPECT_EQ(grpc_web_form("application/grpc-web+proto"), binary);
    EXPECT_EQ(grpc_web_form("application/grpc-web-text;charset=utf-8"), text);
    EXPECT_EQ(grpc_web_form("application/grpc-web-text+proto"), text);
    for (const char* other : {"", "application/grpc", "application/grpc-web+json", "text/plain"})
        EXPECT_FALSE(grpc_web_form(other)) << other;
}

TEST(GrpcWebFraming, reads_one_message) {
    EXPECT_EQ(*read_grpc_web_request(bytes("\0\0\0\0\0", 5), binary), "");
    EXPECT_EQ(*read_grpc_web_request(bytes("\0\0\0\0\3abc", 8), binary), "abc");
    EXPECT_EQ(*read_grpc_web_request("AAAAAANhYmM=", text), "abc");
    // Two encoded pieces: the header and one byte, then two.
    EXPECT_EQ(*read_grpc_web_request("AAAAAANhYmM=", text),
              *read_grpc_web_request("AAAAAAM=YWJj", text));
}

TEST(GrpcWebFraming, rejects_bodies_that_are_not_one_message) {
    const auto fault = [](const std::string& body, GrpcWebForm form = binary) {
        const auto read = read_grpc_web_request(body, form);
        return read.ok() ? "" : read.error().message;
    };
    EXPECT_EQ(fault(""), "the body has 0 bytes; a message has a header of 5");
    EXPECT_NE(fault(bytes("\1\0\0\0\0", 5)).find("compressed"), std::string::npos);
    EXPECT_NE(fault(bytes("\x80\0\0\0\0", 5)).find("0x80"), std::string::npos);
    EXPECT_NE(fault(bytes("\0\0\0\0\4abc", 8)).find("4 bytes, and 3 follow"), std::string::npos);
    EXPECT_NE(fault(bytes("\0\0\0\0\1ab", 7)).find("1 bytes, and 2 follow"), std::string::npos);
    EXPECT_NE(fault(bytes("\0\xff\xff\xff\xff", 5)).find("4294967295"), std::string::npos);
    EXPECT_EQ(fault("AAAA*", text), "the body is not base64");
    EXPECT_EQ(fault("A===", text), "the body is not base64");
}

TEST(GrpcWebFraming, writes_the_message_and_the_trailers) {
    EXPECT_EQ(write_grpc_web_response("abc", 0, "", "", binary),
              bytes("\0\0\0\0\3abc\x80\0\0\0\x10grpc-status: 0\r\n", 8 + 5 + 16));
    EXPECT_EQ(write_grpc_web_response(std::nullopt, 5, "100 %\nno", "\1\2", binary).substr(5),
              "grpc-status: 5\r\ngrpc-message: 100 %25%0Ano\r\n"
              "grpc-status-details-bin: AQI=\r\n");
    EXPECT_EQ(write_grpc_web_response("", 0, "", "", text), "AAAAAACAAAAAEGdycGMtc3RhdHVzOiAwDQo=");
}

TEST(GrpcWebFraming, reads_timeouts) {
    EXPECT_EQ(parse_grpc_timeout("5S"), 5s);
    EXPECT_EQ(parse_grpc_timeout("100m"), 100ms);
    EXPECT_EQ(parse_grpc_timeout("0n"), 0ns);
    EXPECT_EQ(parse_grpc_timeout("2M"), 2min);
    EXPECT_EQ(parse_grpc_timeout("99999999H"), std::chrono::hours(365 * 24)) << "at most a year";
    for (const char* wrong : {"", "S", "5", "5s", "-1S", "1.5S", "123456789S", "5 S"})
        EXPECT_FALSE(parse_grpc_timeout(wrong)) << wrong;
}

}  // namespace
}  // namespace jostle::server

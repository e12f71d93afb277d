// SPDX-License-Identifier: MIT
#include "server/forwarding/proxy_protocol.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "server/util/address.h"

namespace jostle::server {
namespace {

const std::string signature("\r\n\r\n\0\r\nQUIT\n", 12);

std::string header(unsigned command, unsigned family, const std::string& rest) {
    std::string bytes = signature;
    for (const unsigned byte : {command, family, static_cast<unsigned>(rest.size() >> 8),
                                static_cast<unsigned>(rest.size() & 0xff)})
        bytes += static_cast<char>(byte);
    return bytes + rest;
}

// 203.0.113.9:4711 to 192.0.2.1:443.
const std::string ipv4("\xcb\0\x71\x09\xc0\0\x02\x01\x12\x67\x01\xbb", 12);
// [2001:db8::7]:4711 to [2001:db8::1]:443.
const std::string ipv6(
    "\x20\x01\x0d\xb8\0\0\0\0\0\0\0\0\0\0\0\x07"
    "\x20\x01\x0d\xb8\0\0\0\0\0\0\0\0\0\0\0\x01\x12\x67\x01\xbb",
    36);

// Reads in pieces of at most `piece` bytes. Returns the error, or the client, or "none".
std::string read(std::string_view bytes, std::size_t piece) {
    ProxyHeaderReader reader;
    while (reader.wanted() > 0) {
        const std::size_t size = std::min({piece, reader.wanted(), bytes.size()});
        if (size == 0) return "incomplete";
        const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
        if (const Status s = reader.take({data, size}); !s.ok()) return s.error().message;
        bytes.remove_prefix(size);
    }
    EXPECT_EQ(bytes, "GET") << "bytes behind the header are left";
    const auto client = reader.client();
    return client ? peer_name(*client) : "none";
}

TEST(ProxyProtocol, reads_the_client_and_no_byte_behind_the_header) {
    for (const std::size_t piece : {1u, 7u, 4096u}) {
        EXPECT_EQ(read(header(0x21, 0x11, ipv4) + "GET", piece), "203.0.113.9:4711");
        EXPECT_EQ(read(header(0x21, 0x21, ipv6) + "GET", piece), "[2001:db8::7]:4711");
        // With extensions: NOOP of 3 bytes, and 4000 bytes that are skipped.
        EXPECT_EQ(read(header(0x21, 0x11, ipv4 + std::string("\x04\0\0", 3)) + "GET", piece),
                  "203.0.113.9:4711");
        EXPECT_EQ(read(header(0x21, 0x21, ipv6 + std::string(4000, 'x')) + "GET", piece),
                  "[2001:db8::7]:4711");
    }
}

TEST(ProxyProtocol, connections_of_the_proxy_itself_name_no_client) {
    EXPECT_EQ(read(header(0x20, 0x00, "") + "GET", 5), "none") << "a health check";
    EXPECT_EQ(read(header(0x20, 0x11, ipv4) + "GET", 5), "none");
    EXPECT_EQ(read(header(0x21, 0x00, "") + "GET", 5), "none") << "unspecified family";
    EXPECT_EQ(read(header(0x21, 0x12, ipv4) + "GET", 5), "none") << "UDP";
    EXPECT_EQ(read(header(0x21, 0x31, std::string(216, 'x')) + "GET", 50), "none") << "Unix socket";
}

TEST(ProxyProtocol, rejects_other_bytes_at_the_first_wrong_one) {
    EXPECT_NE(read("PROXY TCP4 203.0.113.9 192.0.2.1 4711 443\r\n", 1).find("version 1"),
              std::string::npos);
    EXPECT_NE(read("\x16\x03\x01", 1).find("not PROXY protocol version 2"), std::string::npos);
    EXPECT_NE(read(signature.substr(0, 11) + "x", 1).find("not PROXY"), std::string::npos);
    EXPECT_EQ(read(signature, 1), "incomplete");
    EXPECT_NE(read(header(0x11, 0x11, ipv4), 99).find("0x11"), std::string::npos) << "version 1";
    EXPECT_NE(read(header(0x22, 0x11, ipv4), 99).find("0x22"), std::string::npos) << "command 2";
    EXPECT_NE(read(header(0x21, 0x11, ipv4.substr(1)), 99).find("11 bytes"), std::string::npos);
    EXPECT_NE(read(header(0x21, 0x21, ipv4), 99).find("at least 36"), std::string::npos);
    EXPECT_NE(read(header(0x21, 0x11, ipv4 + std::string(4085, 'x')), 9999).find("4097 bytes"),
              std::string::npos);
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "jostle/datagram/packet.h"

#include <gtest/gtest.h>

#include <utility>

namespace jostle::datagram {
namespace {

Credentials credentials(std::uint8_t fill = 7) {
    Credentials made{.id = 0x0123456789abcdef};
    made.key.fill(fill);
    return made;
}

struct PacketTest : testing::Test {
    std::unique_ptr<PacketCipher> server = *PacketCipher::make(credentials(), Side::server);
    std::unique_ptr<PacketCipher> client = *PacketCipher::make(credentials(), Side::client);
};

std::string to_hex(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes) {
        char pair[3];
        std::snprintf(pair, sizeof pair, "%02x", static_cast<unsigned char>(byte));
        text += pair;
    }
    return text;
}

}  // namespace

TEST_F(PacketTest, decrypts_each_packet_once) {
    const std::string packet = client->close("push 3 N s");
    EXPECT_EQ(packet.size(), 10 + header_bytes + tag_bytes);
    EXPECT_EQ(session_id_of(packet), credentials().id);
    EXPECT_EQ(packet.find("push"), std::string::npos);
    const auto opened = server->open(packet);
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->content, "push 3 N s");
    EXPECT_TRUE(opened->newest);
    EXPECT_FALSE(server->open(packet)) << "the same packet again";
    EXPECT_FALSE(client->open(client->close("hello"))) << "directions have keys of their own";
}

TEST_F(PacketTest, reordered_packet_is_valid_but_not_newest) {
    const std::string first = client->close("a"), second = client->close("b");
    EXPECT_TRUE(server->open(second)->newest);
    const auto late = server->open(first);
    ASSERT_TRUE(late);
    EXPECT_EQ(late->content, "a");
    EXPECT_FALSE(late->newest);
}

TEST_F(PacketTest, rejects_any_flipped_bit_without_side_effects) {
    const std::string packet = client->close("thirty-two bytes of what matters");
    for (std::size_t bit = 0; bit < 8 * packet.size(); bit++) {
        std::string changed = packet;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        ASSERT_FALSE(server->open(changed)) << "bit " << bit;
    }
    EXPECT_TRUE(server->open(packet)) << "forgeries with high numbers moved no window";
}

TEST_F(PacketTest, rejects_wrong_sizes_and_keys) {
    const std::string packet = client->close("");
    EXPECT_EQ(packet.size(), header_bytes + tag_bytes);
    EXPECT_FALSE(server->open(packet.substr(1)));
    EXPECT_FALSE(server->open(packet + "x"));
    EXPECT_FALSE(server->open(""));
    EXPECT_FALSE(server->open(std::string(packet_bytes_max + 1, 'x')));
    EXPECT_TRUE(server->open(packet));
    EXPECT_FALSE((*PacketCipher::make(credentials(8), Side::server))->open(client->close("a")));
    EXPECT_EQ(client->close(std::string(content_bytes_max, 'x')).size(), packet_bytes_max);
    EXPECT_EQ(client->close(std::string(content_bytes_max + 1, 'x')), "");
}

// Of proto/WIRE.md, "Datagrams", so that others can compare; made by another program of the same
// algorithms (Python's cryptography).
TEST_F(PacketTest, first_client_packet_matches_the_documented_bytes) {
    EXPECT_EQ(to_hex(client->close(std::string("\x03\x01\x02\x03\x04\x05\x06\x07\x08", 9))),
              "efcdab896745230100000000000000003406d9d81d6b6f91716119244c13b6d2"
              "59023ccd4b664837c8");
}

}  // namespace jostle::datagram

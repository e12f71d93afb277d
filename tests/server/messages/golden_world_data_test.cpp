// SPDX-License-Identifier: MIT
//
// proto/golden/world_data.jdat: the server writes these bytes, and the C++ client reads them.
#include "tests/server/messages/golden_world_data.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "jostle/client/world_data.h"

namespace jostle::server {
namespace {

TEST(GoldenWorldData, server_writes_the_golden_bytes) {
    std::ifstream in(std::string(GOLDEN_FOLDER) + "/world_data.jdat", std::ios::binary);
    const std::string golden{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(golden_world_data(), golden)
        << "only if the protocol changes: golden_world_data proto/golden/world_data.jdat";
}

TEST(GoldenWorldData, client_knows_what_wire_md_says) {
    using client::AttributeTarget;
    client::WorldData data;
    std::vector<v1::UserMessage> messages;
    std::uint32_t missed = 0;
    for (const std::string& bytes : golden_snapshots()) {
        v1::Snapshot snapshot;
        ASSERT_TRUE(snapshot.ParseFromString(bytes));
        data.apply(snapshot);
        messages.insert(messages.end(), snapshot.messages().begin(), snapshot.messages().end());
        missed += snapshot.messages_missed();
    }
    ASSERT_EQ(data.players().size(), 2u);
    EXPECT_EQ(data.players().at(3).name(), "Zo\xc3\xab");
    EXPECT_EQ(data.players().at(3).ping_ms(), 26u);
    EXPECT_EQ(data.players().at(4).name(), "rob");
    EXPECT_EQ(data.players().at(4).role(), v1::PLAYER_ROLE_OWNER);
    EXPECT_EQ(data.players().at(4).color(), 0xff8000u);
    EXPECT_EQ(data.attribute(AttributeTarget::world(), "gravity")->vector().y(), -9.81);
    EXPECT_TRUE(data.attribute(AttributeTarget::world(), "round")->read_only());
    EXPECT_EQ(data.attribute(AttributeTarget::player(3), "ready"), nullptr);
    EXPECT_EQ(data.attribute(AttributeTarget::player(3), "secret")->text(), "open");
    EXPECT_EQ(data.attributes().size(), 2u) << "nothing of player 4 and entity 7 is left";
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].data(), "hi");
    EXPECT_EQ(messages[1].number(), 3u);
    EXPECT_TRUE(messages[1].direct());
    EXPECT_EQ(messages[1].data(), std::string("\x00\xff", 2));
    EXPECT_EQ(missed, 2u);
}

}  // namespace
}  // namespace jostle::server

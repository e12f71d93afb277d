// SPDX-License-Identifier: MIT
//
// The golden conversation (proto/WIRE.md): a real server's messages from Welcome to the twentieth
// snapshot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "jostle/client/world_view.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {
namespace {

std::string read(const std::string& name) {
    std::ifstream in(std::string(GOLDEN_FOLDER) + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The messages to the client, in order.
std::vector<v1::ServerMessage> messages() {
    const std::string bytes = read("conversation.jcnv");
    std::size_t at = 4;
    const auto next = [&] {
        std::uint32_t value = 0;
        EXPECT_LE(at + 4, bytes.size());
        std::memcpy(&value, bytes.data() + at, 4);
        at += 4;
        return value;
    };
    EXPECT_TRUE(bytes.starts_with("JCNV"));
    EXPECT_EQ(next(), 1u) << "version";
    std::vector<v1::ServerMessage> found;
    for (std::uint32_t left = next(); left > 0 && at < bytes.size(); left--) {
        const std::uint32_t direction = next();
        next();  // time
        const std::uint32_t size = next();
        if (direction == 1) {
            EXPECT_TRUE(found.emplace_back().ParseFromString(bytes.substr(at, size)));
        }
        at += size;
    }
    EXPECT_EQ(at, bytes.size());
    return found;
}

TEST(GoldenConversation, leads_to_the_states_entities_and_results_of_conversation_json) {
    const auto expected = nlohmann::json::parse(read("conversation.json"));
    WorldView view;
    auto snapshots = nlohmann::json::array(), results = nlohmann::json::array();
    for (const v1::ServerMessage& message : messages()) {
        if (message.has_welcome()) view.begin(message.welcome());
        if (message.has_entity_update()) {
            ASSERT_TRUE(view.apply(message.entity_update()).ok());
        }
        if (!message.has_snapshot()) continue;
        const Status applied = view.apply(message.snapshot());
        ASSERT_TRUE(applied.ok()) << message.snapshot().frame() << applied.error().message;
        auto entities = nlohmann::json::array();
        for (const snapshot::EntityState& e : view.frame().entities)
            entities.push_back({e.id, e.position[0], e.position[1], e.position[2], e.largest,
                                e.rotation[0], e.rotation[1], e.rotation[2], e.at_rest ? 1 : 0});
        snapshots.push_back({{"frame", view.frame().frame}, {"entities", entities}});
        for (const v1::InputResult& r : message.snapshot().client_update().results())
            results.push_back({r.sequence(), v1::InputCode_Name(r.code()), r.tick(), r.entity()});
    }
    ASSERT_EQ(snapshots.size(), expected.at("snapshots").size());
    for (std::size_t k = 0; k < snapshots.size(); k++) {
        EXPECT_EQ(snapshots[k]["frame"], expected["snapshots"][k]["frame"]);
        EXPECT_EQ(snapshots[k]["entities"], expected["snapshots"][k]["entities"]) << k;
    }
    std::sort(results.begin(), results.end());  // by sequence
    EXPECT_EQ(results, expected.at("results"));
    auto known = nlohmann::json::array();
    for (const auto& [id, entity] : view.entities()) known.push_back(id);
    EXPECT_EQ(known, expected.at("known_entities"));
}

}  // namespace
}  // namespace jostle::client

// SPDX-License-Identifier: MIT
#include "server/world/player_reports.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "server/world/world_directory.h"

namespace jostle::server {
namespace {

// A world whose ticks run when the test calls them.
class PlayerReportsTest : public testing::Test {
protected:
    PlayerReportsTest() : worlds({.own_ticks = false}, 4) {
        host = *worlds.create("yard", *scenes::find_scene("stack"));
        for (const auto& [client, name] : {std::pair(1u, "ada"), std::pair(2u, "bob")})
            EXPECT_TRUE(host->mailbox().push(
                {.client = client, .action = JoinCommand{.name = name}, .reply = {}}));
        tick();
    }
    void tick() {
        due += std::chrono::milliseconds(17);
        host->tick(due);
    }
    void send(ClientId from, const std::string& topic, const std::string& data,
              bool to_server = true) {
        ASSERT_TRUE(host->mailbox().push(
            {.client = from,
             .sequence = ++sequence,
             .action = SendMessageCommand{.topic = topic, .data = data, .to_server = to_server},
             .reply = {}}));
        tick();
    }
    std::vector<PlayerReport> reports() const { return host->reports()->list(); }

    WorldDirectory worlds;
    std::shared_ptr<WorldHost> host;
    Clock::time_point due = Clock::now();
    std::uint32_t sequence = 0;
};

TEST_F(PlayerReportsTest, lists_what_the_viewer_sends) {
    send(1, "report", R"({"client":2,"name":"Robert","reason":"Insults","messages":["a","b"]})");
    const std::uint32_t tick_of_report = host->frame()->tick;
    ASSERT_EQ(reports().size(), 1u);
    const PlayerReport report = reports()[0];
    EXPECT_EQ(report.number, 1u);
    EXPECT_EQ(report.tick, tick_of_report);
    EXPECT_EQ(report.from, 1u);
    EXPECT_EQ(report.from_name, "ada");
    EXPECT_EQ(report.client, 2u);
    EXPECT_EQ(report.name, "bob") << "the name in the list of players";
    EXPECT_EQ(report.reason, "Insults");
    EXPECT_EQ(report.messages, (std::vector<std::string>{"a", "b"}));
    send(1, "report", R"({"client":9,"name":"gone","reason":"Spam"})");
    EXPECT_EQ(reports()[1].name, "gone") << "of a client that left";
}

TEST_F(PlayerReportsTest, ignores_other_messages) {
    send(1, "chat", R"({"client":2,"reason":"Spam"})");
    send(1, "report", R"({"client":2,"reason":"Spam"})", false);  // to the players
    tick();
    EXPECT_TRUE(reports().empty());
}

TEST_F(PlayerReportsTest, one_client_removes_only_its_own_reports) {
    send(2, "report", R"({"client":1,"reason":"first"})");
    for (int k = 0; k < 30; k++) send(1, "report", "again " + std::to_string(k));
    const std::vector<PlayerReport> all = reports();
    ASSERT_EQ(all.size(), 1 + PlayerReports::reports_per_client_max);
    EXPECT_EQ(all.front().reason, "first");
    EXPECT_EQ(all.back().reason, "again 29");
    EXPECT_EQ(all.back().number, 31u);
}

TEST_F(PlayerReportsTest, stay_when_the_world_is_reset) {
    send(1, "report", R"({"client":2,"reason":"Spam"})");
    host = *worlds.reset(host);
    EXPECT_EQ(reports().size(), 1u);
    tick();
    send(1, "report", R"({"client":2,"reason":"Again"})");
    ASSERT_EQ(reports().size(), 2u);
    EXPECT_EQ(reports()[1].number, 2u);
}

TEST(ParseReport, takes_any_data) {
    EXPECT_EQ(parse_report("he swears\n").reason, "he swears\\n");
    EXPECT_EQ(parse_report("\xff").reason, "\\xff");
    EXPECT_EQ(parse_report(R"({"client":-1,"reason":"x"})").client, 0u);
    EXPECT_EQ(parse_report(R"({"client":4294967296,"reason":"x"})").client, 0u);
    EXPECT_EQ(parse_report(R"({"client":7})").reason, R"({"client":7})") << "no reason";
    EXPECT_EQ(parse_report("").reason, "");
    std::string many = R"({"reason":")" + std::string(5000, 'r') + R"(","messages":[1)";
    for (int k = 0; k < 50; k++) many += ",\"" + std::string(1000, 'm') + "\"";
    const PlayerReport report = parse_report(many + "]}");
    EXPECT_EQ(report.reason.size(), PlayerReports::reason_bytes_max);
    ASSERT_EQ(report.messages.size(), PlayerReports::messages_max);
    EXPECT_EQ(report.messages[0].size(), PlayerReports::message_bytes_max);
}

}  // namespace
}  // namespace jostle::server

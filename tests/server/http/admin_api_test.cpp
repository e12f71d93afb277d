// SPDX-License-Identifier: MIT
#include "server/http/admin_api.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "jostle/scenes/catalog.h"
#include "server/http/http_error.h"
#include "tests/server/server_parts.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

class AdminApiTest : public testing::Test, protected ServerParts {
protected:
    AdminApiTest() : ServerParts(10, 2) {}
    void SetUp() override { ASSERT_TRUE(worlds.create("yard", *scenes::find_scene("stack")).ok()); }
    HttpResponse call(const std::string& method, const std::string& body, Role role = Role::admin) {
        HttpRequest request;
        request.method = "POST";
        request.body = body;
        request.address = "192.0.2.7";
        return api.call(request, method, {.subject = "op", .role = role, .anonymous = false});
    }
    static nlohmann::json json(const HttpResponse& response) {
        return nlohmann::json::parse(response.body);
    }

    AdminControl control{context};
    AdminApi api{*authorizer, admin_methods(control, worlds)};
};

TEST_F(AdminApiTest, returns_the_status_of_the_server_with_zeros) {
    const HttpResponse response = call("GetServerStatus", "{}");
    ASSERT_EQ(response.status, 200) << response.body;
    EXPECT_EQ(json(response).at("worlds").at(0).at("name"), "yard");
    EXPECT_EQ(json(response).at("worlds").at(0).at("clients"), 0);
    EXPECT_FALSE(json(response).at("version").get<std::string>().empty());
}

TEST_F(AdminApiTest, pauses_a_world) {
    EXPECT_EQ(call("SetPaused", R"({"world": "yard", "paused": true})").status, 200);
    EXPECT_TRUE(worlds.find("yard")->lifecycle().paused());
    EXPECT_EQ(call("SetPaused", R"({"world": "pit", "paused": true})").status, 404);
    EXPECT_EQ(call("SetPaused", R"({"wurld": "yard"})").status, 400);
}

// The monitor page shows them.
TEST_F(AdminApiTest, lists_the_reports_of_players) {
    const auto world = worlds.find("yard");
    ASSERT_TRUE(world->mailbox().push(
        {.client = 7, .action = JoinCommand{.name = "ada"}, .reply = nullptr}));
    ASSERT_TRUE(world->mailbox().push(
        {.client = 7,
         .sequence = 1,
         .action = SendMessageCommand{.topic = "report",
                                      .data = R"({"client": 9, "name": "bob", "reason": "Spam"})",
                                      .to_server = true},
         .reply = nullptr}));
    ASSERT_TRUE(test::wait_until([&] { return !world->reports()->list().empty(); }));
    for (const char* method : {"GetServerStatus", "ListReports"}) {
        const HttpResponse response = call(method, "{}");
        ASSERT_EQ(response.status, 200) << response.body;
        const nlohmann::json reports = json(response).at("reports");
        ASSERT_EQ(reports.size(), 1u) << method;
        EXPECT_EQ(reports[0].at("worldName"), "yard");
        EXPECT_EQ(reports[0].at("fromName"), "ada");
        EXPECT_EQ(reports[0].at("client"), 9);
        EXPECT_EQ(reports[0].at("name"), "bob");
        EXPECT_EQ(reports[0].at("reason"), "Spam");
        EXPECT_TRUE(reports[0].at("messages").empty());
    }
    EXPECT_EQ(call("ListReports", R"({"world": "pit"})").status, 404);
    EXPECT_EQ(call("ListReports", "{}", Role::director).status, 403);
}

TEST_F(AdminApiTest, requires_the_role_admin_and_limits_the_methods) {
    EXPECT_EQ(call("GetServerStatus", "{}", Role::director).status, 403);
    EXPECT_EQ(call("SetPaused", R"({"world": "yard"})", Role::director).status, 403);
    EXPECT_EQ(call("Backup", "{}").status, 404) << "over gRPC only";
    EXPECT_EQ(call("Fly", "{}").status, 404);
    EXPECT_EQ(call("Kick", std::string(5000, ' ') + "{}").status, 400);
}

}  // namespace
}  // namespace jostle::server

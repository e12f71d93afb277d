// SPDX-License-Identifier: MIT
#include "gateway/http_routes.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "jostle/scenes/catalog.h"

namespace jostle::server {
namespace {

class HttpRoutesTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(worlds.create("", *scenes::find_scene("stack")).ok()); }

    HttpResponse ask(const std::string& method, const std::string& target,
                     const std::string& body = {}, const std::string& origin = {}) const {
        HttpRequest request;
        request.method = method;
        request.target = target;
        request.host = "localhost:8080";
        request.origin = origin;
        request.content_type = "application/json";
        request.body = body;
        return routes.answer(request);
    }
    static std::string code_of(const HttpResponse& response) {
        return nlohmann::json::parse(response.body).at("code");
    }

    Config config = [] {
        Config c;
        c.world.worlds_max = 2;
        return c;
    }();
    SessionDirectory sessions{10};
    WorldDirectory worlds{{}, 2};
    PlayContext context{.config = config, .worlds = worlds, .sessions = sessions};
    WorldControl control{context};
    QueryControl queries{context};
    HttpRoutes routes{control,
                      queries,
                      {.web_root = "/nonexistent",
                       .allowed_origins = {"https://play.example.org"},
                       .is_ready = [this] { return !context.draining.load(); }}};
};

TEST_F(HttpRoutesTest, lists_worlds_and_scenes) {
    const HttpResponse response = ask("GET", "/api/worlds");
    EXPECT_EQ(response.status, 200);
    const auto json = nlohmann::json::parse(response.body);
    ASSERT_EQ(json.at("worlds").size(), 1u);
    EXPECT_EQ(json["worlds"][0].at("id"), "w1");
    EXPECT_EQ(json["worlds"][0].at("name"), "stack");
    EXPECT_EQ(json["worlds"][0].at("clients"), 0) << "zeros are written";
    EXPECT_EQ(json.at("scenes").size(), scenes::catalog().size());
}

TEST_F(HttpRoutesTest, worlds_are_made_and_deleted) {
    const HttpResponse made =
        ask("POST", "/api/worlds", R"({"name": "two words", "sceneName": "dominoes"})");
    EXPECT_EQ(made.status, 201) << made.body;
    EXPECT_EQ(ask("GET", "/api/worlds/two%20words").status, 200);
    EXPECT_EQ(ask("GET", "/api/worlds/w2").status, 200);
    const HttpResponse third =
        ask("POST", "/api/worlds", R"({"name": "third", "sceneName": "stack"})");
    EXPECT_EQ(third.status, 429);
    EXPECT_EQ(code_of(third), "RESOURCE_EXHAUSTED");
    EXPECT_EQ(ask("DELETE", "/api/worlds/w2").status, 200);
    EXPECT_EQ(ask("DELETE", "/api/worlds/w2").status, 404);
    EXPECT_EQ(code_of(ask("POST", "/api/worlds", R"({"sceneName": "stack"})")), "ALREADY_EXISTS");
    EXPECT_EQ(worlds.list().size(), 1u);
}

TEST_F(HttpRoutesTest, malformed_requests_are_refused_with_words) {
    for (const char* body :
         {"", "{", "[]", R"({"sceneNome": "stack"})", R"({"sceneName": 5})", "{}",
          R"({"scene": {"bodies": [{"shapes": [{"sphere": {"radius": -1}}]}]}})"}) {
        const HttpResponse response = ask("POST", "/api/worlds", body);
        EXPECT_EQ(response.status, 400) << body << response.body;
        EXPECT_EQ(code_of(response), "INVALID_ARGUMENT") << body;
    }
    // Never a file of the server's machine.
    EXPECT_EQ(ask("POST", "/api/worlds", R"({"sceneName": "/etc/passwd"})").status, 404);
    EXPECT_EQ(ask("GET", "/api/nothing").status, 404);
    EXPECT_EQ(ask("GET", "/api/worlds/a/b").status, 404);
    EXPECT_EQ(ask("GET", "/api/worlds/%zz").status, 400);
    EXPECT_EQ(ask("GET", "/api/worlds/..").status, 400);
    EXPECT_EQ(ask("PUT", "/api/worlds").status, 405);
    HttpRequest form{.method = "POST",
                     .target = "/api/worlds",
                     .host = {},
                     .origin = {},
                     .content_type = "text/plain",
                     .if_none_match = {},
                     .body = "{}"};
    EXPECT_EQ(routes.answer(form).status, 415);
}

TEST_F(HttpRoutesTest, pages_from_elsewhere_change_nothing) {
    const char* body = R"({"name": "x", "sceneName": "stack"})";
    EXPECT_EQ(ask("POST", "/api/worlds", body, "http://elsewhere.example").status, 403);
    EXPECT_EQ(ask("POST", "/api/worlds", body, "null").status, 403);
    EXPECT_EQ(ask("DELETE", "/api/worlds/w1", "", "http://localhost:9999").status, 403);
    EXPECT_EQ(worlds.list().size(), 1u);
    EXPECT_EQ(ask("POST", "/api/worlds", body, "http://localhost:8080").status, 201);
    EXPECT_EQ(ask("DELETE", "/api/worlds/x", "", "https://play.example.org").status, 200);
}

TEST_F(HttpRoutesTest, health_follows_the_server) {
    EXPECT_EQ(ask("GET", "/healthz").status, 200);
    EXPECT_EQ(ask("GET", "/readyz").status, 200);
    context.draining = true;
    EXPECT_EQ(ask("GET", "/healthz").status, 200);
    EXPECT_EQ(ask("GET", "/readyz").status, 503);
    EXPECT_EQ(ask("POST", "/api/worlds", R"({"name": "x", "sceneName": "stack"})").status, 503);
}

TEST_F(HttpRoutesTest, play_wants_a_websocket) {
    EXPECT_EQ(ask("GET", "/play").status, 426);
}

}  // namespace
}  // namespace jostle::server

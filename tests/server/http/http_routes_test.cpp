// SPDX-License-Identifier: MIT
#include "server/http/http_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "jostle/scenes/catalog.h"
#include "tests/server/server_parts.h"

namespace jostle::server {
namespace {

class HttpRoutesTest : public testing::Test, protected ServerParts {
protected:
    HttpRoutesTest() : ServerParts(10, 2) { config.world.worlds_max = 2; }
    void SetUp() override { ASSERT_TRUE(worlds.create("", *scenes::find_scene("stack")).ok()); }

    HttpResponse send(const std::string& method, const std::string& target,
                      const std::string& body = {}, const std::string& origin = {}) const {
        HttpRequest request;
        request.method = method;
        request.target = target;
        request.host = "localhost:8080";
        request.origin = origin;
        request.content_type = "application/json";
        request.body = body;
        return routes.handle(request);
    }
    static std::string code_of(const HttpResponse& response) {
        return nlohmann::json::parse(response.body).at("code");
    }

    std::optional<std::string> failure_reason;
    WorldControl control{context};
    QueryControl queries{context};
    AdminControl admin{context};
    HttpRoutes routes{
        control,
        queries,
        {.web_root = "/nonexistent",
         .allowed_origins = {"https://play.example.org"},
         .not_ready_reason =
             [this] {
                 return context.draining ? std::optional<std::string>("the server is shutting down")
                                         : std::nullopt;
             },
         .failure_reason = [this] { return failure_reason; },
         .admin_control = &admin}};
};

TEST_F(HttpRoutesTest, lists_worlds_and_scenes) {
    const HttpResponse response = send("GET", "/api/worlds");
    EXPECT_EQ(response.status, 200);
    const auto json = nlohmann::json::parse(response.body);
    ASSERT_EQ(json.at("worlds").size(), 1u);
    EXPECT_EQ(json["worlds"][0].at("id"), "w1");
    EXPECT_EQ(json["worlds"][0].at("name"), "stack");
    EXPECT_EQ(json["worlds"][0].at("clients"), 0) << "zeros must be written";
    EXPECT_EQ(json.at("scenes").size(), scenes::catalog().size());
}

TEST_F(HttpRoutesTest, joins_lists_and_creates_rooms) {
    const std::string body = R"({"filter": {"tags": ["race"]},
                                 "create": {"sceneName": "stack", "room": {"tags": ["race"]}}})";
    const HttpResponse created = send("POST", "/api/join-or-create", body);
    EXPECT_EQ(created.status, 201) << created.body;
    const HttpResponse joined = send("POST", "/api/join-or-create", body);
    EXPECT_EQ(joined.status, 200);
    const auto world = nlohmann::json::parse(joined.body).at("join").at("world");
    EXPECT_EQ(nlohmann::json::parse(created.body).at("join").at("world").at("id"), world.at("id"));
    const auto names = [&](const std::string& query) {
        const HttpResponse listed = send("GET", "/api/worlds" + query);
        EXPECT_EQ(listed.status, 200) << listed.body;
        std::vector<std::string> ids;
        const auto json = nlohmann::json::parse(listed.body);
        for (const auto& one : json.at("worlds")) ids.push_back(one.at("id"));
        return ids;
    };
    EXPECT_EQ(names("?tags=race&not_full=1"), (std::vector<std::string>{world.at("id")}));
    EXPECT_EQ(names("?tags=race,cars"), (std::vector<std::string>{}));
    EXPECT_EQ(names("?limit=1"), (std::vector<std::string>{"w1"}));
    EXPECT_EQ(send("GET", "/api/worlds?not_full=yes").status, 400);
    const std::string path = "/api/worlds/" + world.at("id").get<std::string>() + "/join";
    const HttpResponse ticket = send("POST", path, "{}");
    EXPECT_EQ(nlohmann::json::parse(ticket.body).at("ticket").get<std::string>().size(), 32u);
    EXPECT_EQ(send("GET", path).status, 405);
    EXPECT_EQ(send("POST", "/api/worlds/w99/join", "{}").status, 404);
}

TEST_F(HttpRoutesTest, resumes_a_paused_world) {
    worlds.find("w1")->pause("for a test");
    EXPECT_EQ(send("GET", "/api/worlds/w1/resume").status, 200) << "the caller may resume it";
    EXPECT_TRUE(worlds.find("w1")->lifecycle().paused());
    EXPECT_EQ(send("DELETE", "/api/worlds/w1/resume").status, 405);
    EXPECT_EQ(send("POST", "/api/worlds/w9/resume").status, 404);
    const HttpResponse resumed = send("POST", "/api/worlds/w1/resume");
    EXPECT_EQ(resumed.status, 200) << resumed.body;
    EXPECT_EQ(nlohmann::json::parse(resumed.body).at("world").at("paused"), "");
    EXPECT_FALSE(worlds.find("w1")->lifecycle().paused());
}

TEST_F(HttpRoutesTest, a_downloaded_scene_can_be_created_again) {
    EXPECT_EQ(routes.work_of({.method = "GET", .target = "/api/worlds/w1/scene"}),
              HttpWork::mutation)
        << "waits for a tick";
    EXPECT_EQ(send("POST", "/api/worlds/w1/scene", "{}").status, 405);
    EXPECT_EQ(send("GET", "/api/worlds/w9/scene").status, 404);
    const HttpResponse downloaded = send("GET", "/api/worlds/w1/scene");
    ASSERT_EQ(downloaded.status, 200) << downloaded.body;
    const auto scene = nlohmann::json::parse(downloaded.body).at("scene");
    const nlohmann::json request = {{"name", "copy"}, {"sceneJson", scene.dump(1)}};
    const HttpResponse created = send("POST", "/api/worlds", request.dump());
    ASSERT_EQ(created.status, 201) << created.body;
    EXPECT_EQ(nlohmann::json::parse(created.body).at("world").at("bodies"),
              scene.at("bodies").size());
}

TEST_F(HttpRoutesTest, reports_the_errors_of_a_scene_with_positions) {
    const auto message_of = [&](const std::string& body) {
        const HttpResponse response = send("POST", "/api/worlds", body);
        EXPECT_EQ(response.status, 400) << response.body;
        return nlohmann::json::parse(response.body)["message"].get<std::string>();
    };
    EXPECT_EQ(message_of("{\"nme\": \"x\",\n \"scene\": {\"bodys\": []}}"),
              "line 1, column 9: nme: unknown field; did you mean \"name\"?\n"
              "line 2, column 21: scene.bodys: unknown field; did you mean \"bodies\"?");
    EXPECT_EQ(
        message_of("{\"scene\": {\"name\": \"a\",\n \"world\": {\"hz\": 1},\n"
                   " \"bodies\": [{\"mass\": -1}]}}"),
        "line 2, column 18: scene.world.hz: 1 is out of range; it must be from 4 to 1000\n"
        "line 3, column 22: scene.bodies[0].mass: -1 is out of range; it must be from 1e-09 to "
        "1e+15\n"
        "bodies[0].shapes: is empty; it must have at least one shape");
    const std::string of_module = message_of(
        "{\"scene\": {\"name\": \"a\", \"modules\": [\n"
        " {\"tag\": \"fields\", \"settings\": {\"waves_levle\": 1}}]}}");
    EXPECT_TRUE(of_module.starts_with(
        "line 2, column 2: scene.modules[0] 'fields': unknown setting waves_levle"))
        << of_module;
    EXPECT_TRUE(of_module.ends_with("; did you mean \"waves_level\"?")) << of_module;
    EXPECT_EQ(
        send("POST", "/api/worlds", R"({"scene": {"$schema": "scene.schema.json", "name": "a"}})")
            .status,
        201);
}

// The balance of a player is 0.1 ms of processor time.
TEST_F(HttpRoutesTest, refuses_queries_beyond_the_share_of_a_player_with_a_time_to_retry) {
    config.quota.query_share = 1e-4;
    const QueryControl limited(context);
    const HttpRoutes of_limited(control, limited, {.web_root = "/nonexistent"});
    HttpRequest request;
    request.method = "POST";
    request.target = "/api/query/CastRays";
    request.host = "localhost:8080";
    request.content_type = "application/json";
    request.body = R"({"rays": [{"origin": {"y": 50}, "motion": {"y": -60}}]})";
    request.address = "192.0.2.1";
    HttpResponse response = of_limited.handle(request);
    EXPECT_EQ(response.status, 200) << response.body;
    response = of_limited.handle(request);
    EXPECT_EQ(response.status, 429) << response.body;
    EXPECT_EQ(code_of(response), "RESOURCE_EXHAUSTED");
    EXPECT_GE(nlohmann::json::parse(response.body).at("retryAfterMs"), 100);
    EXPECT_TRUE(std::ranges::any_of(response.headers, [](const auto& header) {
        return header.first == "Retry-After" && std::stoi(header.second) >= 1;
    }));
    request.address = "198.51.100.1";
    EXPECT_EQ(of_limited.handle(request).status, 200) << "another player";
}

TEST_F(HttpRoutesTest, creates_and_deletes_worlds) {
    const HttpResponse made =
        send("POST", "/api/worlds", R"({"name": "two words", "sceneName": "dominoes"})");
    EXPECT_EQ(made.status, 201) << made.body;
    EXPECT_EQ(send("GET", "/api/worlds/two%20words").status, 200);
    EXPECT_EQ(send("GET", "/api/worlds/w2").status, 200);
    const HttpResponse third =
        send("POST", "/api/worlds", R"({"name": "third", "sceneName": "stack"})");
    EXPECT_EQ(third.status, 429);
    EXPECT_EQ(code_of(third), "RESOURCE_EXHAUSTED");
    EXPECT_EQ(send("DELETE", "/api/worlds/w2").status, 200);
    EXPECT_EQ(send("DELETE", "/api/worlds/w2").status, 404);
    EXPECT_EQ(code_of(send("POST", "/api/worlds", R"({"sceneName": "stack"})")), "ALREADY_EXISTS");
    EXPECT_EQ(worlds.list().size(), 1u);
}

TEST_F(HttpRoutesTest, rejects_malformed_requests_with_a_message) {
    for (const char* body :
         {"", "{", "[]", R"({"sceneNome": "stack"})", R"({"sceneName": 5})", "{}",
          R"({"scene": {"bodies": [{"shapes": [{"sphere": {"radius": -1}}]}]}})"}) {
        const HttpResponse response = send("POST", "/api/worlds", body);
        EXPECT_EQ(response.status, 400) << body << response.body;
        EXPECT_EQ(code_of(response), "INVALID_ARGUMENT") << body;
    }
    // A name of a scene is never a path of a file on the server.
    EXPECT_EQ(send("POST", "/api/worlds", R"({"sceneName": "/etc/passwd"})").status, 404);
    EXPECT_EQ(send("GET", "/api/nothing").status, 404);
    EXPECT_EQ(send("GET", "/api/worlds/a/b").status, 404);
    EXPECT_EQ(send("GET", "/api/worlds/%zz").status, 400);
    EXPECT_EQ(send("GET", "/api/worlds/..").status, 400);
    EXPECT_EQ(send("PUT", "/api/worlds").status, 405);
    HttpRequest form{.method = "POST",
                     .target = "/api/worlds",
                     .host = {},
                     .origin = {},
                     .content_type = "text/plain",
                     .if_none_match = {},
                     .body = "{}"};
    EXPECT_EQ(routes.handle(form).status, 415);
}

TEST_F(HttpRoutesTest, rejects_cross_origin_mutations) {
    const char* body = R"({"name": "x", "sceneName": "stack"})";
    EXPECT_EQ(send("POST", "/api/worlds", body, "http://elsewhere.example").status, 403);
    EXPECT_EQ(send("POST", "/api/worlds", body, "null").status, 403);
    EXPECT_EQ(send("DELETE", "/api/worlds/w1", "", "http://localhost:9999").status, 403);
    EXPECT_EQ(worlds.list().size(), 1u);
    EXPECT_EQ(send("POST", "/api/worlds", body, "http://localhost:8080").status, 201);
    EXPECT_EQ(send("DELETE", "/api/worlds/x", "", "https://play.example.org").status, 200);
}

TEST_F(HttpRoutesTest, serves_queries_as_json) {
    const HttpResponse hit = send("POST", "/api/query/CastRays", R"({
        "rays": [{"origin": {"x": 0, "y": 50, "z": 0}, "motion": {"y": -100}},
                 {"origin": {"y": 50}, "motion": {"y": 1}}]})");
    EXPECT_EQ(hit.status, 200) << hit.body;
    const auto json = nlohmann::json::parse(hit.body);
    ASSERT_EQ(json.at("rays").size(), 2u);
    ASSERT_EQ(json["rays"][0].at("hits").size(), 1u);
    const auto& first = json["rays"][0]["hits"][0];
    EXPECT_GT(first.at("entity"), 1)
        << "the ray must hit the top of the stack instead of the ground";
    EXPECT_NEAR(first["point"].at("y").get<double>(), 50 - 100 * first.at("fraction").get<double>(),
                1e-6);
    EXPECT_EQ(json["rays"][1].at("hits").size(), 0u) << "empty lists must be written";
    const HttpResponse debug =
        send("POST", "/api/query/Debug", R"({"world": "stack", "bounds": true})");
    EXPECT_EQ(debug.status, 200) << debug.body;
    EXPECT_GE(nlohmann::json::parse(debug.body).at("bounds").size(), 10u);
    const std::string at_top = R"("position": {"y": 1}, "sphere": {"radius": 3})";
    EXPECT_EQ(send("POST", "/api/query/Overlap", "{\"shape\": {" + at_top + "}}").status, 200);
    EXPECT_EQ(send("POST", "/api/query/CastShapes",
                   "{\"shapes\": [{\"shape\": {" + at_top + "}, \"motion\": {\"y\": 1}}]}")
                  .status,
              200);
    EXPECT_EQ(
        send("POST", "/api/query/ClosestPoints", R"({"points": [{}], "maxDistance": 5})").status,
        200);
}

TEST_F(HttpRoutesTest, returns_error_details_for_failed_queries) {
    const auto message_of = [&](const char* method, const char* body, int status) {
        const HttpResponse response = send("POST", std::string("/api/query/") + method, body);
        EXPECT_EQ(response.status, status) << response.body;
        return nlohmann::json::parse(response.body).at("message").get<std::string>();
    };
    EXPECT_EQ(message_of("CastRays", R"({"world": "nowhere"})", 404),
              "there is no world \"nowhere\"");
    EXPECT_EQ(message_of("CastRays", R"({"rays": [{"motion": {"y": "NaN"}}]})", 400),
              "rays[0].motion.y is nan; it must be from -1e+07 to 1e+07");
    EXPECT_NE(message_of("CastRays", R"({"ray": []})", 400).find("jostle.v1.CastRaysRequest"),
              std::string::npos);
    EXPECT_NE(message_of("Cast", "{}", 404).find("CastRays, CastShapes"), std::string::npos);
    worlds.find("stack")->stop();
    EXPECT_EQ(message_of("Debug", R"({"islands": true})", 503), "the world was closed");
    EXPECT_EQ(send("GET", "/api/query/Debug").status, 405);
    EXPECT_EQ(send("POST", "/api/query/Debug", "{}", "http://elsewhere.example").status, 403);
}

TEST_F(HttpRoutesTest, health_reflects_server_state) {
    failure_reason = "a tick hangs";
    EXPECT_EQ(send("GET", "/healthz").status, 503);
    EXPECT_EQ(send("GET", "/healthz").body, "a tick hangs\n");
    EXPECT_EQ(send("GET", "/readyz").status, 503);
    failure_reason.reset();
    EXPECT_EQ(send("GET", "/healthz").status, 200);
    EXPECT_EQ(send("GET", "/readyz").status, 200);
    context.draining = true;
    EXPECT_EQ(send("GET", "/healthz").status, 200);
    EXPECT_EQ(send("GET", "/readyz").status, 503);
    EXPECT_EQ(send("POST", "/api/worlds", R"({"name": "x", "sceneName": "stack"})").status, 503);
}

TEST_F(HttpRoutesTest, play_requires_a_websocket_upgrade) {
    EXPECT_EQ(send("GET", "/play").status, 426);
}

TEST_F(HttpRoutesTest, origins_ignore_case_and_default_ports) {
    for (const auto& [origin, host, status] :
         {std::tuple("https://play.example.org", "other", 201),
          std::tuple("HTTPS://Play.example.ORG:443", "other", 201),
          std::tuple("https://play.example.org:8443", "other", 403),
          std::tuple("https://my.example.org", "MY.example.org", 201),
          std::tuple("https://my.example.org", "my.example.org:443", 201),
          std::tuple("http://my.example.org", "my.example.org:443", 403),
          std::tuple("null", "null", 403), std::tuple("https://", "", 403)}) {
        HttpRequest request;
        request.method = "POST";
        request.target = "/api/worlds";
        request.host = host;
        request.origin = origin;
        request.content_type = "application/json";
        request.body = R"({"name": "x", "sceneName": "stack"})";
        EXPECT_EQ(routes.handle(request).status, status) << origin << " " << host;
        if (status == 201) send("DELETE", "/api/worlds/x");
    }
}

std::string value_of(const HttpHeaders& headers, const std::string& name) {
    for (const auto& [key, value] : headers)
        if (key == name) return value;
    return "";
}

TEST_F(HttpRoutesTest, only_pages_of_allowed_origins_may_read_responses) {
    const HttpHeaders allowed = routes.cors_headers("https://play.example.org", "localhost:8080");
    EXPECT_EQ(value_of(allowed, "Access-Control-Allow-Origin"), "https://play.example.org");
    EXPECT_EQ(value_of(allowed, "Vary"), "Origin");
    EXPECT_EQ(value_of(allowed, "Access-Control-Allow-Credentials"), "");
    const HttpHeaders other = routes.cors_headers("https://evil.example", "localhost:8080");
    EXPECT_EQ(value_of(other, "Access-Control-Allow-Origin"), "");
    EXPECT_EQ(value_of(other, "Vary"), "Origin") << "caches must not mix up origins";
    EXPECT_EQ(value_of(routes.cors_headers("", "localhost:8080"), "Access-Control-Allow-Origin"),
              "");
}

TEST_F(HttpRoutesTest, responds_to_preflight_requests) {
    HttpRequest request;
    request.method = "OPTIONS";
    request.target = "/api/worlds";
    request.host = "localhost:8080";
    request.origin = "https://play.example.org";
    request.requested_method = "POST";
    const HttpResponse granted = routes.handle(request);
    EXPECT_EQ(granted.status, 204);
    EXPECT_EQ(value_of(granted.headers, "Access-Control-Allow-Methods"),
              "GET, HEAD, POST, DELETE, OPTIONS");
    EXPECT_NE(value_of(granted.headers, "Access-Control-Allow-Headers").find("authorization"),
              std::string::npos);
    EXPECT_EQ(value_of(granted.headers, "Access-Control-Max-Age"), "600");
    request.origin = "https://evil.example";
    EXPECT_EQ(routes.handle(request).status, 403);
    EXPECT_EQ(value_of(routes.handle(request).headers, "Access-Control-Allow-Methods"), "");
    request.origin.clear();
    request.target = "*";
    EXPECT_EQ(routes.handle(request).status, 204) << "the server as a whole";
    EXPECT_EQ(routes.work_of(request), HttpWork::immediate);
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/grpc_web/grpc_web_routes.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "jostle/v1/world.pb.h"
#include "server/grpc_web/grpc_web_framing.h"
#include "server/http/http_routes.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "tests/server/server_parts.h"

namespace jostle::server {
namespace {

class GrpcWebRoutesTest : public testing::Test, protected ServerParts {
protected:
    GrpcWebRoutesTest() : ServerParts(4, 4) {}
    void SetUp() override { ASSERT_TRUE(worlds.create("", *scenes::find_scene("stack")).ok()); }

    static HttpRequest call(const std::string& method, const std::string& message) {
        HttpRequest request;
        request.method = "POST";
        request.target = "/jostle.v1." + method;
        request.host = "localhost";
        request.content_type = "application/grpc-web+proto";
        request.address = "203.0.113.9";
        request.body = std::string("\0\0\0\0", 4) + static_cast<char>(message.size()) + message;
        return request;
    }
    // The bytes after the header of a frame.
    static std::string rest_of(const HttpResponse& response) { return response.body.substr(5); }

    WorldControl control{context};
    const QueryControl queries{context};
    GrpcWebRoutes grpc_web{world_methods(control, worlds, 4 << 20), *authorizer, nullptr};
    HttpRoutes routes{control,
                      queries,
                      {.web_root = "/nonexistent",
                       .allowed_origins = {"https://play.example.org"},
                       .grpc_web = &grpc_web}};
};

TEST_F(GrpcWebRoutesTest, calls_a_method) {
    const HttpResponse response = routes.handle(call("WorldService/ListWorlds", ""));
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, "application/grpc-web+proto");
    ASSERT_GT(response.body.size(), 26u);
    const std::size_t trailers = response.body.size() - 16 - 5;
    v1::ListWorldsResponse list;
    ASSERT_TRUE(list.ParseFromString(response.body.substr(5, trailers - 5)));
    ASSERT_EQ(list.worlds_size(), 1);
    EXPECT_EQ(list.worlds(0).name(), "stack");
    EXPECT_EQ(response.body.substr(trailers + 5), "grpc-status: 0\r\n");
}

TEST_F(GrpcWebRoutesTest, errors_are_trailers_with_the_status_of_grpc) {
    v1::GetWorldRequest request;
    request.set_world("nothing");
    const HttpResponse missing =
        routes.handle(call("WorldService/GetWorld", request.SerializeAsString()));
    EXPECT_EQ(missing.status, 200);
    EXPECT_TRUE(rest_of(missing).starts_with("grpc-status: 5\r\ngrpc-message: ")) << missing.body;
    EXPECT_NE(missing.body.find("grpc-status-details-bin: "), std::string::npos);
    EXPECT_TRUE(rest_of(routes.handle(call("WorldService/GetWorld", "\xff")))
                    .starts_with("grpc-status: 3\r\n"));
    HttpRequest late = call("WorldService/ListWorlds", "");
    late.grpc_timeout = "0m";
    EXPECT_TRUE(rest_of(routes.handle(late)).starts_with("grpc-status: 4\r\n"));
    HttpRequest stranger = call("WorldService/ListWorlds", "");
    stranger.authorization = "Bearer no.valid.token";
    EXPECT_TRUE(rest_of(routes.handle(stranger)).starts_with("grpc-status: 16\r\n"));
}

TEST_F(GrpcWebRoutesTest, the_play_stream_needs_a_websocket) {
    const HttpResponse response = routes.handle(call("PlayService/Play", ""));
    EXPECT_TRUE(rest_of(response).starts_with("grpc-status: 12\r\n")) << response.body;
    EXPECT_NE(response.body.find("/play"), std::string::npos);
    EXPECT_TRUE(
        rest_of(routes.handle(call("AdminService/Drain", ""))).starts_with("grpc-status: 12"));
}

TEST_F(GrpcWebRoutesTest, requires_post_the_content_type_and_an_allowed_origin) {
    HttpRequest request = call("WorldService/ListWorlds", "");
    request.method = "GET";
    EXPECT_EQ(routes.handle(request).status, 405);
    request = call("WorldService/ListWorlds", "");
    request.content_type = "application/grpc";
    EXPECT_EQ(routes.handle(request).status, 415);
    request = call("WorldService/ListWorlds", "");
    request.origin = "https://evil.example";
    EXPECT_EQ(routes.handle(request).status, 403);
    request.origin = "https://play.example.org";
    EXPECT_EQ(routes.handle(request).status, 200);
}

TEST_F(GrpcWebRoutesTest, runs_changes_on_their_own_thread_and_allows_scenes) {
    const HttpRequest create = call("WorldService/CreateWorld", "");
    EXPECT_EQ(routes.work_of(create), HttpWork::mutation);
    EXPECT_TRUE(routes.accepts_large_body(create));
    const HttpRequest list = call("WorldService/ListWorlds", "");
    EXPECT_EQ(routes.work_of(list), HttpWork::immediate);
    EXPECT_FALSE(routes.accepts_large_body(list));
    EXPECT_EQ(routes.work_of(call("WorldService/Nothing", "")), HttpWork::immediate);
}

}  // namespace
}  // namespace jostle::server

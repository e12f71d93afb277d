// SPDX-License-Identifier: MIT
//
// Permissions over real sockets: five identities and an anonymous client call each row of the
// access table.
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "jostle/scenes/catalog.h"
#include "jostle/v1/world.grpc.pb.h"
#include "server/auth/access_table.h"
#include "server/grpc/grpc_server.h"
#include "server/http/http_routes.h"
#include "server/services/call_method.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::LoginService;

struct User {
    std::string name, role;  // an empty role sends no token
    Role is = Role::none;
};

// The world "mine" belongs to the director dora, "theirs" to another user.
class AccessTest : public testing::Test {
protected:
    void SetUp() override {
        folder.write("keys.json", login.published());
        folder.write("audit.jsonl", "");
        config.auth = {.issuer = LoginService::issuer,
                       .audience = LoginService::audience,
                       .keys = folder / "keys.json",
                       .anonymous_role = "none",
                       .audit_log = folder / "audit.jsonl"};
        config.quota.creates_per_minute = config.quota.joins_per_minute =
            config.quota.queries_per_second = config.quota.refused_logins_per_minute =
                config.quota.refusals_audited_per_minute = 1e6;
        authorizer = *Authorizer::open(config);
        context.reset(new PlayContext{
            .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer});
        control = std::make_unique<WorldControl>(*context);
        queries = std::make_unique<QueryControl>(*context);
        admin = std::make_unique<AdminControl>(*context);
        std::vector<CallMethod> methods = world_methods(*control, worlds, 4 << 20);
        std::ranges::move(query_methods(*queries, worlds), std::back_inserter(methods));
        std::ranges::move(admin_methods(*admin, worlds), std::back_inserter(methods));
        server = std::make_unique<GrpcServer>(
            *context, std::move(methods), [] { return true; }, GrpcSettings{.port = 0});
        ASSERT_TRUE(server->start().ok());
        channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(server->port()),
                                      grpc::InsecureChannelCredentials());
        make_worlds();
    }
    void TearDown() override {
        context->closing = true;
        server->drain({});
        server->stop();
    }
    void make_worlds() {
        for (const auto& [name, owner] : {std::pair("mine", "dora"), std::pair("theirs", "max")})
            if (!worlds.find(name)) {
                ASSERT_TRUE(worlds.create(name, *scenes::find_scene("stack"), owner).ok());
            }
    }
    std::string token_of(const User& user) const {
        if (user.role.empty()) return {};
        return login.token(
            LoginService::claims(user.name, user.role, std::chrono::system_clock::now()));
    }
    // The status of a call whose request has `world` as its first field. All requests about a world
    // start with it.
    grpc::StatusCode call(const std::string& path, const std::string& world,
                          const std::string& token) {
        grpc::GenericStub stub(channel);
        grpc::ClientContext context_of_call;
        // A Watch stream only ends at its deadline.
        const bool watches = path.ends_with("/Watch");
        context_of_call.set_deadline(std::chrono::system_clock::now() +
                                     (watches ? std::chrono::milliseconds(500) : 10s));
        if (!token.empty()) context_of_call.AddMetadata("authorization", "Bearer " + token);
        v1::GetWorldRequest request;
        request.set_world(world);
        const std::string bytes = request.SerializeAsString();
        const grpc::Slice slice(bytes);
        const grpc::ByteBuffer asked(&slice, 1);
        grpc::ByteBuffer answer;
        grpc::CompletionQueue queue;
        const auto reader = stub.PrepareUnaryCall(&context_of_call, path, asked, &queue);
        reader->StartCall();
        grpc::Status status;
        reader->Finish(&answer, &status, nullptr);
        void* tag = nullptr;
        bool ok = false;
        queue.Next(&tag, &ok);
        queue.Shutdown();
        return status.error_code();
    }
    static bool is_refusal(grpc::StatusCode code) {
        return code == grpc::StatusCode::UNAUTHENTICATED ||
               code == grpc::StatusCode::PERMISSION_DENIED;
    }
    int audited(const std::string& outcome, const std::string& call_name) {
        EXPECT_TRUE(authorizer->audit().flush(5s));
        int count = 0;
        std::istringstream lines(folder.read("audit.jsonl"));
        for (std::string line; std::getline(lines, line);) {
            EXPECT_EQ(line.find("eyJ"), std::string::npos) << "the audit log contains a token";
            const auto entry = nlohmann::json::parse(line);
            count += entry.value("outcome", "") == outcome && entry.value("call", "") == call_name;
        }
        return count;
    }

    const std::vector<User> people{{"", "", Role::none},
                                   {"vera", "viewer", Role::viewer},
                                   {"paul", "player", Role::player},
                                   {"dora", "director", Role::director},
                                   {"otto", "director", Role::director},
                                   {"anna", "admin", Role::admin}};
    test::TempFolder folder;
    LoginService login;
    Config config;
    SessionDirectory sessions{100};
    WorldDirectory worlds{{}, 40};
    std::unique_ptr<Authorizer> authorizer;
    std::unique_ptr<PlayContext> context;
    std::unique_ptr<WorldControl> control;
    std::unique_ptr<QueryControl> queries;
    std::unique_ptr<AdminControl> admin;
    std::unique_ptr<GrpcServer> server;
    std::shared_ptr<grpc::Channel> channel;
};

TEST_F(AccessTest, every_rpc_enforces_its_access_row) {
    int asked = 0;
    for (const AccessRow& row : access_table()) {
        const bool is_rpc = row.call.find('.') != std::string_view::npos;
        // Play is a stream and has its own test below.
        if (!is_rpc || row.kind == CallKind::play ||
            row.call.find("ServerReflection") != std::string_view::npos)
            continue;
        for (const User& user : people) {
            make_worlds();
            const auto code = call("/" + std::string(row.call), "mine", token_of(user));
            const bool owns = user.name == "dora" || user.is == Role::admin;
            const bool may = row.kind == CallKind::open ||
                             (user.is >= row.min_role && (row.scope != Scope::own_world || owns));
            EXPECT_EQ(is_refusal(code), !may)
                << row.call << " by " << user.role << " " << user.name << ": " << code;
            if (user.is == Role::none && !may) {
                EXPECT_EQ(code, grpc::StatusCode::UNAUTHENTICATED) << row.call;
            }
            asked++;
        }
    }
    EXPECT_GE(asked, 6 * 19);
    EXPECT_EQ(audited("refused", "jostle.v1.AdminService/Drain"), 5);
    EXPECT_EQ(audited("done", "jostle.v1.AdminService/Drain"), 1);
    EXPECT_EQ(audited("refused", "jostle.v1.WorldService/DeleteWorld"), 4);
    EXPECT_GE(audited("done", "jostle.v1.WorldService/DeleteWorld"), 2);
}

TEST_F(AccessTest, every_route_enforces_its_access_row) {
    const HttpRoutes routes(*control, *queries,
                            {.web_root = "/nonexistent",
                             .allowed_origins = {},
                             .not_ready_reason = [] { return std::optional<std::string>(); },
                             .failure_reason = [] { return std::nullopt; }});
    const std::vector<std::pair<std::string, std::string>> filled = {
        {"{id}", "mine"}, {"{method}", "CastRays"}, {"{file}", "index.html"}};
    for (const AccessRow& row : access_table()) {
        const std::string text(row.call);
        const std::size_t space = text.find(" /");
        if (space == std::string::npos || row.call == "GET /play" || row.call == "GET /metrics" ||
            row.kind == CallKind::admin)
            continue;  // routes of the admin listener, or routes without a regular response
        HttpRequest request{.method = text.substr(0, space), .target = text.substr(space + 1)};
        for (const auto& [hole, content] : filled)
            if (const auto at = request.target.find(hole); at != std::string::npos)
                request.target.replace(at, hole.size(), content);
        request.content_type = "application/json";
        request.body = R"({"world": "mine"})";
        for (const User& user : people) {
            make_worlds();
            const std::string token = token_of(user);
            request.authorization = token.empty() ? "" : "Bearer " + token;
            const HttpResponse answer = routes.handle(request);
            const bool owns = user.name == "dora" || user.is == Role::admin;
            const bool may = row.kind == CallKind::open ||
                             (user.is >= row.min_role && (row.scope != Scope::own_world || owns));
            EXPECT_EQ(answer.status == 401 || answer.status == 403, !may)
                << row.call << " by " << user.name << ": " << answer.status << answer.body;
        }
    }
}

// anna administrates the world "mine" only.
TEST_F(AccessTest, token_for_one_world_sees_and_administrates_only_that_world) {
    auto claims = LoginService::claims("anna", "admin", std::chrono::system_clock::now());
    claims["world"] = "mine";
    const std::string token = login.token(claims);
    const auto stub = v1::WorldService::NewStub(channel);
    grpc::ClientContext listing;
    listing.AddMetadata("authorization", "Bearer " + token);
    v1::ListWorldsResponse listed;
    ASSERT_TRUE(stub->ListWorlds(&listing, {}, &listed).ok());
    ASSERT_EQ(listed.worlds_size(), 1);
    EXPECT_EQ(listed.worlds(0).name(), "mine");
    const HttpRoutes routes(*control, *queries,
                            {.web_root = "/nonexistent",
                             .allowed_origins = {},
                             .not_ready_reason = [] { return std::optional<std::string>(); },
                             .failure_reason = [] { return std::nullopt; }});
    const HttpResponse page = routes.handle({.method = "GET",
                                             .target = "/api/worlds",
                                             .authorization = "Bearer " + token,
                                             .address = "127.0.0.1"});
    const auto worlds_of_page = nlohmann::json::parse(page.body)["worlds"];
    ASSERT_EQ(worlds_of_page.size(), 1u) << page.body;
    EXPECT_EQ(worlds_of_page[0]["name"], "mine");
    const std::string admin_service = "/jostle.v1.AdminService/";
    EXPECT_EQ(call(admin_service + "SetPaused", "mine", token), grpc::StatusCode::OK);
    EXPECT_EQ(call(admin_service + "ListClients", "mine", token), grpc::StatusCode::OK);
    EXPECT_EQ(call(admin_service + "ListClients", "", token), grpc::StatusCode::OK);
    for (const char* name :
         {"SetPaused", "ListClients", "ExportWorld", "RewindWorld", "UndoClient", "Profile"})
        EXPECT_EQ(call(admin_service + name, "theirs", token), grpc::StatusCode::PERMISSION_DENIED)
            << name;
    EXPECT_EQ(call(admin_service + "Drain", "", token), grpc::StatusCode::PERMISSION_DENIED);
    for (const char* name : {"Ban", "Unban", "ListBans"})
        EXPECT_EQ(call(admin_service + name, "eve", token), grpc::StatusCode::PERMISSION_DENIED);
    EXPECT_EQ(call("/jostle.v1.WorldService/CreateWorld", "", token),
              grpc::StatusCode::PERMISSION_DENIED);
    EXPECT_EQ(call("/jostle.v1.WorldService/DeleteWorld", "theirs", token),
              grpc::StatusCode::PERMISSION_DENIED);
}

TEST_F(AccessTest, audits_bans_with_their_subject) {
    const std::string token = token_of({"anna", "admin", Role::admin});
    EXPECT_EQ(call("/jostle.v1.AdminService/Ban", "eve", token), grpc::StatusCode::OK);
    EXPECT_EQ(
        call("/jostle.v1.WorldService/ListWorlds", "", token_of({"eve", "player", Role::player})),
        grpc::StatusCode::PERMISSION_DENIED);
    EXPECT_EQ(audited("done", "jostle.v1.AdminService/Ban"), 1);
    EXPECT_NE(folder.read("audit.jsonl").find(R"("target":"subject eve")"), std::string::npos);
}

TEST_F(AccessTest, rejects_and_audits_forged_and_expired_tokens) {
    const auto now = std::chrono::system_clock::now();
    const auto claims = LoginService::claims("paul", "admin", now);
    const auto with = [&](const char* key, const test::Json& value) {
        auto changed = claims;
        changed[key] = value;
        return changed;
    };
    auto no_exp = claims;
    no_exp.erase("exp");
    test::Json none = login.header();
    none["alg"] = "none";
    LoginService stranger;  // the same key id with another key
    const std::int64_t seconds = std::chrono::system_clock::to_time_t(now);
    const std::vector<std::pair<const char*, std::string>> tokens = {
        {"forged", stranger.token(claims)},
        {"expired", login.token(with("exp", seconds - 3600))},
        {"none", login.token(none, claims)},
        {"no exp", login.token(no_exp)},
        {"wrong audience", login.token(with("aud", "another game"))},
        {"wrong issuer", login.token(with("iss", "https://elsewhere.example.org"))},
        {"25 hours", login.token(with("exp", seconds + 25 * 3600))},
        {"garbage", "eyJhbGciOiJFUzI1NiJ9.e30.AAAA"}};
    for (const auto& [name, token] : tokens)
        EXPECT_EQ(call("/jostle.v1.WorldService/ListWorlds", "", token),
                  grpc::StatusCode::UNAUTHENTICATED)
            << name;
    EXPECT_EQ(call("/jostle.v1.WorldService/ListWorlds", "", login.token(claims)),
              grpc::StatusCode::OK);
    ASSERT_TRUE(authorizer->audit().flush(5s));
    int refused_logins = 0;
    std::istringstream lines(folder.read("audit.jsonl"));
    for (std::string line; std::getline(lines, line);) {
        const auto entry = nlohmann::json::parse(line);
        refused_logins +=
            entry.value("what", "") == "login" && entry.value("outcome", "") == "refused";
    }
    EXPECT_EQ(refused_logins, static_cast<int>(tokens.size()));
}

}  // namespace
}  // namespace jostle::server

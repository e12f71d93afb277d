// SPDX-License-Identifier: MIT
//
// Compares the access table with the compiled-in services: every RPC has a row and every row has an
// RPC. The expected permissions of each role are listed here a second time.
#include "server/auth/access_table.h"

#include <google/protobuf/descriptor.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "server/auth/authorizer.h"

namespace jostle::server {
namespace {

using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptor;
using google::protobuf::ServiceDescriptor;

// All proto files of the project and the proto file that gRPC provides.
std::set<const FileDescriptor*> proto_files() {
    std::set<const FileDescriptor*> files;
    const DescriptorPool& pool = *DescriptorPool::generated_pool();
    const std::filesystem::path root = PROTO_FOLDER;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".proto") continue;
        const std::string name = std::filesystem::relative(entry.path(), root).string();
        const FileDescriptor* file = pool.FindFileByName(name);
        EXPECT_NE(file, nullptr) << name << " is not in jostle_proto (proto/CMakeLists.txt)";
        if (file) files.insert(file);
    }
    // Not a file of the project. A program that refers to it links it.
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
    const ServiceDescriptor* older =
        pool.FindServiceByName("grpc.reflection.v1alpha.ServerReflection");
    EXPECT_NE(older, nullptr);
    if (older) files.insert(older->file());
    return files;
}

std::set<std::string> rpcs() {
    std::set<std::string> names;
    for (const FileDescriptor* file : proto_files())
        for (int s = 0; s < file->service_count(); ++s)
            for (int m = 0; m < file->service(s)->method_count(); ++m)
                names.insert(file->service(s)->full_name() + "/" +
                             file->service(s)->method(m)->name());
    return names;
}

bool is_rpc(std::string_view call) {
    return call.find(' ') == std::string_view::npos;
}

TEST(AccessTable, every_rpc_has_a_row) {
    const std::set<std::string> names = rpcs();
    EXPECT_GE(names.size(), 14u);
    for (const std::string& name : names)
        EXPECT_NE(find_call(name), nullptr)
            << name << " has no row in server/auth/access_table.cpp, so no client may call it";
}

TEST(AccessTable, every_row_names_an_rpc) {
    const std::set<std::string> names = rpcs();
    for (const AccessRow& row : access_table()) {
        const std::string call(row.call);
        if (!is_rpc(call)) continue;
        EXPECT_TRUE(names.contains(call)) << call << " is not an RPC";
    }
}

TEST(AccessTable, has_no_duplicate_rows) {
    std::set<std::string_view> calls;
    for (const AccessRow& row : access_table())
        EXPECT_TRUE(calls.insert(row.call).second) << row.call;
}

TEST(AccessTable, finds_calls_by_grpc_path) {
    const AccessRow* row = find_call("/jostle.v1.WorldService/CreateWorld");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row, find_call("jostle.v1.WorldService/CreateWorld"));
    EXPECT_EQ(row->kind, CallKind::create);
    for (const char* call :
         {"", "/", "jostle.v1.WorldService", "jostle.v1.WorldService/createworld",
          "//jostle.v1.WorldService/CreateWorld"})
        EXPECT_EQ(find_call(call), nullptr) << call;
}

std::string_view route(std::string_view method, std::string_view path) {
    const AccessRow* row = find_route(method, path);
    return row ? row->call : "";
}

TEST(AccessTable, finds_routes_by_method_and_path) {
    EXPECT_EQ(route("GET", "/api/worlds"), "GET /api/worlds");
    EXPECT_EQ(route("HEAD", "/api/worlds"), "GET /api/worlds");
    EXPECT_EQ(route("POST", "/api/worlds"), "POST /api/worlds");
    EXPECT_EQ(route("GET", "/api/worlds/w1"), "GET /api/worlds/{id}");
    EXPECT_EQ(route("DELETE", "/api/worlds/w1"), "DELETE /api/worlds/{id}");
    EXPECT_EQ(route("POST", "/api/worlds/w1/resume"), "POST /api/worlds/{id}/resume");
    EXPECT_EQ(route("DELETE", "/api/worlds/w1/resume"), "");
    EXPECT_EQ(route("GET", "/api/worlds/w1/scene"), "GET /api/worlds/{id}/scene");
    EXPECT_EQ(route("POST", "/api/query/Debug"), "POST /api/query/{method}");
    EXPECT_EQ(route("GET", "/play"), "GET /play");
    EXPECT_EQ(route("GET", "/healthz"), "GET /healthz");
    EXPECT_EQ(route("GET", "/debug/profile"), "GET /debug/profile");
    for (const char* path : {"/", "/index.html", "/assets/a/b.js", "/apis", "//api/worlds"})
        EXPECT_EQ(route("GET", path), "GET /{file}") << path;
}

TEST(AccessTable, returns_null_for_unknown_routes) {
    for (const auto& [method, path] :
         {std::pair("GET", "/api"), std::pair("GET", "/api/"), std::pair("GET", "/api/worlds/"),
          std::pair("GET", "/api/worlds/a/b"), std::pair("GET", "/api//worlds"),
          std::pair("DELETE", "/api/worlds"), std::pair("PUT", "/api/worlds/w1"),
          std::pair("GET", "/api/query/Debug"), std::pair("POST", "/index.html"),
          std::pair("GET", "/debug/other"), std::pair("GET", ""), std::pair("GET", "*"),
          std::pair("OPTIONS", "/"), std::pair("get", "/api/worlds")})
        EXPECT_EQ(find_route(method, path), nullptr) << method << " " << path;
}

// The expected permissions of a call, listed here a second time.
struct Expected {
    Role min_role;
    // api: no world. server: the server as a whole. token_worlds: the worlds of the token. world:
    // one world. own_world: one world, which callers below admin must own.
    enum Object { api, server, token_worlds, world, own_world } object;
};

std::map<std::string, Expected> expected_permissions() {
    using enum Expected::Object;
    const std::tuple<Role, Expected::Object, std::vector<const char*>> groups[] = {
        {Role::none,
         api,
         {"grpc.health.v1.Health/Check", "grpc.health.v1.Health/Watch", "GET /healthz",
          "GET /readyz", "GET /metrics", "GET /{file}"}},
        {Role::viewer,
         api,
         {"grpc.reflection.v1.ServerReflection/ServerReflectionInfo",
          "grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo"}},
        {Role::viewer,
         token_worlds,
         {"jostle.v1.WorldService/ListWorlds", "jostle.v1.WorldService/JoinOrCreateWorld",
          "GET /api/worlds", "POST /api/join-or-create"}},
        {Role::viewer,
         world,
         {"jostle.v1.WorldService/GetWorld", "jostle.v1.WorldService/JoinWorld",
          "jostle.v1.PlayService/Play", "jostle.v1.QueryService/CastRays",
          "jostle.v1.QueryService/CastShapes", "jostle.v1.QueryService/Overlap",
          "jostle.v1.QueryService/ClosestPoints", "jostle.v1.QueryService/Debug",
          "jostle.v1.QueryService/Inspect", "GET /api/worlds/{id}", "POST /api/worlds/{id}/join",
          "POST /api/query/{method}", "GET /play"}},
        {Role::player, world, {"play inputs"}},
        {Role::director, server, {"jostle.v1.WorldService/CreateWorld", "POST /api/worlds"}},
        {Role::director,
         own_world,
         {"jostle.v1.WorldService/DeleteWorld", "DELETE /api/worlds/{id}",
          "GET /api/worlds/{id}/resume", "POST /api/worlds/{id}/resume",
          "GET /api/worlds/{id}/scene"}},
        {Role::admin,
         token_worlds,
         {"jostle.v1.AdminService/GetServerStatus", "jostle.v1.AdminService/ListClients",
          "jostle.v1.AdminService/Kick", "jostle.v1.AdminService/ListReports"}},
        {Role::admin,
         server,
         {"jostle.v1.AdminService/Drain", "jostle.v1.AdminService/Backup",
          "jostle.v1.AdminService/Ban", "jostle.v1.AdminService/Unban",
          "jostle.v1.AdminService/ListBans"}},
        {Role::admin,
         world,
         {"jostle.v1.AdminService/SetPaused", "jostle.v1.AdminService/StepWorld",
          "jostle.v1.AdminService/ExportWorld", "jostle.v1.AdminService/DownloadWorld",
          "jostle.v1.AdminService/RemoveBodies", "jostle.v1.AdminService/RewindWorld",
          "jostle.v1.AdminService/UndoClient", "jostle.v1.AdminService/Profile",
          "jostle.v1.AdminService/ListPlayers", "jostle.v1.AdminService/SetPlayerRole",
          "jostle.v1.AdminService/GetAttributes", "jostle.v1.AdminService/SetAttributes",
          "jostle.v1.AdminService/SendMessage", "jostle.v1.AdminService/GetRoom",
          "jostle.v1.AdminService/ApplyInput", "jostle.v1.AdminService/ModerateRoom",
          "POST /api/admin/{method}", "GET /debug/profile"}},
    };
    std::map<std::string, Expected> expected;
    for (const auto& [role, object, calls] : groups)
        for (const char* call : calls) expected[call] = {role, object};
    return expected;
}

enum class TokenScope { unlimited, this_world, other_world };
enum class Owner { own, other };

bool may(const Expected& row, Role role, TokenScope token, Owner owner) {
    using enum Expected::Object;
    if (row.min_role == Role::none) return true;  // open to everybody
    if (role < row.min_role) return false;
    const bool limited = token != TokenScope::unlimited;
    switch (row.object) {
        case api:
        case token_worlds:
            return true;
        case Expected::server:
            return !limited;
        case Expected::world:
            return token != TokenScope::other_world;
        case Expected::own_world:
            return token != TokenScope::other_world && (owner == Owner::own || role == Role::admin);
    }
    return false;
}

// Every RPC and route x role x scope of the token x owner of the world. A new RPC fails here until
// its permissions are listed.
TEST(AccessTable, enforces_the_complete_matrix_of_permissions) {
    Config config;
    config.auth.audit_log = "/dev/null";
    config.quota.creates_per_minute = config.quota.joins_per_minute =
        config.quota.queries_per_second = 1e9;
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    const std::map<std::string, Expected> expected = expected_permissions();
    std::set<std::string> calls = rpcs();
    for (const AccessRow& row : access_table()) calls.insert(std::string(row.call));
    EXPECT_EQ(expected.size(), calls.size());
    int checked = 0;
    for (const std::string& call : calls) {
        const auto row = expected.find(call);
        if (row == expected.end()) {
            ADD_FAILURE() << call << " is not in expected_permissions()";
            continue;
        }
        for (const Role role :
             {Role::none, Role::viewer, Role::player, Role::director, Role::admin})
            for (const TokenScope token :
                 {TokenScope::unlimited, TokenScope::this_world, TokenScope::other_world})
                for (const Owner owner : {Owner::own, Owner::other}) {
                    Identity who{.subject = "anna", .role = role, .anonymous = false};
                    if (token == TokenScope::this_world) who.worlds = {"pit", "arena"};
                    if (token == TokenScope::other_world) who.worlds = {"w2", "pit"};
                    const Status status = authorizer->admit(
                        who, {.call = call,
                              .world = {"w1", "arena", owner == Owner::own ? "anna" : "berta"},
                              .address = "192.0.2.7"});
                    EXPECT_EQ(status.ok(), may(row->second, role, token, owner))
                        << call << ", role " << name_of(role) << ", token scope "
                        << static_cast<int>(token) << ", owner " << static_cast<int>(owner)
                        << (status.ok() ? "" : ": " + status.error().message);
                    checked++;
                }
    }
    EXPECT_EQ(checked, static_cast<int>(calls.size()) * 5 * 3 * 2);
}

// The line for a role in the operator documentation.
std::string documented(const std::string& rights) {
    std::ifstream in(OPERATIONS_PAGE);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("| " + rights + " | `")) return line;
    return {};
}

TEST(AccessTable, operations_guide_lists_every_row) {
    for (const AccessRow& row : access_table()) {
        std::string rights =
            row.min_role == Role::none ? "everybody" : std::string(name_of(row.min_role));
        if (row.scope == Scope::own_world) rights += ", own worlds";
        std::string call(row.call);  // without its package
        if (is_rpc(call)) call = call.substr(call.rfind('.', call.find('/')) + 1);
        EXPECT_NE(documented(rights).find("`" + call + "`"), std::string::npos)
            << row.call << " is missing in the line of " << rights;
    }
}

}  // namespace
}  // namespace jostle::server

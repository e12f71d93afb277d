// SPDX-License-Identifier: MIT
#include "server/auth/access_table.h"

#include <array>
#include <string>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

using enum CallKind;
constexpr Scope none = Scope::none, server = Scope::server, token_worlds = Scope::token_worlds,
                any_world = Scope::any_world, own_world = Scope::own_world;

constexpr AccessRow table[] = {
    {"jostle.v1.WorldService/ListWorlds", read, Role::viewer, token_worlds},
    {"jostle.v1.WorldService/GetWorld", read, Role::viewer, any_world},
    {"jostle.v1.WorldService/CreateWorld", create, Role::director, server},
    {"jostle.v1.WorldService/DeleteWorld", remove, Role::director, own_world},
    {"jostle.v1.WorldService/JoinWorld", join, Role::viewer, any_world},
    // A caller who joins by it may join; creating a world is admitted as CreateWorld.
    {"jostle.v1.WorldService/JoinOrCreateWorld", join, Role::viewer, token_worlds},
    {"jostle.v1.PlayService/Play", play, Role::viewer, any_world},
    {"jostle.v1.QueryService/CastRays", query, Role::viewer, any_world},
    {"jostle.v1.QueryService/CastShapes", query, Role::viewer, any_world},
    {"jostle.v1.QueryService/Overlap", query, Role::viewer, any_world},
    {"jostle.v1.QueryService/ClosestPoints", query, Role::viewer, any_world},
    {"jostle.v1.QueryService/Debug", query, Role::viewer, any_world},
    {"jostle.v1.QueryService/Inspect", query, Role::viewer, any_world},
    {"jostle.v1.AdminService/GetServerStatus", admin_read, Role::admin, token_worlds},
    {"jostle.v1.AdminService/ListClients", admin, Role::admin, token_worlds},
    {"jostle.v1.AdminService/ListReports", admin, Role::admin, token_worlds},
    {"jostle.v1.AdminService/Kick", admin, Role::admin, token_worlds},
    {"jostle.v1.AdminService/Backup", admin, Role::admin, server},
    {"jostle.v1.AdminService/Ban", admin, Role::admin, server},
    {"jostle.v1.AdminService/Unban", admin, Role::admin, server},
    {"jostle.v1.AdminService/ListBans", admin, Role::admin, server},
    {"jostle.v1.AdminService/SetPaused", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/StepWorld", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/ExportWorld", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/DownloadWorld", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/RemoveBodies", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/GetRoom", admin_read, Role::admin, any_world},
    {"jostle.v1.AdminService/ModerateRoom", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/RewindWorld", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/UndoClient", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/ListPlayers", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/SetPlayerRole", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/GetAttributes", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/SetAttributes", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/SendMessage", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/ApplyInput", admin, Role::admin, any_world},
    {"jostle.v1.AdminService/Drain", admin, Role::admin, server},
    {"jostle.v1.AdminService/Profile", admin, Role::admin, any_world},
    {"grpc.health.v1.Health/Check", open, Role::none, none},
    {"grpc.health.v1.Health/Watch", open, Role::none, none},
    {"grpc.reflection.v1.ServerReflection/ServerReflectionInfo", read, Role::viewer, none},
    {"grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", read, Role::viewer, none},

    {play_inputs, inputs, Role::player, any_world},

    {"GET /api/worlds", read, Role::viewer, token_worlds},
    {"GET /api/worlds/{id}", read, Role::viewer, any_world},
    {"POST /api/worlds", create, Role::director, server},
    {"DELETE /api/worlds/{id}", remove, Role::director, own_world},
    {"POST /api/worlds/{id}/join", join, Role::viewer, any_world},
    {"POST /api/join-or-create", join, Role::viewer, token_worlds},
    // GET: whether the caller may resume the world.
    {"GET /api/worlds/{id}/resume", admin, Role::director, own_world},
    {"POST /api/worlds/{id}/resume", admin, Role::director, own_world},
    // The world as a scene file.
    {"GET /api/worlds/{id}/scene", admin, Role::director, own_world},
    // Admitted once more as the method of AdminService.
    {"POST /api/admin/{method}", admin, Role::admin, any_world},
    {"POST /api/query/{method}", query, Role::viewer, any_world},
    {"GET /play", play, Role::viewer, any_world},
    {"GET /healthz", open, Role::none, none},
    {"GET /readyz", open, Role::none, none},
    // The admin listener is on loopback or requires a client certificate. Metrics identify no
    // client.
    {"GET /metrics", open, Role::none, none},
    {"GET /debug/profile", admin, Role::admin, any_world},
    // Must be last: it matches every path that no other row matches.
    {"GET /{file}", open, Role::none, none},
};

constexpr std::string_view viewer_files = "GET /{file}";
constexpr std::array<std::string_view, 2> not_files = {"/api", "/debug"};

// Removes the next segment from a path with a leading '/' and returns it without the '/'.
std::string_view take_segment(std::string_view& path) {
    ASSERT(path.starts_with('/'));
    path.remove_prefix(1);
    const std::string_view part = path.substr(0, path.find('/'));
    path.remove_prefix(part.size());
    return part;
}

// "/api/worlds/{id}" matches "/api/worlds/w1": a segment in braces matches any one non-empty
// segment.
bool matches(std::string_view pattern, std::string_view path) {
    while (!pattern.empty() && !path.empty()) {
        const std::string_view expected = take_segment(pattern), actual = take_segment(path);
        const bool any = expected.starts_with('{');
        if (any ? actual.empty() : expected != actual) return false;
    }
    return pattern.empty() && path.empty();
}

bool may_be_file(std::string_view path) {
    for (const std::string_view folder : not_files)
        if (path == folder || path.starts_with(std::string(folder) + "/")) return false;
    return true;
}

}  // namespace

std::string_view name_of(CallKind kind) {
    static constexpr std::array<std::string_view, 10> names = {
        "open",   "read",   "query",  "join",  "play",
        "inputs", "create", "delete", "admin", "admin_read"};
    ASSERT(static_cast<std::size_t>(kind) < names.size());
    return names[static_cast<std::size_t>(kind)];
}

std::span<const AccessRow> access_table() {
    return table;
}

const AccessRow* find_call(std::string_view call) {
    if (call.starts_with('/')) call.remove_prefix(1);
    for (const AccessRow& row : table)
        if (row.call == call) return &row;
    return nullptr;
}

const AccessRow* find_route(std::string_view method, std::string_view path) {
    if (!path.starts_with('/')) return nullptr;
    if (method == "HEAD") method = "GET";
    for (const AccessRow& row : table) {
        const std::size_t space = row.call.find(" /");
        if (space == std::string_view::npos || row.call == viewer_files) continue;
        if (row.call.substr(0, space) == method && matches(row.call.substr(space + 1), path))
            return &row;
    }
    return method == "GET" && may_be_file(path) ? find_call(viewer_files) : nullptr;
}

}  // namespace jostle::server

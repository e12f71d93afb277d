// SPDX-License-Identifier: MIT
//
// The access rules in one table: a row for each RPC, each HTTP route, and for the inputs within a
// play stream. authorizer.h evaluates it, docs/guides/operator/secure.md documents it, and a test
// compares it with the services: a new RPC without a row fails that test and is rejected at run
// time.
#pragma once

#include <span>
#include <string_view>

#include "server/auth/identity.h"

namespace jostle::server {

// The kind of a call selects its quota, and whether the audit log records granted calls. Refusals
// are always recorded. admin_read: calls that monitors repeat every second.
enum class CallKind { open, read, query, join, play, inputs, create, remove, admin, admin_read };

std::string_view name_of(CallKind kind);

// The object of a call.
enum class Scope {
    none,          // the API itself or its health; a token for certain worlds suffices
    server,        // the server as a whole; refused to tokens that are limited to certain worlds
    token_worlds,  // every world that the token opens; the handler skips all others
    any_world,     // one world, of any owner
    own_world,     // one world; callers below admin must own it
};

struct AccessRow {
    std::string_view call;  // "package.Service/Method", "METHOD /path/{part}", or play_inputs
    CallKind kind;
    Role min_role;
    Scope scope;
};

// Required in addition to the row of the stream, unless the client is a spectator.
inline constexpr std::string_view play_inputs = "play inputs";

std::span<const AccessRow> access_table();

// The row with that name, or of an RPC with a leading '/', as gRPC passes it; null: none.
const AccessRow* find_call(std::string_view call);

// The row of a request. `path` excludes the query; HEAD counts as GET. A GET outside the APIs and
// the admin routes is a file of the viewer. Null: no such route.
const AccessRow* find_route(std::string_view method, std::string_view path);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// Who may do what, in one table: a row for each RPC, each HTTP route, and for the inputs within a
// play stream. authorizer.h decides by it, docs/operations.md prints it, and a test holds it
// against the services: a new RPC without a row fails there, and is refused here.
#pragma once

#include <span>
#include <string_view>

#include "server/auth/identity.h"

namespace jostle::server {

// What a call is: which quota pays for it, and whether the audit log tells of its grants (refusals
// it always tells of).
enum class CallKind { open, read, query, join, play, inputs, create, remove, admin };

std::string_view name_of(CallKind kind);

// What a call touches.
enum class Scope {
    server,     // no world, or all
    any_world,  // one; whose it is does not matter
    own_world,  // one; below admin only one's own
};

struct AccessRow {
    std::string_view call;  // "package.Service/Method", "METHOD /path/{part}", or play_inputs
    CallKind kind;
    Role min_role;
    Scope scope;
};

// A stream that is no spectator's needs this beside its own row.
inline constexpr std::string_view play_inputs = "play inputs";

std::span<const AccessRow> access_table();

// The row of that name, or of an RPC with a '/' before it, as gRPC writes them; null: none.
const AccessRow* find_call(std::string_view call);

// The row of a request. `path` is without the query; HEAD counts as GET. What is neither an API nor
// of the admin listener is a file of the viewer. Null: there is no such route.
const AccessRow* find_route(std::string_view method, std::string_view path);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// The values that labels of metrics may have, each set as an enumeration with its names. Sets are
// small and closed: nothing that a stranger sends becomes a label.
#pragma once

#include <array>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// What became of an input, as InputCode of play.proto.
enum class InputOutcome { applied, invalid, not_found, not_allowed, limit };
constexpr auto names_of(InputOutcome) {
    return std::to_array<std::string_view>(
        {"applied", "invalid", "not_found", "not_allowed", "limit"});
}

enum class SkipReason { window, pending, rate };
constexpr auto names_of(SkipReason) {
    return std::to_array<std::string_view>({"window", "pending", "rate"});
}

enum class Listener { grpc, http, admin };
constexpr auto names_of(Listener) {
    return std::to_array<std::string_view>({"grpc", "http", "admin"});
}

// Why a connection was closed, most of them as soon as they came.
enum class ConnectionRefusal {
    limit,          // the listener has as many as it may
    address_limit,  // ... as many of that address
    handshake,      // TLS could not be agreed on
    busy,           // no thread to answer it: too many wait already
    penalty,        // one of that address was an attack, a moment ago
    attack,         // it sent what no client sends
};
constexpr auto names_of(ConnectionRefusal) {
    return std::to_array<std::string_view>(
        {"limit", "address_limit", "handshake", "busy", "penalty", "attack"});
}

// In the order of ErrorCode.
constexpr auto names_of(ErrorCode) {
    return std::to_array<std::string_view>(
        {"invalid_argument", "not_found", "failed_precondition", "corrupt_data", "already_exists",
         "permission_denied", "unauthenticated", "resource_exhausted", "deadline_exceeded",
         "aborted", "unavailable", "internal"});
}
static_assert(names_of(ErrorCode{}).size() == static_cast<std::size_t>(ErrorCode::internal) + 1);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// The values of metric labels, each set as an enumeration with its names. Sets are small and
// closed: nothing that a client sends becomes a label.
#pragma once

#include <array>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// The result of an input, like InputCode in play.proto.
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

// Why a connection was closed, in most cases right after it was accepted.
enum class ConnectionRefusal {
    limit,          // the listener has its maximum of connections
    address_limit,  // the address has its maximum of connections
    handshake,      // the TLS handshake failed
    busy,           // too many requests wait for a thread
    penalty,        // the address attacked the server recently
    attack,         // it sent frames that no regular client sends
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

// SPDX-License-Identifier: MIT
//
// The one door. Whoever takes calls, by gRPC, HTTP or WebSocket, asks here who is calling, and
// then, for each call, whether he may. Both are told to the audit log. Nothing of a server is
// reached without it but what the access table calls open.
//
//     Result<Identity> who = gate.identify({.bearer = token, .address = peer});
//     Status may = gate.admit(*who, {.call = "jostle.v1.WorldService/DeleteWorld",
//                                    .world = {id, name, owner}, .address = peer});
//     gate.record(*who, same, worlds.remove(...));
//
// Any thread. Only open(), poll() and reload() read files; nothing else waits for anything.
// Refusals are unauthenticated (show a token), permission_denied (it is not enough), or
// resource_exhausted with a time to ask again.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "server/auth/access_table.h"
#include "server/auth/audit_log.h"
#include "server/auth/clock_pair.h"
#include "server/auth/identity.h"
#include "server/auth/key_set.h"
#include "server/auth/quotas.h"
#include "server/auth/tickets.h"
#include "server/config/config.h"

namespace jostle::server {

// What a connection shows of itself.
struct PeerCredentials {
    std::string_view bearer;       // a token without "Bearer "; empty: none
    std::string_view certificate;  // the subject of a client certificate that TLS has verified
    std::string_view address;      // IP address without the port
};

// The world that a call is about; empty fields: none, or not known.
struct WorldTarget {
    std::string_view id, name;
    std::string_view owner;  // subject of who created it; empty: the server itself
};

struct AccessRequest {
    std::string_view call;  // a row of the access table
    WorldTarget world;
    std::string_view address;
};

class Authorizer {
public:
    // Reads the keys and opens the audit log.
    static Result<std::unique_ptr<Authorizer>> open(const Config& config);

    // A token decides, if there is one; then a certificate, whose holder is an admin; who shows
    // neither is anonymous.
    Result<Identity> identify(const PeerCredentials& caller,
                              const ClockPair& now = ClockPair::now());

    Status admit(const Identity& who, const AccessRequest& ask,
                 const ClockPair& now = ClockPair::now());

    // What came of a call that changes something. The world may be known only now.
    void record(const Identity& who, const AccessRequest& ask, const Status& outcome,
                const ClockPair& now = ClockPair::now());

    // For JoinWorld, once it was admitted.
    Result<std::string> issue_ticket(const Identity& who, std::string_view world_id,
                                     std::string_view address,
                                     const ClockPair& now = ClockPair::now());

    struct Entry {
        Identity who;
        std::string world_id;
    };
    // Instead of identify() and admit() of a play stream whose Hello brings a ticket; play_inputs
    // is still to be asked for. `world_id` is the world that Hello names; empty: that of the
    // ticket.
    Result<Entry> redeem_ticket(std::string_view ticket, std::string_view world_id,
                                std::string_view address, const ClockPair& now = ClockPair::now());

    // Every second or so: takes over keys that have changed.
    void poll(const ClockPair& now = ClockPair::now());
    // SIGHUP: reads the keys and opens the audit log's file anew.
    void reload();

    AuditLog& audit() { return *audit_; }

private:
    Authorizer(const Config& config, std::unique_ptr<KeySet> keys, std::unique_ptr<AuditLog> audit);

    Result<Identity> identify_token(const PeerCredentials& caller, const ClockPair& now);
    void audit_login(const Identity& who, std::string_view address, const ClockPair& now);
    void audit_refusal(const AuditEntry& entry, const ClockPair& now);

    const TokenRules rules_;
    const Role anonymous_role_;
    const std::unique_ptr<KeySet> keys_;  // null: no token is believed
    const std::unique_ptr<AuditLog> audit_;
    Quotas quotas_;
    Tickets tickets_;
    std::mutex logins_mutex_;
    LruMap<bool> logins_;  // which were told to the audit log already
};

// The token in an Authorization header, "Bearer TOKEN"; empty: there is no header. Anything else is
// an error.
Result<std::string_view> parse_bearer(std::string_view authorization);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// The single access check of the server. Every transport (gRPC, HTTP, WebSocket) identifies the
// caller here and then admits each call. Both results are written to the audit log. Only calls that
// the access table marks as open are reachable without it.
//
//     Result<Identity> who = authorizer.identify({.bearer = token, .address = peer});
//     Status status = authorizer.admit(*who, {.call = "jostle.v1.WorldService/DeleteWorld",
//                                             .world = {id, name, owner}, .address = peer});
//     authorizer.record(*who, same, worlds.remove(...));
//
// Any thread. Only open(), poll() and reload() read files; no other function blocks. A refusal is
// unauthenticated (send a token), permission_denied (the rights are insufficient), or
// resource_exhausted with a time to retry.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "server/auth/access_table.h"
#include "server/auth/audit_log.h"
#include "server/auth/ban_list.h"
#include "server/auth/identity.h"
#include "server/auth/key_set.h"
#include "server/auth/quotas.h"
#include "server/auth/tickets.h"
#include "server/config/config.h"
#include "server/util/wall_time.h"

namespace jostle::server {

// The credentials that a connection presents.
struct PeerCredentials {
    std::string_view bearer;       // a token without "Bearer "; empty: none
    std::string_view certificate;  // subject of a client certificate verified by TLS
    std::string_view address;      // IP address without the port
};

// The world that a call refers to; fields are empty if there is none or it is unknown.
struct WorldTarget {
    std::string_view id, name;
    std::string owner = {};  // subject of the creator; empty: the server itself
};

struct AccessRequest {
    std::string_view call;  // a row of the access table
    WorldTarget world;
    std::string_view address;
    // For the audit log: what else the call refers to, such as "client 7", and the operator's
    // reason.
    std::string_view target = {}, reason = {};
};

class Authorizer {
public:
    // Reads the keys and the bans, and opens the audit log.
    static Result<std::unique_ptr<Authorizer>> open(const Config& config);

    // A token takes precedence over a client certificate. The holder of a certificate is an admin;
    // a caller with neither is anonymous.
    Result<Identity> identify(const PeerCredentials& caller,
                              const ClockPair& now = ClockPair::now());

    Status admit(const Identity& who, const AccessRequest& request,
                 const ClockPair& now = ClockPair::now());

    // Records the outcome of a call that changes something. The world may be known only now.
    void record(const Identity& who, const AccessRequest& request, const Status& outcome,
                const ClockPair& now = ClockPair::now());

    // For JoinWorld, after it was admitted.
    Result<std::string> issue_ticket(const Identity& who, std::string_view world_id,
                                     std::string_view address,
                                     const ClockPair& now = ClockPair::now());

    struct Entry {
        Identity who;
        std::string world_id;
    };
    // Replaces identify() and admit() for a play stream whose Hello contains a ticket; play_inputs
    // must still be admitted. `world_id` is the world named in the Hello; empty: the world of the
    // ticket.
    Result<Entry> redeem_ticket(std::string_view ticket, std::string_view world_id,
                                std::string_view address, const ClockPair& now = ClockPair::now());

    // Whether a session of this caller may begin or continue: its token has not expired, the key
    // that signed it is still trusted, and the caller is not banned. Neither counted nor audited.
    // Errors: unauthenticated, or permission_denied for a ban.
    Status check_session(const Identity& who, std::string_view address,
                         const ClockPair& now = ClockPair::now()) const;
    // Changes whenever check_session() may return another result before the token expires.
    std::uint64_t revision() const {
        return revision_.load(std::memory_order_acquire) + bans_->revision();
    }

    // A banned caller may call only what is open to everybody. Administrators at the address of a
    // banned network may still call AdminService, to remove the ban.
    BanList& bans() { return *bans_; }

    // Call about once per second: loads keys that have changed.
    void poll(const ClockPair& now = ClockPair::now());
    // SIGHUP: reloads the keys and reopens the audit log.
    void reload();

    AuditLog& audit() { return *audit_; }

private:
    Authorizer(const Config& config, std::unique_ptr<KeySet> keys, std::unique_ptr<AuditLog> audit,
               std::unique_ptr<BanList> bans);

    Status check_ban(const Identity& who, const AccessRow* row, std::string_view address,
                     WallTime now) const;
    bool key_is_trusted(const Identity& who) const;
    Result<Identity> identify_token(const PeerCredentials& caller, const ClockPair& now);
    void audit_login(const Identity& who, std::string_view address, const ClockPair& now);
    void audit_refusal(const AuditEntry& entry, const ClockPair& now);

    const TokenRules rules_;
    const Role anonymous_role_;
    const std::unique_ptr<KeySet> keys_;  // null: every token is rejected
    const std::unique_ptr<AuditLog> audit_;
    const std::unique_ptr<BanList> bans_;
    Quotas quotas_;
    Tickets tickets_;
    std::atomic<std::uint64_t> revision_{0};
    std::mutex logins_mutex_;
    LruMap<bool> logins_;  // true: already recorded in the audit log
};

// The token in an Authorization header, "Bearer TOKEN"; empty if there is no header. Any other form
// is an error.
Result<std::string_view> parse_bearer(std::string_view authorization);

}  // namespace jostle::server

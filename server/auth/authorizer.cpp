// SPDX-License-Identifier: MIT
#include "server/auth/authorizer.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>

#include "jostle/base/check.h"
#include "server/config/exposure.h"
#include "server/util/address.h"

namespace jostle::server {

namespace {

constexpr std::size_t logins_max = 10000;

Error unauthenticated(std::string message) {
    return {ErrorCode::unauthenticated, std::move(message)};
}
Error denied(std::string message) {
    return {ErrorCode::permission_denied, std::move(message)};
}
Error rate_limited(std::string_view what, Clock::duration wait) {
    const double seconds = to_ms(wait) / 1000;
    return {ErrorCode::resource_exhausted,
            fmt::format("too many {}; retry in {:.1f} s", what, seconds),
            static_cast<int>(to_ms(wait))};
}

// The account that tickets are counted for. All anonymous callers share one subject but are not one
// person, so they are counted by address. The prefix separates a subject from an address with the
// same text.
std::string account_of(const Identity& who, std::string_view address) {
    return who.anonymous ? "address " + network_of(address) : "subject " + who.subject;
}
std::string_view quota_subject_of(const Identity& who) {
    return who.anonymous ? std::string_view{} : std::string_view(who.subject);
}

struct QuotaCharge {
    QuotaKind work;
    std::string_view name;
};
std::optional<QuotaCharge> quota_for(CallKind kind) {
    switch (kind) {
        case CallKind::create:
            return QuotaCharge{QuotaKind::creates, "new worlds"};
        case CallKind::join:
        case CallKind::play:
            return QuotaCharge{QuotaKind::joins, "joins"};
        case CallKind::query:
            return QuotaCharge{QuotaKind::queries, "queries"};
        default:
            return std::nullopt;
    }
}

bool audits_grants(CallKind kind) {
    switch (kind) {
        case CallKind::join:
        case CallKind::play:
        case CallKind::create:
        case CallKind::remove:
        case CallKind::admin:
            return true;
        default:
            return false;
    }
}

AuditEntry entry_of(const Identity& who, std::string_view address, const ClockPair& now) {
    return {.time = now.wall,
            .subject = who.subject,
            .role = name_of(who.role),
            .token_id = who.token_id,
            .address = address};
}

AuditEntry entry_of(const Identity& who, const AccessRequest& request, const ClockPair& now) {
    AuditEntry entry = entry_of(who, request.address, now);
    const AccessRow* row = find_call(request.call);
    entry.what = row ? name_of(row->kind) : "unknown";
    entry.call = request.call;
    entry.world = request.world.id;
    entry.target = request.target;
    entry.reason = request.reason;
    return entry;
}

Status check_role(const Identity& who, const AccessRow& row) {
    if (who.role >= row.min_role) return {};
    const std::string needed = fmt::format("this call requires the role {}", name_of(row.min_role));
    if (who.anonymous) return unauthenticated(needed + "; send a token (Authorization: Bearer)");
    return denied(fmt::format("{}; your role is {}", needed, name_of(who.role)));
}

// A token for certain worlds gives access to no other world and to nothing that affects the server
// as a whole: an administrator of one world is not an administrator of the server.
Status check_worlds_of_token(const Identity& who, const AccessRow& row, const WorldTarget& world) {
    if (!who.is_limited_to_worlds()) return {};
    switch (row.scope) {
        case Scope::none:
        case Scope::token_worlds:
            return {};
        case Scope::server:
            return denied(
                "this call concerns the entire server; the token is limited to certain worlds "
                "(claim world)");
        case Scope::any_world:
        case Scope::own_world:
            break;
    }
    if (who.opens(world.id, world.name)) return {};
    return denied("the token is for another world");
}

Status check_owner(const Identity& who, const AccessRow& row, const WorldTarget& world) {
    if (row.scope != Scope::own_world || who.role >= Role::admin) return {};
    if (!world.owner.empty() && world.owner == who.subject) return {};
    return denied("this world has another owner; only its owner or an admin may do this");
}

Status check_rights(const Identity& who, const AccessRow* row, const WorldTarget& world,
                    const ClockPair& now) {
    if (!row) return denied("this call is not in the access table");
    if (row->kind == CallKind::open) return {};
    if (now.wall >= who.expires) return unauthenticated("the token has expired");
    if (Status s = check_role(who, *row); !s.ok()) return s;
    if (Status s = check_worlds_of_token(who, *row, world); !s.ok()) return s;
    return check_owner(who, *row, world);
}

// Next to the database, because bans outlive the process as worlds do.
std::string bans_file(const PersistenceSettings& persistence) {
    return persistence.is_on() ? persistence.database + ".bans.json" : std::string();
}

std::string_view reason_of(TicketStatus ticket_status) {
    switch (ticket_status) {
        case TicketStatus::good:
            return "";
        case TicketStatus::unknown:
            return "the ticket is unknown";
        case TicketStatus::used:
            return "the ticket was already used";
        case TicketStatus::expired:
            return "the ticket has expired";
    }
    return "";
}

}  // namespace

Result<std::unique_ptr<Authorizer>> Authorizer::open(const Config& config) {
    std::unique_ptr<KeySet> keys;
    if (!config.auth.keys.empty()) {
        Result<std::unique_ptr<KeySet>> opened = KeySet::open(config.auth.keys);
        if (!opened.ok()) return opened.error();
        keys = std::move(*opened);
    }
    Result<std::unique_ptr<AuditLog>> audit = AuditLog::open(config.auth.audit_log);
    if (!audit.ok()) return audit.error();
    Result<std::unique_ptr<BanList>> bans = BanList::open(bans_file(config.persistence));
    if (!bans.ok()) return bans.error();
    return std::unique_ptr<Authorizer>(
        new Authorizer(config, std::move(keys), std::move(*audit), std::move(*bans)));
}

Authorizer::Authorizer(const Config& config, std::unique_ptr<KeySet> keys,
                       std::unique_ptr<AuditLog> audit, std::unique_ptr<BanList> bans)
    : rules_{.issuer = config.auth.issuer,
             .audience = config.auth.audience,
             .leeway = std::chrono::seconds(config.auth.leeway_seconds)},
      anonymous_role_(parse_role(anonymous_role(config)).value_or(Role::none)),
      keys_(std::move(keys)),
      audit_(std::move(audit)),
      bans_(std::move(bans)),
      quotas_(config.quota),
      logins_(logins_max) {}

Result<Identity> Authorizer::identify(const PeerCredentials& caller, const ClockPair& now) {
    if (caller.bearer.empty() && caller.certificate.empty())
        return Identity{.role = anonymous_role_};
    Result<Identity> who =
        !caller.bearer.empty()
            ? identify_token(caller, now)
            : Identity{.subject = std::string(certificate_prefix) + std::string(caller.certificate),
                       .role = Role::admin,
                       .anonymous = false};
    if (who.ok()) audit_login(*who, caller.address, now);
    return who;
}

// Verifying a signature is the most expensive work that an unauthenticated client can cause. An
// address whose tokens are refused repeatedly must therefore wait, even with a valid token.
Result<Identity> Authorizer::identify_token(const PeerCredentials& caller, const ClockPair& now) {
    const std::string network = network_of(caller.address);
    ASSERT(!caller.bearer.empty());
    AuditEntry entry{.time = now.wall, .what = "login", .outcome = "refused"};
    entry.address = caller.address;
    const auto refuse = [&](Error error) {
        entry.reason = error.message;
        audit_refusal(entry, now);
        return error;
    };
    const Quotas::QuotaDecision quota =
        quotas_.peek(QuotaKind::refused_logins, {}, network, now.steady);
    if (!quota.granted) return refuse(rate_limited("refused tokens", quota.retry_after));
    Result<Identity> who =
        keys_ ? verify_token(caller.bearer, *keys_->keys(), rules_, now.wall)
              : unauthenticated("this server accepts no tokens: auth.keys is not set");
    if (who.ok()) return who;
    quotas_.take(QuotaKind::refused_logins, {}, network, now.steady);
    return refuse(who.error());
}

Status Authorizer::admit(const Identity& who, const AccessRequest& request, const ClockPair& now) {
    const AccessRow* row = find_call(request.call);
    Status status = check_rights(who, row, request.world, now);
    if (status.ok()) status = check_ban(who, row, request.address, now.wall);
    if (const std::optional<QuotaCharge> charge = row ? quota_for(row->kind) : std::nullopt;
        status.ok() && charge) {
        const Quotas::QuotaDecision quota = quotas_.take(charge->work, quota_subject_of(who),
                                                         network_of(request.address), now.steady);
        if (!quota.granted) status = rate_limited(charge->name, quota.retry_after);
    }
    AuditEntry entry = entry_of(who, request, now);
    entry.outcome = status.ok() ? "granted" : "refused";
    ASSERT(row || !status.ok());
    if (!status.ok()) {
        entry.reason = status.error().message;
        audit_refusal(entry, now);
    } else if (audits_grants(row->kind)) {
        audit_->record(entry);
    }
    return status;
}

void Authorizer::record(const Identity& who, const AccessRequest& request, const Status& outcome,
                        const ClockPair& now) {
    AuditEntry entry = entry_of(who, request, now);
    entry.outcome = outcome.ok() ? "done" : "failed";
    if (!outcome.ok()) entry.reason = outcome.error().message;
    audit_->record(entry);
}

Result<std::string> Authorizer::issue_ticket(const Identity& who, std::string_view world_id,
                                             std::string_view address, const ClockPair& now) {
    return tickets_.issue(who, account_of(who, address), std::string(world_id), now.steady);
}

// Only the audit log records why a ticket was rejected: the reason would help an attacker who
// guesses tickets.
Result<Authorizer::Entry> Authorizer::redeem_ticket(std::string_view ticket,
                                                    std::string_view world_id,
                                                    std::string_view address,
                                                    const ClockPair& now) {
    Tickets::Redeemed redeemed = tickets_.redeem(ticket, now.steady);
    std::string_view reason = reason_of(redeemed.ticket_status);
    if (reason.empty() && !world_id.empty() && world_id != redeemed.world_id)
        reason = "the ticket is for another world";
    if (reason.empty() && now.wall >= redeemed.who.expires)
        reason = "the token behind the ticket has expired";
    if (reason.empty() && !key_is_trusted(redeemed.who))
        reason = "the key of the token behind the ticket was removed";
    AuditEntry entry = entry_of(redeemed.who, address, now);
    entry.what = "ticket";
    entry.world = redeemed.world_id;
    entry.outcome = reason.empty() ? "granted" : "refused";
    entry.reason = reason;
    const Status ban = check_ban(redeemed.who, nullptr, address, now.wall);
    if (reason.empty() && !ban.ok()) {
        entry.outcome = "refused";
        entry.reason = ban.error().message;
        audit_refusal(entry, now);
        return ban.error();
    }
    if (reason.empty()) {
        audit_->record(entry);
        return Entry{std::move(redeemed.who), std::move(redeemed.world_id)};
    }
    audit_refusal(entry, now);
    return unauthenticated(
        "the ticket is invalid or no longer valid; get a new one from JoinWorld");
}

// A key is compared by its value: a new key under the name of the old one does not stand for it.
bool Authorizer::key_is_trusted(const Identity& who) const {
    if (who.key.empty() || !keys_) return true;
    return std::ranges::any_of(*keys_->keys(),
                               [&](const auto& key) { return key.second.id() == who.key; });
}

// `row`: null for a play session.
Status Authorizer::check_ban(const Identity& who, const AccessRow* row, std::string_view address,
                             WallTime now) const {
    if (row && row->kind == CallKind::open) return {};
    const std::optional<Ban> ban = bans_->find(quota_subject_of(who), address, now);
    if (!ban) return {};
    const bool is_operator = row &&
                             (row->kind == CallKind::admin || row->kind == CallKind::admin_read) &&
                             who.role == Role::admin;
    if (is_operator && ban->target.network) return {};
    return denied(refusal_text(*ban));
}

Status Authorizer::check_session(const Identity& who, std::string_view address,
                                 const ClockPair& now) const {
    if (Status s = check_ban(who, nullptr, address, now.wall); !s.ok()) return s;
    if (now.wall >= who.expires)
        return unauthenticated("the token of the session has expired; resume with a new token");
    if (!key_is_trusted(who))
        return unauthenticated(
            "the key that signed the token of the session was removed; resume with a new token");
    return {};
}

void Authorizer::poll(const ClockPair& now) {
    if (!keys_) return;
    const auto before = keys_->keys();
    keys_->poll(now.steady);
    if (keys_->keys() != before) revision_.fetch_add(1, std::memory_order_release);
}

void Authorizer::reload() {
    if (keys_) keys_->reload();
    revision_.fetch_add(1, std::memory_order_release);
    audit_->reopen();
}

// Records one line per token and address, not one per call.
void Authorizer::audit_login(const Identity& who, std::string_view address, const ClockPair& now) {
    const std::string key = fmt::format("{}\n{}\n{}\n{}", who.subject, address, who.token_id,
                                        who.expires.time_since_epoch().count());
    {
        const std::lock_guard lock(logins_mutex_);
        if (std::exchange(logins_.find_or_make(key, [] { return false; }), true)) return;
    }
    AuditEntry entry = entry_of(who, address, now);
    entry.what = "login";
    entry.outcome = "granted";
    audit_->record(entry);
}

// Repeated refusals of one address must not fill the disk.
void Authorizer::audit_refusal(const AuditEntry& entry, const ClockPair& now) {
    const std::string network = network_of(entry.address);
    if (quotas_.take(QuotaKind::audited_refusals, {}, network, now.steady).granted) {
        audit_->record(entry);
    } else {
        audit_->mute();
    }
}

Result<std::string_view> parse_bearer(std::string_view authorization) {
    if (authorization.empty()) return std::string_view{};
    constexpr std::string_view scheme = "bearer ";
    bool has_scheme = authorization.size() > scheme.size();
    for (std::size_t i = 0; has_scheme && i < scheme.size(); ++i)
        has_scheme = (authorization[i] | (scheme[i] == ' ' ? 0 : 0x20)) == scheme[i];
    if (!has_scheme) return unauthenticated("the Authorization header is not \"Bearer TOKEN\"");
    ASSERT(authorization.size() > scheme.size());
    return authorization.substr(scheme.size());
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// Tickets for joining a world: JoinWorld issues a ticket, and a client's Hello redeems it within 30
// s, once. A ticket stands for the identity that requested it, so the stream itself needs no token.
// The number of unused tickets is bounded in total and per holder, and no holder can evict the
// tickets of a holder with fewer. Any thread.
#pragma once

#include <array>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>

#include "jostle/base/result.h"
#include "server/auth/identity.h"
#include "server/util/clock.h"

namespace jostle::server {

struct TicketLimits {
    Clock::duration life = std::chrono::seconds(30);
    // how long used or expired tickets are remembered
    Clock::duration memory = std::chrono::seconds(60);
    std::size_t total_max = 10000;
    std::size_t subject_max = 32;    // per subject
    std::size_t address_max = 1000;  // per address, for anonymous callers
};

enum class TicketStatus { good, unknown, used, expired };

class Tickets {
public:
    explicit Tickets(TicketLimits limits = {}) : limits_(limits) {}

    // Returns 32 hexadecimal digits. `holder` is the account that the limit applies to: a subject
    // or an address. If a holder has too many tickets, its oldest is discarded.
    Result<std::string> issue(const Identity& who, const std::string& holder,
                              const std::string& world_id, Clock::time_point now);

    struct Redeemed {
        TicketStatus ticket_status = TicketStatus::unknown;
        Identity who;          // empty if the ticket is unknown
        std::string world_id;  // empty if the ticket is unknown
    };
    // Consumes the ticket, whatever the status.
    Redeemed redeem(std::string_view ticket, Clock::time_point now);

    std::size_t waiting() const;

    // 16 bytes from which the ticket cannot be derived. A session remembers them, so that its
    // client can show the same ticket again.
    static std::string digest(std::string_view ticket);

private:
    using Key = std::array<std::uint8_t, 16>;
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };
    struct Ticket {
        Identity who;
        std::string holder, world_id;
        Clock::time_point until;  // expires or, once redeemed or expired, is forgotten
        TicketStatus ticket_status = TicketStatus::good;
        std::list<Key>::iterator position, holder_position;
    };
    using Table = std::unordered_map<Key, Ticket, KeyHash>;

    void sweep(Clock::time_point now);
    void retire(Table::iterator ticket, TicketStatus ticket_status, Clock::time_point now);
    void take_from_holder(const Ticket& ticket);
    void forget_oldest_of(const std::string& holder);
    std::size_t count_of(const std::string& holder) const;
    bool make_room_for(const std::string& holder, bool anonymous);

    const TicketLimits limits_;
    mutable std::mutex mutex_;
    Table table_;
    std::list<Key> waiting_;                           // in order of expiry
    std::list<Key> past_;                              // in the order in which they are forgotten
    std::map<std::string, std::list<Key>> by_holder_;  // unused tickets, oldest first
};

}  // namespace jostle::server

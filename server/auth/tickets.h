// SPDX-License-Identifier: MIT
//
// Tickets for joining: JoinWorld gives one, a client's Hello brings it back within 30 s, once. It
// stands for the identity that asked for it, so the stream itself needs no token. How many wait is
// bounded, in total and for each holder, and nobody's tickets can push out those of somebody who
// has fewer. Any thread.
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
    Clock::duration memory = std::chrono::seconds(60);  // of those that are used or expired
    std::size_t total_max = 10000;
    std::size_t subject_max = 32;    // of one subject
    std::size_t address_max = 1000;  // of those who are anonymous at one address
};

enum class TicketStatus { good, unknown, used, expired };

class Tickets {
public:
    explicit Tickets(TicketLimits limits = {}) : limits_(limits) {}

    // 32 hexadecimal digits. `holder` is whom the bound is for: the subject, or an address. Of too
    // many of one holder the oldest goes.
    Result<std::string> issue(const Identity& who, const std::string& holder,
                              const std::string& world_id, Clock::time_point now);

    struct Redeemed {
        TicketStatus ticket_status = TicketStatus::unknown;
        Identity who;          // not of an unknown one
        std::string world_id;  // likewise
    };
    // Whatever comes of it, the ticket is used up.
    Redeemed redeem(std::string_view ticket, Clock::time_point now);

    std::size_t waiting() const;

private:
    using Key = std::array<std::uint8_t, 16>;
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };
    struct Ticket {
        Identity who;
        std::string holder, world_id;
        Clock::time_point until;  // it expires, or is forgotten
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
    std::list<Key> waiting_;                           // in the order in which they expire
    std::list<Key> past_;                              // in the order in which they are forgotten
    std::map<std::string, std::list<Key>> by_holder_;  // of those that wait, the oldest first
};

}  // namespace jostle::server

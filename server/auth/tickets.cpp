// SPDX-License-Identifier: MIT
#include "server/auth/tickets.h"

#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr char digits[] = "0123456789abcdef";

std::string hex_of(std::span<const std::uint8_t> key) {
    std::string text;
    for (const std::uint8_t byte : key) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

int value_of(char digit) {
    const char* at = digit == '\0' ? nullptr : std::strchr(digits, digit);
    return at ? static_cast<int>(at - digits) : -1;
}

std::optional<std::array<std::uint8_t, 16>> key_of(std::string_view text) {
    std::array<std::uint8_t, 16> key;
    if (text.size() != 2 * key.size()) return std::nullopt;
    for (std::size_t i = 0; i < key.size(); ++i) {
        const int high = value_of(text[2 * i]), low = value_of(text[2 * i + 1]);
        if (high < 0 || low < 0) return std::nullopt;
        key[i] = static_cast<std::uint8_t>(high << 4 | low);
    }
    return key;
}

}  // namespace

// Keys are random, so a prefix is a good hash.
std::size_t Tickets::KeyHash::operator()(const Key& key) const {
    std::size_t hash;
    std::memcpy(&hash, key.data(), sizeof hash);
    return hash;
}

Result<std::string> Tickets::issue(const Identity& who, const std::string& holder,
                                   const std::string& world_id, Clock::time_point now) {
    Key key;
    if (::getentropy(key.data(), key.size()) != 0)
        return Error{ErrorCode::internal, "the operating system returned no random bytes"};
    const std::lock_guard lock(mutex_);
    sweep(now);
    if (!make_room_for(holder, who.anonymous))
        return Error{ErrorCode::resource_exhausted, "too many unused tickets; retry later",
                     static_cast<int>(to_ms(limits_.life))};
    std::list<Key>& own = by_holder_[holder];
    table_[key] = {.who = who,
                   .holder = holder,
                   .world_id = world_id,
                   .until = now + limits_.life,
                   .position = waiting_.insert(waiting_.end(), key),
                   .holder_position = own.insert(own.end(), key)};
    ASSERT(waiting_.size() <= limits_.total_max && table_.size() == waiting_.size() + past_.size());
    return hex_of(key);
}

Tickets::Redeemed Tickets::redeem(std::string_view ticket, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    sweep(now);
    const std::optional<Key> key = key_of(ticket);
    const auto at = key ? table_.find(*key) : table_.end();
    if (at == table_.end()) return {};
    const Redeemed redeemed{at->second.ticket_status, at->second.who, at->second.world_id};
    if (redeemed.ticket_status == TicketStatus::good) retire(at, TicketStatus::used, now);
    return redeemed;
}

std::string Tickets::digest(std::string_view ticket) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    const int done =
        EVP_Digest(ticket.data(), ticket.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
    ASSERT(done == 1);
    return done == 1 ? std::string(digest.begin(), digest.begin() + 16) : std::string();
}

std::size_t Tickets::waiting() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size();
}

// All tickets have the same lifetime, so the oldest expires first.
void Tickets::sweep(Clock::time_point now) {
    while (!waiting_.empty()) {
        const auto oldest = table_.find(waiting_.front());
        ASSERT(oldest != table_.end());
        if (oldest->second.until > now) break;
        retire(oldest, TicketStatus::expired, now);
    }
    while (!past_.empty() && table_.at(past_.front()).until <= now) {
        table_.erase(past_.front());
        past_.pop_front();
    }
}

// The ticket is remembered for a while, so that the audit log can distinguish a replay from a
// guess.
void Tickets::retire(Table::iterator at, TicketStatus ticket_status, Clock::time_point now) {
    Ticket& ticket = at->second;
    ASSERT(ticket.ticket_status == TicketStatus::good);
    take_from_holder(ticket);
    past_.splice(past_.end(), waiting_, ticket.position);
    ticket.ticket_status = ticket_status;
    ticket.until = now + limits_.memory;
    ASSERT(table_.size() == waiting_.size() + past_.size());
    if (past_.size() <= limits_.total_max) return;
    table_.erase(past_.front());
    past_.pop_front();
}

void Tickets::take_from_holder(const Ticket& ticket) {
    const auto holder = by_holder_.find(ticket.holder);
    ASSERT(holder != by_holder_.end());
    holder->second.erase(ticket.holder_position);
    if (holder->second.empty()) by_holder_.erase(holder);
}

void Tickets::forget_oldest_of(const std::string& holder) {
    const auto at = table_.find(by_holder_.at(holder).front());
    ASSERT(at != table_.end());
    waiting_.erase(at->second.position);
    take_from_holder(at->second);
    table_.erase(at);
}

std::size_t Tickets::count_of(const std::string& holder) const {
    const auto at = by_holder_.find(holder);
    return at == by_holder_.end() ? 0 : at->second.size();
}

// If the table is full, the holder with the most tickets loses its oldest one, unless the new
// holder would then have more tickets than that holder. The search for the largest holder visits
// all holders, and runs only in that case.
bool Tickets::make_room_for(const std::string& holder, bool anonymous) {
    const std::size_t own = count_of(holder);
    if (own >= (anonymous ? limits_.address_max : limits_.subject_max)) forget_oldest_of(holder);
    if (waiting_.size() < limits_.total_max) return true;
    const auto largest = std::ranges::max_element(
        by_holder_, {}, [](const auto& entry) { return entry.second.size(); });
    ASSERT(largest != by_holder_.end());
    if (largest->second.size() > own + 1) {
        forget_oldest_of(std::string(largest->first));
    } else if (own > 0) {
        forget_oldest_of(holder);
    } else {
        return false;
    }
    return true;
}

}  // namespace jostle::server

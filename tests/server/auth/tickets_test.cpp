// SPDX-License-Identifier: MIT
#include "server/auth/tickets.h"

#include <gtest/gtest.h>

#include <set>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const Identity anna{.subject = "anna", .role = Role::player, .anonymous = false};
const Identity nobody{.role = Role::viewer};

TEST(Tickets, ticket_is_redeemable_once_for_its_issuer_identity) {
    Tickets tickets;
    const Clock::time_point now{};
    const std::string ticket = tickets.issue(anna, "anna", "w1", now).value();
    EXPECT_EQ(ticket.size(), 32u) << "128 bits";
    const Tickets::Redeemed first = tickets.redeem(ticket, now + 29s);
    EXPECT_EQ(first.ticket_status, TicketStatus::good);
    EXPECT_EQ(first.who.subject, "anna");
    EXPECT_EQ(first.who.role, Role::player);
    EXPECT_EQ(first.world_id, "w1");
    EXPECT_EQ(tickets.redeem(ticket, now + 29s).ticket_status, TicketStatus::used);
}

TEST(Tickets, distinguishes_used_expired_and_unknown_tickets_for_one_minute) {
    Tickets tickets;
    const Clock::time_point now{};
    const std::string used = tickets.issue(anna, "anna", "w1", now).value(),
                      old = tickets.issue(anna, "anna", "w1", now).value();
    EXPECT_EQ(tickets.redeem(used, now).ticket_status, TicketStatus::good);
    EXPECT_EQ(tickets.redeem(old, now + 30s).ticket_status, TicketStatus::expired);
    EXPECT_EQ(tickets.redeem(used, now + 59s).ticket_status, TicketStatus::used);
    EXPECT_EQ(tickets.redeem(used, now + 60s).ticket_status, TicketStatus::unknown);
    EXPECT_EQ(tickets.redeem(old, now + 89s).ticket_status, TicketStatus::expired);
    EXPECT_EQ(tickets.redeem(old, now + 90s).ticket_status, TicketStatus::unknown);
}

TEST(Tickets, malformed_tickets_are_unknown) {
    Tickets tickets;
    const std::string real = tickets.issue(anna, "anna", "w1", {}).value();
    std::string upper = real;
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    for (const std::string& text :
         {std::string(), std::string(32, '0'), std::string(32, 'g'), std::string(1 << 20, 'a'),
          real.substr(1), real + "0", upper + " ", std::string(32, '\0')}) {
        EXPECT_EQ(tickets.redeem(text, {}).ticket_status, TicketStatus::unknown)
            << text.substr(0, 40);
    }
    EXPECT_EQ(tickets.redeem(real, {}).ticket_status, TicketStatus::good);
}

TEST(Tickets, issues_unique_tickets) {
    Tickets tickets;
    std::set<std::string> seen;
    for (int i = 0; i < 10000; ++i)
        EXPECT_TRUE(seen.insert(tickets.issue(nobody, "a", "w1", {}).value()).second);
}

TEST(Tickets, evicts_the_oldest_ticket_of_the_same_holder) {
    Tickets tickets({.subject_max = 3, .address_max = 5});
    const std::string other = tickets.issue(anna, "berta", "w1", {}).value();
    std::vector<std::string> own;
    for (int i = 0; i < 10; ++i) own.push_back(tickets.issue(anna, "anna", "w1", {}).value());
    EXPECT_EQ(tickets.waiting(), 4u);
    EXPECT_EQ(tickets.redeem(other, {}).ticket_status, TicketStatus::good);
    EXPECT_EQ(tickets.redeem(own[6], {}).ticket_status, TicketStatus::unknown);
    for (int i = 7; i < 10; ++i)
        EXPECT_EQ(tickets.redeem(own[i], {}).ticket_status, TicketStatus::good);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(tickets.issue(nobody, "192.0.2.1", "w1", {}).ok());
    EXPECT_EQ(tickets.waiting(), 5u) << "an address may belong to several users";
}

// A flood from one subject does not affect the tickets of others. A flood from many subjects is
// rejected.
TEST(Tickets, does_not_evict_tickets_of_holders_with_fewer) {
    Tickets tickets({.total_max = 100, .subject_max = 1000});
    std::vector<std::string> other_tickets;
    for (int i = 0; i < 10; ++i)
        other_tickets.push_back(tickets.issue(anna, "h" + std::to_string(i), "w1", {}).value());
    for (int i = 0; i < 1000; ++i) EXPECT_TRUE(tickets.issue(anna, "flood", "w1", {}).ok());
    EXPECT_EQ(tickets.waiting(), 100u);
    // New subjects evict tickets of the subject with the most tickets, until no subject has two
    // more than they do.
    int issued = 0;
    Result<std::string> last = std::string();
    for (int i = 0; i < 200; ++i) {
        last = tickets.issue(anna, "n" + std::to_string(i), "w1", {});
        if (last.ok()) ++issued;
    }
    EXPECT_EQ(issued, 89) << "100 minus 10 of other subjects minus 1 of the flood";
    ASSERT_FALSE(last.ok());
    EXPECT_EQ(last.error().code, ErrorCode::resource_exhausted);
    EXPECT_EQ(last.error().retry_after_ms, 30000);
    for (const std::string& ticket : other_tickets)
        EXPECT_EQ(tickets.redeem(ticket, {}).ticket_status, TicketStatus::good);
    const Clock::time_point later = Clock::time_point{} + 30s;
    EXPECT_TRUE(tickets.issue(anna, "later", "w1", later).ok());
    EXPECT_EQ(tickets.waiting(), 1u);
}

TEST(Tickets, bounds_the_number_of_remembered_tickets) {
    Tickets tickets({.total_max = 10});
    std::vector<std::string> used;
    for (int i = 0; i < 25; ++i) {
        used.push_back(tickets.issue(anna, "anna", "w1", {}).value());
        EXPECT_EQ(tickets.redeem(used.back(), {}).ticket_status, TicketStatus::good);
    }
    EXPECT_EQ(tickets.redeem(used[14], {}).ticket_status, TicketStatus::unknown);
    EXPECT_EQ(tickets.redeem(used[15], {}).ticket_status, TicketStatus::used);
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/world/command_mailbox.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

std::vector<ClientId> clients_of(std::span<const Command> commands) {
    std::vector<ClientId> clients;
    for (const Command& command : commands) clients.push_back(command.client);
    return clients;
}

using Clients = std::vector<ClientId>;

TEST(CommandMailbox, joins_come_before_inputs_and_leaves_after_them) {
    CommandMailbox mailbox(16);
    EXPECT_TRUE(mailbox.is_empty());
    mailbox.join(3, {.name = "cy"});
    mailbox.push({.client = 3, .sequence = 1, .action = ReleaseCommand{}, .reply = nullptr});
    mailbox.leave(3, false);
    EXPECT_FALSE(mailbox.is_empty());
    mailbox.take_due(2);
    EXPECT_EQ(clients_of(mailbox.join_commands()), Clients{3});
    EXPECT_EQ(clients_of(mailbox.inputs()), Clients{3});
    EXPECT_EQ(clients_of(mailbox.leave_commands()), Clients{3});
    EXPECT_TRUE(mailbox.late_join_commands().empty());
    mailbox.take_due(3);
    EXPECT_TRUE(mailbox.join_commands().empty() && mailbox.leave_commands().empty());
}

TEST(CommandMailbox, a_client_that_resumes_within_a_tick_joins_after_its_disconnection) {
    CommandMailbox mailbox(16);
    mailbox.disconnect(3);
    mailbox.join(3, {.name = "cy"});
    mailbox.join(4, {.name = "dora"});
    mailbox.take_due(2);
    EXPECT_EQ(clients_of(mailbox.join_commands()), Clients{4});
    EXPECT_EQ(clients_of(mailbox.leave_commands()), Clients{3});
    EXPECT_EQ(clients_of(mailbox.late_join_commands()), Clients{3});
}

TEST(CommandMailbox, the_last_disconnection_of_a_tick_counts) {
    CommandMailbox mailbox(16);
    mailbox.disconnect(3);
    mailbox.join(3, {});
    mailbox.disconnect(3);
    mailbox.take_due(2);
    EXPECT_EQ(clients_of(mailbox.leave_commands()), (Clients{3, 3}));
    EXPECT_TRUE(mailbox.late_join_commands().empty());
    EXPECT_TRUE(mailbox.join_commands().empty());
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/world/scheduled_inputs.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

Command scheduled_input(ClientId client, std::uint32_t sequence, std::uint32_t tick) {
    return {.client = client, .sequence = sequence, .action = ReleaseCommand{}, .tick = tick};
}

// What comes out in a tick, as client * 100 + sequence.
std::vector<std::uint32_t> taken_at(ScheduledInputs& early, std::uint32_t tick,
                                    std::vector<Command> batch,
                                    const std::vector<Command>& leave_commands = {}) {
    early.select_due(batch, tick, leave_commands);
    std::vector<std::uint32_t> out;
    for (const Command& command : batch) out.push_back(command.client * 100 + command.sequence);
    return out;
}

using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST(ScheduledInputs, wait_for_their_tick) {
    ScheduledInputs early(100);
    EXPECT_EQ(taken_at(early, 10, {scheduled_input(1, 1, 12), scheduled_input(2, 1, 0)}),
              Numbers{201});
    EXPECT_EQ(taken_at(early, 11, {scheduled_input(3, 1, 11)}), Numbers{301});
    EXPECT_EQ(taken_at(early, 12, {scheduled_input(3, 2, 0)}), (Numbers{101, 302}));
    EXPECT_EQ(taken_at(early, 13, {}), Numbers{});
}

TEST(ScheduledInputs, preserve_order_per_client) {
    ScheduledInputs early(100);
    EXPECT_EQ(taken_at(early, 10, {scheduled_input(1, 1, 12), scheduled_input(1, 2, 0)}),
              Numbers{});
    EXPECT_EQ(taken_at(early, 11, {scheduled_input(1, 3, 11)}), Numbers{});
    EXPECT_EQ(taken_at(early, 12, {}), (Numbers{101, 102, 103}));
}

TEST(ScheduledInputs, wait_at_most_16_ticks) {
    ScheduledInputs early(100);
    EXPECT_EQ(taken_at(early, 10, {scheduled_input(1, 1, 0xffffffff)}), Numbers{});
    for (std::uint32_t tick = 11; tick < 26; tick++) EXPECT_TRUE(taken_at(early, tick, {}).empty());
    EXPECT_EQ(taken_at(early, 26, {}), Numbers{101});
}

TEST(ScheduledInputs, are_applied_before_the_client_leaves) {
    ScheduledInputs early(100);
    taken_at(early, 10, {scheduled_input(1, 1, 14), scheduled_input(2, 1, 14)});
    EXPECT_EQ(taken_at(early, 11, {scheduled_input(1, 2, 15)}, {scheduled_input(1, 0, 0)}),
              (Numbers{101, 102}));
    EXPECT_EQ(taken_at(early, 14, {}), Numbers{201});
}

TEST(ScheduledInputs, are_all_released_on_overflow) {
    ScheduledInputs early(2);
    EXPECT_TRUE(
        taken_at(early, 10, {scheduled_input(1, 1, 14), scheduled_input(2, 1, 14)}).empty());
    EXPECT_EQ(taken_at(early, 11, {scheduled_input(1, 2, 14)}), (Numbers{101, 201, 102}));
}

}  // namespace jostle::server

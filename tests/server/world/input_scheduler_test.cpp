// SPDX-License-Identifier: MIT
//
// How much of a tick the inputs of one player and of many may take, with costs that the test
// states.
#include "server/world/input_scheduler.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace jostle::server {
namespace {

constexpr double hz = 60;
constexpr double share_s = 0.25 / hz;

struct TickOutcome {
    std::vector<std::pair<AccountId, std::uint32_t>> ran;  // account and sequence
    double seconds = 0;
    std::vector<InputScheduler::Refused> refused;
};

Command input(AccountId account, std::uint32_t sequence, Action action = ExplodeCommand{}) {
    return {.client = static_cast<ClientId>(account),
            .account = account,
            .sequence = sequence,
            .action = std::move(action)};
}

std::vector<Command> inputs(AccountId account, int count, const Action& action = ExplodeCommand{}) {
    std::vector<Command> list;
    for (int i = 1; i <= count; i++)
        list.push_back(input(account, static_cast<std::uint32_t>(i), action));
    return list;
}

TickOutcome tick_with(InputScheduler& scheduler, const std::vector<Command>& due,
                      double explosion_s, const std::vector<Command>& leave_commands = {}) {
    TickOutcome run;
    scheduler.begin_tick(due, leave_commands);
    while (const Command* command = scheduler.next()) {
        run.ran.emplace_back(command->account, command->sequence);
        const double seconds =
            std::holds_alternative<ExplodeCommand>(command->action) ? explosion_s : 1e-5;
        run.seconds += seconds;
        scheduler.charge(seconds);
    }
    run.refused = scheduler.take_refused();
    return run;
}

TEST(InputScheduler, cheap_inputs_run_in_order_of_arrival) {
    InputScheduler scheduler({}, hz);
    const TickOutcome run = tick_with(scheduler, {input(2, 1), input(1, 1), input(2, 2)}, 1e-6);
    EXPECT_EQ(run.ran, (decltype(run.ran){{2, 1}, {1, 1}, {2, 2}}));
    EXPECT_EQ(scheduler.waiting(), 0u);
}

// 840 explosions of 5 ms each: the tick thread would be busy for 4 s.
TEST(InputScheduler, one_player_gets_its_share_of_each_tick_however_many_inputs_it_sends) {
    InputScheduler scheduler({.waiting_max = 1000}, hz);
    double spent = tick_with(scheduler, inputs(1, 840), 5e-3).seconds;
    for (int i = 1; i < 24; i++) spent += tick_with(scheduler, {}, 5e-3).seconds;
    EXPECT_LE(spent, 24 * share_s + 5e-3);
    EXPECT_GE(spent, 23 * share_s);
}

TEST(InputScheduler, another_player_is_not_delayed_by_the_first) {
    InputScheduler scheduler({}, hz);
    tick_with(scheduler, inputs(1, 200), 5e-3);
    for (std::uint32_t i = 1; i <= 20; i++) {
        const TickOutcome run = tick_with(scheduler, {input(2, i, DragCommand{})}, 5e-3);
        ASSERT_FALSE(run.ran.empty());
        EXPECT_EQ(run.ran.back(), (std::pair<AccountId, std::uint32_t>{2, i}));
    }
}

// Twenty players that name one tick, each with 60 expensive inputs.
TEST(InputScheduler, many_players_at_once_do_not_hold_a_tick) {
    InputScheduler scheduler({}, hz);
    std::vector<Command> due;
    for (AccountId account = 1; account <= 20; account++)
        for (const Command& command : inputs(account, 60)) due.push_back(command);
    due.push_back(input(99, 1, DragCommand{}));
    const TickOutcome first = tick_with(scheduler, due, 5e-3);
    EXPECT_LE(first.seconds, 2 * share_s + 2 * 5e-3);
    EXPECT_EQ(first.ran.back().first, 99u) << "a cheap input runs in the same tick";
    double spent = 0;
    for (int i = 0; i < 60; i++) spent += tick_with(scheduler, {}, 5e-3).seconds;
    EXPECT_LE(spent, 60 * share_s + 20 * 5e-3);
}

// A cheap input behind an expensive one: the world accepts only ascending sequence numbers.
TEST(InputScheduler, inputs_of_a_client_run_in_the_order_in_which_it_sent_them) {
    InputScheduler scheduler({}, hz);
    std::uint32_t last = 0;
    for (std::uint32_t i = 0; i < 40; i++) {
        const TickOutcome run =
            tick_with(scheduler, {input(1, 2 * i + 1), input(1, 2 * i + 2, DragCommand{})}, 5e-3);
        for (const auto& [account, sequence] : run.ran) {
            EXPECT_EQ(sequence, last + 1) << "none was overtaken";
            last = sequence;
        }
        for (const auto& refused : run.refused) {
            EXPECT_EQ(refused.command.sequence, last + 1);
            last = refused.command.sequence;
        }
    }
    EXPECT_GT(last, 20u);
}

TEST(InputScheduler, refuses_the_oldest_of_too_many_inputs) {
    InputScheduler scheduler({.waiting_max = 10}, hz);
    const TickOutcome run = tick_with(scheduler, inputs(1, 30), 50e-3);
    ASSERT_EQ(run.refused.size(), 30u - 1 - 10);
    EXPECT_EQ(run.refused.front().command.sequence, 2u);
    EXPECT_EQ(run.refused.back().command.sequence, 20u);
}

// Without authentication, players of one network share an account.
TEST(InputScheduler, a_client_is_not_delayed_by_another_of_its_account) {
    InputScheduler scheduler({}, hz);
    tick_with(scheduler, inputs(1, 200), 5e-3);
    int ran = 0;
    for (std::uint32_t i = 1001; i <= 1060; i++) {
        Command drag = input(1, i, DragCommand{});
        drag.client = 2;
        for (const auto& [account, sequence] : tick_with(scheduler, {drag}, 1e-5).ran)
            ran += sequence == i ? 1 : 0;
    }
    EXPECT_EQ(ran, 60);
}

TEST(InputScheduler, an_input_that_waited_half_a_second_is_refused_with_a_time_to_retry) {
    InputScheduler scheduler({}, hz);
    std::vector<InputScheduler::Refused> refused =
        tick_with(scheduler, inputs(1, 40), 50e-3).refused;
    EXPECT_TRUE(refused.empty());
    int ticks = 1;
    for (; refused.empty() && ticks < 100; ticks++)
        refused = tick_with(scheduler, {}, 50e-3).refused;
    EXPECT_EQ(ticks, 31);
    ASSERT_FALSE(refused.empty());
    EXPECT_EQ(refused[0].status.error().code, ErrorCode::resource_exhausted);
    EXPECT_NE(refused[0].status.error().message.find("retry after 0."), std::string::npos)
        << refused[0].status.error().message;
    EXPECT_GE(refused[0].status.error().retry_after_ms, 100);
    EXPECT_LT(refused[0].status.error().retry_after_ms, 1000);
    EXPECT_EQ(scheduler.waiting(), 0u);
}

TEST(InputScheduler, a_client_holds_256_waiting_inputs) {
    InputScheduler scheduler({}, hz);
    const TickOutcome run = tick_with(scheduler, inputs(1, 400), 50e-3);
    EXPECT_EQ(run.ran.size(), 1u);
    EXPECT_EQ(scheduler.waiting(), 256u);
    EXPECT_EQ(run.refused.size(), 400u - 1 - 256);
}

TEST(InputScheduler, a_leaving_client_has_no_waiting_inputs) {
    InputScheduler scheduler({}, hz);
    tick_with(scheduler, inputs(1, 10), 50e-3);
    const TickOutcome run =
        tick_with(scheduler, {}, 50e-3, {Command{.client = 1, .action = LeaveCommand{}}});
    EXPECT_EQ(run.refused.size(), 9u);
    EXPECT_EQ(scheduler.waiting(), 0u);
}

TEST(InputScheduler, without_a_share_every_input_runs_at_once) {
    InputScheduler scheduler({.tick_share = 0}, hz);
    EXPECT_EQ(tick_with(scheduler, inputs(1, 840), 5e-3).ran.size(), 840u);
}

}  // namespace
}  // namespace jostle::server

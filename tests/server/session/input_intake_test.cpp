// SPDX-License-Identifier: MIT
#include "server/session/input_intake.h"

#include <gtest/gtest.h>

#include "tests/server/session/session_start.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

class InputIntakeTest : public testing::Test {
protected:
    // Inputs that delete entity 1.
    static InputBatch batch(std::uint32_t first, std::size_t count) {
        return {.first_sequence = first,
                .inputs = std::vector<Result<Action>>(count, Action(DeleteCommand{.entity = 1})),
                .ticks = std::vector<std::uint32_t>(count, 0),
                .ack = {}};
    }
    std::size_t pushed() {
        mailbox.take_due(1);
        return mailbox.inputs().size();
    }
    InputIntake intake(bool persisted) {
        return {mailbox, {.client = 7, .persisted = persisted}, limits, queue, start};
    }

    ClientLimits limits;
    CommandMailbox mailbox{3};
    std::shared_ptr<ResultQueue> queue = std::make_shared<ResultQueue>();
};

TEST_F(InputIntakeTest, pushes_each_sequence_once) {
    InputIntake inputs = intake(false);
    ASSERT_TRUE(inputs.receive(batch(1, 2), 50, start).ok());
    ASSERT_TRUE(inputs.receive(batch(2, 2), 50, start).ok());  // 2 is repeated
    EXPECT_EQ(inputs.last_sequence(), 3u);
    EXPECT_EQ(pushed(), 3u);
    EXPECT_TRUE(inputs.results().empty());
}

TEST_F(InputIntakeTest, full_mailbox_yields_a_result_with_the_tick) {
    InputIntake inputs = intake(false);
    ASSERT_TRUE(inputs.receive(batch(1, 4), 50, start).ok());
    ASSERT_EQ(inputs.results().size(), 1u);
    EXPECT_EQ(inputs.results()[0].sequence, 4u);
    EXPECT_EQ(inputs.results()[0].tick, 50u);
    EXPECT_EQ(inputs.results()[0].status.error().code, ErrorCode::resource_exhausted);
}

TEST_F(InputIntakeTest, oversized_batch_is_rejected_entirely) {
    InputIntake inputs = intake(false);
    const Status status = inputs.receive(batch(1, 65), 50, start);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().message, "input.inputs has 65 entries; at most 64 are allowed");
    EXPECT_EQ(inputs.last_sequence(), 0u);
    EXPECT_EQ(pushed(), 0u);
}

TEST_F(InputIntakeTest, persisted_world_confirms_inputs_with_a_result_only) {
    InputIntake inputs = intake(true), volatile_inputs = intake(false);
    ASSERT_TRUE(inputs.receive(batch(1, 3), 50, start).ok());
    EXPECT_EQ(inputs.confirmed(), 0u);
    queue->put({.sequence = 1, .status = {}, .tick = 51, .margin_us = 2'000'000'000});
    queue->put({.sequence = 2, .status = Error{ErrorCode::unavailable, "paused"}, .tick = 51});
    inputs.collect_results();
    EXPECT_EQ(inputs.confirmed(), 1u);
    EXPECT_EQ(inputs.results().size(), 2u);
    const InputIntake::DatagramResult result = inputs.take_datagram_result();
    EXPECT_EQ(result.sequence, 2u);
    EXPECT_EQ(result.margin_us, 1'000'000'000) << "clamped to 1000 s";
    EXPECT_EQ(inputs.take_datagram_result().sequence, 0u);
    ASSERT_TRUE(volatile_inputs.receive(batch(1, 2), 50, start).ok());
    EXPECT_EQ(volatile_inputs.confirmed(), 2u);
}

TEST_F(InputIntakeTest, resumes_with_unsent_results) {
    InputIntake inputs = intake(true);
    inputs.resume(9, 8, {{.sequence = 9, .status = {}, .tick = 40}});
    ASSERT_TRUE(inputs.receive(batch(8, 3), 50, start).ok());
    EXPECT_EQ(pushed(), 1u) << "sequence 10";
    EXPECT_EQ(inputs.confirmed(), 8u);
    EXPECT_EQ(inputs.results()[0].sequence, 9u);
    inputs.on_results_sent();
    EXPECT_TRUE(inputs.results().empty());
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// The same stories as clients/web/src/input_queue.test.ts.
#include "input_queue.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

v1::Input input(std::uint32_t number) {
    v1::Input out;
    out.set_tick(number);
    return out;
}

InputQueue filled(std::uint32_t count) {
    InputQueue queue;
    for (std::uint32_t i = 1; i <= count; i++) EXPECT_EQ(queue.push(input(i)), i);
    return queue;
}

v1::InputBatch taken(InputQueue& queue, std::size_t most) {
    v1::InputBatch batch;
    queue.take(batch, most);
    return batch;
}

TEST(InputQueue, sends_again_what_did_not_come_under_its_numbers_and_nothing_twice) {
    InputQueue queue = filled(10);
    EXPECT_EQ(taken(queue, 8).first_sequence(), 1u);
    for (const std::uint32_t sequence : {1u, 2u, 3u}) EXPECT_TRUE(queue.answered(sequence));
    EXPECT_EQ(queue.go_on_after(5), 3u) << "4 and 5 came; their answers are still to come";
    const v1::InputBatch again = taken(queue, 32);
    EXPECT_EQ(again.first_sequence(), 6u);
    ASSERT_EQ(again.inputs_size(), 5);
    EXPECT_EQ(again.inputs(0).tick(), 6u);
    EXPECT_EQ(again.inputs(4).tick(), 10u);
    EXPECT_FALSE(queue.answered(3)) << "told again, for the server does not know that it came";
    EXPECT_TRUE(queue.answered(4));
    EXPECT_FALSE(queue.answered(4));
    EXPECT_TRUE(queue.answered(10));
    EXPECT_EQ(queue.push(input(11)), 11u);
}

TEST(InputQueue, begins_anew_where_the_server_does_not_know_it_any_more) {
    InputQueue queue = filled(10);
    taken(queue, 8);
    queue.begin_anew();
    const v1::InputBatch batch = taken(queue, 32);
    EXPECT_EQ(batch.first_sequence(), 1u);
    ASSERT_EQ(batch.inputs_size(), 2) << "what was not sent";
    EXPECT_EQ(batch.inputs(0).tick(), 9u);
}

TEST(InputQueue, believes_no_server_that_has_more_than_was_sent) {
    InputQueue queue = filled(3);
    taken(queue, 2);
    EXPECT_EQ(queue.go_on_after(4'000'000'000), 0u);
    EXPECT_EQ(taken(queue, 32).first_sequence(), 3u);
}

}  // namespace
}  // namespace jostle::client

// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/input_outbox.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

using namespace std::chrono_literals;

const Clock::time_point now = Clock::time_point() + 100s;

v1::Input drag(double x = 1) {
    v1::Input input;
    input.mutable_drag()->mutable_target()->set_x(x);
    return input;
}

struct Said {
    std::uint32_t first = 0;
    int count = 0;

    bool operator==(const Said&) const = default;
};

struct InputOutboxTest : testing::Test {
    Said by_stream() {
        v1::InputBatch batch;
        fresh += outbox.take_for_stream(batch);
        return {batch.first_sequence(), batch.inputs_size()};
    }
    Said by_datagram() {
        v1::InputBatch batch;
        fresh += outbox.take_for_datagram(batch, now);
        return {batch.first_sequence(), batch.inputs_size()};
    }
    void push(int count) {
        for (int k = 0; k < count; k++) EXPECT_NE(outbox.push(drag()), 0u);
    }

    InputOutbox outbox;
    std::size_t fresh = 0;
};

}  // namespace

TEST_F(InputOutboxTest, sends_each_input_once_on_the_stream_in_batches_of_32) {
    outbox.start_new_session();
    push(40);
    EXPECT_EQ(by_stream(), (Said{1, 32}));
    EXPECT_EQ(by_stream(), (Said{33, 8}));
    EXPECT_FALSE(outbox.has_for_stream());
    EXPECT_FALSE(outbox.has_unconfirmed()) << "inputs are not stored";
    EXPECT_EQ(fresh, 40u);
}

TEST_F(InputOutboxTest, repeats_unconfirmed_inputs_in_datagrams) {
    outbox.retain_until_confirmed(true);
    push(3);
    EXPECT_EQ(by_datagram(), (Said{1, 3}));
    push(2);
    EXPECT_EQ(by_datagram(), (Said{1, 5}));
    outbox.confirm(3, now);
    EXPECT_EQ(by_datagram(), (Said{4, 2}));
    outbox.confirm(4'000'000'000, now);
    EXPECT_FALSE(outbox.has_unconfirmed());
    EXPECT_EQ(fresh, 5u) << "repeated inputs count once";
    push(1);
    EXPECT_EQ(by_datagram(), (Said{6, 1}));
}

TEST_F(InputOutboxTest, starts_the_stream_with_unconfirmed_inputs_when_it_takes_over) {
    outbox.retain_until_confirmed(true);
    push(3);
    by_datagram();
    outbox.confirm(1, now);
    EXPECT_EQ(by_stream(), (Said{2, 2})) << "the datagram may be lost";
    push(2);
    EXPECT_EQ(by_stream(), (Said{4, 2})) << "a stream loses no inputs";
    EXPECT_FALSE(outbox.has_for_stream());
    EXPECT_EQ(by_datagram(), (Said{2, 4})) << "a datagram that overtakes the stream leaves no gap";
    push(1);
    EXPECT_EQ(by_datagram(), (Said{2, 5}));
    EXPECT_EQ(by_stream(), (Said{2, 5})) << "only a datagram carried the sixth input";
}

TEST_F(InputOutboxTest, reports_oversized_and_stalled_unconfirmed_inputs) {
    outbox.retain_until_confirmed(true);
    push(3);
    EXPECT_TRUE(outbox.fits(100));
    EXPECT_FALSE(outbox.fits(20));
    push(30);
    EXPECT_FALSE(outbox.fits(10'000)) << "more inputs than a batch contains";
    EXPECT_FALSE(outbox.is_stalled(1s, now + 5s)) << "no input was sent";
    by_datagram();
    EXPECT_FALSE(outbox.is_stalled(1s, now + 900ms));
    EXPECT_TRUE(outbox.is_stalled(1s, now + 1100ms));
    outbox.confirm(2, now + 1100ms);
    EXPECT_FALSE(outbox.is_stalled(1s, now + 2s));
}

TEST_F(InputOutboxTest, renumbers_unsent_inputs_on_a_new_stream) {
    outbox.retain_until_confirmed(true);
    push(2);
    by_datagram();
    push(3);
    outbox.start_new_session();
    EXPECT_EQ(by_stream(), (Said{1, 3}));
    EXPECT_EQ(outbox.push(drag()), 4u);
}

TEST_F(InputOutboxTest, resends_only_lost_inputs_after_a_resume) {
    outbox.retain_until_confirmed(true);
    push(10);
    EXPECT_EQ(by_stream(), (Said{1, 10}));
    for (const std::uint32_t sequence : {1u, 2u, 3u}) EXPECT_TRUE(outbox.on_result(sequence, now));
    outbox.resume_after(5, now);  // 4 and 5 arrived; their results are pending
    push(1);
    EXPECT_EQ(by_stream(), (Said{6, 6}));
    EXPECT_EQ(fresh, 11u) << "repeated inputs count once";
    EXPECT_FALSE(outbox.on_result(3, now))
        << "repeated result: the server does not know that it arrived";
    EXPECT_TRUE(outbox.on_result(4, now));
    EXPECT_FALSE(outbox.on_result(4, now));
    for (std::uint32_t sequence = 5; sequence <= 11; sequence++)
        EXPECT_TRUE(outbox.on_result(sequence, now));
    EXPECT_FALSE(outbox.has_unconfirmed());
}

// A server with persistence sends the result of an input when it is durable, and that of a rejected
// input at once.
TEST_F(InputOutboxTest, resends_an_input_without_result_even_if_a_later_one_has_one) {
    outbox.retain_until_confirmed(true);
    push(3);
    EXPECT_EQ(by_stream(), (Said{1, 3}));
    EXPECT_TRUE(outbox.on_result(3, now));
    outbox.resume_after(0, now);  // the server crashed before it persisted anything
    EXPECT_EQ(by_stream(), (Said{1, 3}));
}

TEST_F(InputOutboxTest, ignores_confirmations_beyond_the_last_sent_input) {
    outbox.retain_until_confirmed(true);
    push(33);
    EXPECT_EQ(by_stream(), (Said{1, 32}));
    outbox.resume_after(4'000'000'000, now);
    EXPECT_EQ(by_stream(), (Said{33, 1}));
}

TEST_F(InputOutboxTest, drops_the_oldest_inputs_when_nothing_is_confirmed) {
    outbox.retain_until_confirmed(true);
    for (int k = 0; k < 300; k++) {
        push(32);
        by_stream();
    }
    outbox.resume_after(0, now);
    EXPECT_EQ(by_stream().first, 300u * 32 - 8192 + 1);
}

TEST_F(InputOutboxTest, queues_at_most_4096_unsent_inputs) {
    push(4096);
    EXPECT_EQ(outbox.push(drag()), 0u);
    by_stream();
    EXPECT_EQ(outbox.push(drag()), 4097u);
}

}  // namespace jostle::client

// SPDX-License-Identifier: MIT
#include "server/storage/storage_writer.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/server/storage/faulty_storage.h"
#include "tests/server/storage/journals.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::FaultyState;
using test::FaultyStorage;
using test::JournalMaker;
using test::wait_until;

// A writer over a store that can be made to fail.
struct Desk {
    std::shared_ptr<FaultyState> disk = std::make_shared<FaultyState>();
    std::unique_ptr<StorageWriter> writer;
    JournalMaker journal{"sea"};
    std::atomic<int> done{0}, refused{0};
    Clock::duration slowest{};

    explicit Desk(const StorageWriterSettings& settings = {})
        : writer(std::make_unique<StorageWriter>(std::make_unique<FaultyStorage>(disk), settings)) {
    }

    bool push(StorageChange change) {
        const auto began = Clock::now();
        const bool taken = writer->push(
            std::move(change), [this](const Status& status) { (status.ok() ? done : refused)++; });
        slowest = std::max(slowest, Clock::now() - began);
        return taken;
    }
    // The data of the entries that are written, in their order.
    std::string text() {
        const std::lock_guard lock(disk->mutex);
        std::string all;
        for (const StorageChange& change : disk->written)
            if (const auto* append = std::get_if<AppendEntry>(&change)) all += append->entry.data;
        return all;
    }
};

TEST(StorageWriter, what_twenty_worlds_say_while_the_disk_is_busy_is_one_transaction) {
    Desk desk;
    desk.disk->delay_ms = 30;
    desk.push(desk.journal.next("first"));
    ASSERT_TRUE(wait_until([&] { return desk.writer->pending_bytes() > 0; }));
    std::this_thread::sleep_for(10ms);
    for (int k = 0; k < 20; k++) desk.push(PutWorld{test::stored_world(std::to_string(k))});
    ASSERT_TRUE(desk.writer->flush(5s));
    EXPECT_EQ(desk.done, 21);
    EXPECT_LE(desk.disk->groups.size(), 3u);
    EXPECT_EQ(desk.writer->pending_bytes(), 0u);
}

TEST(StorageWriter, a_disk_that_fails_for_a_while_loses_nothing_and_nobody_waits) {
    for (const ErrorCode code : {ErrorCode::unavailable, ErrorCode::resource_exhausted}) {
        Desk desk;
        desk.disk->fail(Error{code, "the disk is gone"});
        for (const char* text : {"a", "b", "c"}) EXPECT_TRUE(desk.push(desk.journal.next(text)));
        ASSERT_TRUE(wait_until([&] { return desk.writer->failure_reason().has_value(); }));
        EXPECT_EQ(*desk.writer->failure_reason(), "the disk is gone");
        EXPECT_TRUE(desk.push(desk.journal.next("d")));
        EXPECT_EQ(desk.done, 0);
        desk.disk->fail({});
        const auto began = Clock::now();
        ASSERT_TRUE(desk.writer->flush(5s));
        EXPECT_LT(Clock::now() - began, 2s);
        EXPECT_EQ(desk.text(), "abcd");
        EXPECT_EQ(desk.done, 4);
        EXPECT_FALSE(desk.writer->failure_reason());
        EXPECT_LT(to_ms(desk.slowest), 50) << "on a busy machine; a few microseconds otherwise";
    }
}

TEST(StorageWriter, a_disk_that_takes_long_is_told_and_delays_nobody) {
    Desk desk({.timeout = 100ms});
    desk.disk->delay_ms = 500;
    EXPECT_TRUE(desk.push(desk.journal.next("slow")));
    ASSERT_TRUE(wait_until([&] { return desk.writer->failure_reason().has_value(); }));
    EXPECT_EQ(*desk.writer->failure_reason(), "the store takes longer than 100 ms to write");
    EXPECT_TRUE(desk.push(desk.journal.next("er")));
    EXPECT_LT(to_ms(desk.slowest), 50);
    desk.disk->delay_ms = 0;
    ASSERT_TRUE(desk.writer->flush(5s));
    EXPECT_FALSE(desk.writer->failure_reason());
    EXPECT_EQ(desk.text(), "slower");
}

TEST(StorageWriter, beyond_its_buffer_changes_are_refused_until_the_disk_is_back) {
    Desk desk({.bytes_max = 10'000});
    desk.disk->fail(Error{ErrorCode::resource_exhausted, "the disk is full"});
    int taken = 0;
    while (desk.push(desk.journal.next(std::string(1000, 'x')))) taken++;
    EXPECT_EQ(taken, 7);
    desk.disk->fail({});
    ASSERT_TRUE(desk.writer->flush(5s));
    EXPECT_EQ(desk.done, taken);
    EXPECT_TRUE(desk.push(desk.journal.next("again")));
}

TEST(StorageWriter, what_contradicts_the_store_is_left_out_alone) {
    Desk desk;
    desk.disk->delay_ms = 30;
    for (const char* text : {"a", "b"}) desk.push(desk.journal.next(text));
    desk.push(DropWorld{"never there"});
    for (const char* text : {"c", "d"}) desk.push(desk.journal.next(text));
    ASSERT_TRUE(desk.writer->flush(5s));
    EXPECT_EQ(desk.text(), "abcd");
    EXPECT_EQ(desk.done, 4);
    EXPECT_EQ(desk.refused, 1);
}

TEST(StorageWriter, at_the_end_it_writes_what_waits_or_says_that_it_could_not) {
    Desk desk;
    desk.disk->delay_ms = 20;
    for (const char* text : {"a", "b", "c"}) desk.push(desk.journal.next(text));
    desk.writer.reset();
    EXPECT_EQ(desk.text(), "abc");

    Desk dead({.timeout = 200ms});
    dead.disk->fail(Error{ErrorCode::unavailable, "the disk is gone"});
    for (const char* text : {"a", "b", "c"}) dead.push(dead.journal.next(text));
    const auto began = Clock::now();
    dead.writer.reset();
    EXPECT_LT(Clock::now() - began, 2s);
    EXPECT_EQ(dead.done, 0);
    EXPECT_EQ(dead.refused, 3);
}

}  // namespace
}  // namespace jostle::server

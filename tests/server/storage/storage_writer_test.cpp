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

TEST(StorageWriter, writes_queued_changes_of_twenty_worlds_in_one_transaction) {
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

TEST(StorageWriter, temporary_disk_failure_loses_nothing_and_blocks_no_caller) {
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

TEST(StorageWriter, slow_disk_is_reported_and_blocks_no_caller) {
    Desk desk({.timeout = 100ms});
    desk.disk->delay_ms = 500;
    EXPECT_TRUE(desk.push(desk.journal.next("slow")));
    ASSERT_TRUE(wait_until([&] { return desk.writer->failure_reason().has_value(); }));
    EXPECT_EQ(*desk.writer->failure_reason(), "the database takes longer than 100 ms to write");
    EXPECT_TRUE(desk.push(desk.journal.next("er")));
    EXPECT_LT(to_ms(desk.slowest), 50);
    desk.disk->delay_ms = 0;
    ASSERT_TRUE(desk.writer->flush(5s));
    EXPECT_FALSE(desk.writer->failure_reason());
    EXPECT_EQ(desk.text(), "slower");
}

TEST(StorageWriter, rejects_changes_while_the_buffer_is_full) {
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

TEST(StorageWriter, conflicting_change_fails_without_affecting_others) {
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

TEST(StorageWriter, destructor_writes_pending_changes_or_reports_failure) {
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

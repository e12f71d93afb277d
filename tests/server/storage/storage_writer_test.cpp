// SPDX-License-Identifier: MIT
#include "server/storage/storage_writer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/storage/world_storage.h"
#include "tests/server/storage/journals.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::JournalMaker;
using test::wait_until;

// In-memory storage that fails or delays on request. Any thread may control it.
// Shared with the test, which gives up ownership of the storage.
struct FaultyState {
    std::atomic<int> delay_ms{0};  // per write
    std::mutex mutex;
    std::optional<Error> error;  // returned by every write
    std::vector<StorageChange> written;
    std::vector<std::size_t> groups;  // number of changes of each successful write

    void fail(std::optional<Error> with) {
        const std::lock_guard lock(mutex);
        error = std::move(with);
    }
    std::size_t size() {
        const std::lock_guard lock(mutex);
        return written.size();
    }
};

class FaultyStorage : public WorldStorage {
public:
    explicit FaultyStorage(std::shared_ptr<FaultyState> state) : state_(std::move(state)) {}

    Status write(std::span<const StorageChange> changes) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(state_->delay_ms.load()));
        const std::lock_guard lock(state_->mutex);
        if (state_->error) return *state_->error;
        for (const StorageChange& change : changes)
            if (std::holds_alternative<DropWorld>(change))
                return Error{ErrorCode::not_found, "the world does not exist"};
        state_->written.insert(state_->written.end(), changes.begin(), changes.end());
        state_->groups.push_back(changes.size());
        return {};
    }
    Result<std::vector<StoredWorld>> worlds() override { return nothing(); }
    Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string&) override {
        return nothing();
    }
    Result<Checkpoint> checkpoint(const std::string&, std::uint32_t) override { return nothing(); }
    Result<std::vector<JournalEntry>> entries(const std::string&, std::uint64_t,
                                              std::size_t) override {
        return nothing();
    }
    Result<std::optional<std::string>> note(const std::string&) override { return nothing(); }

private:
    static Error nothing() { return {ErrorCode::unavailable, "this storage is write-only"}; }

    std::shared_ptr<FaultyState> state_;
};

// A writer over a storage that can fail on request.
struct WriterFixture {
    std::shared_ptr<FaultyState> disk = std::make_shared<FaultyState>();
    std::unique_ptr<StorageWriter> writer;
    JournalMaker journal{"sea"};
    std::atomic<int> done{0}, refused{0};
    Clock::duration slowest{};

    explicit WriterFixture(const StorageWriterSettings& settings = {})
        : writer(std::make_unique<StorageWriter>(std::make_unique<FaultyStorage>(disk), settings)) {
    }

    bool push(StorageChange change) {
        const auto began = Clock::now();
        const bool taken = writer->push(
            std::move(change), [this](const Status& status) { (status.ok() ? done : refused)++; });
        slowest = std::max(slowest, Clock::now() - began);
        return taken;
    }
    // The data of the written entries, in order.
    std::string text() {
        const std::lock_guard lock(disk->mutex);
        std::string all;
        for (const StorageChange& change : disk->written)
            if (const auto* append = std::get_if<AppendEntry>(&change)) all += append->entry.data;
        return all;
    }
};

TEST(StorageWriter, writes_queued_changes_of_twenty_worlds_in_one_transaction) {
    WriterFixture fixture;
    fixture.disk->delay_ms = 30;
    fixture.push(fixture.journal.next("first"));
    ASSERT_TRUE(wait_until([&] { return fixture.writer->pending_bytes() > 0; }));
    std::this_thread::sleep_for(10ms);
    for (int k = 0; k < 20; k++) fixture.push(PutWorld{test::stored_world(std::to_string(k))});
    ASSERT_TRUE(fixture.writer->flush(5s));
    EXPECT_EQ(fixture.done, 21);
    EXPECT_LE(fixture.disk->groups.size(), 3u);
    EXPECT_EQ(fixture.writer->pending_bytes(), 0u);
}

TEST(StorageWriter, temporary_disk_failure_loses_nothing_and_blocks_no_caller) {
    for (const ErrorCode code : {ErrorCode::unavailable, ErrorCode::resource_exhausted}) {
        WriterFixture fixture;
        fixture.disk->fail(Error{code, "the disk is gone"});
        for (const char* text : {"a", "b", "c"})
            EXPECT_TRUE(fixture.push(fixture.journal.next(text)));
        ASSERT_TRUE(wait_until([&] { return fixture.writer->failure_reason().has_value(); }));
        EXPECT_EQ(*fixture.writer->failure_reason(), "the disk is gone");
        EXPECT_TRUE(fixture.push(fixture.journal.next("d")));
        EXPECT_EQ(fixture.done, 0);
        fixture.disk->fail({});
        const auto began = Clock::now();
        ASSERT_TRUE(fixture.writer->flush(5s));
        EXPECT_LT(Clock::now() - began, 2s);
        EXPECT_EQ(fixture.text(), "abcd");
        EXPECT_EQ(fixture.done, 4);
        EXPECT_FALSE(fixture.writer->failure_reason());
        EXPECT_LT(to_ms(fixture.slowest), 50)
            << "a push takes a few microseconds; the limit allows for a loaded machine";
    }
}

TEST(StorageWriter, slow_disk_is_reported_and_blocks_no_caller) {
    WriterFixture fixture({.timeout = 100ms});
    fixture.disk->delay_ms = 500;
    EXPECT_TRUE(fixture.push(fixture.journal.next("slow")));
    ASSERT_TRUE(wait_until([&] { return fixture.writer->failure_reason().has_value(); }));
    EXPECT_EQ(*fixture.writer->failure_reason(), "the database takes longer than 100 ms to write");
    EXPECT_TRUE(fixture.push(fixture.journal.next("er")));
    EXPECT_LT(to_ms(fixture.slowest), 50);
    fixture.disk->delay_ms = 0;
    ASSERT_TRUE(fixture.writer->flush(5s));
    EXPECT_FALSE(fixture.writer->failure_reason());
    EXPECT_EQ(fixture.text(), "slower");
}

TEST(StorageWriter, rejects_changes_while_the_buffer_is_full) {
    WriterFixture fixture({.bytes_max = 10'000});
    fixture.disk->fail(Error{ErrorCode::resource_exhausted, "the disk is full"});
    int taken = 0;
    while (fixture.push(fixture.journal.next(std::string(1000, 'x')))) taken++;
    EXPECT_EQ(taken, 7);
    fixture.disk->fail({});
    ASSERT_TRUE(fixture.writer->flush(5s));
    EXPECT_EQ(fixture.done, taken);
    EXPECT_TRUE(fixture.push(fixture.journal.next("again")));
}

TEST(StorageWriter, conflicting_change_fails_without_affecting_others) {
    WriterFixture fixture;
    fixture.disk->delay_ms = 30;
    for (const char* text : {"a", "b"}) fixture.push(fixture.journal.next(text));
    fixture.push(DropWorld{"never there"});
    for (const char* text : {"c", "d"}) fixture.push(fixture.journal.next(text));
    ASSERT_TRUE(fixture.writer->flush(5s));
    EXPECT_EQ(fixture.text(), "abcd");
    EXPECT_EQ(fixture.done, 4);
    EXPECT_EQ(fixture.refused, 1);
}

TEST(StorageWriter, destructor_writes_pending_changes_or_reports_failure) {
    WriterFixture fixture;
    fixture.disk->delay_ms = 20;
    for (const char* text : {"a", "b", "c"}) fixture.push(fixture.journal.next(text));
    fixture.writer.reset();
    EXPECT_EQ(fixture.text(), "abc");

    WriterFixture dead({.timeout = 200ms});
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

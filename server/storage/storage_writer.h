// SPDX-License-Identifier: MIT
//
// Decouples worlds, which must not wait, from a disk that may be slow, full or gone. Changes are
// queued, and a thread writes all queued changes of all worlds in one transaction. No change is
// lost while storage fails: the same changes are retried until they are written or the process
// ends.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "server/storage/world_storage.h"
#include "server/util/clock.h"

namespace jostle::server {

struct StorageWriterSettings {
    std::size_t bytes_max = 64 << 20;  // of queued changes; further changes are rejected
    Clock::duration retry = std::chrono::milliseconds(250);  // delay after a failure
    // A write that takes longer counts as a failure.
    Clock::duration timeout = std::chrono::seconds(1);
    // Interval in which the files are checked while nothing is written.
    Clock::duration check_interval = std::chrono::seconds(1);
};

class StorageWriter {
public:
    // Called on the writer's thread once per accepted change: ok once it is durable. Otherwise the
    // change contradicts the stored data (already_exists, not_found) and is skipped, or the writer
    // ended before it was written (aborted). Must not block.
    using Done = std::function<void(const Status&)>;

    StorageWriter(std::unique_ptr<WorldStorage> storage, const StorageWriterSettings& settings);
    // Retries queued changes for up to `timeout`.
    ~StorageWriter();

    // Any thread; never waits for storage. Returns false if the queue is full; the change is then
    // not queued.
    bool push(StorageChange change, Done done);
    // Any thread: calls `function` on the writer's thread after all earlier changes, and returns
    // when the call is complete. Returns false if it did not start within `timeout`.
    bool run_on_writer(const std::function<void(WorldStorage& storage)>& function,
                       Clock::duration timeout);
    // Any thread: waits until all earlier changes are written or rejected. Returns false on
    // timeout.
    bool flush(Clock::duration timeout);
    // Any thread: why storage rejects changes; empty: no fault.
    std::optional<std::string> failure_reason() const;
    // Any thread.
    std::size_t pending_bytes() const;
    // Any thread: how often storage began to fail, and the size of its files, at most some seconds
    // ago.
    std::uint64_t failures() const { return failures_; }
    std::uint64_t bytes_on_disk() const { return bytes_on_disk_; }

private:
    struct Waiting {
        StorageChange change;
        Done done;
        std::size_t bytes = 0;
    };

    void run();
    void write(std::deque<Waiting>& group);
    void try_write(std::deque<Waiting>& group);
    // Returns false if the writer ends and the remaining changes are not retried.
    bool wait_for_retry();
    void check_files();
    // Logs the begin and the end of a failure. Call with the mutex locked.
    void set_failure(std::optional<std::string> failure);

    const std::unique_ptr<WorldStorage> storage_;  // used by the writer's thread only
    const StorageWriterSettings settings_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Waiting> queue_;
    std::size_t bytes_ = 0;  // queued or being written
    std::uint64_t pushed_ = 0, finished_ = 0;
    const std::function<void(WorldStorage& storage)>* task_ = nullptr;  // one at a time
    bool task_running_ = false;
    std::optional<std::string> failure_;
    Clock::time_point failing_since_;
    std::optional<Clock::time_point> writing_since_;
    std::optional<Clock::time_point> last_try_;  // if set, the writer ends at this time
    std::atomic<std::uint64_t> failures_{0}, bytes_on_disk_{0};
    std::thread thread_;
};

}  // namespace jostle::server

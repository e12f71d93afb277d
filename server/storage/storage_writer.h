// SPDX-License-Identifier: MIT
//
// Between worlds that must not wait and a disk that may be slow, full or gone. Changes are queued,
// and a thread of its own writes all that wait in one transaction, for all worlds of the process
// together. While the store fails nothing is lost: the same changes are tried again until they are
// written or the process ends.
#pragma once

#include <condition_variable>
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
    std::size_t bytes_max = 64 << 20;  // that wait; beyond it changes are refused
    Clock::duration retry = std::chrono::milliseconds(250);  // after a failure
    // A store that has taken so long over what it was given counts as failing.
    Clock::duration timeout = std::chrono::seconds(1);
};

class StorageWriter {
public:
    // On the writer's thread, once for each change that was taken: ok when it is durable. Anything
    // else: it contradicts what is stored (already_exists, not_found) and is left out, or the
    // writer ended before it could be written (aborted). Must not wait.
    using Done = std::function<void(const Status&)>;

    StorageWriter(std::unique_ptr<WorldStorage> store, const StorageWriterSettings& settings);
    // Tries for `patience` to write what waits.
    ~StorageWriter();

    // Any thread; never waits for the store. False: too much waits, and the change was not taken.
    bool push(StorageChange change, Done done);
    // Any thread: looks at the store on the writer's thread, after what was pushed before, and
    // returns when that is over. False: the writer did not come to it within that time.
    bool run_on_writer(const std::function<void(WorldStorage& store)>& look,
                       Clock::duration timeout);
    // Any thread: waits until all that was pushed before has been written or refused. False: not
    // within that time.
    bool flush(Clock::duration timeout);
    // Any thread: why the store does not take what it is given; nothing: it does.
    std::optional<std::string> failure_reason() const;
    // Any thread.
    std::size_t pending_bytes() const;

private:
    struct Waiting {
        StorageChange change;
        Done done;
        std::size_t bytes = 0;
    };

    void run();
    void write(std::deque<Waiting>& group);
    void try_write(std::deque<Waiting>& group);
    // False: the writer ends, and what is left is not to be tried again.
    bool wait_for_retry();

    const std::unique_ptr<WorldStorage> store_;  // the writer thread's own
    const StorageWriterSettings settings_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Waiting> queue_;
    std::size_t bytes_ = 0;  // in the queue and in what is being written
    std::uint64_t pushed_ = 0, finished_ = 0;
    const std::function<void(WorldStorage& store)>* task_ = nullptr;  // one at a time
    bool task_running_ = false;
    std::optional<std::string> failure_;
    std::optional<Clock::time_point> writing_since_;
    std::optional<Clock::time_point> last_try_;  // set: the writer ends then
    std::thread thread_;
};

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/storage/storage_writer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "server/util/log.h"

namespace jostle::server {
namespace {

// Whether a retry may succeed.
bool is_transient(const Status& failure) {
    switch (failure.error().code) {
        case ErrorCode::already_exists:
        case ErrorCode::not_found:
        case ErrorCode::invalid_argument:
            return false;
        default:
            return true;
    }
}

}  // namespace

StorageWriter::StorageWriter(std::unique_ptr<WorldStorage> storage,
                             const StorageWriterSettings& settings)
    : storage_(std::move(storage)), settings_(settings), thread_([this] { run(); }) {}

StorageWriter::~StorageWriter() {
    {
        const std::lock_guard lock(mutex_);
        last_try_ = Clock::now() + settings_.timeout;
    }
    changed_.notify_all();
    thread_.join();
    ASSERT(queue_.empty() && bytes_ == 0);
}

bool StorageWriter::push(StorageChange change, Done done) {
    const std::size_t bytes = bytes_of(change);
    {
        const std::lock_guard lock(mutex_);
        if (last_try_ || bytes_ + bytes > settings_.bytes_max) return false;
        bytes_ += bytes;
        pushed_++;
        queue_.push_back({std::move(change), std::move(done), bytes});
        ASSERT(bytes_ <= settings_.bytes_max && pushed_ > finished_);
    }
    changed_.notify_all();
    return true;
}

bool StorageWriter::flush(Clock::duration timeout) {
    std::unique_lock lock(mutex_);
    const std::uint64_t all = pushed_;
    ASSERT(finished_ <= all);
    return changed_.wait_for(lock, timeout, [&] { return finished_ >= all; });
}

bool StorageWriter::run_on_writer(const std::function<void(WorldStorage& storage)>& function,
                                  Clock::duration timeout) {
    const Clock::time_point until = Clock::now() + timeout;
    std::unique_lock lock(mutex_);
    if (!changed_.wait_until(lock, until, [&] { return !task_; })) return false;
    ASSERT(!task_running_);
    task_ = &function;
    changed_.notify_all();
    const auto is_over = [&] { return task_ != &function; };
    if (changed_.wait_until(lock, until, is_over)) return true;
    // A task that has started is waited for.
    if (task_running_) {
        changed_.wait(lock, is_over);
        return true;
    }
    task_ = nullptr;
    changed_.notify_all();
    return false;
}

std::optional<std::string> StorageWriter::failure_reason() const {
    const std::lock_guard lock(mutex_);
    if (failure_) return failure_;
    if (writing_since_ && Clock::now() - *writing_since_ > settings_.timeout)
        return "the database takes longer than " +
               std::to_string(static_cast<int>(to_ms(settings_.timeout))) + " ms to write";
    return std::nullopt;
}

std::size_t StorageWriter::pending_bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

void StorageWriter::run() {
    for (;;) {
        std::deque<Waiting> group;
        {
            std::unique_lock lock(mutex_);
            const auto has_work = [&] { return !queue_.empty() || last_try_ || task_; };
            while (!changed_.wait_for(lock, settings_.check_interval, has_work)) {
                lock.unlock();
                check_files();
                lock.lock();
            }
            if (queue_.empty() && task_) {
                ASSERT(!task_running_);
                task_running_ = true;
                lock.unlock();
                (*task_)(*storage_);
                lock.lock();
                task_running_ = false;
                task_ = nullptr;
                changed_.notify_all();
                continue;
            }
            if (queue_.empty()) return;
            group.swap(queue_);
            ASSERT(queue_.empty() && !group.empty());
        }
        write(group);
    }
}

// Returns when the entire group is finished.
void StorageWriter::write(std::deque<Waiting>& group) {
    for (;;) {
        try_write(group);
        if (group.empty()) return;
        if (!wait_for_retry()) break;
    }
    std::size_t bytes = 0;
    for (const Waiting& waiting : group) {
        bytes += waiting.bytes;
        if (waiting.done)
            waiting.done(
                Error{ErrorCode::aborted, "the server stopped before the change was written"});
    }
    const std::lock_guard lock(mutex_);
    bytes_ -= bytes;
    finished_ += group.size();
    ASSERT(finished_ <= pushed_);
    changed_.notify_all();
}

// Removes finished changes from the group. Writes all in one transaction, or one at a time if one
// of them can never be written.
void StorageWriter::try_write(std::deque<Waiting>& group) {
    {
        const std::lock_guard lock(mutex_);
        writing_since_ = Clock::now();
    }
    ASSERT(!group.empty());
    std::vector<StorageChange> changes;
    for (Waiting& waiting : group) changes.push_back(std::move(waiting.change));
    Status result = storage_->write(changes);
    std::vector<Status> results(group.size(), result);
    std::size_t finished = result.ok() ? group.size() : 0;
    if (!result.ok() && !is_transient(result)) {
        for (; finished < group.size(); finished++) {
            result = storage_->write(std::span(changes).subspan(finished, 1));
            if (!result.ok() && is_transient(result)) break;
            results[finished] = result;
        }
    }
    ASSERT(changes.size() == group.size() && finished <= group.size());
    for (std::size_t k = 0; k < changes.size(); k++) group[k].change = std::move(changes[k]);

    std::size_t bytes = 0;
    for (std::size_t k = 0; k < finished; k++) {
        bytes += group.front().bytes;
        if (group.front().done) group.front().done(results[k]);
        group.pop_front();
    }
    const std::lock_guard lock(mutex_);
    writing_since_.reset();
    set_failure(group.empty() ? std::nullopt : std::optional(result.error().message));
    bytes_ -= bytes;
    finished_ += finished;
    ASSERT(finished_ <= pushed_);
    changed_.notify_all();
}

void StorageWriter::check_files() {
    const Status intact = storage_->check_files();
    bytes_on_disk_ = storage_->bytes_on_disk();
    const std::lock_guard lock(mutex_);
    set_failure(intact.ok() ? std::nullopt : std::optional(intact.error().message));
}

void StorageWriter::set_failure(std::optional<std::string> failure) {
    if (failure && !failure_) {
        failures_++;
        failing_since_ = Clock::now();
        log_error("cannot persist: {}; inputs are refused until it works again", *failure);
    } else if (!failure && failure_) {
        log_info("persisting works again after {:.1f} s",
                 to_ms(Clock::now() - failing_since_) / 1000);
    }
    failure_ = std::move(failure);
}

bool StorageWriter::wait_for_retry() {
    std::unique_lock lock(mutex_);
    if (last_try_ && Clock::now() >= *last_try_) return false;
    // New changes cause spurious wake-ups; the end of the writer must not be delayed.
    const Clock::time_point until = Clock::now() + settings_.retry;
    while (Clock::now() < (last_try_ ? std::min(until, *last_try_) : until))
        changed_.wait_until(lock, last_try_ ? std::min(until, *last_try_) : until);
    return true;
}

}  // namespace jostle::server

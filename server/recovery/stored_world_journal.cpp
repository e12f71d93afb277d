// SPDX-License-Identifier: MIT
#include "server/recovery/stored_world_journal.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "server/recovery/checkpoint_data.h"
#include "server/storage/compression.h"
#include "server/storage/journal_chain.h"
#include "server/util/log.h"

namespace jostle::server {
namespace {

// An idle world is flushed to its journal at least this often.
constexpr double idle_flush_seconds = 1;
// A checkpoint is not worth writing for less replay time than this, about the time to load it.
constexpr double checkpoint_worth_ms = 50;
constexpr std::size_t retained_checkpoints = 2;

}  // namespace

// --- CheckpointWriter ---

CheckpointWriter::CheckpointWriter() : thread_([this] { run(); }) {}

CheckpointWriter::~CheckpointWriter() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void CheckpointWriter::push(Job job) {
    {
        const std::lock_guard lock(mutex_);
        ASSERT(job && !ends_);
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
}

bool CheckpointWriter::wait(Clock::duration timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [&] { return jobs_.empty() && !busy_; });
}

void CheckpointWriter::run() {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex_);
            busy_ = false;
            changed_.notify_all();
            changed_.wait(lock, [&] { return !jobs_.empty() || ends_; });
            if (jobs_.empty()) return;
            job = std::move(jobs_.front());
            jobs_.pop_front();
            busy_ = true;
            ASSERT(job);
        }
        job();
    }
}

// --- StoredWorldJournal ---

StoredWorldJournal::StoredWorldJournal(std::string world, double hz,
                                       const JournalPosition& position, StorageWriter& writer,
                                       CheckpointWriter& checkpoints, CrashMarker mark,
                                       JournalSettings settings)
    : world_(std::move(world)),
      hz_(hz),
      writer_(writer),
      checkpoints_(checkpoints),
      mark_(mark),
      settings_(std::move(settings)),
      position_(position) {
    // The times of checkpoints of an earlier process are unknown: they are retained as if taken
    // now.
    ASSERT(std::ranges::is_sorted(position.checkpoints));
    for (const std::uint32_t tick : position.checkpoints)
        checkpoints_taken_.push_back({tick, Clock::now()});
}

std::optional<std::string> StoredWorldJournal::failure_reason() const {
    {
        const std::lock_guard lock(mutex_);
        if (divergence_) return divergence_;
    }
    return writer_.failure_reason();
}

std::uint32_t StoredWorldJournal::oldest_tick() const {
    const std::lock_guard lock(mutex_);
    return checkpoints_taken_.empty() ? 0 : checkpoints_taken_.front().tick;
}

void StoredWorldJournal::append(ExecutedTick tick) {
    mark_.begin(tick.tick);
    if (first_ == 0) {
        first_ = tick.tick;
        pending_results_ = std::make_shared<PendingResults>();
    }
    ASSERT(tick.tick > last_ && first_ <= tick.tick);
    last_ = tick.tick;
    if (!tick.steps) {
        if (!segment_.paused_ticks.empty() && segment_.paused_ticks.back().last + 1 == tick.tick)
            segment_.paused_ticks.back().last = tick.tick;
        else
            segment_.paused_ticks.push_back({tick.tick, tick.tick});
    }
    const bool urgent = !tick.commands.empty();
    if (urgent) {
        ASSERT(segment_.ticks.empty() || segment_.ticks.back().tick < tick.tick);
        segment_.ticks.push_back({tick.tick, std::move(tick.commands)});
        changed_ = true;
    }
    if (urgent || last_ - first_ + 1 >= idle_flush_seconds * hz_) flush();
}

void StoredWorldJournal::on_published(double step_ms, std::vector<WaitingResult> results) {
    mark_.end();
    ASSERT(step_ms >= 0 && pending_results_);
    replay_ms_ += step_ms;
    if (results.empty()) return;
    bool safe = false;
    {
        const std::lock_guard lock(pending_results_->mutex);
        safe = pending_results_->is_durable;
        if (!safe) std::ranges::move(results, std::back_inserter(pending_results_->results));
    }
    if (safe) send_results(results);
    // Results of inputs without effect need not wait for the idle flush.
    flush();
}

void StoredWorldJournal::send_results(std::vector<WaitingResult>& results) const {
    if (results.empty()) return;
    for (WaitingResult& result : results) result.reply->put(std::move(result.result));
    if (settings_.on_results_sent) settings_.on_results_sent();
}

// Entries that cannot be queued now are retried with the next tick. While storage fails, no inputs
// are applied, so the pending segment stays small.
void StoredWorldJournal::flush() {
    if (first_ == 0) return;
    JournalEntry entry{.sequence = position_.sequence + 1,
                       .epoch = position_.epoch,
                       .first_tick = first_,
                       .last_tick = last_,
                       .data = compress(encode_journal(segment_))};
    ASSERT(first_ <= last_);
    const Chain chain = entry.chain = next_chain(position_.chain, entry.data);
    const bool pushed = writer_.push(
        AppendEntry{world_, std::move(entry)},
        [pending = pending_results_, self = shared_from_this()](const Status& written) {
            if (!written.ok()) return self->on_write_failed(written.error());
            std::vector<WaitingResult> results;
            {
                const std::lock_guard lock(pending->mutex);
                pending->is_durable = true;
                results.swap(pending->results);
            }
            self->send_results(results);
        });
    if (!pushed) return;
    position_.sequence++;
    position_.chain = chain;
    segment_ = {};
    first_ = 0;
}

void StoredWorldJournal::on_write_failed(const Error& error) {
    if (error.code == ErrorCode::aborted) return;
    const std::string why =
        "the journal of world " + world_ + " conflicts with the database: " + error.message;
    log_error("{}", why);
    const std::lock_guard lock(mutex_);
    divergence_ = why;
}

bool StoredWorldJournal::wants_checkpoint() const {
    if (checkpoint_pending_ || failure_reason()) return false;
    if (interrupted_) return true;
    if (!changed_ && replay_ms_ < checkpoint_worth_ms) return false;
    return replay_ms_ > 1000 * settings_.replay_seconds_max ||
           Clock::now() - last_checkpoint_at_ > from_seconds(settings_.checkpoint_interval_seconds);
}

void StoredWorldJournal::write_checkpoint(std::uint32_t tick,
                                          std::shared_ptr<CheckpointCopier> copier) {
    flush();
    if (first_ != 0) return;  // the journal does not reach the checkpoint
    ASSERT(tick >= last_);
    const TakenCheckpoint taken{tick, Clock::now()};
    const std::uint64_t sequence = position_.sequence;
    replay_ms_ = 0;
    changed_ = interrupted_ = false;
    last_checkpoint_at_ = taken.at;
    checkpoint_pending_ = true;
    checkpoints_.push([self = shared_from_this(), copier = std::move(copier), taken, sequence] {
        std::optional<CheckpointCopy> checkpoint_copy = copier->take();
        Result<CheckpointData> data = checkpoint_copy
                                          ? encode_checkpoint(*checkpoint_copy)
                                          : Error{ErrorCode::resource_exhausted, "out of memory"};
        if (checkpoint_copy) {
            const std::lock_guard lock(self->mutex_);
            self->spare_restore_point_ = std::move(checkpoint_copy->bodies);
        }
        if (!data.ok()) {
            log_error("world {}: cannot write the checkpoint of tick {}: {}", self->world_,
                      taken.tick, data.error().message);
            self->checkpoint_pending_ = false;
            return;
        }
        const bool pushed = self->writer_.push(PutCheckpoint{self->world_,
                                                             {.tick = taken.tick,
                                                              .hash = data->hash,
                                                              .sequence = sequence,
                                                              .exact = std::move(data->bytes),
                                                              .portable = {}}},
                                               [self, taken](const Status& written) {
                                                   self->checkpoint_pending_ = false;
                                                   if (written.ok()) self->trim_old(taken);
                                               });
        if (!pushed) self->checkpoint_pending_ = false;
    });
}

physics::RestorePoint StoredWorldJournal::take_spare_restore_point() {
    const std::lock_guard lock(mutex_);
    return std::move(spare_restore_point_);
}

void StoredWorldJournal::end(std::optional<CheckpointCopy> checkpoint_copy) {
    flush();
    if (!checkpoint_copy || failure_reason()) return;
    auto copy = std::make_shared<CheckpointCopy>(*std::move(checkpoint_copy));
    write_checkpoint(copy->tick,
                     std::make_shared<CheckpointCopier>([copy] { return std::move(*copy); }));
}

// Runs on the writer's thread.
void StoredWorldJournal::trim_old(TakenCheckpoint newest) {
    std::uint32_t oldest = 0;
    {
        const std::lock_guard lock(mutex_);
        ASSERT(checkpoints_taken_.empty() || checkpoints_taken_.back().tick <= newest.tick);
        checkpoints_taken_.push_back(newest);
        const auto since = newest.at - from_seconds(3600 * settings_.history_retention_hours);
        while (checkpoints_taken_.size() > retained_checkpoints && checkpoints_taken_[1].at < since)
            checkpoints_taken_.pop_front();
        if (settings_.history_retention_hours == 0)
            while (checkpoints_taken_.size() > retained_checkpoints) checkpoints_taken_.pop_front();
        ASSERT(!checkpoints_taken_.empty());
        oldest = checkpoints_taken_.front().tick;
    }
    writer_.push(Trim{world_, oldest}, nullptr);
}

}  // namespace jostle::server

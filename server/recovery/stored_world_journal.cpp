// SPDX-License-Identifier: MIT
#include "server/recovery/stored_world_journal.h"

#include <algorithm>
#include <utility>

#include "server/recovery/checkpoint_data.h"
#include "server/storage/compression.h"
#include "server/storage/journal_chain.h"
#include "server/util/log.h"

namespace jostle::server {
namespace {

// How far a world that nobody touches may be ahead of its journal.
constexpr double client_timeout_seconds = 1;
// What is as cheap to do again as to load is not written anew.
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
    // When those of another process were taken is not known: they stay as if it were now.
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
    last_ = tick.tick;
    if (!tick.steps) {
        if (!segment_.paused_ticks.empty() && segment_.paused_ticks.back().last + 1 == tick.tick)
            segment_.paused_ticks.back().last = tick.tick;
        else
            segment_.paused_ticks.push_back({tick.tick, tick.tick});
    }
    const bool urgent = !tick.commands.empty();
    if (urgent) {
        segment_.ticks.push_back({tick.tick, std::move(tick.commands)});
        changed_ = true;
    }
    if (urgent || last_ - first_ + 1 >= client_timeout_seconds * hz_) flush();
}

void StoredWorldJournal::on_published(double step_ms, std::vector<WaitingResult> results) {
    mark_.end();
    replay_ms_ += step_ms;
    if (results.empty()) return;
    bool safe = false;
    {
        const std::lock_guard lock(pending_results_->mutex);
        safe = pending_results_->is_durable;
        if (!safe) std::ranges::move(results, std::back_inserter(pending_results_->results));
    }
    if (safe) send_results(results);
    // Of inputs that did nothing: they need not wait for what nobody did.
    flush();
}

void StoredWorldJournal::send_results(std::vector<WaitingResult>& results) const {
    if (results.empty()) return;
    for (WaitingResult& result : results) result.reply->put(std::move(result.result));
    if (settings_.on_results_sent) settings_.on_results_sent();
}

// What cannot be handed over now goes with the next tick: while the store is in trouble no inputs
// are applied, so that it is little.
void StoredWorldJournal::flush() {
    if (first_ == 0) return;
    JournalEntry entry{.sequence = position_.sequence + 1,
                       .epoch = position_.epoch,
                       .first_tick = first_,
                       .last_tick = last_,
                       .data = compress(encode_journal(segment_))};
    const Chain chain = entry.chain = next_chain(position_.chain, entry.data);
    const bool pushed = writer_.push(
        AppendEntry{world_, std::move(entry)},
        [telling = pending_results_, self = shared_from_this()](const Status& written) {
            if (!written.ok()) return self->on_write_failed(written.error());
            std::vector<WaitingResult> results;
            {
                const std::lock_guard lock(telling->mutex);
                telling->is_durable = true;
                results.swap(telling->results);
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
        "the journal of world " + world_ + " is at odds with the store: " + error.message;
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
                                          std::shared_ptr<CheckpointCopier> taker) {
    flush();
    if (first_ != 0) return;  // the journal does not go as far as the moment
    const TakenCheckpoint taken{tick, Clock::now()};
    const std::uint64_t sequence = position_.sequence;
    replay_ms_ = 0;
    changed_ = interrupted_ = false;
    last_checkpoint_at_ = taken.at;
    checkpoint_pending_ = true;
    checkpoints_.push([self = shared_from_this(), taker = std::move(taker), taken, sequence] {
        std::optional<CheckpointCopy> checkpoint_copy = taker->take();
        Result<CheckpointData> host_state =
            checkpoint_copy ? encode_checkpoint(*checkpoint_copy)
                            : Error{ErrorCode::resource_exhausted, "there is no memory for it"};
        if (checkpoint_copy) {
            const std::lock_guard lock(self->mutex_);
            self->spare_restore_point_ = std::move(checkpoint_copy->bodies);
        }
        if (!host_state.ok()) {
            log_error("world {}: no checkpoint of tick {}: {}", self->world_, taken.tick,
                      host_state.error().message);
            self->checkpoint_pending_ = false;
            return;
        }
        const bool pushed = self->writer_.push(PutCheckpoint{self->world_,
                                                             {.tick = taken.tick,
                                                              .hash = host_state->hash,
                                                              .sequence = sequence,
                                                              .exact = std::move(host_state->bytes),
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
    auto kept = std::make_shared<CheckpointCopy>(*std::move(checkpoint_copy));
    write_checkpoint(kept->tick,
                     std::make_shared<CheckpointCopier>([kept] { return std::move(*kept); }));
}

// On the writer's thread.
void StoredWorldJournal::trim_old(TakenCheckpoint newest) {
    std::uint32_t oldest = 0;
    {
        const std::lock_guard lock(mutex_);
        checkpoints_taken_.push_back(newest);
        const auto since = newest.at - from_seconds(3600 * settings_.history_retention_hours);
        while (checkpoints_taken_.size() > retained_checkpoints && checkpoints_taken_[1].at < since)
            checkpoints_taken_.pop_front();
        if (settings_.history_retention_hours == 0)
            while (checkpoints_taken_.size() > retained_checkpoints) checkpoints_taken_.pop_front();
        oldest = checkpoints_taken_.front().tick;
    }
    writer_.push(Trim{world_, oldest}, nullptr);
}

}  // namespace jostle::server

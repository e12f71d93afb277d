// SPDX-License-Identifier: MIT
//
// Persists one world: journals its ticks, and writes checkpoints often enough that replaying the
// journal from the last checkpoint is fast.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/recovery/crash_markers.h"
#include "server/recovery/journal_codec.h"
#include "server/storage/storage_writer.h"
#include "server/util/clock.h"
#include "server/world/world_persistence.h"

namespace jostle::server {

struct JournalSettings {
    // maximum interval of checkpoints of a world that moves
    double checkpoint_interval_seconds = 60;
    double replay_seconds_max = 2;  // maximum step time to replay since the last checkpoint
    // 0: retain the last two checkpoints and the journal after them
    double history_retention_hours = 0;
    // Called on the writer's thread after results were sent; may only wake another thread.
    std::function<void()> on_results_sent;
};

// The end of a world's journal.
struct JournalPosition {
    std::uint64_t epoch = 0;     // of this process
    std::uint64_t sequence = 0;  // of the last entry
    Chain chain{};
    std::vector<std::uint32_t> checkpoints = {};  // ticks of the stored checkpoints, ascending
};

// Encodes checkpoint copies one after the other on its own thread.
class CheckpointWriter {
public:
    using Job = std::function<void()>;

    CheckpointWriter();
    // Runs the queued jobs first.
    ~CheckpointWriter();
    void push(Job job);
    // Waits until all queued jobs are done. Returns false on timeout.
    bool wait(Clock::duration timeout);

private:
    void run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    bool ends_ = false, busy_ = false;
    std::thread thread_;
};

class StoredWorldJournal : public WorldJournal,
                           public std::enable_shared_from_this<StoredWorldJournal> {
public:
    StoredWorldJournal(std::string world, double hz, const JournalPosition& position,
                       StorageWriter& writer, CheckpointWriter& checkpoints, CrashMarker mark,
                       JournalSettings settings);

    std::optional<std::string> failure_reason() const override;
    std::uint32_t oldest_tick() const override;
    void append(ExecutedTick tick) override;
    void on_published(double step_ms, std::vector<WaitingResult> results) override;
    void on_interrupted() override { interrupted_ = true; }
    bool wants_checkpoint() const override;
    void write_checkpoint(std::uint32_t tick,
                          std::shared_ptr<CheckpointCopier> checkpoint_copy) override;
    void end(std::optional<CheckpointCopy> checkpoint_copy) override;
    physics::RestorePoint take_spare_restore_point() override;

private:
    struct TakenCheckpoint {  // a checkpoint in storage
        std::uint32_t tick;
        Clock::time_point at;
    };

    // Results are sent when their tick is both published and durable.
    struct PendingResults {
        std::mutex mutex;
        bool is_durable = false;
        std::vector<WaitingResult> results;
    };

    void flush();
    void send_results(std::vector<WaitingResult>& results) const;
    void on_write_failed(const Error& error);
    void trim_old(TakenCheckpoint newest);

    const std::string world_;
    const double hz_;
    StorageWriter& writer_;
    CheckpointWriter& checkpoints_;
    const CrashMarker mark_;
    const JournalSettings settings_;

    // Used by the world's thread only.
    JournalPosition position_;
    JournalSegment segment_;
    std::uint32_t first_ = 0, last_ = 0;  // ticks of the segment; 0: none yet
    // Of the pending segment, or of the newest entry if no segment is pending.
    std::shared_ptr<PendingResults> pending_results_ = std::make_shared<PendingResults>();
    double replay_ms_ = 0;  // step time since the last checkpoint
    bool changed_ = false;  // since the last checkpoint: commands were applied
    Clock::time_point last_checkpoint_at_ = Clock::now();
    bool interrupted_ = false;

    std::atomic<bool> checkpoint_pending_{false};
    mutable std::mutex mutex_;
    std::optional<std::string> divergence_;  // the database contradicts this journal
    std::deque<TakenCheckpoint> checkpoints_taken_;
    physics::RestorePoint spare_restore_point_;
};

}  // namespace jostle::server

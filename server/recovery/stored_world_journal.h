// SPDX-License-Identifier: MIT
//
// Keeps one world in a store: what is done to it tick by tick, and now and then all of it, so that
// to do it again from the last checkpoint never takes long.
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
    double checkpoint_interval_seconds = 60;  // between two, at most, of a world that moves
    double replay_seconds_max = 2;            // that the steps since the last one took, at most
    double history_retention_hours = 0;  // 0: the last two checkpoints, and what came after them
    // After results were told, on the writer's thread: must only wake somebody.
    std::function<void()> on_results_sent;
};

// Where a world's journal stands.
struct JournalPosition {
    std::uint64_t epoch = 0;     // of this process
    std::uint64_t sequence = 0;  // of the last entry
    Chain chain{};
    std::vector<std::uint32_t> checkpoints = {};  // ticks of those in the store, rising
};

// Turns moments into checkpoints, one after the other, on a thread of its own.
class CheckpointWriter {
public:
    using Job = std::function<void()>;

    CheckpointWriter();
    // Does what is still to be done.
    ~CheckpointWriter();
    void push(Job job);
    // Waits until all that was pushed has been done. False: not within that time.
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
    struct TakenCheckpoint {  // a checkpoint that is in the store
        std::uint32_t tick;
        Clock::time_point at;
    };

    // Results are told when what they are results of is both shown and safe.
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

    // The world's thread's.
    JournalPosition position_;
    JournalSegment segment_;
    std::uint32_t first_ = 0, last_ = 0;  // ticks of the batch; 0: none yet
    // Of the newest entry; of the batch that is not handed over, if there is one.
    std::shared_ptr<PendingResults> pending_results_ = std::make_shared<PendingResults>();
    double replay_ms_ = 0;  // since the last checkpoint
    bool changed_ = false;  // likewise: something was done
    Clock::time_point last_checkpoint_at_ = Clock::now();
    bool interrupted_ = false;

    std::atomic<bool> checkpoint_pending_{false};
    mutable std::mutex mutex_;
    std::optional<std::string> divergence_;  // what is stored contradicts us
    std::deque<TakenCheckpoint> checkpoints_taken_;
    physics::RestorePoint spare_restore_point_;
};

}  // namespace jostle::server

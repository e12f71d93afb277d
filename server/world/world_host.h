// SPDX-License-Identifier: MIT
//
// One world, on one thread at a time, which takes commands, applies them, steps and publishes a
// frame at a fixed rate. Commands enter through a bounded mailbox and frames leave as immutable
// values; no other thread accesses the world. A world without clients in which nothing moves
// rests: it steps at the same rate, but several ticks at once and without frames in between.
// A world without ticks of its own ticks by calls of tick(), for tests and simulations.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/util/thread_cpu_time.h"
#include "server/util/token_bucket.h"
#include "server/world/between_ticks_executor.h"
#include "server/world/body_limits.h"
#include "server/world/command_mailbox.h"
#include "server/world/frame_publisher.h"
#include "server/world/hosted_world.h"
#include "server/world/input_scheduler.h"
#include "server/world/player_reports.h"
#include "server/world/query_broker.h"
#include "server/world/single_step_control.h"
#include "server/world/tick_loop.h"
#include "server/world/tick_metrics.h"
#include "server/world/tick_pool.h"
#include "server/world/timeline.h"
#include "server/world/world_lifecycle.h"
#include "server/world/world_persistence.h"
#include "server/world/world_properties.h"

namespace jostle::server {

// Limits of all worlds of a process together.
struct TotalLimits {
    int bodies_max = 50000;
    double work_per_second_max = 4e8;  // estimate of scene_budget.h
};

struct WorldHostSettings {
    HostLimits limits;
    TotalLimits totals;
    int command_queue_max = 8192;
    InputScheduler::Settings inputs;
    double query_copy_share = 0.1;  // of the tick period for copies for queries; 0: unlimited
    double user_message_bytes_per_second = 262144;  // of all clients; 0: unlimited
    BodyLimits::Settings body_limits;
    int catch_up_ticks_max = 4;
    int physics_threads = 1;
    bool own_ticks = true;  // false: the world ticks only in tick()
    // The threads of its ticks; null: one thread of its own.
    std::shared_ptr<TickPool> tick_pool = nullptr;
    WorldPersistence* world_persistence = nullptr;  // null: worlds end with the process
    // See FramePublisher.
    std::function<void(bool has_events)> on_frame;
    Metrics* metrics = nullptr;  // null: no metrics
};

// A new world, or one that continues after a tick.
struct WorldStart {
    WorldLabel label;
    std::shared_ptr<const scenes::SceneDescription> scene;
    HostedWorld world;
    std::uint32_t tick = 1;
    std::shared_ptr<WorldJournal> world_journal = nullptr;  // null: not persisted
    std::optional<std::string> paused = {};                 // the reason; nothing: not paused
    std::uint32_t speed_percent = 100;                      // of real time
    std::shared_ptr<Timeline> timeline = nullptr;           // of the replaced host; null: none
    std::shared_ptr<PlayerReports> reports = nullptr;       // likewise
};

class WorldHost {
public:
    // Builds the world on the calling thread, then starts the tick thread. Errors: the scene is
    // invalid or exceeds a limit.
    // `room`: nothing: the world is no room.
    static Result<std::shared_ptr<WorldHost>> start(
        WorldLabel label, std::shared_ptr<const scenes::SceneDescription> scene,
        const WorldHostSettings& settings, std::optional<RoomState> room = {});
    static Result<std::shared_ptr<WorldHost>> start(std::string id, std::string name,
                                                    const scenes::SceneDescription& scene,
                                                    const WorldHostSettings& settings) {
        return start(WorldLabel{std::move(id), std::move(name), {}},
                     std::make_shared<const scenes::SceneDescription>(scene), settings);
    }
    static std::shared_ptr<WorldHost> start(WorldStart start, const WorldHostSettings& settings);
    // Likewise for a world that is not in the database yet.
    static Result<std::shared_ptr<WorldHost>> begin(WorldStart start,
                                                    const WorldHostSettings& settings);
    ~WorldHost();

    const WorldProperties& properties() const { return properties_; }
    const std::string& id() const { return properties_.label.id; }
    const std::string& name() const { return properties_.label.name; }
    double hz() const { return properties_.hz; }
    // Any thread: the subject of the owner, which the members of a room can change; empty: the
    // server, or a client without a subject.
    std::string owner() const;

    // Any thread: input and output.
    CommandMailbox& mailbox() { return mailbox_; }
    FramePtr frame() const { return publisher_.frame(); }
    FrameListeners& listeners() { return publisher_.listeners(); }
    // The newest frames, for lag compensation.
    const FrameRing& frame_history() const { return world_.frame_history(); }
    // A copy of the world for queries, at most a few ticks old, or older if
    // copies are expensive (query_copy_share). Waits for the next one; null: none
    // arrived in time. Without ticks of its own: a copy of the current state.
    QueryFramePtr query_frame(CopyLayers layers);

    // Any thread: pausing, stepping and watching the world.
    const WorldLifecycle& lifecycle() const { return lifecycle_; }
    void pause(std::string reason);
    void resume();
    // Pauses the world for a limited time; the running tick skips the rest of its inputs and of its
    // step.
    void interrupt_overloaded(std::string reason, Clock::time_point now);
    // Resumes it when that time has passed.
    void resume_if_due(Clock::time_point now);
    SingleStepControl& single_step() { return single_step_; }
    TickMetrics& tick_metrics() { return tick_metrics_; }
    BetweenTicksExecutor& between_ticks() { return between_ticks_; }
    // Releases every thread that waits for this world; later waits return at once.
    void cancel_waiters();
    // Any thread: what players reported about others.
    const std::shared_ptr<PlayerReports>& reports() const { return reports_; }

    // Any thread: whether the world is in the database, and the oldest tick that can be restored
    // (0: none).
    bool is_persisted() const { return world_journal_ != nullptr; }
    std::uint32_t oldest_restorable_tick() const {
        return world_journal_ ? world_journal_->oldest_tick() : 0;
    }

    // Any thread: whether a member of the room requested to start the world from its scene again.
    bool is_reset_requested() const { return is_reset_requested_.load(); }
    // Any thread: the tick to which a member of the room requested to rewind the world; 0: none.
    std::uint32_t requested_rewind() const { return requested_rewind_.load(); }
    // Any thread: the speed that a member of the room requested, in percent of real time.
    std::uint32_t speed_percent() const { return speed_percent_.load(); }

    // Any thread: the world has work and may not rest (tick_loop.h). Commands, queries, pauses and
    // new clients call it.
    void wake() { loop_.wake(); }

    // Ends the ticks, also during a long step; the last frame remains readable.
    void stop();
    // stop() for a world that another host continues; its clients should reconnect. False: the
    // world was stopped already.
    bool stop_for_replacement();
    // After stop(): the last state.
    const HostedWorld& stopped_world() const { return world_; }
    const std::shared_ptr<Timeline>& stopped_timeline() const { return timeline_; }
    // The rewind that was requested failed; the world continues.
    void cancel_rewind() { requested_rewind_.store(0); }
    // Any thread: stop() writes no checkpoint.
    void skip_final_checkpoint() { skips_final_checkpoint_.store(true); }
    // A world without ticks of its own, one thread at a time: runs the tick that is due.
    void tick(Clock::time_point due) { run_tick(due, 0); }

private:
    WorldHost(WorldStart start, const WorldHostSettings& settings);
    void run_tick(Clock::time_point due, std::uint32_t late_ticks);
    bool run_tick(const TickLoop::Tick& tick);  // returns may_rest()
    // One of several ticks that run at once because the world rests.
    void run_resting_tick(Clock::time_point due);
    // Returns whether the world has no clients and nothing happens in it.
    bool may_rest(const Frame& frame) const;
    // `refusal`: why no input is applied; nothing: inputs are applied.
    std::optional<Error> input_refusal(const std::optional<std::string>& paused) const;
    // Returns whether an input was applied although the world is paused.
    bool apply_commands(std::optional<Error> refusal, Clock::time_point due);
    InputResult apply(const Command& command, Clock::time_point due);
    // Why a user message exceeds the rate of the world; nothing: it does not.
    std::optional<Error> message_refusal(const Command& command, Clock::time_point due);
    void apply_joins(std::span<Command> joins);
    // Why a command about the time of a room is refused; nothing: it is not.
    std::optional<Error> time_refusal(const Command& command) const;
    // Whether a member of the room paused the world.
    bool is_paused_by_room() const;
    void set_speed(std::uint32_t percent);
    void store_timeline(bool stepped);
    // Resumes a world that a member of the room paused. Nothing: the command does not request it.
    std::optional<InputResult> resume_room(const Command& command);
    void grant_room_requests(const Room::Requests& requests);
    void remove_excess_bodies(Clock::time_point now);
    void put_result(const Command& command, InputResult result, Clock::time_point due);
    // `allowed`: step even if the world is paused. False: the world took no step.
    bool step(bool allowed);
    void log_step_warnings();
    void log_time_scale(const Frame& frame, Clock::time_point now);
    std::shared_ptr<Frame> make_frame(Clock::time_point due, std::uint32_t late_ticks);
    // Publishes the frame, then sends the results of its inputs unless the journal sends them.
    void publish(const std::shared_ptr<Frame>& frame, bool sends_results);
    // Passes the step time and unsent results of this tick to the journal.
    void persist_published(double step_ms, bool results_sent);
    CheckpointCopy checkpoint_copy() const;
    void hand_over_checkpoint();
    void serve_queries();

    const WorldProperties properties_;
    const WorldHostSettings settings_;
    WorldLifecycle lifecycle_;
    CommandMailbox mailbox_;
    FramePublisher publisher_;

    // Owned by the tick thread.
    HostedWorld world_;
    std::uint32_t tick_ = 0;
    InputScheduler scheduler_;
    BodyLimits body_limits_;
    TokenBucket message_bytes_;
    ThreadCpuTime cpu_time_;
    std::chrono::nanoseconds cpu_at_begin_{0};  // of this tick
    std::vector<WaitingResult> results_;        // of the inputs of this tick
    bool step_refused_ = false, step_interrupted_ = false;
    Clock::time_point next_pairs_warning_{};
    bool step_aborted_ = false;                 // the end of the world aborted the last step
    bool rests_ = false;                        // may_rest() of the last frame
    std::uint32_t room_steps_ = 0;              // that members requested for a paused world
    const std::shared_ptr<Timeline> timeline_;  // null: the world is no room
    const std::shared_ptr<PlayerReports> reports_;

    const std::shared_ptr<WorldJournal> world_journal_;    // null: not persisted
    std::shared_ptr<CheckpointCopier> checkpoint_copier_;  // of the previous tick; null: none
    QueryBroker queries_;
    SingleStepControl single_step_;
    TickMetrics tick_metrics_;
    BetweenTicksExecutor between_ticks_;
    std::atomic<bool> skips_final_checkpoint_{false}, is_reset_requested_{false};
    std::atomic<std::uint32_t> requested_rewind_{0}, speed_percent_{100};
    std::mutex stop_mutex_;
    bool ended_ = false;
    TickLoop loop_;  // last: its thread uses everything above
};

}  // namespace jostle::server

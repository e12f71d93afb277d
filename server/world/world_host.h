// SPDX-License-Identifier: MIT
//
// One world, one thread: drain, apply, step, publish, at a fixed rate. Commands go in through one
// bounded queue, frames come out as immutable values; nobody else ever touches the world. Who has
// a clock of his own makes a world without a thread, and calls tick().
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "server/util/bounded_queue.h"
#include "server/world/between_ticks_executor.h"
#include "server/world/hosted_world.h"
#include "server/world/query_broker.h"
#include "server/world/scheduled_inputs.h"
#include "server/world/single_step_control.h"
#include "server/world/tick_clock.h"
#include "server/world/tick_metrics.h"
#include "server/world/world_persistence.h"

namespace jostle::server {

// Of all worlds of a process together.
struct TotalLimits {
    int bodies_max = 50000;
    double work_per_second_max = 4e8;  // as scene_budget.h estimates it
};

struct WorldHostSettings {
    HostLimits limits;
    TotalLimits totals;
    int command_queue_max = 8192;
    int catch_up_ticks_max = 4;
    int physics_threads = 1;
    bool own_thread = true;                         // false: it ticks only when tick() is called
    WorldPersistence* world_persistence = nullptr;  // null: worlds end with the process
    // Called on the world's thread after each frame, with whether something happened in it; must
    // only wake somebody.
    std::function<void(bool has_events)> on_frame;
    Metrics* metrics = nullptr;  // null: nobody counts
};

struct WorldLabel {
    std::string id, name;
    std::string owner;  // subject of who created it; empty: the server itself
};

// A world that begins, or goes on after that tick.
struct WorldStart {
    WorldLabel label;
    std::shared_ptr<const scenes::SceneDescription> scene;
    HostedWorld world;
    std::uint32_t tick = 1;
    std::shared_ptr<WorldJournal> world_journal = nullptr;  // null: it ends with the process
    std::optional<std::string> paused = {};                 // why
};

class WorldHost {
public:
    // Builds the world on the calling thread, then starts its own.
    static Result<std::shared_ptr<WorldHost>> start(
        WorldLabel label, std::shared_ptr<const scenes::SceneDescription> scene,
        const WorldHostSettings& settings);
    static Result<std::shared_ptr<WorldHost>> start(std::string id, std::string name,
                                                    const scenes::SceneDescription& scene,
                                                    const WorldHostSettings& settings) {
        return start(WorldLabel{std::move(id), std::move(name), {}},
                     std::make_shared<const scenes::SceneDescription>(scene), settings);
    }
    static std::shared_ptr<WorldHost> start(WorldStart start, const WorldHostSettings& settings);
    // One that is new to whoever keeps worlds.
    static Result<std::shared_ptr<WorldHost>> begin(WorldStart start,
                                                    const WorldHostSettings& settings);
    ~WorldHost();

    // Any thread. False: the queue is full, the command was not taken.
    bool push(Command command) { return commands_.push(std::move(command)); }
    // Any thread; never waits and is never refused: the world takes it after what the client sent.
    void leave(ClientId client, bool retain_bodies);
    // The same for a client whose connection broke and that may come back.
    void disconnect(ClientId client);
    // Any thread: the newest frame; there is one from the start.
    FramePtr frame() const;
    // Any thread: a copy of the world to ask, at most a few ticks old. Waits a little for the next
    // one; null when none came. Without a thread of its own: a copy of this moment.
    QueryFramePtr query_frame(CopyLayers layers);
    // Any thread: its newest frames, for what clients saw a moment ago.
    const FrameRing& frame_history() const { return world_.frame_history(); }
    // Any thread: frames carry events while there are listeners.
    void add_event_listener() { event_listeners_++; }
    void remove_event_listener() { event_listeners_--; }
    // Likewise, of how bodies move (module_channels.h).
    void add_motion_listener() { motion_listeners_++; }
    void remove_motion_listener() { motion_listeners_--; }
    // Likewise, of what is driven.
    void add_controlled_entity_listener() { controlled_entity_listeners_++; }
    void remove_controlled_entity_listener() { controlled_entity_listeners_--; }
    // Any thread: whether the world was stopped, or ended by an error that it could not survive.
    bool stopped() const { return stopping_.load(std::memory_order_relaxed); }
    // Any thread: ... by an error.
    bool failed() const { return failed_.load(std::memory_order_relaxed); }
    // Ends the thread, also in the midst of a long step; the last frame stays readable.
    void stop();
    // stop(), and another host will go on with it: its clients are to come back. False: it was
    // stopped already.
    bool stop_for_replacement();
    // Any thread: whether it ended so.
    bool was_replaced() const { return was_replaced_.load(); }
    // Any thread: what it is at its end will not be asked for.
    void skip_final_checkpoint() { skips_final_checkpoint_.store(true); }
    // A world without a thread of its own, one thread at a time: the tick that was due then.
    void tick(Clock::time_point due);

    // Any thread. A paused world is seen and may be left, but does not step and takes no inputs.
    void pause(std::string reason);
    void resume();
    std::optional<std::string> paused() const;  // why
    // Any thread: what else operators do.
    SingleStepControl& single_step() { return single_step_; }
    TickMetrics& tick_metrics() { return tick_metrics_; }
    BetweenTicksExecutor& between_ticks() { return between_ticks_; }
    // Any thread: nobody waits for this world any longer, and nobody is answered.
    void cancel_waiters();
    // Any thread: when the tick that runs began; nothing between two ticks.
    std::optional<Clock::time_point> tick_began() const;
    // Any thread: the step that runs leaves out what it still can, and the world is paused.
    void interrupt(std::string reason);

    const WorldLabel& label() const { return label_; }
    const std::string& id() const { return label_.id; }
    const std::string& name() const { return label_.name; }
    const std::string& owner() const { return label_.owner; }
    const std::string& scene() const { return scene_->name; }
    const std::shared_ptr<const scenes::SceneDescription>& description() const { return scene_; }
    double hz() const { return hz_; }
    // What clients did is still there after the process.
    bool is_persisted() const { return world_journal_ != nullptr; }
    // The one after which this host began.
    std::uint32_t first_tick() const { return first_tick_; }
    // Any thread: the first tick that can be had again; 0: none can.
    std::uint32_t oldest_restorable_tick() const {
        return world_journal_ ? world_journal_->oldest_tick() : 0;
    }
    double work_per_second() const { return work_per_second_; }
    physics::Vec3 gravity() const { return gravity_; }
    // Of a step; 0: each island takes as many as it needs.
    int substeps() const { return substeps_; }
    // When tick 0 would have been due, on the server's clock.
    std::uint64_t epoch_us() const { return to_us(epoch_); }
    // What its modules tell clients: a channel's kind is a place in this list.
    const std::vector<physics::ChannelKind>& channel_kinds() const { return channel_kinds_; }

private:
    WorldHost(WorldStart start, const WorldHostSettings& settings);
    void run();
    void tick_late(Clock::time_point due, std::uint32_t late_ticks);
    // `refusal`: why no input is applied.
    void apply_commands(const std::optional<Error>& refusal, Clock::time_point due);
    InputResult execute(const Command& command, const std::optional<Error>& refusal,
                        Clock::time_point due);
    std::optional<Error> input_refusal(const std::optional<std::string>& paused) const;
    // `allowed`: also when the world is paused. False: it took no step.
    bool step(bool allowed);
    // Shows the frame, then answers the inputs that are in it, unless they are to be kept first.
    void publish(std::shared_ptr<Frame> frame, bool answers);
    // Hands the results of this tick, and now and then the world, to who keeps it.
    void persist_published(double step_ms, bool answered);
    CheckpointCopy checkpoint_copy() const;
    void hand_over_checkpoint();
    std::int64_t late_us(Clock::time_point due) const;
    void measure(Frame& frame, Clock::time_point began);
    void record_events();
    void warn_of_quarantine();
    void warn_of_large_channels();
    void serve_queries();

    const WorldLabel label_;
    const std::shared_ptr<const scenes::SceneDescription> scene_;
    const double hz_, work_per_second_;
    const physics::Vec3 gravity_;
    const int substeps_;
    const Clock::time_point epoch_;
    const std::uint32_t first_tick_;
    const std::vector<physics::ChannelKind> channel_kinds_;
    const WorldHostSettings settings_;

    HostedWorld world_;  // the tick thread's own
    const std::shared_ptr<WorldJournal> world_journal_;
    std::shared_ptr<CheckpointCopier>
        checkpoint_copier_;  // of the tick before; null: nobody wants it
    std::uint32_t tick_ = 0;
    bool step_refused_ = false, step_interrupted_ = false;
    bool step_aborted_ = false;  // the last step, by the world's end
    std::shared_ptr<const RecentEvents> events_ = std::make_shared<const RecentEvents>();
    std::vector<Command> batch_, leave_commands_taken_;
    std::vector<InputResult> results_;    // of batch_, one each
    std::vector<double> recent_tick_ms_;  // ring of the last second
    std::size_t recent_next_ = 0;

    BoundedQueue<Command> commands_;
    ScheduledInputs scheduled_;  // the tick thread's own
    std::mutex leave_mutex_;
    std::vector<Command> leave_commands_;  // few of each client
    mutable std::mutex pause_mutex_;
    std::optional<std::string> paused_;
    std::atomic<Clock::rep> tick_began_{0};  // 0: between two ticks
    QueryBroker queries_;
    SingleStepControl single_step_;
    TickMetrics tick_metrics_;
    BetweenTicksExecutor between_ticks_;
    std::atomic<int> event_listeners_{0}, motion_listeners_{0}, controlled_entity_listeners_{0};
    mutable std::mutex frame_mutex_;
    FramePtr frame_;
    std::atomic<bool> stopping_{false}, failed_{false}, skips_final_checkpoint_{false},
        was_replaced_{false};
    std::mutex stop_mutex_;
    bool ended_ = false;
    struct Timer;  // Asio's, kept out of this header
    std::unique_ptr<Timer> timer_;
    std::thread thread_;
};

}  // namespace jostle::server

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

#include "base/bounded_queue.h"
#include "host/hosted_world.h"
#include "host/query_broker.h"
#include "host/tick_clock.h"

namespace jostle::server {

struct WorldHostSettings {
    HostLimits limits;
    int command_queue_max = 8192;
    int catch_up_max = 4;
    int physics_threads = 1;
    bool own_thread = true;  // false: it ticks only when tick() is called
    // Called on the world's thread after each frame; must only wake somebody.
    std::function<void()> on_frame;
};

class WorldHost {
public:
    // Builds the world on the calling thread, then starts its own.
    static Result<std::shared_ptr<WorldHost>> start(std::string id, std::string name,
                                                    const scenes::SceneDescription& scene,
                                                    const WorldHostSettings& settings);
    ~WorldHost();

    // Any thread. False: the queue is full, the command was not taken.
    bool push(Command command) { return commands_.push(std::move(command)); }
    // Any thread: the newest frame; there is one from the start.
    FramePtr frame() const;
    // Any thread: a copy of the world to ask, at most a few ticks old. Waits a little for the next
    // one; null when none came. Without a thread of its own: a copy of this moment.
    QueryFramePtr query_frame(CopyParts parts);
    // Any thread: frames carry events while there are listeners.
    void add_event_listener() { event_listeners_++; }
    void remove_event_listener() { event_listeners_--; }
    // Any thread: whether the world was stopped, or ended by an error that it could not survive.
    bool stopped() const { return stopping_.load(std::memory_order_relaxed); }
    // Ends the thread; the last frame stays readable.
    void stop();
    // A world without a thread of its own, one thread at a time: the tick that was due then.
    void tick(Clock::time_point due);

    const std::string& id() const { return id_; }
    const std::string& name() const { return name_; }
    const std::string& scene() const { return scene_; }
    double hz() const { return hz_; }
    physics::Vec3 gravity() const { return gravity_; }

private:
    WorldHost(std::string id, std::string name, const scenes::SceneDescription& scene,
              const WorldHostSettings& settings, HostedWorld world);
    void run();
    void tick_late(Clock::time_point due, std::uint32_t late_ticks);
    // Shows the frame, then answers the inputs that are in it.
    void publish(std::shared_ptr<Frame> frame);
    void measure(Frame& frame);
    void record_events();
    void warn_of_quarantine();
    void warn_of_large_chunks();
    void serve_queries();

    const std::string id_, name_, scene_;
    const double hz_;
    const physics::Vec3 gravity_;
    const WorldHostSettings settings_;

    HostedWorld world_;  // the tick thread's own
    std::uint32_t tick_ = 0;
    bool step_refused_ = false;
    std::shared_ptr<const RecentEvents> events_ = std::make_shared<const RecentEvents>();
    std::vector<Command> batch_;
    std::vector<InputResult> results_;    // of batch_, one each
    std::vector<double> recent_step_ms_;  // ring of the last second
    std::size_t recent_next_ = 0;

    BoundedQueue<Command> commands_;
    QueryBroker queries_;
    std::atomic<int> event_listeners_{0};
    mutable std::mutex frame_mutex_;
    FramePtr frame_;
    std::atomic<bool> stopping_{false};
    std::mutex stop_mutex_;
    struct Timer;  // Asio's, kept out of this header
    std::unique_ptr<Timer> timer_;
    std::thread thread_;
};

}  // namespace jostle::server

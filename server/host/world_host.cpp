// SPDX-License-Identifier: MIT
#include "host/world_host.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <numeric>

#include "base/log.h"
#include "host/result_queue.h"

namespace jostle::server {

namespace asio = boost::asio;
struct WorldHost::Timer {
    asio::io_context io{1};
    asio::steady_timer due{io};
};

Result<std::shared_ptr<WorldHost>> WorldHost::start(std::string id, std::string name,
                                                    const scenes::SceneDescription& scene,
                                                    const WorldHostSettings& settings) {
    Result<HostedWorld> world =
        HostedWorld::create(scene, settings.limits, settings.physics_threads);
    if (!world.ok()) return world.error();
    std::shared_ptr<WorldHost> host(
        new WorldHost(std::move(id), std::move(name), scene, settings, std::move(*world)));
    return host;
}

WorldHost::WorldHost(std::string id, std::string name, const scenes::SceneDescription& scene,
                     const WorldHostSettings& settings, HostedWorld world)
    : id_(std::move(id)),
      name_(std::move(name)),
      scene_(scene.name),
      hz_(scene.hz),
      gravity_(scene.world.gravity),
      settings_(settings),
      world_(std::move(world)),
      commands_(static_cast<std::size_t>(settings.command_queue_max)),
      timer_(std::make_unique<Timer>()) {
    recent_step_ms_.assign(static_cast<std::size_t>(std::max(1.0, hz_)), 0.0);
    auto first = std::make_shared<Frame>();
    first->tick = tick_ = 1;
    first->due = Clock::now();
    first->events = events_;
    world_.copy_into(*first);
    frame_ = std::move(first);
    if (settings_.own_thread) thread_ = std::thread([this] { run(); });
}

WorldHost::~WorldHost() {
    stop();
}

FramePtr WorldHost::frame() const {
    const std::lock_guard lock(frame_mutex_);
    return frame_;
}

void WorldHost::stop() {
    const std::lock_guard lock(stop_mutex_);
    stopping_.store(true);
    queries_.close();
    timer_->io.stop();
    if (thread_.joinable()) thread_.join();
}

void WorldHost::run() {
    TickClock clock(Clock::now(), hz_, settings_.catch_up_max);
    std::function<void()> wait = [&] {
        timer_->due.expires_at(clock.next_due());
        timer_->due.async_wait([&](const boost::system::error_code& error) {
            if (error || stopping_.load(std::memory_order_relaxed)) return;
            for (int left = clock.due(Clock::now()); left > 0; left--)
                tick_late(clock.begin_tick(), clock.late_ticks());
            wait();
        });
    };
    wait();
    // Out of memory, say: this world ends, its clients are told, and the others go on.
    try {
        timer_->io.run();
    } catch (const std::exception& error) {
        log_error("world {} \"{}\" ends: {}", id_, name_, error.what());
        stopping_.store(true);
        queries_.close();
    }
}

void WorldHost::tick(Clock::time_point due) {
    tick_late(due, 0);
}

QueryFramePtr WorldHost::query_frame(CopyParts parts) {
    if (!settings_.own_thread && !stopped()) {
        queries_.want(parts, Clock::now());
        serve_queries();
    }
    return queries_.ask(parts);
}

// One tick of one world. Nothing outside this thread ever touches world_.
void WorldHost::tick_late(Clock::time_point due, std::uint32_t late_ticks) {
    tick_++;
    commands_.drain_into(batch_);  // what was asked since the last tick, in order of arrival
    results_.clear();
    for (const Command& command : batch_) results_.push_back(world_.apply(command, tick_));
    if (const auto stepped = world_.step(1 / hz_); stepped.ok()) {
        record_events();
        warn_of_quarantine();
        warn_of_large_chunks();
    } else if (!step_refused_) {
        step_refused_ = true;  // said once; the world stands still but answers
        log_error("world {}: step refused: {}", id_, stepped.error().message);
    }
    auto frame = std::make_shared<Frame>();
    frame->tick = tick_;
    frame->due = due;
    frame->late_ticks = late_ticks;
    frame->events = events_;
    world_.copy_into(*frame);
    measure(*frame);
    publish(std::move(frame));
    serve_queries();  // players first
}

// Readers hold what they were given, so each tick with events makes a new list of the newest ones.
void WorldHost::record_events() {
    if (event_listeners_.load() == 0) {
        if (!events_->ticks.empty())
            events_ = std::make_shared<const RecentEvents>(RecentEvents{events_->count, {}});
        return;
    }
    std::optional<TickEvents> happened = world_.events_of_step(tick_);
    if (!happened) return;
    const auto& old = events_->ticks;
    const std::size_t dropped = old.size() == RecentEvents::ticks_max ? 1 : 0;
    auto recent = std::make_shared<RecentEvents>();
    recent->count = events_->count + 1;
    recent->ticks.assign(old.begin() + static_cast<std::ptrdiff_t>(dropped), old.end());
    recent->ticks.push_back(std::make_shared<const TickEvents>(*std::move(happened)));
    events_ = std::move(recent);
}

void WorldHost::warn_of_quarantine() {
    for (const auto& entity : world_.newly_quarantined())
        log_warn(
            "world {}: the state of entity {} \"{}\" stopped being a number; it was put back to "
            "where it was, at rest",
            id_, entity->id, entity->name);
}

void WorldHost::warn_of_large_chunks() {
    for (const auto& [tag, bytes] : world_.newly_too_large())
        log_warn(
            "world {}: the chunk of module \"{}\" has {} bytes; clients are sent {} at most, so it "
            "is "
            "left out of such ticks",
            id_, tag, bytes, chunk_bytes_max);
}

void WorldHost::serve_queries() {
    if (const CopyParts parts = queries_.begin_tick(tick_, Clock::now()))
        queries_.put(world_.query_frame(tick_, parts));
}

void WorldHost::measure(Frame& frame) {
    recent_step_ms_[recent_next_] = frame.step_ms;
    recent_next_ = (recent_next_ + 1) % recent_step_ms_.size();
    frame.step_ms_mean = std::accumulate(recent_step_ms_.begin(), recent_step_ms_.end(), 0.0) /
                         static_cast<double>(recent_step_ms_.size());
    frame.step_ms_max = *std::max_element(recent_step_ms_.begin(), recent_step_ms_.end());
}

void WorldHost::publish(std::shared_ptr<Frame> frame) {
    FramePtr old;  // freed outside the lock
    {
        const std::lock_guard lock(frame_mutex_);
        old = std::exchange(frame_, std::move(frame));
    }
    // After the frame: who hears that a body was spawned finds it there.
    for (std::size_t i = 0; i < batch_.size(); i++)
        if (batch_[i].reply) batch_[i].reply->put(std::move(results_[i]));
    if (settings_.on_frame) settings_.on_frame();
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/world/world_host.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <numeric>

#include "server/util/log.h"
#include "server/world/result_queue.h"

namespace jostle::server {

namespace asio = boost::asio;
struct WorldHost::Timer {
    asio::io_context io{1};
    asio::steady_timer due{io};
};

Result<std::shared_ptr<WorldHost>> WorldHost::start(
    WorldLabel label, std::shared_ptr<const scenes::SceneDescription> scene,
    const WorldHostSettings& settings) {
    Result<HostedWorld> world =
        HostedWorld::create(*scene, settings.limits, settings.physics_threads);
    if (!world.ok()) return world.error();
    return begin({std::move(label), std::move(scene), *std::move(world)}, settings);
}

Result<std::shared_ptr<WorldHost>> WorldHost::begin(WorldStart start,
                                                    const WorldHostSettings& settings) {
    if (settings.world_persistence)
        if (Status s = settings.world_persistence->open(start); !s.ok()) return s.error();
    return WorldHost::start(std::move(start), settings);
}

std::shared_ptr<WorldHost> WorldHost::start(WorldStart start, const WorldHostSettings& settings) {
    return std::shared_ptr<WorldHost>(new WorldHost(std::move(start), settings));
}

WorldHost::WorldHost(WorldStart start, const WorldHostSettings& settings)
    : label_(std::move(start.label)),
      scene_(std::move(start.scene)),
      hz_(scene_->hz),
      work_per_second_(start.world.work_per_second()),
      gravity_(scene_->world.gravity),
      substeps_(scene_->world.tolerance > 0 ? 0 : scene_->world.substeps),
      epoch_(Clock::now() - from_seconds((start.tick - 1) / hz_)),
      first_tick_(start.tick),
      channel_kinds_(start.world.channel_kinds()),
      settings_(settings),
      world_(std::move(start.world)),
      world_journal_(std::move(start.world_journal)),
      tick_(start.tick),
      commands_(static_cast<std::size_t>(settings.command_queue_max)),
      scheduled_(static_cast<std::size_t>(settings.command_queue_max)),
      paused_(std::move(start.paused)),
      tick_metrics_(settings.metrics, label_.name),
      timer_(std::make_unique<Timer>()) {
    recent_tick_ms_.assign(static_cast<std::size_t>(std::max(1.0, hz_)), 0.0);
    auto first = std::make_shared<Frame>();
    first->tick = tick_;
    first->due = epoch_ + from_seconds(tick_ / hz_);
    first->events = events_;
    world_.copy_into(*first);
    frame_ = std::move(first);
    world_.frame_history().put(frame_);
    if (world_journal_) world_.enable_journal();
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
    world_.stop_stepping();
    cancel_waiters();
    timer_->io.stop();
    if (thread_.joinable()) thread_.join();
    if (checkpoint_copier_) checkpoint_copier_->finish();
    if (world_journal_ && !failed() && !skips_final_checkpoint_ && !ended_)
        world_journal_->end(step_aborted_ ? std::nullopt : std::optional(checkpoint_copy()));
    ended_ = true;
}

bool WorldHost::stop_for_replacement() {
    {
        const std::lock_guard lock(stop_mutex_);
        if (stopped()) return false;
        was_replaced_.store(true);  // before anybody sees that it stopped
        stopping_.store(true);
    }
    stop();
    return true;
}

void WorldHost::leave(ClientId client, bool retain_bodies) {
    const std::lock_guard lock(leave_mutex_);
    leave_commands_.push_back(
        {.client = client, .action = LeaveCommand{retain_bodies}, .reply = nullptr});
}

void WorldHost::disconnect(ClientId client) {
    const std::lock_guard lock(leave_mutex_);
    leave_commands_.push_back({.client = client, .action = DisconnectCommand{}, .reply = nullptr});
}

void WorldHost::pause(std::string reason) {
    const std::lock_guard lock(pause_mutex_);
    paused_ = std::move(reason);
}

void WorldHost::resume() {
    {
        const std::lock_guard lock(pause_mutex_);
        paused_.reset();
    }
    single_step_.cancel();
}

void WorldHost::cancel_waiters() {
    queries_.close();
    single_step_.close();
    tick_metrics_.close();
    between_ticks_.close();
}

std::optional<std::string> WorldHost::paused() const {
    const std::lock_guard lock(pause_mutex_);
    return paused_;
}

std::optional<Clock::time_point> WorldHost::tick_began() const {
    const Clock::rep began = tick_began_.load(std::memory_order_relaxed);
    if (began == 0) return std::nullopt;
    return Clock::time_point(Clock::duration(began));
}

void WorldHost::interrupt(std::string reason) {
    pause(std::move(reason));
    world_.stop_stepping();
}

void WorldHost::run() {
    // The first tick is the world as it was made; the clock counts from there.
    TickClock clock(epoch_ + from_seconds(tick_ / hz_), hz_, settings_.catch_up_ticks_max);
    std::function<void()> wait = [&] {
        timer_->due.expires_at(clock.next_due());
        timer_->due.async_wait([&](const boost::system::error_code& error) {
            if (error || stopping_.load(std::memory_order_relaxed)) return;
            for (int left = clock.due(Clock::now()); left > 0 && !stopping_; left--)
                tick_late(clock.begin_tick(), clock.late_ticks());
            wait();
        });
    };
    wait();
    // Out of memory, say: this world ends, its clients are told, and the others go on.
    try {
        timer_->io.run();
    } catch (const std::exception& error) {
        log_error("world {} \"{}\" ends: {}", id(), name(), error.what());
        failed_.store(true);
        stopping_.store(true);
        cancel_waiters();
    }
    tick_began_.store(0, std::memory_order_relaxed);
}

void WorldHost::tick(Clock::time_point due) {
    tick_late(due, 0);
}

QueryFramePtr WorldHost::query_frame(CopyLayers layers) {
    if (!settings_.own_thread && !stopped()) {
        queries_.request(layers, Clock::now());
        serve_queries();
    }
    return queries_.acquire(layers);
}

// One tick of one world. Nothing outside this thread ever touches world_, but to stop its step.
void WorldHost::tick_late(Clock::time_point due, std::uint32_t late_ticks) {
    const Clock::time_point began = Clock::now();
    tick_began_.store(began.time_since_epoch().count(), std::memory_order_relaxed);
    tick_metrics_.begin_tick(began);
    if (checkpoint_copier_) std::exchange(checkpoint_copier_, nullptr)->finish();
    tick_++;
    const std::optional<std::string> why = paused();
    const std::optional<Error> refusal = input_refusal(why);
    apply_commands(refusal, due);
    const bool allowed = why && single_step_.begin_step();
    const bool steps = !why || allowed;
    if (world_journal_) world_journal_->append({tick_, steps, world_.take_journal()});
    tick_metrics_.begin_step();
    const bool stepped = steps && step(allowed);
    auto frame = std::make_shared<Frame>();
    frame->tick = tick_;
    frame->due = due;
    frame->late_us = late_us(due);
    frame->late_ticks = late_ticks;
    frame->events = events_;
    frame->paused = why;
    world_.copy_into(*frame);
    if (!stepped) frame->step_ms = 0;
    measure(*frame, began);
    const FramePtr shown = frame;
    const bool answered = !world_journal_ || refusal;
    publish(std::move(frame), answered);
    if (world_journal_) persist_published(shown->step_ms, answered);
    serve_queries();  // players first
    single_step_.end_tick();
    between_ticks_.run_pending(world_);
    tick_metrics_.end_tick(*shown, stepped ? &world_.world().profile() : nullptr, batch_.size());
    hand_over_checkpoint();
    tick_began_.store(0, std::memory_order_relaxed);
}

// What was asked since the last tick, in order of arrival, but for what is meant for a later one;
// then who left. A leaver's own commands were pushed before, so those who left are taken first.
void WorldHost::apply_commands(const std::optional<Error>& refusal, Clock::time_point due) {
    {
        const std::lock_guard lock(leave_mutex_);
        leave_commands_taken_.swap(leave_commands_);
    }
    commands_.drain_into(batch_);
    scheduled_.select_due(batch_, tick_, leave_commands_taken_);
    results_.clear();
    for (const Command& command : batch_) results_.push_back(execute(command, refusal, due));
    for (const Command& command : leave_commands_taken_) world_.apply(command, tick_);
    leave_commands_taken_.clear();
}

std::optional<Error> WorldHost::input_refusal(const std::optional<std::string>& paused) const {
    if (paused) return Error{ErrorCode::resource_exhausted, "the world is paused: " + *paused};
    if (!world_journal_) return std::nullopt;
    const std::optional<std::string> failure_reason = world_journal_->failure_reason();
    if (!failure_reason) return std::nullopt;
    return Error{ErrorCode::unavailable, "nothing can be kept now, try again: " + *failure_reason};
}

InputResult WorldHost::execute(const Command& command, const std::optional<Error>& refusal,
                               Clock::time_point due) {
    InputResult result{.sequence = command.sequence, .tick = tick_};
    if (refusal)
        result.status = *refusal;
    else
        result = world_.apply(command, tick_);
    const std::int64_t meant = command.tick == 0 ? tick_ : command.tick;
    const std::chrono::duration<double> wait =
        due - command.received +
        std::chrono::duration<double>(static_cast<double>(meant - tick_) / hz_);
    result.margin_us = static_cast<std::int64_t>(1e6 * wait.count());
    return result;
}

bool WorldHost::step(bool allowed) {
    world_.publish_motion(motion_listeners_.load() > 0);
    world_.publish_controlled_entities(controlled_entity_listeners_.load() > 0);
    world_.resume_stepping();
    // interrupt() pauses before it stops: whoever resumed stepping just after it sees the pause.
    // The journal has a step there.
    if (stopping_ || (paused() && !allowed)) {
        (stopping_ ? step_aborted_ : step_interrupted_) = true;
        return false;
    }
    if (const auto stepped = world_.step(1 / hz_, tick_ + 1); stepped.ok()) {
        record_events();
        warn_of_quarantine();
        warn_of_large_channels();
        return true;
    } else if (stepped.error().code == ErrorCode::aborted) {
        (stopping_ ? step_aborted_ : step_interrupted_) = true;
        log_error("world {} \"{}\": a step was stopped and the world is paused: {}", id(), name(),
                  paused().value_or("the world is being closed"));
    } else if (!step_refused_) {
        step_refused_ = true;  // said once; the world stands still but answers
        log_error("world {}: step refused: {}", id(), stepped.error().message);
    }
    return false;
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
            id(), entity->id, entity->name);
}

void WorldHost::warn_of_large_channels() {
    for (const auto& [kind, entity, what] : world_.newly_oversized())
        log_warn("world {}: what \"{}\" tells of entity {} has {}, so it is left out of such ticks",
                 id(), kind, entity, what);
}

void WorldHost::serve_queries() {
    if (const CopyLayers layers = queries_.begin_tick(tick_, Clock::now()))
        queries_.put(world_.query_frame(tick_, layers));
}

// A microsecond is rounding.
std::int64_t WorldHost::late_us(Clock::time_point due) const {
    const Clock::time_point on_time = epoch_ + from_seconds(static_cast<double>(tick_) / hz_);
    const auto late = std::chrono::duration_cast<std::chrono::microseconds>(due - on_time).count();
    return std::abs(late) <= 1 ? 0 : late;
}

// The whole tick, with commands and the copy: what is not measured cannot be seen to be too long.
void WorldHost::measure(Frame& frame, Clock::time_point began) {
    recent_tick_ms_[recent_next_] = to_ms(Clock::now() - began);
    recent_next_ = (recent_next_ + 1) % recent_tick_ms_.size();
    frame.tick_ms_mean = std::accumulate(recent_tick_ms_.begin(), recent_tick_ms_.end(), 0.0) /
                         static_cast<double>(recent_tick_ms_.size());
    frame.tick_ms_max = *std::max_element(recent_tick_ms_.begin(), recent_tick_ms_.end());
}

void WorldHost::publish(std::shared_ptr<Frame> frame, bool answers) {
    FramePtr old;  // freed outside the lock
    const std::uint32_t events = frame->events->count;
    bool has_events = frame->changed_at == frame->tick || !batch_.empty();
    world_.frame_history().put(frame);
    {
        const std::lock_guard lock(frame_mutex_);
        old = std::exchange(frame_, std::move(frame));
    }
    // After the frame: who hears that a body was spawned finds it there.
    for (std::size_t i = 0; answers && i < batch_.size(); i++)
        if (batch_[i].reply) batch_[i].reply->put(std::move(results_[i]));
    has_events = has_events || events != old->events->count;
    if (settings_.on_frame) settings_.on_frame(has_events);
}

CheckpointCopy WorldHost::checkpoint_copy() const {
    CheckpointCopy now{.tick = tick_,
                       .bodies = world_journal_->take_spare_restore_point(),
                       .host_state = world_.host_state(tick_)};
    now.bodies.capture(world_.world());
    return now;
}

void WorldHost::persist_published(double step_ms, bool answered) {
    if (std::exchange(step_interrupted_, false)) world_journal_->on_interrupted();
    std::vector<WaitingResult> results;
    for (std::size_t i = 0; !answered && i < batch_.size(); i++)
        if (batch_[i].reply) results.push_back({batch_[i].reply, std::move(results_[i])});
    world_journal_->on_published(step_ms, std::move(results));
}

// The last thing in a tick: from here on others read the world, until the next one begins.
void WorldHost::hand_over_checkpoint() {
    if (!world_journal_ || step_aborted_ || !world_journal_->wants_checkpoint()) return;
    auto taken = std::make_shared<CheckpointCopier>([this] { return checkpoint_copy(); });
    world_journal_->write_checkpoint(tick_, taken);
    if (taken.use_count() == 1) return;          // it is of no use now
    if (!settings_.own_thread) taken->finish();  // who ticks it may look at it in between
    checkpoint_copier_ = std::move(taken);
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/world/world_host.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "jostle/base/check.h"
#include "server/auth/identity.h"
#include "server/util/log.h"
#include "server/world/command_mailbox.h"

namespace jostle::server {

namespace {

// Length of a rest. A checkpoint or an operator's request may wait for this long.
constexpr double rest_seconds = 0.25;
// A world rests after this time without a change.
constexpr double rests_after_seconds = 1;

// The latest time at which a world of this rate may begin. The worlds of a process begin at
// different fractions of their periods (the golden ratio spreads any number of them), so that their
// ticks do not wait for each other.
Clock::time_point begin_of_world(Clock::time_point now, double hz) {
    static std::atomic<std::uint32_t> worlds = 0;
    const double part = std::fmod(0.6180339887498949 * worlds++, 1.0);
    const double periods =
        std::chrono::duration<double>(now.time_since_epoch()).count() * hz - part;
    return now - from_seconds((periods - std::floor(periods)) / hz);
}

WorldProperties properties_of(WorldStart& start) {
    ASSERT(start.scene && start.tick > 0);
    const scenes::SceneDescription& scene = *start.scene;
    return {
        .label = std::move(start.label),
        .scene = start.scene,
        .hz = scene.hz,
        .work_per_second = start.world.work_per_second(),
        .gravity = scene.world.gravity,
        .substeps = scene.world.tolerance > 0 ? 0 : scene.world.substeps,
        .epoch = begin_of_world(Clock::now(), scene.hz) - from_seconds((start.tick - 1) / scene.hz),
        .first_tick = start.tick,
        .is_room = start.world.room() != nullptr,
        .channel_kinds = start.world.channel_kinds()};
}

// The reason of a pause by a member of the room, who may end it.
constexpr std::string_view room_pause = "by a member of the room";

std::optional<Error> pause_refusal(const std::optional<std::string>& paused) {
    if (!paused) return std::nullopt;
    return Error{ErrorCode::resource_exhausted, "the world is paused: " + *paused};
}

}  // namespace

Result<std::shared_ptr<WorldHost>> WorldHost::start(
    WorldLabel label, std::shared_ptr<const scenes::SceneDescription> scene,
    const WorldHostSettings& settings, std::optional<RoomState> room) {
    Result<HostedWorld> world =
        HostedWorld::create(*scene, settings.limits, settings.physics_threads);
    if (!world.ok()) return world.error();
    world->set_room(std::move(room));
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
    : properties_(properties_of(start)),
      settings_(settings),
      lifecycle_(std::move(start.paused)),
      mailbox_(static_cast<std::size_t>(settings.command_queue_max), [this] { wake(); }),
      publisher_(properties_.hz, settings.on_frame),
      world_(std::move(start.world)),
      tick_(start.tick),
      scheduler_(settings.inputs, properties_.hz),
      body_limits_(settings.body_limits, properties_.hz),
      // The burst has space for the largest message.
      message_bytes_(settings.user_message_bytes_per_second,
                     std::max(settings.user_message_bytes_per_second, 131072.0), properties_.epoch),
      timeline_(start.timeline ? std::move(start.timeline)
                : properties_.is_room
                    ? std::make_shared<Timeline>(properties_.hz, start.world_journal == nullptr)
                    : nullptr),
      reports_(start.reports ? std::move(start.reports) : std::make_shared<PlayerReports>()),
      world_journal_(std::move(start.world_journal)),
      // A world without ticks of its own does not depend on measured times.
      queries_(settings.own_ticks ? settings.query_copy_share / properties_.hz : 0),
      tick_metrics_(settings.metrics, properties_.label.name) {
    auto first = std::make_shared<Frame>();
    first->tick = tick_;
    first->due = properties_.due_time(tick_);
    first->events = publisher_.events();
    world_.copy_into(*first);
    world_.frame_history().put(first, false);
    publisher_.set_frame(std::move(first));
    static_cast<void>(world_.take_room_requests());  // of commands that a recovery replayed
    if (world_journal_) world_.enable_journal();
    speed_percent_ = start.speed_percent;
    publisher_.set_speed(start.speed_percent / 100.0);
    if (!settings_.own_ticks) return;
    // The first tick is the world as it was built; the loop continues from there.
    loop_.start(
        settings_.tick_pool ? settings_.tick_pool : std::make_shared<TickPool>(1),
        {.hz = properties_.hz,
         .catch_up_ticks_max = settings_.catch_up_ticks_max,
         .rest_ticks = std::max(1, static_cast<int>(rest_seconds * properties_.hz)),
         .speed = start.speed_percent / 100.0},
        properties_.due_time(tick_), [this](const TickLoop::Tick& tick) { return run_tick(tick); },
        [this] { return lifecycle_.stopped(); },
        // Out of memory, for example: this world ends, its clients are notified and the other
        // worlds continue.
        [this](const char* what) {
            log_error("world {} \"{}\" failed: {}", id(), name(), what);
            lifecycle_.set_failed();
            cancel_waiters();
            lifecycle_.end_tick();
        });
}

std::string WorldHost::owner() const {
    const std::string& creator = properties_.label.owner;
    if (!properties_.is_room) return creator;
    const RoomView room = frame()->room;
    if (!room->owner.empty()) return room->owner.substr(subject_member.size());
    return creator == anonymous_subject ? creator : std::string();
}

WorldHost::~WorldHost() {
    stop();
}

void WorldHost::stop() {
    const std::lock_guard lock(stop_mutex_);
    lifecycle_.set_stopped();
    world_.stop_stepping();
    cancel_waiters();
    loop_.stop();
    if (checkpoint_copier_) checkpoint_copier_->finish();
    if (world_journal_ && !lifecycle_.failed() && !skips_final_checkpoint_ && !ended_)
        world_journal_->end(step_aborted_ ? std::nullopt : std::optional(checkpoint_copy()));
    ended_ = true;
}

bool WorldHost::stop_for_replacement() {
    {
        const std::lock_guard lock(stop_mutex_);
        if (lifecycle_.stopped()) return false;
        lifecycle_.set_replaced();
    }
    stop();
    return true;
}

void WorldHost::pause(std::string reason) {
    log_info("world {} \"{}\" was paused: {}", id(), name(), reason);
    lifecycle_.pause(std::move(reason));
    wake();
    tick_metrics_.count_pause(PauseCause::request);
}

void WorldHost::resume() {
    if (lifecycle_.paused()) log_info("world {} \"{}\" was resumed", id(), name());
    lifecycle_.clear_pause();
    single_step_.cancel();
    wake();
}

// Pauses before it stops the step: see step().
void WorldHost::interrupt_overloaded(std::string reason, Clock::time_point now) {
    if (!lifecycle_.pause_overloaded(std::move(reason), now)) return;
    world_.stop_stepping();
    tick_metrics_.count_pause(PauseCause::overload);
    log_warn("world {} \"{}\" was paused: {}", id(), name(), lifecycle_.paused().value_or(""));
}

void WorldHost::resume_if_due(Clock::time_point now) {
    if (!lifecycle_.resume_if_due(now)) return;
    single_step_.cancel();
    log_info("world {} \"{}\" resumed by itself", id(), name());
}

void WorldHost::cancel_waiters() {
    queries_.close();
    single_step_.close();
    tick_metrics_.close();
    between_ticks_.close();
}

QueryFramePtr WorldHost::query_frame(CopyLayers layers) {
    if (!settings_.own_ticks && !lifecycle_.stopped()) {
        queries_.request(layers, Clock::now());
        serve_queries();
    }
    queries_.request(layers, Clock::now());
    wake();
    return queries_.acquire(layers);
}

bool WorldHost::run_tick(const TickLoop::Tick& tick) {
    if (rests_ && tick.following > 0) {
        run_resting_tick(tick.due);
        return true;
    }
    run_tick(tick.due, tick.late_ticks);
    rests_ = may_rest(*publisher_.frame());
    return rests_;
}

bool WorldHost::may_rest(const Frame& frame) const {
    const auto unchanged = static_cast<double>(frame.tick - frame.changed_at);
    return (frame.awake == 0 || frame.paused) && unchanged > rests_after_seconds * properties_.hz &&
           publisher_.listeners().streams.load() == 0 && results_.empty() &&
           scheduler_.waiting() == 0 && mailbox_.is_empty() && !queries_.is_requested() &&
           !tick_metrics_.is_recording();
}

void WorldHost::run_resting_tick(Clock::time_point due) {
    if (checkpoint_copier_) std::exchange(checkpoint_copier_, nullptr)->finish();
    // The last of the ticks that run at once ends it. Processor times cost more than such a tick.
    if (!lifecycle_.is_in_tick()) lifecycle_.begin_tick(Clock::now());
    tick_++;
    const bool steps = !lifecycle_.paused();
    if (world_journal_) world_journal_->append({tick_, steps, world_.take_journal()});
    results_.clear();
    if (steps) {
        step(false);
        publisher_.count_resting_tick(due);
    }
    tick_metrics_.count_resting_tick();
    if (world_journal_) persist_published(0, true);
}

// One tick. No other thread touches world_ meanwhile, except to stop its step.
void WorldHost::run_tick(Clock::time_point due, std::uint32_t late_ticks) {
    const Clock::time_point began = Clock::now();
    lifecycle_.begin_tick(began);
    tick_metrics_.begin_tick(began);
    cpu_time_.use_this_thread();
    cpu_at_begin_ = cpu_time_.now().value_or(std::chrono::nanoseconds(0));
    if (checkpoint_copier_) std::exchange(checkpoint_copier_, nullptr)->finish();
    tick_++;
    ASSERT(tick_ > properties_.first_tick);
    const std::optional<std::string> paused = lifecycle_.paused();
    const std::optional<Error> refusal = input_refusal(paused);
    const bool applies_data = apply_commands(refusal, due);
    remove_excess_bodies(began);
    if (!is_paused_by_room()) room_steps_ = 0;
    bool allowed = paused && single_step_.begin_step();
    if (paused && !allowed && room_steps_ > 0) {
        room_steps_--;
        allowed = true;
    }
    const bool steps = !paused || allowed;
    if (world_journal_) world_journal_->append({tick_, steps, world_.take_journal()});
    const Room::Requests room_requests = world_.take_room_requests();
    tick_metrics_.begin_step();
    const bool stepped = steps && step(allowed);
    const std::shared_ptr<Frame> frame = make_frame(due, late_ticks);
    frame->paused = paused;
    frame->speed_percent = speed_percent_;
    store_timeline(stepped);
    if (timeline_) frame->restorable_ticks = timeline_->ticks();
    if (!stepped) frame->step_ms = 0;
    ASSERT(frame->tick == tick_ && frame->entity_list);
    publisher_.measure(*frame, began);
    const bool sends_results = !world_journal_ || (refusal && !applies_data);
    publish(frame, sends_results);
    if (world_journal_) persist_published(frame->step_ms, sends_results);
    reports_->add_from(*frame, properties_.label, began);
    serve_queries();  // after the frame, which has priority
    single_step_.end_tick();
    grant_room_requests(room_requests);
    between_ticks_.run_pending(world_);
    tick_metrics_.end_tick(*frame, stepped ? &world_.world().profile() : nullptr,
                           results_.size() + scheduler_.waiting());
    hand_over_checkpoint();
    const std::chrono::nanoseconds cpu_now = cpu_time_.now().value_or(cpu_at_begin_);
    body_limits_.end_tick(std::chrono::duration<double>(cpu_now - cpu_at_begin_).count(), stepped);
    log_time_scale(*frame, began);
    lifecycle_.end_tick();
}

void WorldHost::log_time_scale(const Frame& frame, Clock::time_point now) {
    const TimeScale::Change change = publisher_.poll_time_scale(now);
    if (change == TimeScale::Change::behind)
        log_warn(
            "world {} \"{}\" falls behind: time scale {:.2f}, ticks of {:.1f} ms on average, {} "
            "late "
            "ticks",
            id(), name(), frame.time_scale, frame.tick_ms_mean, frame.late_ticks);
    else if (change == TimeScale::Change::caught_up)
        log_info("world {} \"{}\" keeps its rate again", id(), name());
}

std::optional<Error> WorldHost::input_refusal(const std::optional<std::string>& paused) const {
    if (paused) return pause_refusal(paused);
    if (!world_journal_) return std::nullopt;
    const std::optional<std::string> failure = world_journal_->failure_reason();
    if (!failure) return std::nullopt;
    return Error{ErrorCode::unavailable, "the input cannot be persisted, retry later: " + *failure};
}

// A pause or the end of the world during the tick refuses the rest of its inputs, except those
// about players, attributes and messages, which a pause does not concern.
bool WorldHost::apply_commands(std::optional<Error> refusal, Clock::time_point due) {
    mailbox_.take_due(tick_);
    results_.clear();
    if (world_.room())
        for (const Command& command : mailbox_.entries()) world_.apply(command, tick_);
    apply_joins(mailbox_.join_commands());
    scheduler_.begin_tick(mailbox_.inputs(), mailbox_.leave_commands());
    const bool may_persist = !world_journal_ || !world_journal_->failure_reason();
    bool applies_data = false;
    const auto is_refused = [&](const Command& command) {
        if (!refusal) return false;
        const bool builds =
            is_build_command(command.action) || std::holds_alternative<RoomCommand>(command.action);
        if (!may_persist || lifecycle_.stopped() ||
            !(is_data_command(command.action) || (builds && is_paused_by_room())))
            return true;
        applies_data = true;
        return false;
    };
    std::chrono::nanoseconds before = cpu_time_.now().value_or(std::chrono::nanoseconds(0));
    while (const Command* const command = scheduler_.next()) {
        if (!refusal && lifecycle_.stopped())
            refusal = Error{ErrorCode::unavailable, "the world is being closed"};
        else if (!refusal)
            refusal = pause_refusal(lifecycle_.paused());
        std::optional<InputResult> resumed;
        if (refusal && world_.room()) resumed = resume_room(*command);
        put_result(*command,
                   resumed ? *std::move(resumed)
                   : is_refused(*command)
                       ? InputResult{.sequence = command->sequence, .status = *refusal}
                       : apply(*command, due),
                   due);
        const std::chrono::nanoseconds after = cpu_time_.now().value_or(before);
        scheduler_.charge(std::chrono::duration<double>(after - before).count());
        before = after;
    }
    for (InputScheduler::Refused& refused : scheduler_.take_refused())
        put_result(refused.command,
                   refusal ? InputResult{.sequence = refused.command.sequence, .status = *refusal}
                           : world_.refuse(refused.command, std::move(refused.status), tick_),
                   due);
    for (const Command& command : mailbox_.leave_commands()) {
        const LeaveCommand* const leave = std::get_if<LeaveCommand>(&command.action);
        if (leave && leave->retain_bodies)
            body_limits_.on_retained(world_.ownership().owned_by(command.client), due);
        world_.apply(command, tick_);
    }
    apply_joins(mailbox_.late_join_commands());
    return applies_data;
}

void WorldHost::apply_joins(std::span<Command> joins) {
    for (Command& command : joins) {
        std::get<JoinCommand>(command.action).tick = tick_;
        world_.apply(command, tick_);
    }
}

std::optional<Error> WorldHost::message_refusal(const Command& command, Clock::time_point due) {
    const auto* const message = std::get_if<SendMessageCommand>(&command.action);
    const double rate = settings_.user_message_bytes_per_second;
    if (!message || rate == 0) return std::nullopt;
    const auto bytes = static_cast<double>(message->topic.size() + message->data.size());
    if (message_bytes_.take(bytes, due)) return std::nullopt;
    const double wait_ms = std::ceil(to_ms(message_bytes_.wait_for(bytes, due)));
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("the clients of this world send more than {:g} bytes of messages per "
                             "second (world.user_message_bytes_per_second); retry after {:g} ms",
                             rate, wait_ms),
                 static_cast<int>(std::min(wait_ms, 1e9))};
}

InputResult WorldHost::apply(const Command& command, Clock::time_point due) {
    std::optional<Error> refused = body_limits_.refusal(command, world_.ownership());
    if (!refused) refused = message_refusal(command, due);
    if (!refused) refused = time_refusal(command);
    return refused ? world_.refuse(command, *std::move(refused), tick_)
                   : world_.apply(command, tick_);
}

bool WorldHost::is_paused_by_room() const {
    return lifecycle_.paused() == room_pause;
}

std::optional<Error> WorldHost::time_refusal(const Command& command) const {
    const auto* const about_room = std::get_if<RoomCommand>(&command.action);
    if (!about_room || !timeline_) return std::nullopt;
    if (std::holds_alternative<StepRoom>(about_room->kind) && !is_paused_by_room())
        return Error{ErrorCode::permission_denied,
                     "no member of the room paused the world; pause it before a step"};
    const auto* const rewind = std::get_if<RewindRoom>(&about_room->kind);
    if (!rewind || timeline_->contains(rewind->tick)) return std::nullopt;
    const std::vector<std::uint32_t>& ticks = *timeline_->ticks();
    if (ticks.empty())
        return Error{ErrorCode::not_found,
                     "the room has no timeline; set timeline_seconds in its settings"};
    return Error{ErrorCode::not_found,
                 fmt::format("rewind.tick is {}; the timeline has {} states from tick {} to tick "
                             "{}, one per second",
                             rewind->tick, ticks.size(), ticks.front(), ticks.back())};
}

void WorldHost::set_speed(std::uint32_t percent) {
    if (speed_percent_.exchange(percent) == percent) return;
    loop_.set_speed(percent / 100.0);
    publisher_.set_speed(percent / 100.0);
    log_info("world {} \"{}\" runs at {} % of real time", id(), name(), percent);
}

void WorldHost::store_timeline(bool stepped) {
    // The state of a requested rewind stays until the rewind.
    if (!timeline_ || step_aborted_ || requested_rewind_.load() != 0) return;
    timeline_->on_tick(tick_, stepped, world_, world_.room()->state().properties.timeline_seconds,
                       oldest_restorable_tick());
}

std::optional<InputResult> WorldHost::resume_room(const Command& command) {
    const auto* const about_room = std::get_if<RoomCommand>(&command.action);
    const auto* const pause = about_room ? std::get_if<PauseRoom>(&about_room->kind) : nullptr;
    if (!pause || pause->paused || lifecycle_.paused() != room_pause) return std::nullopt;
    InputResult result{.sequence = command.sequence,
                       .status = world_.room()->may(command.client, RoomAction::pause)};
    if (result.status.ok()) resume();
    return result;
}

void WorldHost::grant_room_requests(const Room::Requests& requests) {
    if (requests.reset) is_reset_requested_ = true;
    if (requests.paused == true && !lifecycle_.paused()) pause(std::string(room_pause));
    room_steps_ = std::min(room_steps_ + requests.steps, StepRoom::steps_max);
    if (requests.speed_percent) set_speed(*requests.speed_percent);
    if (requests.rewind && timeline_ && timeline_->contains(*requests.rewind))
        requested_rewind_ = *requests.rewind;
}

void WorldHost::remove_excess_bodies(Clock::time_point now) {
    const BodyLimits::Removal removal = body_limits_.take_removals(world_.ownership(), now);
    world_.remove_entities(removal.expired);
    if (removal.excess.empty()) return;
    world_.remove_entities(removal.excess);
    log_warn(
        "world {} \"{}\" cannot keep its rate (load {:.2f}): removed {} bodies of the players with "
        "most bodies",
        id(), name(), body_limits_.load(), removal.excess.size());
}

void WorldHost::put_result(const Command& command, InputResult result, Clock::time_point due) {
    const std::int64_t target = command.tick == 0 ? tick_ : command.tick;
    const std::chrono::duration<double> margin =
        due - command.received +
        std::chrono::duration<double>(static_cast<double>(target - tick_) / properties_.hz);
    result.tick = tick_;
    result.margin_us = static_cast<std::int64_t>(1e6 * margin.count());
    results_.push_back({command.reply, std::move(result)});
}

bool WorldHost::step(bool allowed) {
    const FrameListeners& listeners = publisher_.listeners();
    world_.publish_motion(listeners.motion.load() > 0);
    world_.publish_points(listeners.points.load() > 0 || queries_.is_requested(copy_points));
    world_.publish_controlled_entities(listeners.controlled_entities.load() > 0);
    world_.publish_joints(listeners.joints.load() > 0);
    world_.resume_stepping();
    // interrupt_overloaded() pauses before it stops the step, so resuming here just after it still
    // sees the pause. The journal already contains a step for this tick.
    const bool ends = lifecycle_.stopped();
    if (ends || (lifecycle_.paused() && !allowed)) {
        (ends ? step_aborted_ : step_interrupted_) = true;
        return false;
    }
    if (const auto stepped = world_.step(1 / properties_.hz, tick_); stepped.ok()) {
        publisher_.record_events(listeners.events.load() > 0 ? world_.events_of_step(tick_)
                                                             : std::nullopt);
        log_step_warnings();
        return true;
    } else if (stepped.error().code == ErrorCode::aborted) {
        (lifecycle_.stopped() ? step_aborted_ : step_interrupted_) = true;
    } else if (!step_refused_) {
        step_refused_ = true;  // logged once; the world no longer moves but still serves clients
        log_error("world {} \"{}\": step failed: {}", id(), name(), stepped.error().message);
    }
    return false;
}

void WorldHost::log_step_warnings() {
    const int skipped = world_.world().profile().pairs_skipped;
    if (const Clock::time_point now = Clock::now(); skipped > 0 && now >= next_pairs_warning_) {
        next_pairs_warning_ = now + std::chrono::seconds(10);
        log_warn(
            "world {} \"{}\": {} overlapping pairs of shapes were skipped and pass through each "
            "other (scene.pairs_per_shape_max is {})",
            id(), name(), skipped, settings_.limits.scene.pairs_per_shape_max);
    }
    for (const auto& entity : world_.newly_quarantined())
        log_warn(
            "world {}: the state of entity {} \"{}\" became non-finite; the entity was reset to "
            "its "
            "last finite pose at rest",
            id(), entity->id, entity->name);
    for (const auto& [kind, entity, reason] : world_.newly_oversized())
        log_warn("world {}: skipped channel \"{}\" of entity {} with {}", id(), kind, entity,
                 reason);
}

std::shared_ptr<Frame> WorldHost::make_frame(Clock::time_point due, std::uint32_t late_ticks) {
    auto frame = std::make_shared<Frame>();
    const auto late =
        std::chrono::duration_cast<std::chrono::microseconds>(due - properties_.due_time(tick_))
            .count();
    frame->tick = tick_;
    frame->due = due;
    frame->late_us = std::abs(late) <= 1 ? 0 : late;  // 1 us is rounding
    frame->late_ticks = late_ticks;
    frame->events = publisher_.events();
    world_.copy_into(*frame);
    return frame;
}

// Results follow the frame, so that a client finds a spawned body in the frame.
void WorldHost::publish(const std::shared_ptr<Frame>& frame, bool sends_results) {
    frame->published = Clock::now();
    world_.frame_history().put(frame, publisher_.listeners().streams.load() > 0);
    publisher_.set_frame(frame);
    if (sends_results)
        for (WaitingResult& waiting : results_)
            if (waiting.reply) waiting.reply->put(std::move(waiting.result));
    publisher_.notify(frame->changed_at == frame->tick || frame->has_new_data || !results_.empty());
}

void WorldHost::serve_queries() {
    const CopyLayers layers = queries_.begin_tick(tick_, Clock::now());
    if (layers == 0) return;
    const auto before = cpu_time_.now();
    queries_.put(world_.query_frame(tick_, layers));
    const auto after = cpu_time_.now();
    if (before && after) queries_.charge(std::chrono::duration<double>(*after - *before).count());
}

CheckpointCopy WorldHost::checkpoint_copy() const {
    ASSERT(world_journal_);
    CheckpointCopy copy{.tick = tick_,
                        .bodies = world_journal_->take_spare_restore_point(),
                        .host_state = world_.host_state(tick_)};
    copy.bodies.capture(world_.world());
    return copy;
}

void WorldHost::persist_published(double step_ms, bool results_sent) {
    if (std::exchange(step_interrupted_, false)) world_journal_->on_interrupted();
    std::vector<WaitingResult> results;
    for (WaitingResult& waiting : results_)
        if (!results_sent && waiting.reply) results.push_back(std::move(waiting));
    world_journal_->on_published(step_ms, std::move(results));
}

// The last part of a tick: other threads may read the world until the next tick begins.
void WorldHost::hand_over_checkpoint() {
    if (!world_journal_ || step_aborted_ || !world_journal_->wants_checkpoint()) return;
    auto copier = std::make_shared<CheckpointCopier>([this] { return checkpoint_copy(); });
    world_journal_->write_checkpoint(tick_, copier);
    if (copier.use_count() == 1) return;         // the journal does not need it any more
    if (!settings_.own_ticks) copier->finish();  // the caller of tick() may read the world
    ASSERT(!checkpoint_copier_);
    checkpoint_copier_ = std::move(copier);
}

}  // namespace jostle::server

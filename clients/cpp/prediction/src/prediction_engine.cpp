// SPDX-License-Identifier: MIT
#include "clients/cpp/prediction/src/prediction_engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/modules/controlled_entity_state.h"

namespace jostle::client {

using namespace physics;

namespace {

// A frame and a matching prediction differ by the quantization of the frame (1.7 mm, 5 mrad at the
// default of 512 units per metre) and a small tolerance.
constexpr double position_tolerance_m = 0.003, rotation_tolerance_rad = 0.01;
// Difference between the motion of a body in two frames and its prediction: a smaller one is
// quantization noise, a larger one is caused by a push.
constexpr double disturbance_speed = 0.25, disturbance_spin = 1;                // m/s, rad/s
constexpr double control_speed_tolerance = 0.05, control_spin_tolerance = 0.1;  // m/s, rad/s
// of neighbor_radius_m: distance at which a neighbour is removed
constexpr double leave_factor = 1.5;
constexpr double boundary_factor = 2;
constexpr std::size_t boundary_max = 64;
constexpr std::uint32_t slow_ticks = 15;
constexpr std::size_t inputs_max = 1024;
constexpr std::int64_t sample_gap_max_us = 250'000;
// The stream carries the state of the controlled entity, and frames may overtake it.
constexpr std::uint32_t late_ticks = 8;
constexpr std::uint32_t control_timeout_ticks = 60;

double gap(const Vec3& a, const Vec3& b) {
    return length(a - b);
}

bool poses_agree(const Transform& a, const Transform& b) {
    return gap(a.position, b.position) <= position_tolerance_m &&
           length(rotation_vector_between(a.rotation, b.rotation)) <= rotation_tolerance_rad;
}

// A push is visible in the velocity before it is visible in the pose.
bool was_disturbed(const MotionState& guess, const BodyUpdate& update) {
    return update.velocity && !update.at_rest &&
           (gap(guess.linear, update.velocity->linear) > disturbance_speed ||
            gap(guess.angular, update.velocity->angular) > disturbance_spin);
}

// A body controlled by a remote module moves with the velocity of the frames. A body with joints is
// kinematic: it keeps its velocity and nothing in the local world moves it.
LocalBody local_body(const BodyUpdate& update, bool own) {
    return {.type = update.jointed && update.type == BodyType::dynamic ? BodyType::kinematic
                                                                       : update.type,
            .mass = update.mass,
            .linear_damping = update.linear_damping,
            .angular_damping = update.angular_damping,
            .gravity_scale = update.controllable && !own ? 0 : update.gravity_scale,
            .locks = update.locks};
}

// Static bodies and resting kinematic bodies are not simulated.
bool is_simulated(const BodyUpdate& body) {
    return body.type == BodyType::dynamic || (body.type == BodyType::kinematic && !body.at_rest);
}

const BodyUpdate* find_body(const FrameUpdate& frame, std::uint32_t entity) {
    const auto at =
        std::lower_bound(frame.bodies.begin(), frame.bodies.end(), entity,
                         [](const BodyUpdate& body, std::uint32_t id) { return body.entity < id; });
    return at != frame.bodies.end() && at->entity == entity ? &*at : nullptr;
}

}  // namespace

void PredictionEngine::begin(Vec3 gravity, double tick_hz, int substeps) {
    reset_world();
    newest_control_ = 0;
    substeps_ = substeps >= 1 && substeps <= 64 ? substeps : options_.substeps;
    inputs_.clear();
    rendered_.clear();
    gravity_ = gravity;
    if (tick_hz >= 4 && tick_hz <= 1e4) tick_s_ = 1 / tick_hz;
}

void PredictionEngine::follow(std::uint32_t entity) {
    if (entity_ == entity) return;
    entity_ = entity;
    reset_world();
    newest_control_ = 0;
}

void PredictionEngine::add_action(std::uint32_t sequence, std::uint32_t input_tick,
                                  InputAction action) {
    if (sequence == 0 || input_tick == 0) return;
    std::uint32_t first = input_tick;
    if (!inputs_.empty() && inputs_.back().sequence == sequence) {
        first = std::min(first, inputs_.back().tick);
        inputs_.pop_back();
    }
    inputs_.push_back({sequence, input_tick, std::move(action)});
    if (inputs_.size() > inputs_max) inputs_.pop_front();
    // A new input of this client is not a misprediction; its effect is shown immediately.
    const bool changed = changed_;
    const bool late = !history_.empty() && input_tick < tick();
    resimulate_from(first);
    changed_ = changed || late;
}

void PredictionEngine::on_result(std::uint32_t sequence, std::uint32_t applied_in, bool applied) {
    const auto sent = std::find_if(inputs_.begin(), inputs_.end(),
                                   [&](const Sent& s) { return s.sequence == sequence; });
    if (sent == inputs_.end()) return;
    const std::uint32_t requested_tick = sent->tick;
    if (!applied)
        inputs_.erase(sent);
    else if (applied_in != requested_tick)
        sent->tick = applied_in;
    else
        return;
    resimulate_from(std::min(requested_tick, std::max(1u, applied_in)));
}

// --- ticks ---

void PredictionEngine::reset_world() {
    world_.reset();
    history_.clear();
    near_updates_.clear();
    boundary_.clear();
    corrected_.clear();
    newest_frame_ = 0;
    extra_radius_ = 0;
}

PredictionEngine::TickState* PredictionEngine::find(std::uint32_t target) {
    if (history_.empty() || target < history_.front().tick || target > tick()) return nullptr;
    return &history_[target - history_.front().tick];
}

void PredictionEngine::save(std::uint32_t at) {
    history_.emplace_back();
    if (!free_states_.empty()) {
        history_.back() = std::move(free_states_.back());
        free_states_.pop_back();
    }
    world_->save(history_.back(), at);
}

void PredictionEngine::drop_oldest() {
    free_states_.push_back(std::move(history_.front()));
    history_.pop_front();
}

void PredictionEngine::drop_newest() {
    free_states_.push_back(std::move(history_.back()));
    history_.pop_back();
}

void PredictionEngine::step() {
    const std::uint32_t next = tick() + 1;
    for (const Sent& sent : inputs_)
        if (sent.tick == next) world_->apply(sent.action);
    world_->step(tick_s_);
    stats_.steps++;
    save(next);
}

void PredictionEngine::step_to(std::uint32_t target) {
    while (tick() < target) step();
}

// Restores the world to its state after a tick and discards later states.
void PredictionEngine::roll_back(std::uint32_t to) {
    world_->roll_back(*find(to));
    while (tick() > to) drop_newest();
    changed_ = true;
}

// Repeats the steps from a tick on, because its inputs changed.
void PredictionEngine::resimulate_from(std::uint32_t first) {
    if (history_.empty() || first > tick() || first == 0) return;
    const std::uint32_t now = tick();
    // The state of the newest frame is authoritative.
    roll_back(std::max({first - 1, history_.front().tick, newest_frame_}));
    step_to(now);
}

// --- frames ---

// Selects the bodies near the current or the predicted position of the followed body, with
// hysteresis, and the closest of the others as boundary.
PredictionEngine::Neighborhood PredictionEngine::collect_neighbors(const FrameUpdate& frame,
                                                                   const Vec3& center) const {
    std::vector<std::pair<double, const BodyUpdate*>> candidates;
    const MotionState* const predicted =
        is_member(entity_) ? &history_.back().motions.at(entity_) : nullptr;
    for (const BodyUpdate& body : frame.bodies) {
        const bool own = body.entity == entity_;
        if (!is_simulated(body) && !own) continue;
        const Vec3& at = body.pose.position;
        double far = own ? 0 : gap(at, center);
        if (predicted && !own) far = std::min(far, gap(at, predicted->pose.position));
        far = std::max(0.0, far - extra_radius_);
        if (far <= boundary_factor * options_.neighbor_radius_m)
            candidates.emplace_back(far, &body);
    }
    std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return std::pair(a.first, a.second->entity) < std::pair(b.first, b.second->entity);
    });
    Neighborhood neighborhood;
    for (const auto& [far, body] : candidates) {
        const double most = is_member(body->entity) ? leave_factor * options_.neighbor_radius_m
                                                    : options_.neighbor_radius_m;
        // Kinematic bodies cost almost nothing.
        const bool railed = body->type == BodyType::kinematic;
        if (railed || (far <= most && neighborhood.near.size() < options_.neighbors_max))
            neighborhood.near[body->entity] = *body;
        else if (neighborhood.boundary.size() < boundary_max)
            neighborhood.boundary[body->entity] = *body;
    }
    return neighborhood;
}

bool PredictionEngine::add(const FrameUpdate& frame, const BodyUpdate& body,
                           const MotionState& motion) {
    const auto shapes = frame.shapes_of(body.entity);
    return shapes && world_->add(body.entity, local_body(body, body.entity == entity_), *shapes,
                                 motion, body.at_rest);
}

void PredictionEngine::add_fixed(const FrameUpdate& frame, const Bodies& near) {
    for (const BodyUpdate& body : frame.bodies) {
        if (body.type == BodyType::dynamic || near.contains(body.entity)) continue;
        if (world_->members().fixed.contains(body.entity)) {
            if (body.type == BodyType::kinematic) world_->put(body.entity, body.pose);
            continue;
        }
        if (world_->members().fixed.size() >= options_.static_bodies_max) return;
        LocalBody stands = local_body(body, false);
        stands.simulated = false;
        if (const auto shapes = frame.shapes_of(body.entity))
            world_->add(body.entity, stands, *shapes, {.pose = body.pose}, true);
    }
}

// Duration of a body's motion since the previous frame. While nothing moves the server sends no
// frames, so a body that was at rest started to move in this tick.
double PredictionEngine::seconds_since(const BodyUpdate& before, std::uint32_t frame) const {
    return (before.at_rest ? 1 : frame - newest_frame_) * tick_s_;
}

// Motion of a new body, measured since the previous frame.
MotionState PredictionEngine::measured_motion(const BodyUpdate& now, std::uint32_t frame) const {
    MotionState motion{.pose = now.pose};
    if (now.velocity && !now.at_rest)
        return {now.pose, now.velocity->linear, now.velocity->angular};
    const auto before = near_updates_.find(now.entity);
    if (now.at_rest || before == near_updates_.end() || frame <= newest_frame_) return motion;
    const double seconds = seconds_since(before->second, frame);
    const Transform& was = before->second.pose;
    motion.linear = (now.pose.position - was.position) * (1 / seconds);
    motion.angular = rotation_vector_between(was.rotation, now.pose.rotation) * (1 / seconds);
    if (length(motion.linear) > 100 || length(motion.angular) > 100) return {.pose = now.pose};
    return motion;
}

// The pose and the velocity of the frame.
MotionState PredictionEngine::corrected_motion(const BodyUpdate& now, std::uint32_t frame) {
    if (now.velocity && !now.at_rest)
        return {now.pose, now.velocity->linear, now.velocity->angular};
    return estimated_motion(now, frame);
}

// The pose of the frame, with a velocity that explains it.
MotionState PredictionEngine::estimated_motion(const BodyUpdate& now, std::uint32_t frame) {
    const std::uint32_t id = now.entity;
    const MotionState& guess = find(frame)->motions.at(id);
    MotionState corrected{now.pose, guess.linear, guess.angular};
    const TickState* before = find(newest_frame_);
    const auto was = near_updates_.find(id);
    if (before && was != near_updates_.end() && before->motions.contains(id) &&
        frame > newest_frame_) {
        const Transform& from = before->motions.at(id).pose;
        const double seconds = seconds_since(was->second, frame);
        const Vec3 more =
            (now.pose.position - was->second.pose.position) - (guess.pose.position - from.position);
        const Vec3 turned = rotation_vector_between(was->second.pose.rotation, now.pose.rotation) -
                            rotation_vector_between(from.rotation, guess.pose.rotation);
        const auto last = corrected_.find(id);
        const std::uint32_t since =
            last == corrected_.end() ? slow_ticks : std::min(slow_ticks, frame - last->second);
        const double slow_seconds = std::max(1u, since) * tick_s_;
        corrected.linear += length(more) > disturbance_speed * seconds
                                ? more * (1 / seconds)
                                : (now.pose.position - guess.pose.position) * (1 / slow_seconds);
        corrected.angular += length(turned) > disturbance_spin * seconds
                                 ? turned * (1 / seconds)
                                 : rotation_vector_between(guess.pose.rotation, now.pose.rotation) *
                                       (1 / slow_seconds);
    }
    if (now.at_rest) corrected.linear = corrected.angular = {};
    corrected_[id] = frame;
    return corrected;
}

bool PredictionEngine::boundary_changed(const Bodies& boundary) const {
    return !std::equal(boundary.begin(), boundary.end(), boundary_.begin(), boundary_.end(),
                       [](const auto& now, const auto& before) {
                           return now.first == before.first &&
                                  poses_agree(now.second.pose, before.second.pose);
                       });
}

void PredictionEngine::update_members(const FrameUpdate& frame, const Neighborhood& neighborhood) {
    const LocalWorld::Members& members = world_->members();
    std::vector<std::uint32_t> gone;
    for (const auto& [id, body] : members.moving)
        if (!neighborhood.near.contains(id)) gone.push_back(id);
    for (const auto& [id, body] : members.fixed)
        if (!find_body(frame, id) || neighborhood.near.contains(id)) gone.push_back(id);
    for (const auto& [id, body] : members.boundary)
        if (!neighborhood.boundary.contains(id)) gone.push_back(id);
    for (const std::uint32_t id : gone) world_->remove(id);
    for (const auto& [id, now] : neighborhood.near)
        if (!is_member(id)) add(frame, now, measured_motion(now, frame.number));
    add_fixed(frame, neighborhood.near);
    update_boundary(frame, neighborhood.boundary);
}

void PredictionEngine::update_boundary(const FrameUpdate& frame, const Bodies& boundary) {
    for (const auto& [id, now] : boundary) {
        const auto before = boundary_.find(id);
        if (!world_->members().boundary.contains(id)) {
            if (const auto shapes = frame.shapes_of(id))
                world_->add_boundary_body(id, *shapes, now.pose);
        } else if (before == boundary_.end() || !(before->second.pose == now.pose)) {
            world_->put(id, now.pose);
        }
    }
    boundary_ = boundary;
}

void PredictionEngine::start(const FrameUpdate& frame, const Neighborhood& neighborhood) {
    history_.clear();
    boundary_.clear();
    world_.emplace(gravity_, substeps_);
    update_members(frame, neighborhood);
    if (is_controlled(frame)) {
        newest_control_ = frame.control.tick;
        if (!world_->set_controlled(entity_, frame.control.module, frame.control.words))
            return reset_world();
    }
    // Distances are measured between origins, so the radius of a large body is added.
    if (is_member(entity_)) extra_radius_ = std::max(0.0, world_->bounding_radius(entity_) - 1);
    save(frame.number);
    changed_ = true;
}

void PredictionEngine::compare(const FrameUpdate& update, const Neighborhood& neighborhood) {
    const Bodies& near = neighborhood.near;
    const std::uint32_t frame = update.number, now = tick();
    const TickState& guess = *find(frame);
    stats_.frames++;
    stats_.last_error_m = 0;
    std::map<std::uint32_t, MotionState> wrong;
    bool others = false;  // bodies were added or removed
    for (const auto& [id, body] : near) {
        const auto at = guess.motions.find(id);
        others |= at == guess.motions.end();
        // apply_control() corrects the controlled entity.
        if (at == guess.motions.end() || id == world_->members().controlled) continue;
        stats_.last_error_m =
            std::max(stats_.last_error_m, gap(at->second.pose.position, body.pose.position));
        if (!poses_agree(at->second.pose, body.pose) || was_disturbed(at->second, body))
            wrong[id] = corrected_motion(body, frame);
    }
    others |= std::any_of(guess.motions.begin(), guess.motions.end(),
                          [&](const auto& one) { return !near.contains(one.first); });
    if (wrong.empty() && !others && !boundary_changed(neighborhood.boundary)) return;
    stats_.corrections += wrong.empty() ? 0 : 1;
    roll_back(frame);
    drop_newest();
    for (const auto& [id, motion] : wrong)
        if (near.contains(id)) world_->set_motion(id, motion, near.at(id).at_rest);
    update_members(update, neighborhood);
    save(frame);
    step_to(now);
}

// Frames advanced beyond the prediction because nothing was rendered. Steps the local world with
// its inputs. Returns false if the gap is too large.
bool PredictionEngine::catch_up(std::uint32_t frame) {
    if (!world_ || frame <= newest_frame_ || frame - newest_frame_ > options_.ticks_ahead_max)
        return false;
    step_to(frame);
    return find(frame) != nullptr;
}

// Whether a recent state of the controlled entity is available.
bool PredictionEngine::is_controlled(const FrameUpdate& frame) const {
    const ControlUpdate& control = frame.control;
    return control.tick != 0 && control.entity == entity_ &&
           control.tick + control_timeout_ticks >= frame.number &&
           control.tick <= frame.number + late_ticks;
}

// Applies the complete state of the controlled entity. If the prediction agrees within the
// precision of frames, it remains unchanged.
void PredictionEngine::apply_control(const ControlUpdate& control) {
    if (control.tick <= newest_control_) return;
    const TickState* const guess = find(control.tick);
    const auto corrected = modules::decode_controlled_motion(control.words);
    if (!guess || !corrected) return;
    newest_control_ = control.tick;
    const auto at = guess->motions.find(entity_);
    if (at == guess->motions.end()) return;
    const MotionState& guessed = at->second;
    stats_.control_updates++;
    stats_.last_control_error_m = gap(guessed.pose.position, corrected->pose.position);
    if (poses_agree(guessed.pose, corrected->pose) &&
        gap(guessed.linear, corrected->linear) <= control_speed_tolerance &&
        gap(guessed.angular, corrected->angular) <= control_spin_tolerance)
        return;
    stats_.control_corrections++;
    const std::uint32_t now = tick();
    roll_back(control.tick);
    drop_newest();
    const bool accepted = world_->set_controlled(entity_, control.module, control.words);
    save(control.tick);
    if (!accepted) return reset_world();
    step_to(now);
}

void PredictionEngine::on_frame(const FrameUpdate& update) {
    const std::uint32_t frame = update.number;
    const BodyUpdate* own = entity_ == 0 ? nullptr : find_body(update, entity_);
    const bool controlled = own && is_controlled(update);
    const bool is_free = own && own->type == BodyType::dynamic && !own->jointed;
    if (!own || (own->controllable ? !controlled : !is_free)) return reset_world();
    if (frame == newest_frame_) {
        if (controlled) apply_control(update.control);
        return;
    }
    const Neighborhood neighborhood = collect_neighbors(update, own->pose.position);
    if (catch_up(frame)) {
        if (controlled) apply_control(update.control);
        if (world_) compare(update, neighborhood);
    } else if (!controlled || update.control.tick == frame) {
        start(update, neighborhood);
    } else {
        reset_world();  // until a frame and a state of the same tick arrive
    }
    if (!world_) return;
    newest_frame_ = frame;
    near_updates_ = neighborhood.near;
    while (history_.front().tick + late_ticks < frame) drop_oldest();
    while (!inputs_.empty() && inputs_.front().tick + late_ticks + 1 < frame) inputs_.pop_front();
    std::erase_if(corrected_, [&](const auto& one) { return !near_updates_.contains(one.first); });
}

// --- rendering ---

std::vector<std::uint32_t> PredictionEngine::predicted_entities() const {
    std::vector<std::uint32_t> ids;
    if (world_)
        for (const auto& [id, body] : world_->members().moving) ids.push_back(id);
    for (const auto& [id, rendered] : rendered_)
        if (!is_member(id)) ids.push_back(id);
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::optional<snapshot::Pose> PredictionEngine::predicted_pose(std::uint32_t id, double position,
                                                               BodySpeed* body_speed) {
    if (history_.empty()) return std::nullopt;
    const double at = std::clamp(position, static_cast<double>(history_.front().tick),
                                 static_cast<double>(tick()));
    const auto before = static_cast<std::uint32_t>(std::floor(at));
    const TickState& a = *find(before);
    const TickState& b = before < tick() ? *find(before + 1) : a;
    const auto from = a.motions.find(id), to = b.motions.find(id);
    if (from == a.motions.end() || to == b.motions.end()) return std::nullopt;
    if (body_speed) *body_speed = {length(to->second.linear), length(to->second.angular)};
    return to_pose(interpolate(from->second.pose, to->second.pose, at - before));
}

// A body that starts or stops being predicted is blended.
PoseError PredictionEngine::error_of(const SmoothPose& drawn,
                                     const std::optional<snapshot::Pose>& predicted,
                                     const RenderedPose* before, const BodySpeed& body_speed,
                                     double seconds) {
    if (!before) return smoothable_error(pose_error(drawn.pose, *predicted), body_speed);
    PoseError error = before->error;
    if (!predicted && before->predicted_pose)
        error = smoothable_error(pose_error(before->pose, drawn.pose), body_speed);
    else if (predicted && changed_)
        error = smoothable_error(
            pose_error(before->pose,
                       predicted_pose(drawn.entity, last_position_, nullptr).value_or(*predicted)),
            body_speed);
    return decayed(error, body_speed, seconds);
}

std::vector<SmoothPose> PredictionEngine::sample(double position, std::int64_t now_us,
                                                 std::vector<SmoothPose> poses) {
    const double seconds =
        static_cast<double>(std::max<std::int64_t>(0, now_us - last_sample_us_)) / 1e6;
    if (now_us - last_sample_us_ > sample_gap_max_us) rendered_.clear();
    if (!history_.empty()) {
        const double most = newest_frame_ + options_.ticks_ahead_max;
        step_to(static_cast<std::uint32_t>(std::ceil(std::min(std::max(0.0, position), most))));
    }
    std::map<std::uint32_t, RenderedPose> now;
    for (SmoothPose& drawn : poses) {
        BodySpeed body_speed;
        const auto predicted = predicted_pose(drawn.entity, position, &body_speed);
        const auto before = rendered_.find(drawn.entity);
        if (!predicted && before == rendered_.end()) continue;
        const PoseError error =
            error_of(drawn, predicted, before == rendered_.end() ? nullptr : &before->second,
                     body_speed, seconds);
        drawn.pose = apply_error(predicted ? *predicted : drawn.pose, error);
        if (predicted || !error.none())
            now[drawn.entity] = {drawn.pose, error, predicted.has_value()};
    }
    rendered_ = std::move(now);
    last_position_ = position;
    last_sample_us_ = now_us;
    changed_ = false;
    return poses;
}

}  // namespace jostle::client

// SPDX-License-Identifier: MIT
//
// What Predictor does (jostle/client/predictor.h), without messages: it is told of bodies, frames
// and acts as plain data. Predictor reads messages for it, and clients/cpp/prediction/wasm is asked
// by browsers. One thread at a time.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "clients/cpp/prediction/src/local_world.h"
#include "jostle/client/interpolation.h"
#include "jostle/client/predictor_options.h"

namespace jostle::client {

// A body of a frame.
struct BodyUpdate {
    std::uint32_t entity = 0;
    physics::BodyType type = physics::BodyType::dynamic;
    double mass = 0;  // kg, of a dynamic one
    physics::Transform pose;
    bool at_rest = false;
    std::optional<Velocity> velocity = {};  // nothing: that was not told
    bool controllable = false;              // a module of the server moves it
    bool jointed = false;                   // joints of the server hold it
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    physics::AxisLocks locks = 0;
};

// What the client drives, as jostle/modules/controlled_entity_state.h tells it.
struct ControlUpdate {
    std::uint32_t entity = 0, tick = 0;  // 0: nothing was told
    std::string module;
    std::span<const std::uint32_t> words;
};

// A frame of the server.
struct FrameUpdate {
    std::uint32_t number = 0;
    std::span<const BodyUpdate> bodies;  // in rising order of entity
    // Of one of them; nothing: they were never told, or are none that the solver can have.
    std::function<std::optional<std::vector<physics::ShapeDef>>(std::uint32_t entity)> shapes_of;
    ControlUpdate control = {};
};

class PredictionEngine {
public:
    explicit PredictionEngine(PredictorOptions options) : options_(options) {}

    // A stream begins: everything is forgotten but whom it follows.
    void begin(physics::Vec3 gravity, double tick_hz, int substeps);
    // Whose motion is foreseen; 0: nobody's.
    void follow(std::uint32_t entity);
    // An input of that number that is meant for a tick. Of the same number as the last one: in its
    // place.
    void add_action(std::uint32_t sequence, std::uint32_t tick, InputAction action);
    // What became of it: it was applied in a tick, or it was not.
    void on_result(std::uint32_t sequence, std::uint32_t tick, bool applied);
    void on_frame(const FrameUpdate& frame);

    // Who is drawn otherwise than interpolated, now or since the last picture; in rising order.
    std::vector<std::uint32_t> predicted_entities() const;
    // What Predictor::sample() says. Who is not among drawn() may be left out.
    std::vector<SmoothPose> sample(double position, std::int64_t now_us,
                                   std::vector<SmoothPose> interpolated);

    const PredictorStats& stats() const { return stats_; }
    std::size_t bodies() const { return world_ ? world_->members().moving.size() : 0; }

private:
    using TickState = LocalWorld::TickState;
    struct Sent {
        std::uint32_t sequence, tick;
        InputAction action;
    };
    struct RenderedPose {
        wire::Pose pose;
        PoseError error;
        bool predicted_pose;
    };
    using Bodies = std::map<std::uint32_t, BodyUpdate>;
    // The dynamic bodies about the one that is followed: who moves in the world, and round these
    // who stands in it, so that nothing falls for want of what carries it.
    struct Neighborhood {
        Bodies near, boundary;
    };

    // --- ticks ---
    void reset_world();
    std::uint32_t tick() const { return history_.back().tick; }
    TickState* find(std::uint32_t tick);
    void save(std::uint32_t tick);
    void drop_oldest();
    void drop_newest();
    void step();
    void step_to(std::uint32_t tick);
    void roll_back(std::uint32_t tick);
    void resimulate_from(std::uint32_t first);

    // --- frames ---
    bool is_member(std::uint32_t id) const {
        return world_ && world_->members().moving.contains(id);
    }
    Neighborhood collect_neighbors(const FrameUpdate& frame, const physics::Vec3& center) const;
    bool add(const FrameUpdate& frame, const BodyUpdate& body, const MotionState& motion);
    void add_fixed(const FrameUpdate& frame, const Bodies& near);
    bool boundary_changed(const Bodies& boundary) const;
    void update_members(const FrameUpdate& frame, const Neighborhood& neighborhood);
    void update_boundary(const FrameUpdate& frame, const Bodies& boundary);
    double seconds_since(const BodyUpdate& before, std::uint32_t frame) const;
    MotionState measured_motion(const BodyUpdate& now, std::uint32_t frame) const;
    MotionState corrected_motion(const BodyUpdate& now, std::uint32_t frame);
    MotionState estimated_motion(const BodyUpdate& now, std::uint32_t frame);
    void start(const FrameUpdate& frame, const Neighborhood& neighborhood);
    bool catch_up(std::uint32_t frame);
    bool is_controlled(const FrameUpdate& frame) const;
    void apply_control(const ControlUpdate& control);
    void compare(const FrameUpdate& frame, const Neighborhood& neighborhood);

    // --- pictures ---
    std::optional<wire::Pose> predicted_pose(std::uint32_t id, double position,
                                             BodySpeed* body_speed);
    PoseError error_of(const SmoothPose& predicted_entities,
                       const std::optional<wire::Pose>& predicted, const RenderedPose* before,
                       const BodySpeed& body_speed, double seconds);

    PredictorOptions options_;
    PredictorStats stats_;
    physics::Vec3 gravity_{0, -9.81, 0};
    int substeps_ = 8;
    double tick_s_ = 1.0 / 60;
    std::uint32_t entity_ = 0;
    std::optional<LocalWorld> world_;
    std::deque<TickState> history_;       // one for each tick, the newest last: where the world is
    std::vector<TickState> free_states_;  // for their memory
    std::deque<Sent> inputs_;             // by sequence
    std::uint32_t newest_frame_ = 0, newest_control_ = 0;
    double extra_radius_ = 0;  // m that the followed body is larger than a metre about its origin
    Bodies near_updates_;      // of that frame: who was near
    Bodies boundary_;          // as they stand in the world
    std::map<std::uint32_t, std::uint32_t> corrected_;  // tick, by entity
    // The last picture.
    std::map<std::uint32_t, RenderedPose> rendered_;
    double last_position_ = 0;
    std::int64_t last_sample_us_ = 0;
    bool changed_ = false;  // since then, what had been foreseen
};

}  // namespace jostle::client

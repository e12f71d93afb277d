// SPDX-License-Identifier: MIT
//
// Implementation of Predictor (jostle/client/predictor.h) without messages: bodies, frames and
// inputs are plain data. Predictor converts messages; clients/cpp/prediction/wasm serves browsers.
// One thread at a time.
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
    double mass = 0;  // kg, of a dynamic body
    physics::Transform pose;
    bool at_rest = false;
    std::optional<Velocity> velocity = {};  // nothing: not received
    bool controllable = false;              // a module of the server controls it
    bool jointed = false;                   // joints of the server hold it
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    physics::AxisLocks locks = 0;
};

// State of the controlled entity (jostle/modules/controlled_entity_state.h).
struct ControlUpdate {
    std::uint32_t entity = 0, tick = 0;  // 0: not received
    std::string module;
    std::span<const std::uint32_t> words;
};

// A frame of the server.
struct FrameUpdate {
    std::uint32_t number = 0;
    std::span<const BodyUpdate> bodies;  // sorted by entity
    // Returns the shapes of a body; nothing: unknown, or invalid for the solver.
    std::function<std::optional<std::vector<physics::ShapeDef>>(std::uint32_t entity)> shapes_of;
    ControlUpdate control = {};
};

class PredictionEngine {
public:
    explicit PredictionEngine(PredictorOptions options) : options_(options) {}

    // Starts a stream. Discards all state except the followed entity.
    void begin(physics::Vec3 gravity, double tick_hz, int substeps);
    // Selects the entity whose motion is predicted; 0: none.
    void follow(std::uint32_t entity);
    // Adds an input for a tick. An input with the same sequence number as the last one replaces it.
    void add_action(std::uint32_t sequence, std::uint32_t tick, InputAction action);
    // Adds a result: the input was applied in `tick` or rejected.
    void on_result(std::uint32_t sequence, std::uint32_t tick, bool applied);
    void on_frame(const FrameUpdate& frame);

    // Entities whose rendered poses differ from the interpolated ones, now or since the last
    // rendered frame; sorted.
    std::vector<std::uint32_t> predicted_entities() const;
    // See Predictor::sample(). Entities that are not in predicted_entities() may be omitted.
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
        snapshot::Pose pose;
        PoseError error;
        bool predicted_pose;
    };
    using Bodies = std::map<std::uint32_t, BodyUpdate>;
    // The dynamic bodies around the followed one: near bodies are simulated, boundary bodies around
    // them are static, so that near bodies keep their support.
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

    // --- rendering ---
    std::optional<snapshot::Pose> predicted_pose(std::uint32_t id, double position,
                                                 BodySpeed* body_speed);
    PoseError error_of(const SmoothPose& predicted_entities,
                       const std::optional<snapshot::Pose>& predicted, const RenderedPose* before,
                       const BodySpeed& body_speed, double seconds);

    PredictorOptions options_;
    PredictorStats stats_;
    physics::Vec3 gravity_{0, -9.81, 0};
    int substeps_ = 8;
    double tick_s_ = 1.0 / 60;
    std::uint32_t entity_ = 0;
    std::optional<LocalWorld> world_;
    // one per tick, the newest last: the current state of the world
    std::deque<TickState> history_;
    std::vector<TickState> free_states_;  // reused for their memory
    std::deque<Sent> inputs_;             // sorted by sequence
    std::uint32_t newest_frame_ = 0, newest_control_ = 0;
    double extra_radius_ = 0;  // m by which the followed body exceeds a radius of 1 m
    Bodies near_updates_;      // near bodies of the newest frame
    Bodies boundary_;          // as in the local world
    std::map<std::uint32_t, std::uint32_t> corrected_;  // tick, by entity
    // The last rendered frame.
    std::map<std::uint32_t, RenderedPose> rendered_;
    double last_position_ = 0;
    std::int64_t last_sample_us_ = 0;
    bool changed_ = false;  // the prediction changed since then
};

}  // namespace jostle::client

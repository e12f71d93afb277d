// SPDX-License-Identifier: MIT
//
// The local world of the predictor: entities as bodies of the solver, and saved states for
// rollback. Independent of messages, so it also builds without protobuf
// (clients/cpp/prediction/wasm). One thread at a time.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "clients/cpp/prediction/src/motion_state.h"
#include "jostle/physics/module.h"
#include "jostle/physics/restore_point.h"
#include "jostle/physics/world.h"

namespace jostle::client {

// Effects of an input in its tick, as on the server (jostle/modules/player_interaction.h).
struct Push {
    std::uint32_t entity = 0;
    physics::Vec3 impulse;               // N s
    std::optional<physics::Vec3> point;  // world; nothing: the centre of mass
};
struct Grab {
    std::uint32_t entity = 0;
    physics::Vec3 point;  // world
};
struct Drag {
    physics::Vec3 target;
};
struct Release {};
// Control state, in effect until the next one.
struct Steer {
    physics::Controls controls;
};
using InputAction = std::variant<Push, Grab, Drag, Release, Steer>;

// Properties of a body in the local world.
struct LocalBody {
    physics::BodyType type = physics::BodyType::dynamic;
    double mass = 0;  // kg, of a dynamic body
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    physics::AxisLocks locks = 0;
    bool simulated = true;  // false: the pose changes only with frames
};

class LocalWorld {
public:
    // The bodies in the world, shared by the saved states with the same bodies.
    struct Members {
        // By entity. Boundary bodies are dynamic bodies whose pose changes only with frames.
        std::map<std::uint32_t, physics::BodyId> moving, fixed, boundary;
        std::optional<physics::JointId> held;
        // The controlled entity and the module that controls it.
        std::uint32_t controlled = 0;
        std::string controller_module;
    };
    // State after the step of a tick.
    struct TickState {
        std::uint32_t tick = 0;
        physics::RestorePoint point;
        std::shared_ptr<const Members> members;
        std::map<std::uint32_t, MotionState> motions;  // of the moving bodies
    };

    LocalWorld(physics::Vec3 gravity, int substeps);

    const Members& members() const { return *members_; }
    // Returns false if the solver rejects the body.
    bool add(std::uint32_t entity, const LocalBody& body, std::span<const physics::ShapeDef> shapes,
             const MotionState& motion, bool at_rest);
    bool add_boundary_body(std::uint32_t entity, std::span<const physics::ShapeDef> shapes,
                           const physics::Transform& pose);
    // Moves a fixed body, or a kinematic one among the fixed.
    void put(std::uint32_t entity, const physics::Transform& pose);
    // Makes the module with this tag control one of the moving bodies, with the state in `words`
    // (jostle/modules/controlled_entity_state.h). Returns false if there is no such module or it
    // rejects the words.
    bool set_controlled(std::uint32_t entity, const std::string& module,
                        std::span<const std::uint32_t> words);
    void remove(std::uint32_t entity);
    MotionState motion(std::uint32_t entity) const;
    // m, from the origin to the furthest corner of the bounding box
    double bounding_radius(std::uint32_t entity) const;
    void set_motion(std::uint32_t entity, const MotionState& motion, bool at_rest);
    // Applies an input at the start of a tick, like the server.
    void apply(const InputAction& action);
    void step(double seconds);

    void save(TickState& tick_state, std::uint32_t tick) const;
    void roll_back(const TickState& tick_state);

private:
    Members& change();
    void perform(const Push& push);
    void perform(const Grab& grab);
    void perform(const Drag& drag);
    void perform(const Release& release);
    void perform(const Steer& steer);
    physics::BodyId body_of(std::uint32_t entity) const;

    physics::World world_;
    std::shared_ptr<const Members> members_ = std::make_shared<const Members>();
};

}  // namespace jostle::client

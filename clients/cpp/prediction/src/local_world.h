// SPDX-License-Identifier: MIT
//
// What is foreseen in: entities as bodies of the solver, and moments of it to go back to. It knows
// no message, so that it is also built where there are none (clients/cpp/prediction/wasm). One
// thread at a time.
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

// What an input does in its tick, as the server does it (jostle/modules/hand.h).
struct Push {
    std::uint32_t entity = 0;
    physics::Vec3 impulse;               // N s
    std::optional<physics::Vec3> point;  // of the world; nothing: the centre of mass
};
struct Grab {
    std::uint32_t entity = 0;
    physics::Vec3 point;  // of the world
};
struct Drag {
    physics::Vec3 target;
};
struct Release {};
// What is held by who drives, until it is held otherwise.
struct Steer {
    physics::Controls controls;
};
using InputAction = std::variant<Push, Grab, Drag, Release, Steer>;

// What a body is, for this world.
struct LocalBody {
    physics::BodyType type = physics::BodyType::dynamic;
    double mass = 0;  // kg, of a dynamic one
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    physics::AxisLocks locks = 0;
    bool simulated = true;  // else it stands as long as no frame says otherwise
};

class LocalWorld {
public:
    // Who is in it. Shared by the moments in which that was so.
    struct Members {
        // By entity. Those of the rim are dynamic ones that stand as long as no frame says
        // otherwise.
        std::map<std::uint32_t, physics::BodyId> moving, fixed, boundary;
        std::optional<physics::JointId> held;
        // Who is driven, and the module that moves it.
        std::uint32_t controlled = 0;
        std::string controller_module;
    };
    // After the step of a tick.
    struct TickState {
        std::uint32_t tick = 0;
        physics::RestorePoint point;
        std::shared_ptr<const Members> members;
        std::map<std::uint32_t, MotionState> motions;  // of the moving
    };

    LocalWorld(physics::Vec3 gravity, int substeps);

    const Members& members() const { return *members_; }
    // False: the solver cannot have such a body.
    bool add(std::uint32_t entity, const LocalBody& body, std::span<const physics::ShapeDef> shapes,
             const MotionState& motion, bool at_rest);
    bool add_boundary_body(std::uint32_t entity, std::span<const physics::ShapeDef> shapes,
                           const physics::Transform& pose);
    // One that stands, or a kinematic one of the fixed.
    void put(std::uint32_t entity, const physics::Transform& pose);
    // From now on it moves one of the moving as the module of that tag does, and it is as the words
    // say (jostle/modules/controlled_entity_state.h). False: there is no such module, or it takes
    // no such words.
    bool set_controlled(std::uint32_t entity, const std::string& module,
                        std::span<const std::uint32_t> words);
    void remove(std::uint32_t entity);
    MotionState motion(std::uint32_t entity) const;
    // m from its origin to the furthest corner of what bounds it.
    double bounding_radius(std::uint32_t entity) const;
    void set_motion(std::uint32_t entity, const MotionState& motion, bool at_rest);
    // As the server does, at the begin of a tick.
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

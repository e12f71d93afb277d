// SPDX-License-Identifier: MIT
//
// What is foreseen in: entities as bodies of the solver, and moments of it to go back to. It knows
// no message, so that it is also built where there are none (clients/predict/wasm). One thread at a
// time.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <variant>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/world.h"
#include "motion.h"

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
using Act = std::variant<Push, Grab, Drag, Release>;

class LocalWorld {
public:
    // Who is in it. Shared by the moments in which that was so.
    struct Members {
        // By entity. Those of the rim are dynamic ones that stand as long as no frame says
        // otherwise.
        std::map<std::uint32_t, physics::BodyId> moving, fixed, rim;
        std::optional<physics::JointId> held;
    };
    // After the step of a tick.
    struct Moment {
        std::uint32_t tick = 0;
        physics::RestorePoint point;
        std::shared_ptr<const Members> members;
        std::map<std::uint32_t, Motion> motions;  // of the moving
    };

    LocalWorld(physics::Vec3 gravity, int substeps);

    const Members& members() const { return *members_; }
    // Of some type; `mass` is of a dynamic one, in kg. False: the solver cannot have such a body.
    bool add(std::uint32_t entity, physics::BodyType type, double mass,
             std::span<const physics::ShapeDef> shapes, const Motion& motion, bool at_rest);
    bool add_to_rim(std::uint32_t entity, std::span<const physics::ShapeDef> shapes,
                    const physics::Transform& pose);
    void move_rim(std::uint32_t entity, const physics::Transform& pose);
    void remove(std::uint32_t entity);
    Motion motion(std::uint32_t entity) const;
    void set_motion(std::uint32_t entity, const Motion& motion, bool at_rest);
    // As the server does, at the begin of a tick.
    void apply(const Act& act);
    void step(double seconds);

    void keep(Moment& moment, std::uint32_t tick) const;
    void go_back(const Moment& moment);

private:
    Members& change();
    void perform(const Push& push);
    void perform(const Grab& grab);
    void perform(const Drag& drag);
    void perform(const Release& release);

    physics::World world_;
    std::shared_ptr<const Members> members_ = std::make_shared<const Members>();
};

}  // namespace jostle::client

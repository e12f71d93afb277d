// SPDX-License-Identifier: MIT
//
// The predictor's world: entities as bodies of the solver, and moments of it to go back to. One
// thread at a time.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "jostle/client/world_view.h"
#include "jostle/physics/restore_point.h"
#include "jostle/physics/world.h"

namespace jostle::client {

// What a body does.
struct Motion {
    physics::Transform pose;
    physics::Vec3 linear, angular;
};

physics::Transform to_transform(const wire::Pose& pose);
wire::Pose to_pose(const physics::Transform& pose);

class LocalWorld {
public:
    // Who is in it. Shared by the moments in which that was so.
    struct Members {
        std::map<std::uint32_t, physics::BodyId> moving, fixed;  // by entity
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
    // False: the solver cannot have such a body, or its shape was never told.
    bool add(const WorldView& view, const v1::Entity& entity, const Motion& motion, bool at_rest);
    void remove(std::uint32_t entity);
    Motion motion(std::uint32_t entity) const;
    void set_motion(std::uint32_t entity, const Motion& motion, bool at_rest);
    // As the server does, at the begin of a tick.
    void apply(const v1::Input& input);
    void step(double seconds);

    void keep(Moment& moment, std::uint32_t tick) const;
    void go_back(const Moment& moment);

private:
    Members& change();
    void hold(const v1::GrabInput& input);
    void drag(const v1::DragInput& input);
    void release();

    physics::World world_;
    std::shared_ptr<const Members> members_ = std::make_shared<const Members>();
};

}  // namespace jostle::client

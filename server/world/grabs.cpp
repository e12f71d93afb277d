// SPDX-License-Identifier: MIT
#include "server/world/grabs.h"

#include <string>

#include "jostle/base/check.h"
#include "jostle/modules/player_interaction.h"

namespace jostle::server {

using namespace physics;

Status Grabs::grab(World& world, ClientId client, const BodyState& body, Vec3 point) {
    release(world, client);
    const Result<JointId> joint = world.create_joint(modules::make_grab_joint(body, point));
    if (!joint.ok()) return joint.error();
    ASSERT(!held_.contains(client));
    held_[client] = {body.id, *joint};
    return {};
}

std::optional<BodyId> Grabs::drag(World& world, ClientId client, Vec3 target) {
    const auto at = held_.find(client);
    if (at == held_.end()) return std::nullopt;
    const Result<JointState> joint = world.joint(at->second.joint);
    if (!joint.ok()) {  // the joint was removed together with its body
        held_.erase(at);
        return std::nullopt;
    }
    GrabJoint kind = std::get<GrabJoint>(joint->def.kind);
    kind.target = target;
    if (!world.set_joint(at->second.joint, kind).ok()) return std::nullopt;
    return at->second.body;
}

Status Grabs::grab_deformable(World& world, ClientId client, modules::Deformables& of,
                              modules::DeformablePoint at) {
    if (Status s = of.grab(world, client, at); !s.ok()) return s;
    release_joint(world, client);
    release_deformables(world, client, &of);
    return {};
}

bool Grabs::drag_deformable(World& world, ClientId client, Vec3 target) const {
    for (const std::string& tag : world.modules())
        if (modules::Deformables* deformables = modules::deformables_of(world, tag))
            if (deformables->drag(client, target)) return true;
    return false;
}

void Grabs::release(World& world, ClientId client) {
    release_joint(world, client);
    release_deformables(world, client, nullptr);
}

void Grabs::release_deformables(World& world, ClientId client, const modules::Deformables* except) {
    for (const std::string& tag : world.modules())
        if (modules::Deformables* deformables = modules::deformables_of(world, tag);
            deformables != nullptr && deformables != except)
            deformables->release(client);
}

void Grabs::release_joint(World& world, ClientId client) {
    const auto at = held_.find(client);
    if (at == held_.end()) return;
    static_cast<void>(world.destroy_joint(at->second.joint).ok());  // it may be removed already
    held_.erase(at);
}

void Grabs::release_body(World& world, BodyId body) {
    std::erase_if(held_, [&](const auto& entry) {
        if (entry.second.body != body) return false;
        static_cast<void>(world.destroy_joint(entry.second.joint).ok());
        return true;
    });
}

void Grabs::write(SavedHostState& host_state) const {
    for (const auto& [client, held] : held_)
        host_state.held.push_back({client, held.body, held.joint});
}

void Grabs::restore(const SavedHostState& host_state) {
    ASSERT(held_.empty());
    for (const SavedHostState::Held& held : host_state.held)
        held_[held.client] = {held.body, held.joint};
}

}  // namespace jostle::server

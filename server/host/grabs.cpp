// SPDX-License-Identifier: MIT
#include "host/grabs.h"

namespace jostle::server {

void Grabs::grab(ClientId client, const physics::BodyState& body, physics::Vec3 point) {
    springs_.insert_or_assign(client, DragSpring{body.id, apply_inverse(body.pose, point), point});
}

std::optional<physics::BodyId> Grabs::drag(ClientId client, physics::Vec3 target) {
    const auto at = springs_.find(client);
    if (at == springs_.end()) return std::nullopt;
    at->second.target = target;
    return at->second.body;
}

void Grabs::release_body(physics::BodyId body) {
    std::erase_if(springs_, [&](const auto& entry) { return entry.second.body == body; });
}

void Grabs::pull_all(physics::World& world, double dt) {
    std::erase_if(springs_, [&](const auto& entry) { return !pull(world, entry.second, dt).ok(); });
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "modules/character/src/sweep_parts.h"

namespace jostle::modules::character_detail {

using namespace physics;

void PrePushStates::store(const World& world, BodyId id) {
    for (const BodyState& body : bodies_)
        if (body.id == id) return;
    const Result<BodyState> body = world.body(id);
    if (body.ok() && body->type == BodyType::dynamic) bodies_.push_back(*body);
}

Result<BodyState> PrePushStates::of(const World& world, BodyId id) const {
    for (const BodyState& body : bodies_)
        if (body.id == id) return body;
    return world.body(id);
}

}  // namespace jostle::modules::character_detail

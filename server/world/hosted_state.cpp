// SPDX-License-Identifier: MIT
#include "server/world/hosted_state.h"

namespace jostle::server {

using namespace physics;

void forget_entity(HostedState& state, EntityId id) {
    const BodyId body = state.entities.find(id)->body;
    state.grabs.release_body(state.world, body);
    state.controllers.release_body(state.world, body);
    state.ownership.remove(id);
    state.attributes.remove({AttributeTargetKind::entity, id});
    state.entities.remove(id);
}

}  // namespace jostle::server

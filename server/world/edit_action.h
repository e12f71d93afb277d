// SPDX-License-Identifier: MIT
//
// Applies edits of bodies. Only apply_action.cpp and the other actions call it.
#pragma once

#include "server/world/action_context.h"
#include "server/world/body_record.h"

namespace jostle::server {

Status edit_body(const ActionContext& context, const EditCommand& command);

// A dynamic or frozen body that the client may change.
Result<const Entity*> editable_entity(const ActionContext& context, EntityId id,
                                      Reachable reachable);

// Sets these fields of a body to those of a definition. After an error, some of them may be set.
Status write_fields(HostedState& state, physics::BodyId body, const BodyAndShapes& to,
                    EditFields fields, bool frozen);

}  // namespace jostle::server

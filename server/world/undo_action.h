// SPDX-License-Identifier: MIT
//
// Reverts the newest action of a client, and records deletions for it.
#pragma once

#include "server/world/action_context.h"

namespace jostle::server {

Status undo_newest(const ActionContext& context);

// Before a client deletes the entity.
void record_deletion(const ActionContext& context, EntityId id);

}  // namespace jostle::server

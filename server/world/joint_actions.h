// SPDX-License-Identifier: MIT
//
// Creates and deletes joints for clients.
#pragma once

#include "server/world/action_context.h"

namespace jostle::server {

Status create_joint(const ActionContext& context, const CreateJointCommand& command);
Status delete_joint(const ActionContext& context, const DeleteJointCommand& command);

// Error of a client that owns the most joints.
Error too_many_joints(const HostedState& state, ClientId client);

// Adds the joint to an undo step. False: it cannot be recorded.
bool record_joint_of(const HostedState& state, const physics::JointDef& def, physics::JointId id,
                     UndoStep& to);

}  // namespace jostle::server

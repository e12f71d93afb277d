// SPDX-License-Identifier: MIT
//
// Encodes the difference of two lists of joints as fields of snapshots. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "server/messages/out_message.h"
#include "server/world/joint_list.h"

namespace jostle::server {

// Each entry is a field of jostle.v1.Snapshot of at most about 64 KiB, for one snapshot each, in
// order. `from` null: the client's list is unknown, and the first field replaces it. At least one
// field in that case; otherwise none if the lists are equal.
std::vector<SharedBytes> joint_update_fields(const JointList* from, const JointList& to);

}  // namespace jostle::server

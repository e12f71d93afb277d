// SPDX-License-Identifier: MIT
//
// The messages of QueryService.Inspect. Pure functions; any thread.
#pragma once

#include "server/world/inspection.h"

namespace jostle::v1 {
class InspectedBody;
class InspectedJoint;
}  // namespace jostle::v1

namespace jostle::server {

// Without attributes.
void write_inspection(v1::InspectedBody& to, const BodyInspection& from);
void write_inspection(v1::InspectedJoint& to, const JointInspection& from);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// WorldService over gRPC: translate, ask WorldControl, answer. Any thread.
#pragma once

#include <vector>

#include "protocol/world_control.h"
#include "rpc/call_method.h"

namespace jostle::server {

// Both outlive them.
std::vector<CallMethod> world_methods(WorldControl& control, const WorldDirectory& worlds);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// WorldService over gRPC: translate, ask WorldControl, answer. Any thread.
#pragma once

#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/world_control.h"

namespace jostle::server {

// Both outlive them.
std::vector<CallMethod> world_methods(WorldControl& control, const WorldDirectory& worlds);

}  // namespace jostle::server

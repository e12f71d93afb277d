// SPDX-License-Identifier: MIT
//
// WorldService over gRPC: decodes requests, calls WorldControl, encodes responses. Any thread.
#pragma once

#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/world_control.h"

namespace jostle::server {

// Both arguments must outlive the methods.
std::vector<CallMethod> world_methods(WorldControl& control, const WorldDirectory& worlds);

}  // namespace jostle::server

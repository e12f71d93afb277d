// SPDX-License-Identifier: MIT
//
// QueryService over gRPC: translate, ask QueryControl, answer. Any thread.
#pragma once

#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/query_control.h"

namespace jostle::server {

// Both outlive them.
std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds);

}  // namespace jostle::server

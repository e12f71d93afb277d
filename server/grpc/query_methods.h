// SPDX-License-Identifier: MIT
//
// QueryService over gRPC: decodes requests, calls QueryControl, encodes responses. Any thread.
#pragma once

#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/query_control.h"

namespace jostle::server {

// Both arguments must outlive the methods.
std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds);

}  // namespace jostle::server

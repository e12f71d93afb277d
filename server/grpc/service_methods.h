// SPDX-License-Identifier: MIT
//
// The methods of the gRPC services. Each function adds the methods of one service.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/admin_control.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"

namespace jostle::server {

// WorldService over gRPC: decodes requests, calls WorldControl, encodes responses. Any thread.
//
// Both arguments must outlive the methods.
std::vector<CallMethod> world_methods(WorldControl& control, const WorldDirectory& worlds);

// QueryService over gRPC: decodes requests, calls QueryControl, encodes responses. Any thread.
//
// Both arguments must outlive the methods.
std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds);

// AdminService over gRPC: decodes requests, calls AdminControl, encodes responses, and records
// calls that change something in the audit log. Any thread.
//
// Both arguments must outlive the methods.
std::vector<CallMethod> admin_methods(AdminControl& control, const WorldDirectory& worlds);

// grpc.health.v1.Health: Check responds once, Watch after each change. Any thread.
//
// `services`: the known services besides the empty name, which is the entire server; all share one
// status. `is_serving`: called on any thread.
std::vector<CallMethod> health_methods(std::vector<std::string> services,
                                       std::function<bool()> is_serving);

// gRPC reflection, v1 and v1alpha, from the compiled-in descriptors. Pure; any thread.
//
// For these services, by full name.
std::vector<CallMethod> reflection_methods(std::vector<std::string> services);

}  // namespace jostle::server

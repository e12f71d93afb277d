// SPDX-License-Identifier: MIT
//
// AdminService over gRPC: decodes requests, calls AdminControl, encodes responses, and records
// calls that change something in the audit log. Any thread.
#pragma once

#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/admin_control.h"

namespace jostle::server {

// Both arguments must outlive the methods.
std::vector<CallMethod> admin_methods(AdminControl& control, const WorldDirectory& worlds);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// AdminService over gRPC: translate, ask AdminControl, answer; what changes something is told to
// the audit log. Any thread.
#pragma once

#include <vector>

#include "server/grpc/call_method.h"
#include "server/services/admin_control.h"

namespace jostle::server {

// Both outlive them.
std::vector<CallMethod> admin_methods(AdminControl& control, const WorldDirectory& worlds);

}  // namespace jostle::server

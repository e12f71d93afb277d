// SPDX-License-Identifier: MIT
//
// AdminService over gRPC: translate, ask AdminControl, answer. Callers of this machine only, for as
// long as nobody says who a caller is. Any thread.
#pragma once

#include <vector>

#include "protocol/admin_control.h"
#include "rpc/call_method.h"

namespace jostle::server {

// `control` outlives them.
std::vector<CallMethod> admin_methods(AdminControl& control);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// grpc.health.v1.Health: Check responds once, Watch after each change. Any thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "server/grpc/call_method.h"

namespace jostle::server {

// `services`: the known services besides the empty name, which is the entire server; all share one
// status. `is_serving`: called on any thread.
std::vector<CallMethod> health_methods(std::vector<std::string> services,
                                       std::function<bool()> is_serving);

}  // namespace jostle::server

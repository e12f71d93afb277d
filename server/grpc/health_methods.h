// SPDX-License-Identifier: MIT
//
// grpc.health.v1.Health: Check answers once, Watch whenever it changes. Any thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "server/grpc/call_method.h"

namespace jostle::server {

// `services`: those it knows besides the empty name, which is the server as a whole; all begin and
// end together. `is_serving`: any thread.
std::vector<CallMethod> health_methods(std::vector<std::string> services,
                                       std::function<bool()> is_serving);

}  // namespace jostle::server

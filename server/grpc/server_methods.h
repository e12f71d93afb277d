// SPDX-License-Identifier: MIT
//
// The methods that every gRPC server offers: health and reflection.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "server/services/call_method.h"

namespace jostle::server {

// grpc.health.v1.Health: Check responds once, Watch after each change. Any thread.
// `services`: the known services besides the empty name, which is the entire server; all share one
// status. `is_serving`: called on any thread.
std::vector<CallMethod> health_methods(std::vector<std::string> services,
                                       std::function<bool()> is_serving);

// gRPC reflection, v1 and v1alpha, from the compiled-in descriptors. Pure; any thread. For
// these services, by full name.
std::vector<CallMethod> reflection_methods(std::vector<std::string> services);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// gRPC reflection, v1 and v1alpha, from the compiled-in descriptors. Pure; any thread.
#pragma once

#include <string>
#include <vector>

#include "server/grpc/call_method.h"

namespace jostle::server {

// For these services, by full name.
std::vector<CallMethod> reflection_methods(std::vector<std::string> services);

}  // namespace jostle::server

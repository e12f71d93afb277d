// SPDX-License-Identifier: MIT
//
// gRPC's reflection, v1 and v1alpha: the descriptors that are compiled in anyway. Pure; any thread.
#pragma once

#include <string>
#include <vector>

#include "server/grpc/call_method.h"

namespace jostle::server {

// Of these services, by full name.
std::vector<CallMethod> reflection_methods(std::vector<std::string> services);

}  // namespace jostle::server

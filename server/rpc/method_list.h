// SPDX-License-Identifier: MIT
//
// Which methods services have, as the descriptors of their messages say: who counts calls wants to
// know them before the first one comes.
#pragma once

#include <string>
#include <vector>

#include "telemetry/rpc_metrics.h"

namespace jostle::server {

// All that this server answers.
const std::vector<std::string>& served_services();

// Of services by their full names; one that is unknown has none.
std::vector<RpcMethod> unary_methods_of(const std::vector<std::string>& services);
std::vector<RpcMethod> streaming_methods_of(const std::vector<std::string>& services);

}  // namespace jostle::server

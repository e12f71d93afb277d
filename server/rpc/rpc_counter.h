// SPDX-License-Identifier: MIT
//
// Counts the calls of a gRPC server that are no play streams: an interceptor sees each from its
// arrival to its status. A play stream would pay for it with every message, so it counts its own
// end.
#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <memory>
#include <vector>

#include "telemetry/rpc_metrics.h"

namespace jostle::server {

// For ServerBuilder::experimental(). `metrics` outlives the server.
std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> rpc_counters(
    RpcMetrics& metrics);

}  // namespace jostle::server

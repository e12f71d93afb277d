// SPDX-License-Identifier: MIT
//
// What a gRPC call shows of who calls: a token in its metadata, a client certificate in its TLS.
// Pure; any thread.
#pragma once

#include <grpcpp/server_context.h>

#include "identity/gate.h"

namespace jostle::server {

Result<Identity> identify(const grpc::ServerContext& call, Gate& gate);

}  // namespace jostle::server

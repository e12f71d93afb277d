// SPDX-License-Identifier: MIT
//
// What a gRPC call shows of who calls: a token in its metadata, the certificate of its connection.
// Pure; any thread.
#pragma once

#include <grpcpp/server_context.h>

#include "server/auth/authorizer.h"
#include "server/grpc_proxy/connection_table.h"

namespace jostle::server {

Result<Identity> identify(const grpc::ServerContext& call, const Connection& connection,
                          Authorizer& authorizer);

}  // namespace jostle::server

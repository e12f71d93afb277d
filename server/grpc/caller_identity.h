// SPDX-License-Identifier: MIT
//
// The identity of the caller of a gRPC call: a token in the metadata, or the certificate of the
// connection. Pure; any thread.
#pragma once

#include <grpcpp/server_context.h>

#include "server/auth/authorizer.h"
#include "server/grpc_proxy/connection_table.h"

namespace jostle::server {

Result<Identity> identify(const grpc::ServerContext& call, const Connection& connection,
                          Authorizer& authorizer);

}  // namespace jostle::server

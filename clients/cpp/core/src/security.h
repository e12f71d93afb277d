// SPDX-License-Identifier: MIT
//
// Converts Security to gRPC credentials. Pure functions; any thread.
#pragma once
#include <grpcpp/client_context.h>
#include <grpcpp/security/credentials.h>

#include <memory>

#include "jostle/client/security.h"

namespace jostle::client {

std::shared_ptr<grpc::ChannelCredentials> channel_credentials(const Security& security);
// Attaches the token, if there is one.
void attach_token(grpc::ClientContext& call, const Security& security);

}  // namespace jostle::client

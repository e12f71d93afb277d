// SPDX-License-Identifier: MIT
//
// Conversions between the types of gRPC and those of the server. Pure; any thread.
#pragma once
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/status.h>

#include <string>

#include "jostle/base/result.h"
#include "server/auth/authorizer.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/messages/out_message.h"

namespace jostle::server {

// A gRPC status with google.rpc details for programs: the invalid field, the time to retry, and a
// one-word reason.
grpc::Status to_rich_status(const Status& status);

// The address of the client of a call: that of the connection, or the one that a trusted proxy
// names in the metadata.
std::string client_address(const grpc::ServerContext& call, const Connection& connection,
                           const ConnectionTable& connections);

// The identity of the caller of a gRPC call: a token in the metadata, or the certificate of the
// connection.
Result<Identity> identify(const grpc::ServerContext& call, const Connection& connection,
                          const std::string& address, Authorizer& authorizer);

// Converts messages to gRPC buffers and back without copying shared bytes: a shared piece becomes a
// slice that holds a reference until the transport has sent it.
grpc::ByteBuffer to_byte_buffer(const OutMessage& message);

// Replaces `out` with the bytes of a received message. Callers reuse one string, so that it rarely
// allocates.
void copy_bytes(std::string& out, const grpc::ByteBuffer& buffer);

}  // namespace jostle::server

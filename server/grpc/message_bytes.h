// SPDX-License-Identifier: MIT
//
// Converts messages to gRPC buffers and back without copying shared bytes: a shared piece becomes a
// slice that holds a reference until the transport has sent it.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <string>

#include "server/messages/out_message.h"

namespace jostle::server {

grpc::ByteBuffer to_byte_buffer(const OutMessage& message);

// Replaces `out` with the bytes of a received message. Callers reuse one string, so that it rarely
// allocates.
void copy_bytes(std::string& out, const grpc::ByteBuffer& buffer);

}  // namespace jostle::server

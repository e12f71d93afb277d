// SPDX-License-Identifier: MIT
//
// Our bytes in gRPC's buffers and back, without copying what is shared: a shared piece becomes a
// slice that keeps one more count on it until the transport has sent it.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <string>

#include "server/messages/out_message.h"

namespace jostle::server {

grpc::ByteBuffer to_byte_buffer(const OutMessage& message);

// The bytes of a received message, appended to a cleared `out`: callers keep one string and
// allocate rarely.
void copy_bytes(std::string& out, const grpc::ByteBuffer& buffer);

}  // namespace jostle::server

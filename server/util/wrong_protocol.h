// SPDX-License-Identifier: MIT
//
// Replies to clients that speak another protocol than their port: TLS to a port without TLS, plain
// HTTP to a port with TLS, HTTP/1.1 to the gRPC port. The reply is in the protocol of the client,
// so that it shows the hint. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace jostle::server {

enum class FirstBytes { unknown, tls, http1, http2 };

// The protocol of a client, by the first bytes that it sent.
FirstBytes protocol_of(std::span<const std::uint8_t> first_bytes);

// For TLS an alert, which has no text; for HTTP/1 a response with status 400; for HTTP/2 a GOAWAY
// frame. Empty for an unknown protocol. `hint`: one sentence.
std::string wrong_protocol_reply(FirstBytes protocol, std::string_view hint);

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
//
// Replies to clients that speak another protocol than their port: TLS to a port without TLS, plain
// HTTP to a port with TLS, HTTP/1.1 to the gRPC port. The client shows the hint, or at least fails
// at once. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace jostle::server {

enum class FirstBytes { unknown, tls, http1, http2 };

// The protocol of a client, by the first bytes that it sent.
FirstBytes protocol_of(std::span<const std::uint8_t> first_bytes);

// For TLS an alert, which has no text; for HTTP a response of HTTP/1.1 with status 400. gRPC
// clients report such a response at once; after a GOAWAY they would connect again and again. Empty
// for an unknown protocol. `hint`: one sentence.
std::string wrong_protocol_reply(FirstBytes protocol, std::string_view hint);

}  // namespace jostle::server

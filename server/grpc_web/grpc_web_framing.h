// SPDX-License-Identifier: MIT
//
// The bytes of gRPC-Web (https://github.com/grpc/grpc/blob/master/doc/PROTOCOL-WEB.md): a message
// is a frame of one flag byte, four bytes of length and its bytes; the trailers are such a frame at
// the end of the body. The text form is the same in base64. Pure; any thread.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

enum class GrpcWebForm { binary, text };

// "application/grpc-web", "application/grpc-web-text", each alone or with "+proto". Nothing:
// another content type.
std::optional<GrpcWebForm> grpc_web_form(std::string_view content_type);
// The content type of a response.
std::string content_type_of(GrpcWebForm form);

// The only message of a request body. Errors name the fault.
Result<std::string> read_grpc_web_request(std::string_view body, GrpcWebForm form);

// The body of a response: the message, if the call succeeded, and the trailers. `details`: bytes of
// a google.rpc.Status; empty: none.
std::string write_grpc_web_response(const std::optional<std::string_view>& message, int code,
                                    std::string_view text, std::string_view details,
                                    GrpcWebForm form);

// "5S" or "100m": at most eight digits and a unit (H, M, S, m, u, n). Nothing: malformed.
std::optional<std::chrono::nanoseconds> parse_grpc_timeout(std::string_view text);

}  // namespace jostle::server

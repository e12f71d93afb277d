// SPDX-License-Identifier: MIT
//
// Converts received bytes to requests and messages: Beast's parsers with the limits of
// HttpServerSettings. Sessions use it on sockets, fuzzers on memory.
#pragma once

#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/http_message.h"
#include "server/http/http_server_settings.h"

namespace jostle::server {

using BeastRequest = boost::beast::http::request<boost::beast::http::string_body>;
using BeastRequestParser = boost::beast::http::request_parser<boost::beast::http::string_body>;

inline void set_limits(BeastRequestParser& parser, const HttpServerSettings& settings) {
    parser.header_limit(static_cast<std::uint32_t>(settings.header_bytes_max));
    parser.body_limit(settings.body_bytes_max);
}

template <class Stream>
void set_limits(boost::beast::websocket::stream<Stream>& socket, std::size_t message_bytes_max) {
    socket.read_message_max(message_bytes_max);
    socket.binary(true);
}

// Why a request that Beast accepts is invalid or ambiguous, as a sentence for its client; nothing:
// it is valid. Another parser, such as a proxy, might read such a request differently. HTTP/1.1
// requires exactly one Host header, HTTP/1.0 at most one.
std::optional<std::string_view> request_fault(const BeastRequest& request);

// Whether a header continues on a second line (obs-fold), which Beast joins to one. `bytes`: the
// received bytes of a header, complete or not.
bool has_folded_header(std::string_view bytes);

// The forms of a request target (RFC 9112, 3.2): a path, an http or https URI, or "*" in OPTIONS.
struct RequestTarget {
    std::string path;       // with the query
    std::string authority;  // of a URI; else empty
};
// Nothing: the target has another form, or its authority is not HOST or HOST:PORT.
std::optional<RequestTarget> parse_target(std::string_view method, std::string_view target);

// All values of a header, joined with commas.
std::string joined_header(const BeastRequest& request, std::string_view name);

// Requires a request without fault. The authority of a URI replaces the Host header (RFC 9112,
// 3.2.2).
inline HttpRequest to_http_request(const BeastRequest& request) {
    using boost::beast::http::field;
    const auto header = [&](field name) { return std::string(request[name]); };
    const std::string method(request.method_string());
    const RequestTarget target =
        parse_target(method, std::string(request.target())).value_or(RequestTarget{});
    return {.method = method,
            .target = target.path,
            .host = target.authority.empty() ? header(field::host) : target.authority,
            .origin = header(field::origin),
            .content_type = header(field::content_type),
            .if_none_match = header(field::if_none_match),
            .accept_encoding = header(field::accept_encoding),
            .authorization = header(field::authorization),
            .grpc_timeout = std::string(request["grpc-timeout"]),
            .requested_method = header(field::access_control_request_method),
            .body = request.body()};
}

}  // namespace jostle::server

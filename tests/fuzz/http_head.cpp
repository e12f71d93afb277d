// SPDX-License-Identifier: MIT
//
// The bytes of an HTTP connection, in pieces as a socket may give them, read with the gateway's own
// bounds.
#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "server/auth/allowed_hosts.h"
#include "server/auth/authorizer.h"
#include "server/http/beast_request.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

// What the gateway does with one request, up to its answer.
void parse_head(const server::BeastRequest& raw, const server::HttpServerSettings& settings) {
    static_cast<void>(server::request_fault(raw));
    const server::HttpRequest request = server::to_http_request(raw);
    expect(request.target.size() <= settings.header_bytes_max, "a target fits into the header");
    expect(request.body.size() <= settings.body_bytes_max, "a body is within its bound");
    static_cast<void>(boost::beast::websocket::is_upgrade(raw));
    static_cast<void>(server::host_is_allowed(request.host, {"play.example.org"}));
    if (const auto bearer = server::parse_bearer(request.authorization); bearer.ok())
        expect(bearer->size() <= request.authorization.size(), "a token is part of its header");
    static_cast<void>(raw.keep_alive());
}

}  // namespace

void run(Bytes input) {
    const server::HttpServerSettings settings{.header_bytes_max = 1024, .body_bytes_max = 2048};
    Reader in(input);
    const std::size_t piece = 1 + in.number<std::uint8_t>() * 4u;
    boost::beast::flat_buffer buffer;
    for (int requests = 0; requests < 8; requests++) {
        server::BeastRequestParser parser;
        set_limits(parser, settings);
        while (!parser.is_done()) {
            if (parser.is_header_done()) {
                if (parser.chunked()) return;  // refused, and the connection closed
                parser.eager(true);
            }
            const Bytes fresh = in.take(piece);
            const bool ended = fresh.empty();
            buffer.commit(boost::asio::buffer_copy(
                buffer.prepare(fresh.size()), boost::asio::buffer(fresh.data(), fresh.size())));
            if (!parser.is_header_done() &&
                server::has_folded_header(
                    {static_cast<const char*>(buffer.cdata().data()), buffer.cdata().size()}))
                return;
            boost::beast::error_code error;
            buffer.consume(parser.put(buffer.data(), error));
            if (error == boost::beast::http::error::need_more && !ended) continue;
            if (error) return;
            if (ended) return;
        }
        parse_head(parser.get(), settings);
    }
}

}  // namespace jostle::fuzz

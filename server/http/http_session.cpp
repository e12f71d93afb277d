// SPDX-License-Identifier: MIT
#include "server/http/http_session.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/version.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <cstring>
#include <exception>
#include <utility>

#include "jostle/base/check.h"
#include "server/forwarding/trusted_proxies.h"
#include "server/util/address.h"
#include "server/util/log.h"

namespace jostle::server {

namespace beast = boost::beast;
namespace http = beast::http;
namespace asio = boost::asio;

namespace {

// Only scripts of this server are allowed. A page may also connect to /play of other servers,
// because the viewer can be pointed at them. The predictor is WebAssembly. The viewer must not be
// embedded in a frame.
constexpr std::string_view content_security_policy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; "
    "connect-src 'self' ws: wss: http: https:; frame-ancestors 'none'";

constexpr std::size_t read_bytes = 1536;  // of a header at once

}  // namespace

HttpSession::HttpSession(SocketStream stream, const Services& services)
    : stream_(std::move(stream)), services_(services) {
    beast::error_code error;
    const auto endpoint = stream_.tcp().socket().remote_endpoint(error);
    if (error) return;
    sockaddr_storage peer{};
    std::memcpy(&peer, endpoint.data(), endpoint.size());
    address_ = address_name(peer);
    peer_ = peer_name(peer);
}

HttpSession::~HttpSession() {
    release_body();
}

void HttpSession::start() {
    idle_since_ = Clock::now();
    const HttpServerSettings& settings = services_.settings;
    stream_.tcp().expires_after(settings.request_timeout);
    if (settings.proxy_protocol && settings.proxies && settings.proxies->contains(address_)) {
        proxy_header_.emplace();
        return read_proxy_header();
    }
    secure();
}

// Reads no byte behind the header, which may be the first of TLS or of a request.
void HttpSession::read_proxy_header() {
    stream_.tcp().async_read_some(
        asio::buffer(first_bytes_, std::min(first_bytes_.size(), proxy_header_->wanted())),
        [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
            self->on_proxy_header(error, bytes);
        });
}

void HttpSession::on_proxy_header(beast::error_code error, std::size_t bytes) {
    const Status taken = error ? Status(Error{ErrorCode::unavailable, error.message()})
                               : proxy_header_->take({first_bytes_.data(), bytes});
    if (!taken.ok()) {
        log_warn("http: {}: connection closed in its PROXY header: {}", peer_,
                 taken.error().message);
        if (services_.settings.metrics)
            services_.settings.metrics->refused(ConnectionRefusal::proxy_header).Increment();
        return;
    }
    if (proxy_header_->wanted() > 0) return read_proxy_header();
    if (const auto client = proxy_header_->client()) {
        const std::string address = address_name(*client);
        if (!services_.has_room_for(address)) return;  // closes the connection
        address_ = address;
        peer_ = peer_name(*client);
    }
    proxy_header_.reset();
    secure();
}

// Performs the TLS handshake, after a look at the first bytes.
void HttpSession::secure() {
    if (!stream_.tls()) return read(services_.settings.request_timeout);
    stream_.tcp().async_read_some(
        asio::buffer(first_bytes_),
        [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
            self->on_first_bytes(error, bytes);
        });
}

void HttpSession::on_first_bytes(beast::error_code error, std::size_t bytes) {
    if (error) return;
    const FirstBytes protocol = protocol_of({first_bytes_.data(), bytes});
    if (protocol == FirstBytes::http1 || protocol == FirstBytes::http2)
        return reply_to_wrong_protocol(protocol, "This port requires TLS: use https:// or wss://.");
    stream_.async_handshake(asio::buffer(first_bytes_.data(), bytes),
                            [self = shared_from_this()](beast::error_code failure) {
                                if (failure) return;  // not TLS, or an invalid certificate
                                self->certificate_ = self->stream_.certificate();
                                self->read(self->services_.settings.request_timeout);
                            });
}

// Sends the hint without TLS and closes the connection.
void HttpSession::reply_to_wrong_protocol(FirstBytes protocol, std::string_view hint) {
    if (services_.hint_log.take(1, Clock::now())) log_info("http: {}: {}", peer_, hint);
    raw_reply_ = wrong_protocol_reply(protocol, hint);
    asio::async_write(stream_.tcp(), asio::buffer(raw_reply_),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                          if (!error)
                              self->stream_.tcp().socket().shutdown(
                                  asio::ip::tcp::socket::shutdown_send, error);
                      });
}

void HttpSession::abort() {
    beast::error_code ignored;
    stream_.tcp().socket().close(ignored);
}

void HttpSession::read(std::chrono::seconds timeout) {
    release_body();
    idle_since_ = Clock::now();
    parser_.emplace();
    set_limits(*parser_, services_.settings);
    stream_.tcp().expires_after(timeout);
    parse_header();
}

// Like async_read_header() of Beast, but checks the bytes of the header before Beast parses them.
// The parser consumes nothing until the header is complete.
void HttpSession::parse_header() {
    const asio::const_buffer received = buffer_.cdata();
    const FirstBytes protocol =
        stream_.tls()
            ? FirstBytes::unknown
            : protocol_of({static_cast<const std::uint8_t*>(received.data()), received.size()});
    if (protocol == FirstBytes::tls)
        return reply_to_wrong_protocol(protocol, "This port has no TLS: use http:// or ws://.");
    if (protocol == FirstBytes::http2)
        return reply_to_wrong_protocol(
            protocol, "this is the HTTP/1.1 port; gRPC has another one (setting listen)");
    if (has_folded_header({static_cast<const char*>(received.data()), received.size()}))
        return refuse(400, "A header continues on a second line.\n");
    beast::error_code error;
    buffer_.consume(parser_->put(received, error));
    if (error != http::error::need_more) return on_header(error);
    stream_.async_read_some(
        buffer_.prepare(read_bytes),
        [self = shared_from_this()](beast::error_code failure, std::size_t bytes) {
            if (failure == asio::error::eof)
                failure = self->buffer_.size() > 0 ? http::error::partial_message
                                                   : http::error::end_of_stream;
            if (failure) return self->on_header(failure);
            self->buffer_.commit(bytes);
            self->parse_header();
        });
}

// Returns true if the connection cannot continue; an error response was sent if one is due.
bool HttpSession::failed(beast::error_code error) {
    if (error == http::error::header_limit) {
        refuse(431, "The request header is too large.\n");
    } else if (error == http::error::body_limit) {
        refuse(413, "The request body is too large.\n");
    } else if (error && error != http::error::end_of_stream && error != beast::error::timeout &&
               error.category() != asio::error::get_system_category()) {
        refuse(400, "This is not an HTTP request.\n");
    }
    // Otherwise the connection was closed or timed out, and no response is expected.
    return static_cast<bool>(error);
}

void HttpSession::on_header(beast::error_code error) {
    if (failed(error)) return;
    if (parser_->get().method() == http::verb::connect)
        return refuse(501, "This server is not a proxy; it does not support CONNECT.\n");
    if (const auto fault = request_fault(parser_->get()))
        return refuse(400, std::string(*fault) + "\n");
    HttpRequest request = request_of_peer();
    if (beast::websocket::is_upgrade(parser_->get()) && services_.routes.accepts_players(request)) {
        if (const auto refusal = services_.routes.cross_origin_refusal(request))
            return refuse(403, *refusal + "\n");
        const bool is_forwarded = request.address != address_;
        if (is_forwarded && !services_.has_room_for(request.address))
            return refuse(429, "Too many connections of this address are open.\n");
        const SocketPeer peer{is_forwarded ? request.address + " via " + peer_ : peer_,
                              request.address};
        return services_.upgrade(std::move(stream_), parser_->release(), peer);
    }
    const bool large = services_.routes.accepts_large_body(request);
    const std::size_t bytes_max =
        large ? services_.settings.body_bytes_max : services_.settings.small_body_bytes_max;
    parser_->body_limit(bytes_max);
    // Beast 1.74 has assertions on chunked bodies that a client can violate.
    if (parser_->chunked()) return refuse(411, "The Content-Length header is required.\n");
    const std::uint64_t length = parser_->content_length().value_or(0);
    if (length > bytes_max)
        return refuse(413, "The request body has " + std::to_string(length) + " bytes; at most " +
                               std::to_string(bytes_max) + " are allowed" +
                               (large ? " (setting scene.request_bytes_max)" : "") + ".\n");
    if (length > 0 && !reserve_body(static_cast<std::size_t>(length)))
        return refuse(503, "Too many requests are being received; retry in 1 s.\n");
    read_body();
}

bool HttpSession::reserve_body(std::size_t bytes) {
    const auto size = static_cast<double>(bytes);
    if (services_.body_bytes + size > services_.settings.bodies_bytes_max) return false;
    services_.body_bytes += size;
    ASSERT(reserved_ == 0);
    reserved_ = size;
    return true;
}

void HttpSession::release_body() {
    services_.body_bytes -= std::exchange(reserved_, 0);
    ASSERT(services_.body_bytes >= 0);
}

void HttpSession::read_body() {
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                         self->on_body(error);
                     });
}

void HttpSession::on_body(beast::error_code error) {
    if (failed(error)) return;
    idle_since_.reset();
    handle_request();
}

// The address of the client of the current request.
std::string HttpSession::client_address() const {
    const TrustedProxies* const proxies = services_.settings.proxies;
    if (!proxies || !proxies->contains(address_)) return address_;
    return proxies->client_address(address_, joined_header(parser_->get(), proxies->header_name()));
}

HttpRequest HttpSession::request_of_peer() const {
    HttpRequest request = to_http_request(parser_->get());
    request.address = client_address();
    request.certificate = certificate_;
    return request;
}

void HttpSession::handle_request() {
    HttpRequest request = request_of_peer();
    ASSERT(!idle_since_);
    switch (services_.routes.work_of(request)) {
        case HttpWork::immediate:
            return write(services_.routes.handle(request));
        case HttpWork::query:
            return handle_on(services_.query_pool, std::move(request));
        case HttpWork::mutation:
            return handle_on(services_.mutation_pool, std::move(request));
    }
}

// The rest of the connection cannot be parsed: sends one response, then closes it.
void HttpSession::refuse(int status, std::string text) {
    HttpResponse response = plain_text(status, std::move(text));
    response.headers.emplace_back("Connection", "close");
    if (status == 503) response.headers.emplace_back("Retry-After", "1");
    closing_ = true;
    write(response);
}

void HttpSession::handle_on(WorkPool& pool, HttpRequest request) {
    stream_.tcp().expires_never();  // building a world has no time limit
    const bool added = pool.add([self = shared_from_this(), request = std::move(request)] {
        HttpResponse response;
        try {
            response = self->services_.routes.handle(request);
        } catch (const std::exception& error) {
            // For example out of memory: only this request fails.
            log_error("{} {} failed: {}", request.method, request.target, error.what());
            response.status = 503;
            response.body = "The response needs more memory than is available.\n";
        }
        asio::post(self->stream_.get_executor(),
                   [self, response = std::move(response)] { self->write(response); });
    });
    if (added) return;
    if (services_.settings.metrics)
        services_.settings.metrics->refused(ConnectionRefusal::busy).Increment();
    refuse(503, "Too many requests are queued; retry in 1 s.\n");
}

void HttpSession::write(const HttpResponse& response) {
    ASSERT(parser_);
    const auto& request = parser_->get();
    ASSERT(response.status >= 100 && response.status < 600);
    head_only_ = request.method() == http::verb::head;
    response_ = Response(static_cast<http::status>(response.status), 11);
    response_.keep_alive(!closing_ && parser_->is_done() && request.keep_alive());
    response_.set(http::field::server, "jostle");
    response_.set("X-Content-Type-Options", "nosniff");
    if (response.status != 304) response_.set(http::field::content_type, response.content_type);
    if (response.content_type.starts_with("text/html")) {
        response_.set(
            "Content-Security-Policy",
            beast::string_view(content_security_policy.data(), content_security_policy.size()));
    }
    for (const auto& [name, value] : response.headers) response_.set(name, value);
    const auto text = [&](http::field name) { return std::string(request[name]); };
    for (const auto& [name, value] :
         services_.routes.cors_headers(text(http::field::origin), text(http::field::host)))
        response_.insert(name, value);
    // A response to HEAD states the length of the omitted body.
    if (response.status != 304) response_.content_length(response.body.size());
    if (!head_only_) response_.body() = response.body;

    stream_.tcp().expires_after(services_.settings.request_timeout);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->on_wrote(error);
                      });
}

void HttpSession::on_wrote(beast::error_code error) {
    if (error) return;
    if (!response_.keep_alive()) {
        stream_.tcp().socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
        return;
    }
    read(services_.settings.idle_timeout);
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/http/http_session.h"

#include <boost/asio/post.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/version.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <exception>
#include <utility>

#include "server/util/address.h"
#include "server/util/log.h"

namespace jostle::server {

namespace beast = boost::beast;
namespace http = beast::http;
namespace asio = boost::asio;

namespace {

// Scripts come from this server alone; a page may also talk to other servers' /play, because the
// viewer can be pointed at them. Its predictor is WebAssembly. Nobody may put the viewer into a
// frame.
constexpr std::string_view content_security_policy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; "
    "connect-src 'self' ws: wss: http: https:; frame-ancestors 'none'";

}  // namespace

HttpSession::HttpSession(SocketStream stream, const Services& services)
    : stream_(std::move(stream)), services_(services) {
    beast::error_code error;
    const auto endpoint = stream_.tcp().socket().remote_endpoint(error);
    if (!error) address_ = endpoint.address().to_string();
}

HttpSession::~HttpSession() {
    release_body();
}

void HttpSession::start() {
    idle_since_ = Clock::now();
    stream_.tcp().expires_after(services_.settings.request_timeout);
    stream_.async_handshake([self = shared_from_this()](beast::error_code error) {
        if (error) return;  // no client of ours, or one with a bad certificate
        self->certificate_ = self->stream_.certificate();
        self->read(self->services_.settings.request_timeout);
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
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                                self->on_header(error);
                            });
}

// True: there is nothing to go on with, and what there was to say was said.
bool HttpSession::failed(beast::error_code error) {
    if (error == http::error::header_limit) {
        refuse(431, "The request's header is too big.\n");
    } else if (error == http::error::body_limit) {
        refuse(413, "The request's body is too big.\n");
    } else if (error && error != http::error::end_of_stream && error != beast::error::timeout &&
               error.category() != asio::error::get_system_category()) {
        refuse(400, "This is not an HTTP request.\n");
    }
    // Else: ended, cut or silent too long, and nobody waits for an answer.
    return static_cast<bool>(error);
}

void HttpSession::on_header(beast::error_code error) {
    if (failed(error)) return;
    HttpRequest request = request_of_peer();
    if (beast::websocket::is_upgrade(parser_->get()) && services_.routes.accepts_players(request)) {
        if (const auto refusal = services_.routes.cross_origin_refusal(request))
            return refuse(403, *refusal + "\n");
        return services_.upgrade(std::move(stream_), parser_->release());
    }
    const bool large = services_.routes.accepts_large_body(request);
    const std::size_t most =
        large ? services_.settings.body_bytes_max : services_.settings.small_body_bytes_max;
    parser_->body_limit(most);
    // Beast 1.74 asserts things of chunks that a client can make wrong.
    if (parser_->chunked()) return refuse(411, "Say the body's length: Content-Length.\n");
    const std::uint64_t length = parser_->content_length().value_or(0);
    if (length > most) return refuse(413, "The request's body is too big.\n");
    if (length > 0 && !reserve_body(static_cast<std::size_t>(length)))
        return refuse(503, "Too many requests are being received; try again in a second.\n");
    read_body();
}

bool HttpSession::reserve_body(std::size_t bytes) {
    const auto wanted = static_cast<double>(bytes);
    if (services_.body_bytes + wanted > services_.settings.bodies_bytes_max) return false;
    services_.body_bytes += wanted;
    reserved_ = wanted;
    return true;
}

void HttpSession::release_body() {
    services_.body_bytes -= std::exchange(reserved_, 0);
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

HttpRequest HttpSession::request_of_peer() const {
    HttpRequest request = to_http_request(parser_->get());
    request.address = address_;
    request.certificate = certificate_;
    return request;
}

void HttpSession::handle_request() {
    HttpRequest request = request_of_peer();
    switch (services_.routes.work_of(request)) {
        case HttpWork::immediate:
            return write(services_.routes.handle(request));
        case HttpWork::query:
            return handle_on(services_.query_pool, std::move(request));
        case HttpWork::mutation:
            return handle_on(services_.mutation_pool, std::move(request));
    }
}

// The peer sent what we cannot read on from: one answer, then the connection ends.
void HttpSession::refuse(int status, std::string text) {
    HttpResponse answer = plain_text(status, std::move(text));
    answer.headers.emplace_back("Connection", "close");
    if (status == 503) answer.headers.emplace_back("Retry-After", "1");
    closing_ = true;
    write(answer);
}

void HttpSession::handle_on(WorkPool& pool, HttpRequest request) {
    stream_.tcp().expires_never();  // however long the world takes to build
    const bool added = pool.add([self = shared_from_this(), request = std::move(request)] {
        HttpResponse answer;
        try {
            answer = self->services_.routes.handle(request);
        } catch (const std::exception& error) {
            // Out of memory, say: this request fails and nothing else does.
            log_error("{} {} failed: {}", request.method, request.target, error.what());
            answer.status = 503;
            answer.body = "The answer takes more than there is.\n";
        }
        asio::post(self->stream_.get_executor(),
                   [self, answer = std::move(answer)] { self->write(answer); });
    });
    if (added) return;
    if (services_.settings.metrics)
        services_.settings.metrics->refused(ConnectionRefusal::busy).Increment();
    refuse(503, "Too many requests wait to be answered; try again in a second.\n");
}

void HttpSession::write(const HttpResponse& answer) {
    const auto& request = parser_->get();
    head_only_ = request.method() == http::verb::head;
    response_ = Response(static_cast<http::status>(answer.status), 11);
    response_.keep_alive(!closing_ && parser_->is_done() && request.keep_alive());
    response_.set(http::field::server, "jostle");
    response_.set("X-Content-Type-Options", "nosniff");
    if (answer.status != 304) response_.set(http::field::content_type, answer.content_type);
    if (answer.content_type.starts_with("text/html")) {
        response_.set(
            "Content-Security-Policy",
            beast::string_view(content_security_policy.data(), content_security_policy.size()));
    }
    for (const auto& [name, value] : answer.headers) response_.set(name, value);
    // HEAD promises the length of the body it leaves out.
    if (answer.status != 304) response_.content_length(answer.body.size());
    if (!head_only_) response_.body() = answer.body;

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

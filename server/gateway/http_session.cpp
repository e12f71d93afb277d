// SPDX-License-Identifier: MIT
#include "gateway/http_session.h"

#include <boost/asio/dispatch.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/version.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

namespace jostle::server {

namespace beast = boost::beast;
namespace http = beast::http;
namespace asio = boost::asio;

namespace {

// Scripts come from this server alone; a page may also talk to other servers' /play, because the
// viewer can be pointed at them. Nobody may put the viewer into a frame.
constexpr std::string_view content_security_policy =
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self' ws: wss: http: https:; frame-ancestors 'none'";

}  // namespace

HttpSession::HttpSession(asio::ip::tcp::socket socket, const Services& services)
    : stream_(std::move(socket)), services_(services) {}

void HttpSession::start() {
    read(services_.settings.request_timeout);
}

void HttpSession::abort() {
    beast::error_code ignored;
    stream_.socket().close(ignored);
}

void HttpSession::read(std::chrono::seconds patience) {
    parser_.emplace();
    set_bounds(*parser_, services_.settings);
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                         self->on_read(error);
                     });
}

void HttpSession::on_read(beast::error_code error) {
    if (error == http::error::header_limit) {
        return refuse(431, "The request's header is too big.\n");
    }
    if (error == http::error::body_limit) return refuse(413, "The request's body is too big.\n");
    // Ended, cut or silent too long: nobody waits for an answer.
    if (error == http::error::end_of_stream || error == beast::error::timeout ||
        (error && error.category() == asio::error::get_system_category())) {
        return;
    }
    if (error) return refuse(400, "This is not an HTTP request.\n");

    HttpRequest request = plain_request(parser_->get());
    if (beast::websocket::is_upgrade(parser_->get()) && path_of(request.target) == "/play") {
        if (!services_.routes.origin_is_allowed(request)) {
            return refuse(403, "A page from another origin may not play on this server.\n");
        }
        return services_.upgrade(std::move(stream_), parser_->release());
    }
    if (HttpRoutes::may_take_long(request)) return answer_on_worker(std::move(request));
    write(services_.routes.answer(request));
}

// The peer sent what we cannot read on from: one answer, then the connection ends.
void HttpSession::refuse(int status, std::string text) {
    HttpResponse answer;
    answer.status = status;
    answer.body = std::move(text);
    answer.headers.emplace_back("Connection", "close");
    write(answer);
}

void HttpSession::answer_on_worker(HttpRequest request) {
    stream_.expires_never();  // however long the world takes to build
    asio::post(services_.worker, [self = shared_from_this(), request = std::move(request)] {
        HttpResponse answer = self->services_.routes.answer(request);
        asio::dispatch(self->stream_.get_executor(),
                       [self, answer = std::move(answer)] { self->write(answer); });
    });
}

void HttpSession::write(const HttpResponse& answer) {
    const auto& request = parser_->get();
    head_only_ = request.method() == http::verb::head;
    response_ = Response(static_cast<http::status>(answer.status), 11);
    response_.keep_alive(parser_->is_done() && request.keep_alive());
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

    stream_.expires_after(services_.settings.request_timeout);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->on_wrote(error);
                      });
}

void HttpSession::on_wrote(beast::error_code error) {
    if (error) return;
    if (!response_.keep_alive()) {
        stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
        return;
    }
    read(services_.settings.idle_timeout);
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "gateway/gateway.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <thread>
#include <utility>
#include <vector>

#include "gateway/http_session.h"
#include "gateway/websocket_session.h"

namespace jostle::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;

namespace {

// Timeouts and statistics need no better; frames wake the thread by themselves.
constexpr auto housekeeping_period = std::chrono::milliseconds(20);
// When no file descriptor is left, trying again at once would only spin.
constexpr auto accept_pause = std::chrono::milliseconds(100);

template <class Session>
std::size_t drop_gone(std::vector<std::weak_ptr<Session>>& sessions) {
    std::erase_if(sessions, [](const auto& session) { return session.expired(); });
    return sessions.size();
}

}  // namespace

struct Gateway::Impl {
    Impl(PlayContext& play_context, const HttpHandler& handler, GatewaySettings gateway_settings)
        : context(play_context),
          settings(std::move(gateway_settings)),
          services{handler, settings, worker, slow,
                   [this](beast::tcp_stream stream, WebSocketSession::Request request) {
                       begin_play(std::move(stream), request);
                   }} {}

    Status listen();
    void accept();
    void on_accept(beast::error_code error, tcp::socket socket);
    void begin_play(beast::tcp_stream stream, const WebSocketSession::Request& request);
    void schedule_housekeeping();
    void advance_all();
    void count_open();
    void abort_all();

    PlayContext& context;
    const GatewaySettings settings;
    asio::io_context io{1};
    asio::thread_pool worker{static_cast<std::size_t>(settings.workers)};
    std::atomic<int> slow{0};
    tcp::acceptor acceptor{io};
    asio::steady_timer housekeeping{io}, accept_again{io};
    bool ending = false;  // the thread's own
    const HttpSession::Services services;
    // The sessions keep themselves alive; these only know them.
    std::vector<std::weak_ptr<HttpSession>> http_sessions;
    std::vector<std::weak_ptr<WebSocketSession>> play_sessions;
    std::size_t first = 0;           // whose write starts first this time
    std::atomic<bool> awake{false};  // a wake-up is on its way
    std::uint16_t real_port = 0;
    std::thread thread;
};

Status Gateway::Impl::listen() {
    const auto failure = [&](std::string_view what, const beast::error_code& error) {
        return Error{
            ErrorCode::unavailable,
            fmt::format("cannot {} {}:{} for HTTP: {}; choose another with {} HOST:PORT", what,
                        settings.host, settings.port, error.message(), settings.flag)};
    };
    beast::error_code error;
    tcp::resolver resolver(io);
    const auto found =
        resolver.resolve(settings.host, std::to_string(settings.port),
                         tcp::resolver::passive | tcp::resolver::numeric_service, error);
    if (error) return failure("resolve", error);
    const tcp::endpoint endpoint = found.begin()->endpoint();
    acceptor.open(endpoint.protocol(), error);
    // Only means that a port whose last connections linger may be used again; a port in use is
    // still refused.
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) return failure("listen on", error);
    real_port = acceptor.local_endpoint().port();
    return {};
}

void Gateway::Impl::accept() {
    acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
        on_accept(error, std::move(socket));
    });
}

void Gateway::Impl::on_accept(beast::error_code error, tcp::socket socket) {
    if (ending || error == asio::error::operation_aborted) return;
    if (error) {
        spdlog::warn("http: cannot take a connection: {}", error.message());
        accept_again.expires_after(accept_pause);
        accept_again.async_wait([this](beast::error_code stopped) {
            if (!stopped && !ending) accept();
        });
        return;
    }
    // Above the limit the socket is closed again at once: the cheapest answer there is.
    const std::size_t open = drop_gone(http_sessions) + drop_gone(play_sessions);
    if (settings.metrics && open >= settings.connections_max)
        settings.metrics->refused(ConnectionRefusal::limit).Increment();
    if (open < settings.connections_max) {
        socket.set_option(tcp::no_delay(true), error);
        const auto session = std::make_shared<HttpSession>(std::move(socket), services);
        http_sessions.push_back(session);
        session->start();
    }
    accept();
}

void Gateway::Impl::begin_play(beast::tcp_stream stream, const WebSocketSession::Request& request) {
    const auto session =
        std::make_shared<WebSocketSession>(context, std::move(stream), settings.message_bytes_max);
    play_sessions.push_back(session);
    session->start(request);
}

void Gateway::Impl::schedule_housekeeping() {
    if (ending) return;
    housekeeping.expires_after(housekeeping_period);
    housekeeping.async_wait([this](beast::error_code stopped) {
        if (stopped) return;
        advance_all();
        count_open();
        schedule_housekeeping();
    });
}

// Each round begins with the next client, so that not always the same one is written to last.
void Gateway::Impl::advance_all() {
    const std::size_t count = drop_gone(play_sessions);
    if (count == 0) return;
    const Clock::time_point now = Clock::now();
    first = (first + 1) % count;
    for (std::size_t i = 0; i < count; ++i) {
        // advance() starts operations only, so no session can end or begin while we walk.
        if (const auto session = play_sessions[(first + i) % count].lock()) session->advance(now);
    }
}

void Gateway::Impl::count_open() {
    if (!settings.metrics) return;
    const std::size_t open = drop_gone(http_sessions) + drop_gone(play_sessions);
    settings.metrics->open.Set(static_cast<double>(open));
}

void Gateway::Impl::abort_all() {
    // Cancelling does not reach a timer whose handler is queued already: those look at this before
    // they start anew.
    ending = true;
    beast::error_code ignored;
    acceptor.close(ignored);
    housekeeping.cancel();
    accept_again.cancel();
    for (const auto& known : http_sessions) {
        if (const auto session = known.lock()) session->abort();
    }
    for (const auto& known : play_sessions) {
        if (const auto session = known.lock()) session->abort();
    }
}

Gateway::Gateway(PlayContext& context, const HttpHandler& routes, GatewaySettings settings)
    : impl_(std::make_unique<Impl>(context, routes, std::move(settings))) {}

Gateway::~Gateway() {
    stop();
}

Status Gateway::start() {
    if (Status s = impl_->listen(); !s.ok()) return s;
    impl_->accept();
    impl_->schedule_housekeeping();
    impl_->thread = std::thread([impl = impl_.get()] { impl->io.run(); });
    return {};
}

std::uint16_t Gateway::port() const {
    return impl_->real_port;
}

void Gateway::wake() {
    if (impl_->awake.exchange(true)) return;
    asio::post(impl_->io, [impl = impl_.get()] {
        impl->awake = false;  // before looking: a frame that comes meanwhile wakes again
        impl->advance_all();
    });
}

// Sockets are closed on their own thread; the operations they had in flight end with an error and
// let go of the sessions, so the io_context runs out of work and its thread ends.
void Gateway::stop() {
    if (!impl_->thread.joinable()) return;
    asio::post(impl_->io, [impl = impl_.get()] { impl->abort_all(); });
    impl_->thread.join();
    impl_->worker.join();
}

}  // namespace jostle::server

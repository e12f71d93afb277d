// SPDX-License-Identifier: MIT
#include "server/http/http_server.h"

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <thread>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "server/forwarding/trusted_proxies.h"
#include "server/http/http_session.h"
#include "server/http/websocket_session.h"
#include "server/tls/tls_contexts.h"
#include "server/util/address.h"
#include "server/util/log.h"
#include "server/util/work_pool.h"

namespace jostle::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;

namespace {

// Sufficient for timeouts and statistics; frames wake the thread directly.
constexpr auto housekeeping_period = std::chrono::milliseconds(50);
constexpr auto idle_period = std::chrono::milliseconds(250);  // without WebSockets
// If no file descriptor is available, an immediate retry would only spin.
constexpr auto accept_pause = std::chrono::milliseconds(100);

// Queries and changes run at a lower priority than play sessions.
constexpr int query_niceness = 10, mutation_niceness = 5;

template <class Session>
std::size_t remove_closed(std::vector<std::weak_ptr<Session>>& sessions) {
    std::erase_if(sessions, [](const auto& session) { return session.expired(); });
    return sessions.size();
}

}  // namespace

struct HttpServer::Impl {
    Impl(PlayContext& play_context, const HttpHandler& handler, HttpServerSettings server_settings)
        : context(play_context),
          settings(std::move(server_settings)),
          services{handler,
                   settings,
                   query_pool,
                   mutation_pool,
                   body_bytes,
                   [this](SocketStream stream, WebSocketSession::Request request, SocketPeer peer) {
                       begin_play(std::move(stream), request, std::move(peer));
                   },
                   [this](const std::string& address) { return has_room_for(address); },
                   hint_log} {}

    Status listen();
    void accept();
    void on_accept(beast::error_code error, tcp::socket socket);
    bool make_room(const tcp::socket& socket);
    bool is_proxy(const std::string& address) const {
        return settings.proxies && settings.proxies->contains(address);
    }
    bool has_room_for(const std::string& address);
    void begin_play(SocketStream stream, const WebSocketSession::Request& request, SocketPeer peer);
    void schedule_housekeeping();
    void advance_all();
    void count_open();
    void count_refused(ConnectionRefusal why);
    void abort_all();
    void run();

    PlayContext& context;
    const HttpServerSettings settings;
    OverloadControl overload;  // outlives the sessions, which handlers of `io` may own
    asio::io_context io{1};
    TokenBucket hint_log{0.2, 3, Clock::now()};
    double body_bytes = 0;  // of requests that are being received or handled
    WorkPool query_pool{settings.query_threads, settings.work_queue_max, query_niceness},
        mutation_pool{1, settings.work_queue_max, mutation_niceness};
    tcp::acceptor acceptor{io};
    asio::steady_timer housekeeping{io}, accept_again{io};
    bool stopping = false;  // used by the thread only
    TlsContexts tls{settings.certificates, {.require_certificates = settings.require_certificates}};
    const HttpSession::Services services;
    // The sessions own themselves; these lists only refer to them.
    std::vector<std::weak_ptr<HttpSession>> http_sessions;
    std::vector<std::weak_ptr<WebSocketSession>> play_sessions;
    std::size_t first = 0;                 // the session that starts the next round
    std::atomic<bool> awake{false};        // a wake-up is pending
    std::atomic<bool> has_players{false};  // play_sessions are not empty
    std::uint16_t bound_port = 0;
    std::thread thread;
};

Status HttpServer::Impl::listen() {
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
    // Allows reuse of a port with lingering connections; binding a port in use still fails.
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) return failure("listen on", error);
    bound_port = acceptor.local_endpoint().port();
    ASSERT(bound_port != 0);
    return {};
}

void HttpServer::Impl::accept() {
    acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
        on_accept(error, std::move(socket));
    });
}

void HttpServer::Impl::on_accept(beast::error_code error, tcp::socket socket) {
    if (stopping || error == asio::error::operation_aborted) return;
    if (error) {
        log_warn("http: cannot accept a connection: {}", error.message());
        accept_again.expires_after(accept_pause);
        accept_again.async_wait([this](beast::error_code stopped) {
            if (!stopped && !stopping) accept();
        });
        return;
    }
    if (make_room(socket)) {
        socket.set_option(tcp::no_delay(true), error);
        const auto session =
            std::make_shared<HttpSession>(SocketStream(std::move(socket), tls.current()), services);
        http_sessions.push_back(session);
        session->start();
    }
    accept();
}

// Returns false if the socket must be closed at once, the cheapest refusal. Of the HTTP connections
// the one that was idle longest is closed first; play sessions are never closed.
bool HttpServer::Impl::make_room(const tcp::socket& socket) {
    const std::size_t players = remove_closed(play_sessions), others = remove_closed(http_sessions);
    beast::error_code error;
    const auto endpoint = socket.remote_endpoint(error);
    if (error) return false;
    const std::string address = endpoint.address().to_string(), network = network_of(address);
    const auto is_same = [&](const auto& session) {
        return network_of(session->address()) == network;
    };
    std::size_t of_address = 0;
    std::shared_ptr<HttpSession> oldest, oldest_of_address;
    const auto is_older = [](const auto& a, const auto& b) {
        return !b || *a->idle_since() < *b->idle_since();
    };
    for (const auto& known : play_sessions)
        if (const auto session = known.lock()) of_address += is_same(session) ? 1 : 0;
    for (const auto& known : http_sessions) {
        const auto session = known.lock();
        if (!session) continue;
        const bool same = is_same(session);
        of_address += same ? 1 : 0;
        if (!session->idle_since()) continue;
        if (is_older(session, oldest)) oldest = session;
        if (same && is_older(session, oldest_of_address)) oldest_of_address = session;
    }
    // The connections of a proxy belong to many clients; has_room_for() counts each of them.
    if (of_address >= settings.per_address_max && !is_proxy(address)) {
        count_refused(ConnectionRefusal::address_limit);
        if (!oldest_of_address) return false;
        oldest_of_address->abort();
    } else if (players + others >= settings.connections_max) {
        count_refused(ConnectionRefusal::limit);
        if (!oldest) return false;
        oldest->abort();
    }
    return true;
}

// For a client that a proxy named. If it is refused, the caller closes its connection.
bool HttpServer::Impl::has_room_for(const std::string& address) {
    if (is_proxy(address)) return true;
    const std::string network = network_of(address);
    std::size_t count = 0;
    const auto count_same = [&](const auto& sessions) {
        for (const auto& known : sessions)
            if (const auto session = known.lock())
                count += network_of(session->address()) == network ? 1 : 0;
    };
    count_same(play_sessions);
    count_same(http_sessions);
    if (count < settings.per_address_max) return true;
    count_refused(ConnectionRefusal::address_limit);
    return false;
}

void HttpServer::Impl::begin_play(SocketStream stream, const WebSocketSession::Request& request,
                                  SocketPeer peer) {
    const auto session = std::make_shared<WebSocketSession>(
        context, overload, std::move(stream), std::move(peer), settings.message_bytes_max);
    play_sessions.push_back(session);
    has_players = true;
    if (play_sessions.size() == 1) schedule_housekeeping();  // replaces the longer idle period
    session->start(request);
}

void HttpServer::Impl::schedule_housekeeping() {
    if (stopping) return;
    housekeeping.expires_after(play_sessions.empty() ? idle_period : housekeeping_period);
    housekeeping.async_wait([this](beast::error_code stopped) {
        if (stopped) return;
        advance_all();
        count_open();
        schedule_housekeeping();
    });
}

// Each round starts with the next client, so that no client is always written to last. A round
// takes a while, so each client has its own time.
void HttpServer::Impl::advance_all() {
    const std::size_t count = remove_closed(play_sessions);
    has_players = count > 0;
    if (count == 0) return;
    first = (first + 1) % count;
    ASSERT(first < count);
    for (std::size_t i = 0; i < count; ++i) {
        // advance() only starts operations, so no session starts or ends during the loop.
        if (const auto session = play_sessions[(first + i) % count].lock())
            session->advance(Clock::now());
    }
}

void HttpServer::Impl::count_open() {
    if (!settings.metrics) return;
    const std::size_t open = remove_closed(http_sessions) + remove_closed(play_sessions);
    settings.metrics->open.Set(static_cast<double>(open));
}

// Counts a connection that was refused or closed for this reason.
void HttpServer::Impl::count_refused(ConnectionRefusal why) {
    if (settings.metrics) settings.metrics->refused(why).Increment();
}

void HttpServer::Impl::abort_all() {
    // Cancelling does not affect a timer whose handler is already queued; handlers check this flag
    // before they restart the timer.
    stopping = true;
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

// If memory runs out while a request or a message is read, only its session ends.
void HttpServer::Impl::run() {
    for (;;) {
        try {
            io.run();
            return;
        } catch (const std::exception& error) {
            log_error("http: a connection failed: {}", error.what());
        }
    }
}

HttpServer::HttpServer(PlayContext& context, const HttpHandler& routes, HttpServerSettings settings)
    : impl_(std::make_unique<Impl>(context, routes, std::move(settings))) {}

HttpServer::~HttpServer() {
    stop();
}

Status HttpServer::start() {
    if (Status s = impl_->listen(); !s.ok()) return s;
    impl_->accept();
    impl_->schedule_housekeeping();
    ASSERT(!impl_->thread.joinable());
    impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
    return {};
}

std::uint16_t HttpServer::port() const {
    return impl_->bound_port;
}

void HttpServer::wake() {
    if (!impl_->has_players || impl_->awake.exchange(true)) return;
    asio::post(impl_->io, [impl = impl_.get()] {
        // before processing: a frame that arrives meanwhile wakes the thread again
        impl->awake = false;
        impl->advance_all();
    });
}

// Sockets are closed on their own thread. Their pending operations end with an error and release
// the sessions, so that the io_context runs out of work and its thread ends.
void HttpServer::stop() {
    if (!impl_->thread.joinable()) return;
    impl_->query_pool.stop();
    impl_->mutation_pool.stop();
    asio::post(impl_->io, [impl = impl_.get()] { impl->abort_all(); });
    impl_->thread.join();
}

}  // namespace jostle::server

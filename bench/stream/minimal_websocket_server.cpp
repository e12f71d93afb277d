// SPDX-License-Identifier: MIT
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <list>
#include <memory>

#include "bench/stream/minimal_server.h"

namespace jostle::bench {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;
using ServerClock = std::chrono::steady_clock;
using SharedMessage = std::shared_ptr<const MinimalServerMessage>;

// The pending read keeps the session alive.
class MinimalWebSocketSession : public std::enable_shared_from_this<MinimalWebSocketSession> {
public:
    explicit MinimalWebSocketSession(tcp::socket socket) : socket_(std::move(socket)) {
        beast::error_code ignored;
        socket_.next_layer().set_option(tcp::no_delay(true), ignored);
        socket_.binary(true);
        socket_.auto_fragment(false);
    }

    void start() {
        socket_.async_accept([self = shared_from_this()](beast::error_code error) {
            if (error) return;
            self->open_ = true;
            self->read();
        });
    }

    void write(const SharedMessage& message) {
        if (!open_ || writing_) return;
        writing_ = true;
        outgoing_ = message;
        const std::array<asio::const_buffer, 2> pieces{asio::buffer(message->head),
                                                       asio::buffer(message->shared)};
        socket_.async_write(pieces,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                                self->writing_ = false;
                                if (error) self->open_ = false;
                            });
    }

private:
    // Acks are read and ignored.
    void read() {
        socket_.async_read(incoming_,
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                               self->open_ = !error;
                               self->incoming_.clear();
                               if (!error) self->read();
                           });
    }

    beast::websocket::stream<tcp::socket> socket_;
    beast::flat_buffer incoming_;
    SharedMessage outgoing_;
    bool open_ = false, writing_ = false;
};

class MinimalWebSocketServer {
public:
    explicit MinimalWebSocketServer(const MinimalServerOptions& options)
        : options_(options),
          period_(std::chrono::duration_cast<ServerClock::duration>(
              std::chrono::duration<double>(1 / options.hz))) {}

    Status listen() {
        beast::error_code error;
        const tcp::endpoint any(asio::ip::address_v4::loopback(), 0);
        acceptor_.open(any.protocol(), error);
        if (!error) acceptor_.bind(any, error);
        if (!error) acceptor_.listen(1024, error);
        if (error) return Error{ErrorCode::unavailable, "cannot listen: " + error.message()};
        accept();
        return write_port_file(options_.port_file, acceptor_.local_endpoint().port());
    }

    void run(const std::atomic<bool>& stop) {
        next_ = ServerClock::now();
        tick(stop);
        context_.run();
    }

private:
    void accept() {
        acceptor_.async_accept([this](beast::error_code error, tcp::socket socket) {
            if (error) return;
            const auto client = std::make_shared<MinimalWebSocketSession>(std::move(socket));
            clients_.push_back(client);
            client->start();
            accept();
        });
    }

    void tick(const std::atomic<bool>& stop) {
        if (stop) return context_.stop();
        next_ += period_;
        timer_.expires_at(next_);
        timer_.async_wait([this, &stop](beast::error_code) {
            write_to_all();
            tick(stop);
        });
    }

    void write_to_all() {
        const auto message = std::make_shared<const MinimalServerMessage>(
            make_minimal_server_message(options_.bytes, ++frame_));
        for (auto client = clients_.begin(); client != clients_.end();) {
            if (const auto socket = client->lock()) {
                socket->write(message);
                ++client;
            } else {
                client = clients_.erase(client);
            }
        }
    }

    const MinimalServerOptions& options_;
    const ServerClock::duration period_;
    asio::io_context context_{1};
    tcp::acceptor acceptor_{context_};
    asio::steady_timer timer_{context_};
    ServerClock::time_point next_{};
    std::list<std::weak_ptr<MinimalWebSocketSession>> clients_;
    std::uint32_t frame_ = 0;
};

}  // namespace

Status serve_minimal_websocket(const MinimalServerOptions& options, const std::atomic<bool>& stop) {
    MinimalWebSocketServer floor(options);
    if (Status listening = floor.listen(); !listening.ok()) return listening;
    floor.run(stop);
    return {};
}

}  // namespace jostle::bench

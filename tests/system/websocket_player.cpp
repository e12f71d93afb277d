// SPDX-License-Identifier: MIT
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <thread>

#include "tests/system/player.h"

namespace jostle::test {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;

class WebSocketPlayer final : public Player {
public:
    WebSocketPlayer(int port, const std::string& origin) {
        beast::error_code error;
        socket_.next_layer().connect(
            {asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)}, error);
        socket_.set_option(beast::websocket::stream_base::decorator(
            [origin](beast::websocket::request_type& request) {
                if (!origin.empty()) request.set(beast::http::field::origin, origin);
            }));
        if (!error) socket_.handshake("127.0.0.1:" + std::to_string(port), "/play", error);
        if (error) {
            ended("handshake: " + error.message());
            return;
        }
        socket_.binary(true);
        socket_.read_message_max(0);
        read();
        thread_ = std::thread([this] { io_.run(); });
    }
    ~WebSocketPlayer() override {
        io_.stop();
        if (thread_.joinable()) thread_.join();
    }

    void send(const v1::ClientMessage& message) override {
        asio::post(io_, [this, bytes = message.SerializeAsString()] {
            outgoing_.push_back(bytes);
            if (outgoing_.size() == 1) write();
        });
    }
    void stall() override { stalled_ = true; }

private:
    void read() {
        socket_.async_read(incoming_, [this](beast::error_code error, std::size_t) {
            if (error) {
                const unsigned code = socket_.reason().code;
                return ended(code != 0 ? std::to_string(code) : error.message());
            }
            v1::ServerMessage message;
            const asio::const_buffer bytes = incoming_.cdata();
            message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
            incoming_.consume(bytes.size());
            take(message);
            if (!stalled_) read();
        });
    }
    void write() {
        socket_.async_write(asio::buffer(outgoing_.front()),
                            [this](beast::error_code error, std::size_t) {
                                if (error) return;
                                outgoing_.pop_front();
                                if (!outgoing_.empty()) write();
                            });
    }

    asio::io_context io_{1};
    beast::websocket::stream<tcp::socket> socket_{io_};
    beast::flat_buffer incoming_;
    std::deque<std::string> outgoing_;
    std::atomic<bool> stalled_{false};
    std::thread thread_;
};

}  // namespace

std::unique_ptr<Player> websocket_player(int port, const std::string& origin) {
    return std::make_unique<WebSocketPlayer>(port, origin);
}

}  // namespace jostle::test

// SPDX-License-Identifier: MIT
//
// One accepted socket, with TLS or without: what HTTP and WebSocket sessions read from and write
// to. Moves from one session to the other. Lives on the gateway's thread.
#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace jostle::server {

class SocketStream {
public:
    using executor_type = boost::beast::tcp_stream::executor_type;
    using Tls = boost::asio::ssl::stream<boost::beast::tcp_stream&>;

    // Null `tls`: without. The context lives as long as the stream.
    SocketStream(boost::asio::ip::tcp::socket socket,
                 std::shared_ptr<boost::asio::ssl::context> tls);

    executor_type get_executor() { return tcp_->get_executor(); }
    // Has the timeouts of both.
    boost::beast::tcp_stream& tcp() { return *tcp_; }
    // Beast's name for it: where it looks for what to close.
    using next_layer_type = boost::beast::tcp_stream;
    next_layer_type& next_layer() { return *tcp_; }
    const next_layer_type& next_layer() const { return *tcp_; }
    Tls* tls() { return tls_.get(); }
    // Subject of the client's certificate that TLS has verified; empty: it showed none.
    std::string certificate() const;

    template <class Handler>
    void async_handshake(Handler handler) {
        if (tls_) return tls_->async_handshake(Tls::server, std::move(handler));
        handler(boost::beast::error_code{});
    }
    template <class Buffers, class Handler>
    void async_read_some(const Buffers& buffers, Handler&& handler) {
        read_some(Pieces<boost::asio::mutable_buffer>(buffers),
                  shared(std::forward<Handler>(handler)));
    }
    template <class Buffers, class Handler>
    void async_write_some(const Buffers& buffers, Handler&& handler) {
        write_some(Pieces<boost::asio::const_buffer>(buffers),
                   shared(std::forward<Handler>(handler)));
    }
    template <class Handler>
    void async_teardown(boost::beast::role_type role, Handler&& handler) {
        end(role, [kept = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                      boost::beast::error_code error) { std::move (*kept)(error); });
    }

private:
    // Beast has a type for each kind of buffers and each handler. Here they become one of each:
    // else TLS and TCP are compiled anew for every pair of them.
    using Done = std::function<void(boost::beast::error_code, std::size_t)>;
    // The first few that are not empty: the others are for the next call.
    template <class Buffer>
    class Pieces {
    public:
        template <class Buffers>
        explicit Pieces(const Buffers& buffers) {
            const auto last = boost::asio::buffer_sequence_end(buffers);
            for (auto it = boost::asio::buffer_sequence_begin(buffers); it != last; ++it) {
                const Buffer piece = *it;
                if (count_ < pieces_.size() && piece.size() > 0) pieces_[count_++] = piece;
            }
        }
        const Buffer* begin() const { return pieces_.data(); }
        const Buffer* end() const { return pieces_.data() + count_; }

    private:
        std::array<Buffer, 8> pieces_;
        std::size_t count_ = 0;
    };
    template <class Handler>
    static Done shared(Handler&& handler) {
        return [kept = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                   boost::beast::error_code error, std::size_t bytes) {
            std::move (*kept)(error, bytes);
        };
    }
    void read_some(const Pieces<boost::asio::mutable_buffer>& pieces, Done done);
    void write_some(const Pieces<boost::asio::const_buffer>& pieces, Done done);
    void end(boost::beast::role_type role, std::function<void(boost::beast::error_code)> done);

    std::shared_ptr<boost::asio::ssl::context> context_;
    std::unique_ptr<boost::beast::tcp_stream> tcp_;
    std::unique_ptr<Tls> tls_;
};

// What Beast calls when a WebSocket ends.
void teardown(boost::beast::role_type role, SocketStream& stream, boost::beast::error_code& error);
template <class Handler>
void async_teardown(boost::beast::role_type role, SocketStream& stream, Handler&& handler) {
    stream.async_teardown(role, std::forward<Handler>(handler));
}

}  // namespace jostle::server

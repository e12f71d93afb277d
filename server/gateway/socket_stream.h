// SPDX-License-Identifier: MIT
//
// One accepted socket, with TLS or without: what HTTP and WebSocket sessions read from and write
// to. Moves from one session to the other. Lives on the gateway's thread.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <memory>
#include <string>
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
    template <class Buffers, class Token>
    auto async_read_some(const Buffers& buffers, Token&& token) {
        if (tls_) return tls_->async_read_some(buffers, std::forward<Token>(token));
        return tcp_->async_read_some(buffers, std::forward<Token>(token));
    }
    template <class Buffers, class Token>
    auto async_write_some(const Buffers& buffers, Token&& token) {
        if (tls_) return tls_->async_write_some(buffers, std::forward<Token>(token));
        return tcp_->async_write_some(buffers, std::forward<Token>(token));
    }

private:
    std::shared_ptr<boost::asio::ssl::context> context_;
    std::unique_ptr<boost::beast::tcp_stream> tcp_;
    std::unique_ptr<Tls> tls_;
};

// What Beast calls when a WebSocket ends.
void teardown(boost::beast::role_type role, SocketStream& stream, boost::beast::error_code& error);
template <class Handler>
void async_teardown(boost::beast::role_type role, SocketStream& stream, Handler&& handler) {
    using boost::beast::websocket::async_teardown;
    if (stream.tls()) return async_teardown(role, *stream.tls(), std::forward<Handler>(handler));
    async_teardown(role, stream.tcp().socket(), std::forward<Handler>(handler));
}

}  // namespace jostle::server

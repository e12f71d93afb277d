// SPDX-License-Identifier: MIT
//
// An accepted socket with or without TLS, used by HTTP and WebSocket sessions. Can be moved from
// one session to another. Runs on the server's thread.
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

// The client of a connection, as its proxy may have named it.
struct SocketPeer {
    std::string name;     // for the log: "192.0.2.7:4711", "192.0.2.7 via 10.0.0.1:4711"
    std::string address;  // "192.0.2.7"
};

class SocketStream {
public:
    using executor_type = boost::beast::tcp_stream::executor_type;
    using Tls = boost::asio::ssl::stream<boost::beast::tcp_stream&>;

    // Null `tls`: plain TCP. The stream shares ownership of the context.
    SocketStream(boost::asio::ip::tcp::socket socket,
                 std::shared_ptr<boost::asio::ssl::context> tls);

    executor_type get_executor() { return tcp_->get_executor(); }
    // Holds the timeouts of both cases.
    boost::beast::tcp_stream& tcp() { return *tcp_; }
    // Beast uses this name to find the layer to close.
    using next_layer_type = boost::beast::tcp_stream;
    next_layer_type& next_layer() { return *tcp_; }
    const next_layer_type& next_layer() const { return *tcp_; }
    Tls* tls() { return tls_.get(); }
    // Subject of the client certificate that TLS verified; empty: none.
    std::string certificate() const;

    // Only with TLS. `received`: the first bytes of the client, which were read from tcp().
    template <class Handler>
    void async_handshake(boost::asio::const_buffer received, Handler handler) {
        tls_->async_handshake(
            Tls::server, received,
            [handler = std::move(handler)](boost::beast::error_code error, std::size_t) mutable {
                handler(error);
            });
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
        end(role, [shared_handler =
                       std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                      boost::beast::error_code error) { std::move (*shared_handler)(error); });
    }

private:
    // Beast instantiates its code for each buffer type and handler type. These wrappers erase the
    // types; otherwise TLS and TCP would be compiled again for every combination.
    using Done = std::function<void(boost::beast::error_code, std::size_t)>;
    // The first non-empty buffers; the rest is left to the next call.
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
        return [shared_handler =
                    std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                   boost::beast::error_code error, std::size_t bytes) {
            std::move (*shared_handler)(error, bytes);
        };
    }
    void read_some(const Pieces<boost::asio::mutable_buffer>& pieces, Done done);
    void write_some(const Pieces<boost::asio::const_buffer>& pieces, Done done);
    void end(boost::beast::role_type role, std::function<void(boost::beast::error_code)> done);

    std::shared_ptr<boost::asio::ssl::context> context_;
    std::unique_ptr<boost::beast::tcp_stream> tcp_;
    std::unique_ptr<Tls> tls_;
};

// Called by Beast when a WebSocket ends.
void teardown(boost::beast::role_type role, SocketStream& stream, boost::beast::error_code& error);
template <class Handler>
void async_teardown(boost::beast::role_type role, SocketStream& stream, Handler&& handler) {
    stream.async_teardown(role, std::forward<Handler>(handler));
}

}  // namespace jostle::server

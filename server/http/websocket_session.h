// SPDX-License-Identifier: MIT
//
// Runs one browser socket as a ClientSession: each binary message is a ClientMessage or a
// ServerMessage. Runs on the server's thread; owned by its pending operations.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "jostle/base/result.h"
#include "server/http/socket_stream.h"
#include "server/session/client_session.h"

namespace jostle::server {

class WebSocketSession : public std::enable_shared_from_this<WebSocketSession> {
public:
    using Request = boost::beast::http::request<boost::beast::http::string_body>;

    // `overload`: of the server's thread; outlives the session.
    WebSocketSession(PlayContext& context, OverloadControl& overload, SocketStream stream,
                     SocketPeer peer, std::size_t message_bytes_max);

    // Responds to the upgrade and starts the session.
    void start(const Request& upgrade);
    // Starts the next write if none is in flight and a message is available, or closes the socket.
    void advance(Clock::time_point now);
    // Closes the socket at once: the server stops, or the client does not complete the close.
    void abort();
    const std::string& address() const { return peer_.address; }

private:
    void on_accepted(boost::beast::error_code error);
    void read();
    void on_read(boost::beast::error_code error);
    void on_wrote(boost::beast::error_code error);
    void write();
    void close(const Status& end, Clock::time_point now);
    void release_stream(int turns);

    PlayContext& context_;
    OverloadControl& overload_;
    // Empty some turns of the event loop after abort(). In Beast 1.74 a close and a failing read
    // can wait for each other forever; destroying the stream releases the operations that hold this
    // session. Operations of the TCP socket refer to the stream, so they must complete before.
    std::optional<boost::beast::websocket::stream<SocketStream>> socket_;
    const SocketPeer peer_;
    std::optional<ClientSession> session_;
    boost::beast::flat_buffer incoming_;
    OutMessage outgoing_;
    bool writing_ = false, aborted_ = false;
    std::optional<Clock::time_point> closing_since_;
};

}  // namespace jostle::server

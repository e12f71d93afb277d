// SPDX-License-Identifier: MIT
//
// One browser socket as a ClientSession: each binary message is a ClientMessage or a ServerMessage.
// Lives on the gateway's thread; kept alive by the operations it has in flight.
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

    WebSocketSession(PlayContext& context, SocketStream stream, std::size_t message_bytes_max);

    // Answers the upgrade and begins the conversation.
    void start(const Request& upgrade);
    // Starts the next write when none is in flight and there is something to say, or closes the
    // socket.
    void advance(Clock::time_point now);
    // Closes the socket at once: the gateway stops, or the client does not let us go.
    void abort();
    // We did not listen for so long.
    const std::string& address() const { return address_; }

private:
    void on_accepted(boost::beast::error_code error);
    void read();
    void on_read(boost::beast::error_code error);
    void on_wrote(boost::beast::error_code error);
    void write();
    void close(const Status& end, Clock::time_point now);

    PlayContext& context_;
    // Nothing: given up. Beast (1.74) can tie a close and a read that fails to each other for ever;
    // what waits inside of the stream holds the session, and goes with it.
    std::optional<boost::beast::websocket::stream<SocketStream>> socket_;
    std::string peer_, address_;
    std::optional<ClientSession> session_;
    boost::beast::flat_buffer incoming_;
    OutMessage outgoing_;
    bool writing_ = false;
    std::optional<Clock::time_point> closing_since_;
};

}  // namespace jostle::server

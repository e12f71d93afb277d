// SPDX-License-Identifier: MIT
#include "server/http/websocket_session.h"

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <string_view>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "server/http/beast_request.h"
#include "server/util/socket.h"
#include "server/util/text.h"

namespace jostle::server {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::asio::const_buffer;

namespace {

constexpr auto closing_timeout = std::chrono::seconds(5);
// Beast has one timeout for both handshakes. It is longer than ours of the closing handshake, so
// that abort() comes first: in Beast 1.74 a read that waits for the closing handshake can receive
// the timeout, which an assertion of Beast forbids.
constexpr auto handshake_timeout = 2 * closing_timeout;
constexpr auto last_write_timeout = std::chrono::seconds(1);
// Turns of the event loop in which cancelled operations complete. Each needs one or two.
constexpr int release_turns = 4;

websocket::close_code close_code_of(ErrorCode code) {
    switch (code) {
        case ErrorCode::unavailable:
            return websocket::close_code::service_restart;
        case ErrorCode::resource_exhausted:
            return websocket::close_code::try_again_later;
        case ErrorCode::internal:
            return websocket::close_code::internal_error;
        case ErrorCode::aborted:
            return websocket::close_code::going_away;
        default:
            return websocket::close_code::policy_error;
    }
}

// The reason in a close frame is limited to 123 bytes.
websocket::close_reason reason_of(const Status& end) {
    if (end.ok()) return websocket::close_code::normal;
    const std::string_view reason = clip_utf8(end.error().message, 120);
    return {close_code_of(end.error().code), boost::string_view(reason.data(), reason.size())};
}

}  // namespace

WebSocketSession::WebSocketSession(PlayContext& context, OverloadControl& overload,
                                   SocketStream stream, SocketPeer peer,
                                   std::size_t message_bytes_max)
    : context_(context), overload_(overload), peer_(std::move(peer)) {
    socket_.emplace(std::move(stream));
    boost::beast::tcp_stream& tcp = socket_->next_layer().tcp();
    tcp.expires_never();  // from here on the WebSocket layer and the session handle timeouts
    set_tcp_user_timeout(tcp.socket().native_handle(),
                         from_seconds(context_.config.stream.client_timeout_seconds));
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = handshake_timeout;
    // the session has its own, shorter timeout
    timeout.idle_timeout = websocket::stream_base::none();
    timeout.keep_alive_pings = false;
    socket_->set_option(timeout);
    set_limits(*socket_, message_bytes_max);
    // A snapshot is one frame whose pieces are sent without copying.
    socket_->auto_fragment(false);
}

void WebSocketSession::start(const Request& upgrade) {
    socket_->async_accept(upgrade, [self = shared_from_this()](beast::error_code error) {
        self->on_accepted(error);
    });
}

void WebSocketSession::on_accepted(beast::error_code error) {
    if (error || aborted_) return;  // the socket closes with the last reference to this session
    ASSERT(!session_);
    session_.emplace(
        context_,
        Peer{.name = "ws:" + peer_.name,
             .address = peer_.address,
             .call = "GET /play",
             .who = context_.authorizer.identify(
                 {.certificate = socket_->next_layer().certificate(), .address = peer_.address}),
             .overload = &overload_},
        Clock::now());
    read();
}

void WebSocketSession::read() {
    socket_->async_read(incoming_,
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                            self->on_read(error);
                        });
}

void WebSocketSession::on_read(beast::error_code error) {
    if (aborted_) return;
    const Clock::time_point now = Clock::now();
    if (error == websocket::error::message_too_big) {
        session_->refuse(Error{ErrorCode::resource_exhausted, "the message is too large"}, now);
    } else if (error) {
        session_->on_peer_closed(now);
    } else if (socket_->got_text()) {
        session_->refuse(Error{ErrorCode::invalid_argument, "messages must be binary, not text"},
                         now);
    } else {
        const const_buffer bytes = incoming_.cdata();
        session_->receive({static_cast<const char*>(bytes.data()), bytes.size()}, now);
        incoming_.consume(bytes.size());
        // Reading continues after the session ended, to receive the peer's close frame.
        read();
    }
    advance(now);
}

void WebSocketSession::on_wrote(beast::error_code error) {
    if (aborted_) return;
    const Clock::time_point now = Clock::now();
    writing_ = false;
    if (error) session_->on_peer_closed(now);
    advance(now);
}

void WebSocketSession::advance(Clock::time_point now) {
    if (!session_ || aborted_) return;
    if (closing_since_) {
        if (now >= *closing_since_ + closing_timeout) abort();
        return;
    }
    if (writing_) {
        session_->wait_for_write(now);
        // A client that no longer reads would block its last write, and with it the socket,
        // forever.
        if (session_->end() && now >= session_->end_time() + last_write_timeout) abort();
        return;
    }
    if (std::optional<OutMessage> message = session_->take_message(now)) {
        outgoing_ = std::move(*message);
        writing_ = true;
        write();
        return;
    }
    if (const std::optional<Status>& end = session_->end()) close(*end, now);
}

void WebSocketSession::write() {
    ASSERT(writing_);
    const auto wrote = [self = shared_from_this()](beast::error_code error, std::size_t) {
        self->on_wrote(error);
    };
    std::array<const_buffer, 2> pieces{boost::asio::buffer(outgoing_.header), const_buffer{}};
    if (outgoing_.shared) pieces[1] = boost::asio::buffer(*outgoing_.shared);
    if (outgoing_.shared_fields.empty()) return socket_->async_write(pieces, wrote);
    std::vector<const_buffer> all(pieces.begin(), pieces.end());
    for (const SharedBytes& field : outgoing_.shared_fields)
        all.push_back(boost::asio::buffer(*field));
    socket_->async_write(all, wrote);
}

void WebSocketSession::close(const Status& end, Clock::time_point now) {
    ASSERT(!closing_since_ && !writing_);
    closing_since_ = now;
    socket_->async_close(reason_of(end), [self = shared_from_this()](beast::error_code) {});
}

void WebSocketSession::abort() {
    if (std::exchange(aborted_, true)) return;
    // Cancels the operations of the TCP socket, which complete in the next turns.
    socket_->next_layer().tcp().close();
    release_stream(release_turns);
}

void WebSocketSession::release_stream(int turns) {
    if (turns == 0) return socket_.reset();
    boost::asio::post(socket_->get_executor(),
                      [self = shared_from_this(), turns] { self->release_stream(turns - 1); });
}

}  // namespace jostle::server

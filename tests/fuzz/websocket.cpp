// SPDX-License-Identifier: MIT
//
// The bytes of a WebSocket connection: the upgrade's head, then frames, read as the gateway reads
// them. Each message fits into the bound.
#include <boost/asio/io_context.hpp>
#include <boost/beast/_experimental/test/stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "server/http/beast_request.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    namespace beast = boost::beast;
    constexpr std::size_t message_bytes_max = 512;
    static boost::asio::io_context io;
    beast::test::stream ours(io), theirs(io);
    ours.connect(theirs);
    ours.append({reinterpret_cast<const char*>(input.data()), input.size()});
    theirs.close();  // after these bytes there are no more

    beast::error_code error;
    beast::flat_buffer buffer;
    server::BeastRequestParser parser;
    server::set_limits(parser, server::HttpServerSettings{});
    beast::http::read(ours, buffer, parser, error);
    if (error || !beast::websocket::is_upgrade(parser.get())) return;

    // The frames came with the head, and its reader took them along.
    beast::websocket::stream<beast::test::stream> socket(std::move(ours));
    server::set_limits(socket, message_bytes_max);
    socket.next_layer().append({static_cast<const char*>(buffer.data().data()), buffer.size()});
    socket.accept(parser.release(), error);
    if (error) return;
    for (beast::flat_buffer message; !error; message.clear()) {
        socket.read(message, error);
        expect(message.size() <= message_bytes_max, "a message is within its bound");
        static_cast<void>(socket.got_text());
    }
}

}  // namespace jostle::fuzz

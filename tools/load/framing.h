// SPDX-License-Identifier: MIT
//
// The client side of a play stream without its socket: converts received bytes to messages, and
// messages to bytes to send. One implementation per transport: HTTP/2 with gRPC framing, WebSocket,
// raw. Written for a load generator, which must cost far less than the measured server: a complete
// message is processed in place. Bytes are untrusted, and all buffers are bounded. One thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "tools/load/proto_field_reader.h"

namespace jostle::load {

// Limit for a message of any transport.
inline constexpr std::size_t message_bytes_max = std::size_t{64} << 20;
// Limit for queued responses that the server does not read.
inline constexpr std::size_t outgoing_bytes_max = std::size_t{4} << 20;

class Framing {
public:
    // Receives messages; the bytes are valid only during the call.
    class Reader {
    public:
        virtual void on_message(Bytes message) = 0;

    protected:
        ~Reader() = default;
    };

    virtual ~Framing() = default;
    // Takes the next received bytes, split anywhere. An error ends the stream and contains the
    // reason.
    virtual Status take(Bytes bytes, Reader& reader) = 0;
    virtual void send(std::string_view message) = 0;
    // The reader has processed a message: the server may send that number of bytes again.
    virtual void consume(std::size_t message_bytes) = 0;

    // Bytes to write to the socket.
    std::string& outgoing() { return out_; }

protected:
    std::string out_;
};

// Messages with a four-byte little-endian length prefix: the minimum for a stream over TCP. Only
// benchmark servers use it, as a lower bound for the other transports.
class RawFraming : public Framing {
public:
    Status take(Bytes bytes, Reader& reader) override;
    void send(std::string_view message) override;
    void consume(std::size_t) override {}

private:
    std::string partial_;  // of an incomplete message
};

}  // namespace jostle::load

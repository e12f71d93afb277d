// SPDX-License-Identifier: MIT
//
// The client's side of a play stream without its socket: bytes that arrived become messages, and
// messages become bytes to send. One for each transport: HTTP/2 with gRPC's messages, WebSocket.
// Written for a load generator, which is to cost far less than the server that it measures: a
// message that arrived whole is looked at where it lies. Bytes are foreign, and everything that is
// kept of them is bounded. One thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "tools/load/proto_field_reader.h"

namespace jostle::load {

// Of one message; whatever transport has it, no larger one is taken.
inline constexpr std::size_t message_bytes_max = std::size_t{64} << 20;
// Answers that a server makes us write and does not read.
inline constexpr std::size_t outgoing_bytes_max = std::size_t{4} << 20;

class Framing {
public:
    // Whom messages are handed to; the bytes are gone when it returns.
    class Reader {
    public:
        virtual void on_message(Bytes message) = 0;

    protected:
        ~Reader() = default;
    };

    virtual ~Framing() = default;
    // What came next, cut anywhere. An error: the stream is over, and why.
    virtual Status take(Bytes bytes, Reader& reader) = 0;
    virtual void send(std::string_view message) = 0;
    // The reader is done with a message of so many bytes: the server may send as many more.
    virtual void consume(std::size_t message_bytes) = 0;

    // To be written to the socket, from its front.
    std::string& outgoing() { return out_; }

protected:
    std::string out_;
};

}  // namespace jostle::load

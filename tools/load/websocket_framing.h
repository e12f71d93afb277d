// SPDX-License-Identifier: MIT
//
// One play stream over a WebSocket, by hand: RFC 6455. The key of every mask is 0, so that what is
// sent is masked as it lies; masks guard proxies against scripts of strangers, and a load generator
// has neither.
#pragma once

#include "tools/load/framing.h"

namespace jostle::load {

class WebSocketFraming : public Framing {
public:
    // The upgrade of /play waits to be sent. `authority`: HOST:PORT.
    explicit WebSocketFraming(const std::string& authority);

    Status take(Bytes bytes, Reader& reader) override;
    void send(std::string_view message) override;
    void consume(std::size_t) override {
    }  // TCP holds the server back, when its reader does not read

private:
    struct Head {
        std::size_t size = 0;  // of the head itself
        std::uint64_t payload = 0;
        std::uint8_t opcode = 0;
        bool final = false;
    };

    static Result<Head> read_head(Bytes bytes);  // size 0: it is not complete
    static void put_frame(std::string& out, std::uint8_t opcode, std::string_view payload);
    Result<std::size_t> take_response(Bytes bytes);
    Result<std::size_t> take_frames(Bytes bytes, Reader& reader);
    Status on_frame(const Head& head, Bytes payload, Reader& reader);

    bool open_ = false;
    std::string pending_until_open_;  // to be sent when the server has answered
    std::string partial_;             // of a frame that is not complete
    std::string message_;             // of one in several frames
    bool continues_ = false;
};

}  // namespace jostle::load

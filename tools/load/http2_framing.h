// SPDX-License-Identifier: MIT
//
// One gRPC call over HTTP/2, by hand: RFC 9113 for the frames, RFC 7541 for the request's header
// block, which is written with literals only. What the server's header blocks say is not decoded: a
// play stream tells by a Notice why it ends.
#pragma once

#include <deque>

#include "tools/load/framing.h"

namespace jostle::load {

struct Http2Request {
    std::string authority;  // HOST:PORT
    std::string token;      // shown as "Bearer ..."; empty: none
    // How much the server may send before used() says that it may send more. The usual window is
    // that of clients that did not ask for another.
    std::uint32_t window = default_window;

    static constexpr std::uint32_t default_window = 65'535, window_max = 0x7fff'ffff;
};

class Http2Framing : public Framing {
public:
    // The connection's preface and the beginning of the call wait to be sent.
    explicit Http2Framing(const Http2Request& request);

    Status take(Bytes bytes, Reader& reader) override;
    void send(std::string_view message) override;
    void consume(std::size_t message_bytes) override;

private:
    struct Head {
        std::uint32_t length = 0, stream = 0;
        std::uint8_t type = 0, flags = 0;
    };

    void put_head(std::uint32_t length, std::uint8_t type, std::uint8_t flags,
                  std::uint32_t stream);
    void put_window_update(std::uint32_t stream, std::uint32_t increment);
    void replenish_window(std::size_t bytes);
    void send_waiting();

    // The frames that are complete; how many bytes they were.
    Result<std::size_t> take_frames(Bytes bytes, Reader& reader);
    Status on_frame(const Head& head, Bytes payload, Reader& reader);
    Status on_data(const Head& head, Bytes payload, Reader& reader);
    Status on_messages(Bytes bytes, Reader& reader);
    Status on_piece(Reader& reader);
    Bytes partial_message() const;
    bool is_large(std::size_t size) const;
    Status on_headers(const Head& head);
    Status on_settings(const Head& head, Bytes payload);
    Status on_window_update(const Head& head, Bytes payload);

    const std::uint32_t window_;
    std::string partial_;                 // of a frame that is not complete
    std::string message_;                 // likewise
    std::size_t replenished_bytes_ = 0;   // of message_, when it is large
    std::int64_t unused_ = 0;             // bytes of our window that are taken
    std::uint32_t unreported_bytes_ = 0;  // of these, what is used, and not told
    // What the server lets us send.
    std::int64_t connection_credit_ = Http2Request::default_window;
    std::int64_t stream_credit_ = Http2Request::default_window;
    std::uint32_t server_window_ = Http2Request::default_window;
    std::deque<std::string> waiting_;  // DATA for which there is no credit yet
    std::size_t waiting_bytes_ = 0;
    bool header_block_open_ = false, header_ends_stream_ = false;
};

}  // namespace jostle::load

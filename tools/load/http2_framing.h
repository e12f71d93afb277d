// SPDX-License-Identifier: MIT
//
// One gRPC call over HTTP/2: RFC 9113 for the frames, RFC 7541 for the header block of the request,
// which uses literals only. Header blocks of the server are not decoded: a play stream reports its
// end in a Notice.
#pragma once

#include <deque>

#include "jostle/http2/frame.h"
#include "tools/load/framing.h"

namespace jostle::load {

struct Http2Request {
    std::string authority;  // HOST:PORT
    std::string token;      // sent as "Bearer ..."; empty: none
    // Initial flow control window, bytes. The default is that of clients without a setting.
    std::uint32_t window = default_window;

    static constexpr std::uint32_t default_window = http2::default_window,
                                   window_max = http2::window_max;
};

class Http2Framing : public Framing {
public:
    // Queues the connection preface and the start of the call.
    explicit Http2Framing(const Http2Request& request);

    Status take(Bytes bytes, Reader& reader) override;
    void send(std::string_view message) override;
    void consume(std::size_t message_bytes) override;

private:
    using Head = http2::FrameHeader;

    void put_window_update(std::uint32_t stream, std::uint32_t increment);
    void replenish_window(std::size_t bytes);
    void send_waiting();

    // Processes complete frames and returns their size in bytes.
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
    std::string partial_;                 // of an incomplete frame
    std::string message_;                 // of an incomplete message
    std::size_t replenished_bytes_ = 0;   // of message_, if it is large
    std::int64_t unused_ = 0;             // received bytes not yet returned to the window
    std::uint32_t unreported_bytes_ = 0;  // of these, consumed bytes not yet reported
    // Send windows that the server grants.
    std::int64_t connection_credit_ = Http2Request::default_window;
    std::int64_t stream_credit_ = Http2Request::default_window;
    std::uint32_t server_window_ = Http2Request::default_window;
    std::deque<std::string> waiting_;  // DATA that exceeds the send window
    std::size_t waiting_bytes_ = 0;
    bool header_block_open_ = false, header_ends_stream_ = false;
};

}  // namespace jostle::load

// SPDX-License-Identifier: MIT
//
// Inspects the HTTP/2 frames of a client of the gRPC port before gRPC sees them. gRPC processes
// frames as fast as they arrive and retains the state they create, so floods that HTTP/2 allows
// exhaust its memory and time: streams that are reset right after opening (CVE-2023-44487), endless
// header blocks (CVE-2024-27316), SETTINGS, PING and empty DATA (CVE-2019-9512 to 9518). Frames
// that no client needs end the connection; frames that clients need are throttled beyond a generous
// rate.
//
// Nothing is decompressed, and frames are not changed. A value; one thread.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "jostle/base/result.h"
#include "jostle/http2/frame.h"
#include "server/util/token_bucket.h"

namespace jostle::server {

class Http2FrameGuard {
public:
    // `clients`: the number of clients whose frames share the connection; its rates grow with it.
    explicit Http2FrameGuard(Clock::time_point now, double clients = 1);

    // Inspects the next bytes of the connection, split anywhere. An error names the forbidden
    // frame; the caller must close the connection without passing these bytes to gRPC.
    Status take(std::span<const std::uint8_t> bytes, Clock::time_point now);

    // Whether the client has sent the HTTP/2 preface. Before that, gRPC is not involved.
    bool has_preface() const { return preface_bytes_ == http2::preface.size(); }
    // How long the client must not be read; zero: it may be read now.
    Clock::duration throttle_delay(Clock::time_point now) { return work_.wait_for(0, now); }

    std::uint64_t streams_opened() const { return streams_opened_; }

private:
    Status on_header(const http2::FrameHeader& head, Clock::time_point now);
    Status on_headers(const http2::FrameHeader& head);
    Status on_continuation(const http2::FrameHeader& head);
    Status allow(TokenBucket& bucket, const char* what, Clock::time_point now);

    std::size_t preface_bytes_ = 0, header_bytes_ = 0;
    std::array<std::uint8_t, http2::frame_header_bytes> header_{};
    std::uint32_t payload_left_ = 0;
    std::uint32_t last_stream_ = 0;
    std::uint32_t block_stream_ = 0;  // stream of the open header block; 0: none
    std::uint32_t block_bytes_ = 0, block_frames_ = 0;
    std::uint64_t streams_opened_ = 0;
    TokenBucket work_, resets_, settings_, pings_, empty_, unusual_;
};

}  // namespace jostle::server

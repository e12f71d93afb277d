// SPDX-License-Identifier: MIT
//
// Watches the HTTP/2 frames that a client of the gRPC port sends, before gRPC sees them. gRPC
// takes frames as fast as they come and keeps what they make it keep, so floods that HTTP/2 allows
// cost it all its memory and time: streams that are reset as soon as they are begun
// (CVE-2023-44487), header blocks that never end (CVE-2024-27316), SETTINGS, PING, empty DATA
// (CVE-2019-9512 to 9518). What no client needs ends the connection; of what clients need, more
// than a generous rate has to wait.
//
// RFC 9113, 4.1 for the frames' heads. Nothing is decompressed, and frames are not changed. A
// value; one thread.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "jostle/base/result.h"
#include "server/util/token_bucket.h"

namespace jostle::server {

class Http2FrameGuard {
public:
    explicit Http2FrameGuard(Clock::time_point now);

    // What came next, cut anywhere. An error says which frame no client may send; the connection is
    // to be cut before gRPC gets these bytes.
    Status take(std::span<const std::uint8_t> bytes, Clock::time_point now);

    // The client has introduced itself as one of HTTP/2: before, nothing concerns gRPC.
    bool has_preface() const { return preface_bytes_ == preface_size; }
    // Zero, or how long nothing more should be read from this client.
    Clock::duration throttle_delay(Clock::time_point now) { return work_.wait_for(0, now); }

    std::uint64_t streams_opened() const { return streams_opened_; }

private:
    struct FrameHeader {
        std::uint32_t length = 0, stream = 0;
        std::uint8_t type = 0, flags = 0;
    };

    static constexpr std::size_t preface_size = 24, header_size = 9;

    Status on_header(const FrameHeader& head, Clock::time_point now);
    Status on_headers(const FrameHeader& head);
    Status on_continuation(const FrameHeader& head);
    Status allow(TokenBucket& bucket, const char* what, Clock::time_point now);

    std::size_t preface_bytes_ = 0, header_bytes_ = 0;
    std::array<std::uint8_t, header_size> header_{};
    std::uint32_t payload_left_ = 0;
    std::uint32_t last_stream_ = 0;
    std::uint32_t block_stream_ = 0;  // whose header block goes on; 0: none does
    std::uint32_t block_bytes_ = 0, block_frames_ = 0;
    std::uint64_t streams_opened_ = 0;
    TokenBucket work_, resets_, settings_, pings_, empty_, unusual_;
};

}  // namespace jostle::server

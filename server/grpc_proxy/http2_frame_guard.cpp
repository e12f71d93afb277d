// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/http2_frame_guard.h"

#include <fmt/format.h>

#include <algorithm>

namespace jostle::server {

using http2::FrameHeader, http2::FrameType, http2::frame_bytes_max;

namespace {

// Compressed size of a header block. Clients send a few hundred bytes, or 2000 bytes with a token.
constexpr std::uint32_t block_bytes_max = 32 * 1024, block_frames_max = 8;

// Work is counted in small frames. A player sends about 200 frames per second (inputs, window
// updates and pings); a message of 4 MiB takes 260 frames.
constexpr double work_per_second = 4000, work_burst = 4000;
constexpr double work_of_stream = 4;  // opening a call costs more than a frame
constexpr double work_of_byte = 1.0 / 4096;
// Sustained rates and bursts. Clients measure their round-trip time with pings, some of them once
// per round trip.
constexpr double resets_per_second = 20, resets_burst = 100;
constexpr double settings_per_second = 1, settings_burst = 16;
constexpr double pings_per_second = 200, pings_burst = 400;
constexpr double empty_per_second = 10, empty_burst = 100;
constexpr double unusual_per_second = 10, unusual_burst = 100;

}  // namespace

Http2FrameGuard::Http2FrameGuard(Clock::time_point now, double clients)
    : work_(clients * work_per_second, clients * work_burst, now),
      resets_(clients * resets_per_second, clients * resets_burst, now),
      settings_(clients * settings_per_second, clients * settings_burst, now),
      pings_(clients * pings_per_second, clients * pings_burst, now),
      empty_(clients * empty_per_second, clients * empty_burst, now),
      unusual_(clients * unusual_per_second, clients * unusual_burst, now) {}

Status Http2FrameGuard::take(std::span<const std::uint8_t> bytes, Clock::time_point now) {
    work_.spend(static_cast<double>(bytes.size()) * work_of_byte, now);
    while (!bytes.empty()) {
        if (!has_preface()) {
            if (bytes[0] != static_cast<std::uint8_t>(http2::preface[preface_bytes_]))
                return Error{ErrorCode::invalid_argument, "this is not HTTP/2"};
            preface_bytes_++;
            bytes = bytes.subspan(1);
        } else if (payload_left_ > 0) {
            const std::size_t skipped = std::min<std::size_t>(payload_left_, bytes.size());
            payload_left_ -= static_cast<std::uint32_t>(skipped);
            bytes = bytes.subspan(skipped);
        } else {
            header_[header_bytes_++] = bytes[0];
            bytes = bytes.subspan(1);
            if (header_bytes_ < header_.size()) continue;
            header_bytes_ = 0;
            const FrameHeader head = http2::read_frame_header(header_);
            if (Status s = on_header(head, now); !s.ok()) return s;
            payload_left_ = head.length;
        }
    }
    return {};
}

Status Http2FrameGuard::on_header(const FrameHeader& head, Clock::time_point now) {
    work_.spend(1, now);
    if (head.length > frame_bytes_max)
        return Error{ErrorCode::invalid_argument,
                     fmt::format("a frame of {} bytes; at most {} are allowed", head.length,
                                 frame_bytes_max)};
    if (block_stream_ != 0) return on_continuation(head);
    switch (head.type) {
        case FrameType::data:
            if (head.length == 0 && !head.has(http2::flags::end_stream))
                return allow(empty_, "empty DATA", now);
            return {};
        case FrameType::headers:
            if (head.stream > last_stream_) work_.spend(work_of_stream, now);
            return on_headers(head);
        case FrameType::rst_stream:
            return allow(resets_, "RST_STREAM", now);
        case FrameType::settings:
            return allow(settings_, "SETTINGS", now);
        case FrameType::ping:
            return allow(pings_, "PING", now);
        case FrameType::window_update:
            return {};
        case FrameType::priority:
        case FrameType::goaway:
            return allow(unusual_, "PRIORITY or GOAWAY", now);
        case FrameType::push_promise:
        case FrameType::continuation:
            return Error{ErrorCode::invalid_argument,
                         "PUSH_PROMISE, or CONTINUATION without a header block"};
        default:
            return allow(unusual_, "unknown", now);
    }
}

Status Http2FrameGuard::on_headers(const FrameHeader& head) {
    if (head.stream > last_stream_) {
        streams_opened_++;
        last_stream_ = head.stream;
    }
    if (head.has(http2::flags::end_headers)) return {};
    block_stream_ = head.stream;
    block_bytes_ = head.length;
    block_frames_ = 1;
    return {};
}

Status Http2FrameGuard::on_continuation(const FrameHeader& head) {
    if (head.type != FrameType::continuation || head.stream != block_stream_)
        return Error{ErrorCode::invalid_argument, "a header block interrupted by other frames"};
    block_bytes_ += head.length;
    block_frames_++;
    if (block_bytes_ > block_bytes_max || block_frames_ > block_frames_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("a header block of more than {} bytes or {} frames",
                                 block_bytes_max, block_frames_max)};
    if (head.has(http2::flags::end_headers)) block_stream_ = 0;
    return {};
}

Status Http2FrameGuard::allow(TokenBucket& bucket, const char* what, Clock::time_point now) {
    if (bucket.take(1, now)) return {};
    return Error{ErrorCode::resource_exhausted, fmt::format("too many {} frames", what)};
}

}  // namespace jostle::server

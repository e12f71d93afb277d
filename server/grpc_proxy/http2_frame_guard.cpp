// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/http2_frame_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace jostle::server {

namespace {

constexpr std::string_view preface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";

// RFC 9113, section 6.
enum FrameType : std::uint8_t {
    data = 0,
    headers = 1,
    priority = 2,
    rst_stream = 3,
    settings = 4,
    push_promise = 5,
    ping = 6,
    goaway = 7,
    window_update = 8,
    continuation = 9,
};
constexpr std::uint8_t end_stream = 1, end_headers = 4;

constexpr std::uint32_t frame_bytes_max = 16384;  // the maximum that the server's settings allow
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

Http2FrameGuard::Http2FrameGuard(Clock::time_point now)
    : work_(work_per_second, work_burst, now),
      resets_(resets_per_second, resets_burst, now),
      settings_(settings_per_second, settings_burst, now),
      pings_(pings_per_second, pings_burst, now),
      empty_(empty_per_second, empty_burst, now),
      unusual_(unusual_per_second, unusual_burst, now) {}

Status Http2FrameGuard::take(std::span<const std::uint8_t> bytes, Clock::time_point now) {
    work_.spend(static_cast<double>(bytes.size()) * work_of_byte, now);
    while (!bytes.empty()) {
        if (!has_preface()) {
            if (bytes[0] != static_cast<std::uint8_t>(preface[preface_bytes_]))
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
            if (header_bytes_ < header_size) continue;
            header_bytes_ = 0;
            const auto big_endian = [&](std::size_t at, std::size_t count) {
                std::uint32_t value = 0;
                for (std::size_t i = at; i < at + count; i++) value = value << 8 | header_[i];
                return value;
            };
            const FrameHeader head{.length = big_endian(0, 3),
                                   .stream = big_endian(5, 4) & 0x7fff'ffff,
                                   .type = header_[3],
                                   .flags = header_[4]};
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
        case data:
            if (head.length == 0 && (head.flags & end_stream) == 0)
                return allow(empty_, "empty DATA", now);
            return {};
        case headers:
            if (head.stream > last_stream_) work_.spend(work_of_stream, now);
            return on_headers(head);
        case rst_stream:
            return allow(resets_, "RST_STREAM", now);
        case settings:
            return allow(settings_, "SETTINGS", now);
        case ping:
            return allow(pings_, "PING", now);
        case window_update:
            return {};
        case priority:
        case goaway:
            return allow(unusual_, "PRIORITY or GOAWAY", now);
        case push_promise:
        case continuation:
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
    if ((head.flags & end_headers) != 0) return {};
    block_stream_ = head.stream;
    block_bytes_ = head.length;
    block_frames_ = 1;
    return {};
}

Status Http2FrameGuard::on_continuation(const FrameHeader& head) {
    if (head.type != continuation || head.stream != block_stream_)
        return Error{ErrorCode::invalid_argument, "a header block interrupted by other frames"};
    block_bytes_ += head.length;
    block_frames_++;
    if (block_bytes_ > block_bytes_max || block_frames_ > block_frames_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("a header block of more than {} bytes or {} frames",
                                 block_bytes_max, block_frames_max)};
    if ((head.flags & end_headers) != 0) block_stream_ = 0;
    return {};
}

Status Http2FrameGuard::allow(TokenBucket& bucket, const char* what, Clock::time_point now) {
    if (bucket.take(1, now)) return {};
    return Error{ErrorCode::resource_exhausted, fmt::format("too many {} frames", what)};
}

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/http2_frame_guard.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view client_preface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";
enum Type : char { data, headers, priority, reset, settings, push, ping, goaway, window, more };
constexpr char end_headers = 4, end_stream = 1;

std::string frame(char type, char flags, std::uint32_t stream, std::size_t length) {
    std::string out;
    for (const int shift : {16, 8, 0}) out += static_cast<char>(length >> shift);
    out += type;
    out += flags;
    for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(stream >> shift);
    return out + std::string(length, 'x');
}

class Http2FrameGuardTest : public testing::Test {
protected:
    Status take(std::string_view bytes) {
        return guard.take({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, now);
    }
    // Sends `frames_per_second` frames for 10 s. Returns the error message; empty: no error.
    std::string flood(const std::string& frame_bytes, int frames_per_second) {
        for (int i = 0; i < 10 * frames_per_second; i++) {
            now += 1000000us / frames_per_second;
            if (const Status s = take(frame_bytes); !s.ok()) return s.error().message;
        }
        return {};
    }
    void greet() {
        ASSERT_TRUE(take(std::string(client_preface) + frame(settings, 0, 0, 36)).ok());
    }

    Clock::time_point now = Clock::now();
    Http2FrameGuard guard{now};
};

TEST_F(Http2FrameGuardTest, normal_play_is_never_throttled) {
    greet();
    ASSERT_TRUE(take(frame(headers, end_headers, 1, 300)).ok());
    // 60 times per second an input, a WINDOW_UPDATE frame and a ping response, split at arbitrary
    // positions.
    for (int tick = 0; tick < 60 * 3600; tick++) {
        now += 16667us;
        const std::string sent = frame(data, 0, 1, 40) + frame(window, 0, 0, 4) +
                                 frame(window, 0, 1, 4) + frame(ping, 1, 0, 8);
        const std::size_t cut = static_cast<std::size_t>(tick) % sent.size();
        ASSERT_TRUE(take(sent.substr(0, cut)).ok() && take(sent.substr(cut)).ok());
        ASSERT_EQ(guard.throttle_delay(now), Clock::duration::zero());
    }
    EXPECT_EQ(guard.streams_opened(), 1u);
}

TEST_F(Http2FrameGuardTest, accepts_a_4_mb_message) {
    greet();
    std::string sent = frame(headers, end_headers, 1, 300);
    for (int i = 0; i < 256; i++) sent += frame(data, 0, 1, 16384);
    ASSERT_TRUE(take(sent).ok());
    EXPECT_EQ(guard.throttle_delay(now), Clock::duration::zero());
}

TEST_F(Http2FrameGuardTest, rejects_invalid_preface_at_the_first_wrong_byte) {
    EXPECT_EQ(take("GET / HTTP/1.1\r\n").error().message, "this is not HTTP/2");
    Http2FrameGuard other(now);
    guard = other;
    EXPECT_TRUE(take(client_preface.substr(0, 23)).ok());
    EXPECT_FALSE(guard.has_preface());
    EXPECT_TRUE(take(client_preface.substr(23)).ok());
    EXPECT_TRUE(guard.has_preface());
}

// CVE-2023-44487.
TEST_F(Http2FrameGuardTest, rejects_rapid_stream_resets) {
    greet();
    int begun = 0;
    Status status;
    for (std::uint32_t stream = 1; status.ok(); stream += 2, begun++)
        status =
            take(frame(headers, end_headers | end_stream, stream, 60) + frame(reset, 0, stream, 4));
    EXPECT_EQ(status.error().message, "too many RST_STREAM frames");
    EXPECT_EQ(begun, 101);
}

TEST_F(Http2FrameGuardTest, allows_ten_cancelled_calls_per_second) {
    greet();
    for (std::uint32_t i = 0; i < 36000; i++) {
        now += 100ms;
        ASSERT_TRUE(
            take(frame(headers, end_headers, 2 * i + 1, 60) + frame(reset, 0, 2 * i + 1, 4)).ok());
    }
    EXPECT_EQ(guard.streams_opened(), 36000u);
}

// CVE-2024-27316.
TEST_F(Http2FrameGuardTest, limits_header_blocks_to_8_frames_and_32_kb) {
    greet();
    ASSERT_TRUE(take(frame(headers, 0, 1, 16000) + frame(more, 0, 1, 16000)).ok());
    EXPECT_FALSE(take(frame(more, 0, 1, 16000)).ok());
    guard = Http2FrameGuard(now);
    greet();
    std::string sent = frame(headers, 0, 1, 1);
    for (int i = 0; i < 7; i++) sent += frame(more, 0, 1, 0);
    ASSERT_TRUE(take(sent).ok());
    EXPECT_EQ(take(frame(more, 0, 1, 0)).error().message,
              "a header block of more than 32768 bytes or 8 frames");
    guard = Http2FrameGuard(now);
    greet();
    ASSERT_TRUE(take(frame(headers, 0, 1, 9) + frame(more, end_headers, 1, 9)).ok());
    EXPECT_TRUE(take(frame(data, 0, 1, 9)).ok())
        << "DATA frames are allowed after the end of the block";
    EXPECT_FALSE(take(frame(more, 0, 1, 9)).ok());
    guard = Http2FrameGuard(now);
    greet();
    EXPECT_FALSE(take(frame(headers, 0, 1, 9) + frame(data, 0, 1, 9)).ok());
}

TEST_F(Http2FrameGuardTest, rejects_floods_of_rare_frames) {
    greet();
    EXPECT_EQ(flood(frame(settings, 0, 0, 0), 100), "too many SETTINGS frames");
    EXPECT_EQ(flood(frame(ping, 0, 0, 8), 1000), "too many PING frames");
    EXPECT_EQ(flood(frame(data, 0, 1, 0), 100), "too many empty DATA frames");
    EXPECT_EQ(flood(frame(priority, 0, 1, 5), 100), "too many PRIORITY or GOAWAY frames");
    EXPECT_EQ(flood(frame(77, 0, 1, 5), 100), "too many unknown frames");
    EXPECT_FALSE(take(frame(push, 0, 1, 9)).ok());
}

TEST_F(Http2FrameGuardTest, rejects_oversized_frames) {
    greet();
    EXPECT_EQ(take(frame(data, 0, 1, 16385).substr(0, 9)).error().message,
              "a frame of 16385 bytes; at most 16384 are allowed");
}

// Legitimate frames above their rate limit are delayed.
TEST_F(Http2FrameGuardTest, throttles_window_updates_to_4000_per_second) {
    greet();
    std::string updates;
    for (int i = 0; i < 1000; i++) updates += frame(window, 0, 0, 4);
    int taken = 0;
    for (const auto end = now + 10s; now < end; now += guard.throttle_delay(now)) {
        ASSERT_TRUE(take(updates).ok());
        taken += 1000;
    }
    EXPECT_NEAR(taken, 44000, 1500);
}

}  // namespace
}  // namespace jostle::server

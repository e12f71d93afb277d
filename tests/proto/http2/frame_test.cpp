// SPDX-License-Identifier: MIT
#include "jostle/http2/frame.h"

#include <gtest/gtest.h>

namespace jostle::http2 {

TEST(Http2Frame, writes_and_reads_the_header_of_rfc_9113) {
    const FrameHeader header{.length = 0x010203,
                             .type = FrameType::headers,
                             .flags = flags::end_headers | flags::end_stream,
                             .stream = 0x7a0b0c0d};
    std::string bytes;
    put_frame_header(bytes, header);
    EXPECT_EQ(bytes, std::string("\x01\x02\x03\x01\x05\x7a\x0b\x0c\x0d", 9));
    bytes[5] = static_cast<char>(0xfa);  // the reserved bit is ignored
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const FrameHeader read =
        read_frame_header(std::span<const std::uint8_t, frame_header_bytes>(data, 9));
    EXPECT_EQ(read.length, header.length);
    EXPECT_EQ(read.type, header.type);
    EXPECT_TRUE(read.has(flags::end_headers));
    EXPECT_FALSE(read.has(flags::padded));
    EXPECT_EQ(read.stream, header.stream);
}

TEST(Http2Frame, writes_a_setting) {
    std::string bytes;
    put_setting(bytes, Setting::initial_window, 65'536);
    EXPECT_EQ(bytes, std::string("\x00\x04\x00\x01\x00\x00", setting_bytes));
}

}  // namespace jostle::http2

// SPDX-License-Identifier: MIT
#include "jostle/snapshot/baseline_frames.h"

#include <gtest/gtest.h>

namespace jostle::snapshot {
namespace {

TEST(BaselineFrames, equal_spacing_encodes_as_one_small_number) {
    EXPECT_EQ(encode_baseline_frames(100, {}), 0u);
    EXPECT_EQ(encode_baseline_frames(100, {99, 98, 97}), 1u);
    EXPECT_EQ(encode_baseline_frames(100, {97, 94, 91}), 3u);
    EXPECT_EQ(encode_baseline_frames(100, {98, 97, 96}), 2u | 1u << 8 | 0u << 16);
}

TEST(BaselineFrames, round_trips_every_baseline_set) {
    int sets = 0;
    for (const std::uint32_t a : {0u, 1u, 2u, 7u, 254u})
        for (const std::uint32_t b : {0u, 1u, 2u, 7u, 254u})
            for (const std::uint32_t c : {0u, 1u, 2u, 7u, 254u}) {
                const std::uint32_t frame = 0xffffff00;
                BaselineFrames baselines;
                if (a != 0) baselines.baseline = frame - a;
                if (a != 0 && b != 0) baselines.baseline2 = baselines.baseline - b;
                if (baselines.baseline2 != 0 && c != 0)
                    baselines.baseline3 = baselines.baseline2 - c;
                const auto back =
                    decode_baseline_frames(frame, encode_baseline_frames(frame, baselines));
                ASSERT_TRUE(back.ok()) << back.error().message;
                EXPECT_EQ(*back, baselines);
                sets++;
            }
    EXPECT_EQ(sets, 125);
}

TEST(BaselineFrames, rejects_invalid_codes) {
    const std::uint32_t none = 255;
    for (const std::uint32_t code :
         {none, 256u, 1u | none << 8 | 1u << 16, 1u | 1u << 24, 10u, 5u | 5u << 8, 0xffffffffu})
        EXPECT_FALSE(decode_baseline_frames(10, code).ok()) << code;
    EXPECT_EQ(decode_baseline_frames(10, 10).error().message,
              "frame 10: baselines 10 are before the first frame");
    EXPECT_TRUE(decode_baseline_frames(10, 3).ok()) << "baselines 7, 4 and 1";
    EXPECT_FALSE(decode_baseline_frames(9, 3).ok()) << "baselines 6, 3 and 0";
}

}  // namespace
}  // namespace jostle::snapshot

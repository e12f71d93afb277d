// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <vector>

#include "server/grpc/conversions.h"

namespace jostle::server {

namespace {

TEST(MessageBytes, pieces_form_one_message) {
    const auto shared = std::make_shared<const std::string>(5000, 's');
    const grpc::ByteBuffer buffer = to_byte_buffer({"head", shared});
    EXPECT_EQ(buffer.Length(), 5004u);
    std::string bytes = "left over";
    copy_bytes(bytes, buffer);
    EXPECT_EQ(bytes, "head" + *shared);
}

TEST(MessageBytes, shared_piece_is_not_copied_and_is_released) {
    const auto shared = std::make_shared<const std::string>(5000, 's');
    {
        const grpc::ByteBuffer buffer = to_byte_buffer({"head", shared});
        EXPECT_EQ(shared.use_count(), 2);
        std::vector<grpc::Slice> slices;
        ASSERT_TRUE(buffer.Dump(&slices).ok());
        ASSERT_EQ(slices.size(), 2u);
        EXPECT_EQ(static_cast<const void*>(slices[1].begin()), shared->data());
    }
    EXPECT_EQ(shared.use_count(), 1);
}

TEST(MessageBytes, skips_missing_pieces) {
    std::string bytes;
    copy_bytes(bytes, to_byte_buffer({"only", nullptr}));
    EXPECT_EQ(bytes, "only");
    copy_bytes(bytes, to_byte_buffer({"", std::make_shared<const std::string>("shared")}));
    EXPECT_EQ(bytes, "shared");
}

}  // namespace

}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <vector>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
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

// gRPC clients reject a response with more than 8 KiB of metadata.
TEST(RichStatus, long_errors_fit_into_the_trailers) {
    const std::string name(80, 'x');
    for (const char* letter : {"y", "\xc3\xa4"}) {
        std::string message;
        for (int i = 0; i < 20; i++) {
            message += fmt::format("{}bodies[{}].{}: ", i == 0 ? "" : "\n", i, name);
            for (int k = 0; k < 60; k++) message += letter;
        }
        const grpc::Status status = to_rich_status(Error{ErrorCode::invalid_argument, message});
        EXPECT_LT(status.error_message().size() + status.error_details().size() * 4 / 3, 7700u);
        google::rpc::Status details;
        google::rpc::BadRequest violations;
        ASSERT_TRUE(details.ParseFromString(status.error_details()));
        ASSERT_TRUE(details.details(1).UnpackTo(&violations));
        EXPECT_GE(violations.field_violations_size(), 6);
        EXPECT_EQ(violations.field_violations(1).field(), "bodies[1]." + name);
        EXPECT_TRUE(status.error_message().starts_with("bodies[0]."));
    }
}

TEST(RichStatus, fields_of_a_text_have_no_position) {
    const grpc::Status status = to_rich_status(
        Error{ErrorCode::invalid_argument, "line 2, column 4: world.hz: 1 is out of range"});
    google::rpc::Status details;
    google::rpc::BadRequest violations;
    ASSERT_TRUE(details.ParseFromString(status.error_details()));
    ASSERT_TRUE(details.details(1).UnpackTo(&violations));
    EXPECT_EQ(violations.field_violations(0).field(), "world.hz");
    EXPECT_EQ(violations.field_violations(0).description(),
              "line 2, column 4: world.hz: 1 is out of range");
}

}  // namespace

}  // namespace jostle::server

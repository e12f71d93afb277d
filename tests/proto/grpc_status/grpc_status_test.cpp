// SPDX-License-Identifier: MIT
#include "jostle/grpc_status/grpc_status.h"

#include <gtest/gtest.h>

namespace jostle {

TEST(GrpcStatus, round_trips_every_error) {
    for (const GrpcCode& code : grpc_codes) {
        const Status back = from_grpc(to_grpc(Error{code.error_code, "why"}));
        ASSERT_FALSE(back.ok());
        EXPECT_EQ(back.error().message, "why");
        // Corrupt bytes are an invalid argument of their sender.
        EXPECT_EQ(back.error().code, code.error_code == ErrorCode::corrupt_data
                                         ? ErrorCode::invalid_argument
                                         : code.error_code);
    }
    EXPECT_EQ(std::size(grpc_codes), static_cast<std::size_t>(ErrorCode::internal) + 1)
        << "one row per code";
}

TEST(GrpcStatus, round_trips_success) {
    EXPECT_TRUE(to_grpc({}).ok());
    EXPECT_TRUE(from_grpc(grpc::Status::OK).ok());
}

TEST(GrpcStatus, reads_the_time_to_retry_of_the_details) {
    google::rpc::RetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(2);
    retry.mutable_retry_delay()->set_nanos(345'600'000);
    google::rpc::Status details;
    details.add_details()->PackFrom(google::rpc::ErrorInfo());
    details.add_details()->PackFrom(retry);
    const auto ms_of = [](const std::string& bytes) {
        return from_grpc({grpc::StatusCode::RESOURCE_EXHAUSTED, "later", bytes})
            .error()
            .retry_after_ms;
    };
    EXPECT_EQ(ms_of(details.SerializeAsString()), 2346) << "rounded up";
    EXPECT_EQ(ms_of(""), 0);
    EXPECT_EQ(ms_of("not a message"), 0);
}

TEST(GrpcStatus, unknown_codes_become_internal_and_empty_messages_are_replaced) {
    const Status odd = from_grpc({grpc::StatusCode::DATA_LOSS, ""});
    EXPECT_EQ(odd.error().code, ErrorCode::internal);
    EXPECT_EQ(odd.error().message, "the server gave no reason");
}

}  // namespace jostle

// SPDX-License-Identifier: MIT
#include "jostle/base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace jostle {
namespace {

Result<int> half(int x) {
    if (x % 2 != 0) return invalid_argument(std::to_string(x) + " is odd");
    return x / 2;
}

TEST(Result, holds_a_value_or_an_error) {
    ASSERT_TRUE(half(6).ok());
    EXPECT_EQ(*half(6), 3);
    ASSERT_FALSE(half(7).ok());
    EXPECT_EQ(half(7).error().code, ErrorCode::invalid_argument);
    EXPECT_EQ(half(7).error().message, "7 is odd");
}

TEST(Result, supports_move_only_values) {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
    const std::unique_ptr<int> taken = std::move(*result);
    EXPECT_EQ(*taken, 5);
}

TEST(Status, is_ok_unless_constructed_from_an_error) {
    EXPECT_TRUE(Status().ok());
    const Status status = half(7).error();
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().message, "7 is odd");
}

}  // namespace
}  // namespace jostle

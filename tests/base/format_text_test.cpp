// SPDX-License-Identifier: MIT
#include "jostle/base/format_text.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {

TEST(FormatText, formats_and_truncates) {
    EXPECT_EQ(format_text("%4s %.3g", "row", 0.12345), " row 0.123");
    EXPECT_EQ(format_text("%1000d", 7).size(), 639u);
}

}  // namespace
}  // namespace jostle::test

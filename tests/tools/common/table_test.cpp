// SPDX-License-Identifier: MIT
#include "tools/common/table.h"

#include <gtest/gtest.h>

namespace jostle::common {

TEST(CtlTable, aligns_columns_with_multibyte_characters) {
    Table table({{"ID", Align::right}, {"NAME"}, {"MS", Align::right}, {"STATE"}});
    table.add({"7", "Zoë", "1.25", "runs"});
    table.add({"12", "al", "103.00", "paused"});
    EXPECT_EQ(table.text(),
              "ID  NAME      MS  STATE\n"
              " 7  Zoë     1.25  runs\n"
              "12  al    103.00  paused\n");
}

// Clients choose their names.
TEST(CtlTable, removes_control_characters_from_foreign_text) {
    EXPECT_EQ(sanitized("a\x1b[2Jb\nc\x7f"), "a?[2Jb?c?");
    EXPECT_EQ(sanitized("x\xc2\x9b"
                        "2Jy"),
              "x?2Jy")
        << "CSI as a single character";
    EXPECT_EQ(sanitized("Zo\xc3\xab"), "Zo\xc3\xab");
    EXPECT_EQ(sanitized("nnnnnnnnnn", 8), "nnnnnnnn...");
    EXPECT_EQ(sanitized("nnnnnnnn", 8), "nnnnnnnn");
}

TEST(CtlTable, formats_durations_with_at_most_two_units) {
    EXPECT_EQ(duration_text(0.4), "0 s");
    EXPECT_EQ(duration_text(59.9), "59 s");
    EXPECT_EQ(duration_text(200), "3 min 20 s");
    EXPECT_EQ(duration_text(7200), "2 h");
    EXPECT_EQ(duration_text(4 * 86400 + 3600 + 59), "4 d 1 h");
    EXPECT_EQ(duration_text(-5), "0 s");
    EXPECT_EQ(number_text(2.345, 1), "2.3");
}

}  // namespace jostle::common

// SPDX-License-Identifier: MIT
#include "server/util/watched_file.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

TEST(WatchedFile, stamp_detects_a_replaced_file_of_equal_size) {
    const test::TempFolder folder;
    EXPECT_FALSE(stamp_of(folder / "a").exists);
    folder.write("a", "one");
    const FileStamp first = stamp_of(folder / "a");
    EXPECT_EQ(stamp_of(folder / "a"), first);
    folder.write("a", "two");
    EXPECT_NE(stamp_of(folder / "a"), first);
}

TEST(WatchedFile, bounded_read_never_blocks) {
    const test::TempFolder folder;
    const std::string path = folder.write("a", std::string(1000, 'x'));
    EXPECT_EQ(read_bounded(path, 1000)->size(), 1000u);
    EXPECT_EQ(read_bounded(path, 999).error().message,
              "cannot read " + path + ": it is longer than 999 bytes");
    EXPECT_EQ(read_bounded(folder.write("empty", ""), 10).value(), "");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_FALSE(read_bounded(folder / "pipe", 10).ok());
    EXPECT_FALSE(read_bounded("/dev/zero", 10).ok());
    EXPECT_FALSE(read_bounded(folder / "", 10).ok()) << "a folder is not a file";
    EXPECT_FALSE(read_bounded(folder / "missing", 10).ok());
}

}  // namespace
}  // namespace jostle::server

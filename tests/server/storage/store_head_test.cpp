// SPDX-License-Identifier: MIT
#include "server/storage/store_head.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

StoreHead head_of(std::uint64_t commits, std::uint8_t content = 1) {
    StoreHead head{.id = std::string(StoreHead::id_bytes, 'i'),
                   .commits = commits,
                   .written = 1'795'000'000 + commits};
    Digest digest{};
    digest[0] = content;
    head.total = DigestTotal(digest);
    return head;
}

TEST(DigestTotal, does_not_depend_on_the_order_and_removes_what_was_added) {
    const std::string_view pieces_a[] = {"a"}, pieces_b[] = {"b"};
    const Digest a = digest_of(pieces_a), b = digest_of(pieces_b);
    DigestTotal ab, ba;
    ab.add(view_of(a)), ab.add(view_of(b));
    ba.add(view_of(b)), ba.add(view_of(a));
    EXPECT_EQ(ab, ba);
    ab.add(view_of(b));
    EXPECT_EQ(ab, DigestTotal(a));
    DigestTotal short_digest;
    short_digest.add("short");
    EXPECT_NE(short_digest, DigestTotal());
    short_digest.add("other");
    EXPECT_NE(short_digest, DigestTotal()) << "two corrupt digests must not cancel";
}

TEST(HeadFile, returns_the_newest_head_and_is_private) {
    const test::TempFolder folder;
    HeadFile file(folder / "head", true);
    EXPECT_FALSE(file.read()->exists);
    for (std::uint64_t k = 1; k <= 5; k++) ASSERT_TRUE(file.write(head_of(k)).ok());
    EXPECT_EQ(file.read()->head, head_of(5));
    EXPECT_FALSE(file.read()->has_corrupt_slot);
    struct stat about {};
    stat((folder / "head").c_str(), &about);
    EXPECT_EQ(about.st_mode & 0777, 0600u);
    EXPECT_EQ(about.st_size, 8192);
}

TEST(HeadFile, a_torn_write_leaves_the_previous_head) {
    const test::TempFolder folder;
    HeadFile file(folder / "head", false);
    for (std::uint64_t k = 1; k <= 4; k++) ASSERT_TRUE(file.write(head_of(k)).ok());
    std::string bytes = folder.read("head");
    bytes.replace(20, 100, std::string(100, '\0'));  // commit 4 is in the first slot
    const HeadFile torn(folder.write("torn", bytes), false);
    EXPECT_EQ(torn.read()->head, head_of(3));
    EXPECT_TRUE(torn.read()->has_corrupt_slot);
}

TEST(HeadFile, reports_a_folder_that_does_not_exist) {
    HeadFile file("/no/such/folder/head", true);
    EXPECT_FALSE(file.read()->exists);
    EXPECT_EQ(file.write(head_of(1)).error().message,
              "/no/such/folder/head: cannot open it: No such file or directory");
}

TEST(HeadConflict, accepts_a_database_that_is_as_new_or_newer) {
    EXPECT_EQ(head_conflict(head_of(7), false, {true, head_of(7), false}, "f"), "");
    EXPECT_EQ(head_conflict(head_of(8), false, {true, head_of(7), false}, "f"), "");
    EXPECT_EQ(head_conflict(head_of(8, 2), false, {true, head_of(7), true}, "f"), "");
    EXPECT_EQ(head_conflict(head_of(8), true, {}, "f"), "");
}

TEST(HeadConflict, states_what_is_missing) {
    EXPECT_EQ(head_conflict(head_of(5), false, {true, head_of(7), false}, "f"),
              "it ends with commit 5 of 2026-11-18 11:06:45 UTC, but commit 7 of "
              "2026-11-18 11:06:47 UTC was written: 2 commits are missing");
    EXPECT_EQ(head_conflict(head_of(7, 2), false, {true, head_of(7), false}, "f"),
              "its commit 7 has other content than was written");
    EXPECT_EQ(head_conflict(head_of(7), false, {}, "f"),
              "its file f is missing, so the copy of the database is incomplete");
    EXPECT_EQ(head_conflict(head_of(7), false, {true, std::nullopt, true}, "f"),
              "its file f is corrupt");
    StoreHead other = head_of(7);
    other.id[0] = 'j';
    EXPECT_EQ(head_conflict(head_of(7), false, {true, other, false}, "f"),
              "the file f belongs to another database");
}

}  // namespace
}  // namespace jostle::server

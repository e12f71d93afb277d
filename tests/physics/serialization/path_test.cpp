// SPDX-License-Identifier: MIT
//
// Where a field is, in words.
#include "physics/src/serialization/path.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using physics::Path;

TEST(Path, joins_names_with_dots_and_puts_indices_in_brackets) {
    Path path;
    path.enter("bodies");
    path.enter("awake");
    path.enter(std::size_t{3});
    path.enter("center");
    EXPECT_EQ(path.text("y"), "bodies.awake[3].center.y");
    EXPECT_EQ(path.text(""), "bodies.awake[3].center");
    path.leave();
    path.leave();
    EXPECT_EQ(path.text("size"), "bodies.awake.size");
}

TEST(Path, top_level_field_is_its_name) {
    EXPECT_EQ(Path().text("steps"), "steps");
}

}  // namespace
}  // namespace jostle::test

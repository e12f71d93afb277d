// SPDX-License-Identifier: MIT
#include "tools/mesh/obj_file.h"

#include <gtest/gtest.h>

namespace jostle::mesh {
namespace {

TEST(ObjFile, triangulates_faces_and_supports_negative_indices) {
    const auto mesh = read_obj(
        "# a square\no it\nv 0 0 0\nv 1 0 0\r\nv 1 1 0\n\tv 0 1e0 0\nvn 0 0 1\n"
        "f 1/4 2//1 3/2/1 -1\nusemtl x\n");
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(mesh->vertices.size(), 4u);
    EXPECT_EQ(mesh->vertices[3], (physics::Vec3{0, 1, 0}));
    EXPECT_EQ(mesh->indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(ObjFile, errors_name_the_line) {
    const auto complaint = [](const char* text) {
        const auto mesh = read_obj(text);
        return mesh.ok() ? std::string() : mesh.error().message;
    };
    EXPECT_EQ(complaint("v 0 0\n"),
              "line 1: \"\" is not a finite number; a vertex needs three coordinates");
    EXPECT_EQ(complaint("v 0 0 nan\n"),
              "line 1: \"nan\" is not a finite number; a vertex needs three coordinates");
    EXPECT_EQ(complaint("v 0 0 0\nf 1 2 3\n"),
              "line 2: vertex index 2 is out of range; there are 1 vertices up to this line");
    EXPECT_EQ(complaint("v 0 0 0\nf 1 1\n"), "line 2: a face needs at least three corners");
    EXPECT_EQ(complaint("f a b c\n"),
              "line 1: \"a\" is not a corner of a face; use INDEX, INDEX/UV or INDEX/UV/NORMAL");
    EXPECT_EQ(complaint("v 0 0 0\n"), "the file has no faces (lines such as \"f 1 2 3\")");
}

}  // namespace
}  // namespace jostle::mesh

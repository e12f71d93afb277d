// SPDX-License-Identifier: MIT
#include "jostle/modules/fracture_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

std::vector<std::byte> bytes_of(const FracturedShape& shape) {
    return write_fracture(shape).value();
}

// Updates the checksum to the contents.
std::vector<std::byte> sealed(std::vector<std::byte> bytes) {
    const std::uint64_t sum = fracture_checksum(std::span(bytes).subspan(fracture_header_bytes));
    std::memcpy(bytes.data() + 12, &sum, sizeof sum);
    return bytes;
}

std::string error_of(const std::vector<std::byte>& bytes) {
    const auto read = read_fracture(bytes);
    return read.ok() ? std::string() : read.error().message;
}

TEST(FractureFile, round_trip_is_bit_identical) {
    FracturedShape boxes = split_box({1, 0.5, 0.25}, 3, 2, 1).value();
    anchor(boxes, {0, -1, 0}, 0.499);
    for (const FracturedShape& shape : {wall(60), boxes}) {
        const FracturedShape read = read_fracture(bytes_of(shape)).value();
        ASSERT_EQ(read.chunks.size(), shape.chunks.size());
        ASSERT_EQ(read.bonds.size(), shape.bonds.size());
        for (std::size_t k = 0; k < read.chunks.size(); k++) {
            EXPECT_EQ(read.chunks[k].volume, shape.chunks[k].volume);
            EXPECT_EQ(read.chunks[k].center, shape.chunks[k].center);
            EXPECT_EQ(read.chunks[k].unit_inertia, shape.chunks[k].unit_inertia);
            EXPECT_EQ(read.chunks[k].anchored, shape.chunks[k].anchored);
        }
        for (std::size_t k = 0; k < read.bonds.size(); k++)
            EXPECT_EQ(std::memcmp(&read.bonds[k], &shape.bonds[k], sizeof(FractureBond)), 0);
        EXPECT_EQ(bytes_of(read), bytes_of(shape));
        Stage stage;
        stage.add(read, standing());
        stage.step(3);
    }
}

TEST(FractureFile, errors_name_the_invalid_field) {
    const FracturedShape shape = split_box({1, 1, 1}, 2, 1, 1).value();
    const std::vector<std::byte> valid = bytes_of(shape);
    EXPECT_EQ(error_of({}), "not a fracture file; create one with jostle-mesh fracture");
    std::vector<std::byte> bytes = valid;
    bytes[8] = std::byte{7};
    EXPECT_EQ(error_of(bytes),
              "unsupported version 7; this program reads version 1; create the file again with "
              "jostle-mesh fracture");
    bytes = valid;
    bytes.back() ^= std::byte{1};
    EXPECT_EQ(error_of(bytes), "checksum mismatch: the file is corrupt or truncated");
    bytes = valid;
    bytes[fracture_header_bytes + 3] = std::byte{0x7f};
    EXPECT_EQ(error_of(sealed(bytes)),
              "header declares 2130706434 chunks and 1 bonds, which exceeds the file size or the "
              "limits");
    bytes = valid;
    bytes.push_back({});
    EXPECT_EQ(error_of(sealed(bytes)), "1 unexpected bytes at the end of the file");
    FracturedShape wrong = shape;
    wrong.chunks[1].volume *= 1.1;
    EXPECT_EQ(error_of(bytes_of(wrong)), "chunks[1]: volume does not match the geometry");
    wrong = shape;
    wrong.chunks[0].center.y = 3;
    EXPECT_EQ(error_of(bytes_of(wrong)), "chunks[0]: centre of mass is outside the geometry");
    wrong = shape;
    wrong.chunks[0].unit_inertia = diagonal({1, 1, -1});
    EXPECT_EQ(error_of(bytes_of(wrong)),
              "chunks[0]: inertia is not possible for a solid of this size");
    wrong = shape;
    wrong.chunks[1].geometry = Sphere{1};
    EXPECT_EQ(write_fracture(wrong).error().message, "chunks[1] is neither a box nor a hull");
    wrong.bonds[0].area = std::nan("");
    EXPECT_FALSE(write_fracture(wrong).ok());
}

// Any byte may have any value, with a matching checksum: the file is rejected, or its shape can be
// added.
TEST(FractureFile, corrupted_bytes_are_rejected_or_yield_a_valid_shape) {
    const std::vector<std::byte> valid = bytes_of(wall(4));
    int refused = 0, added = 0;
    for (std::size_t at = fracture_header_bytes; at < valid.size(); at++) {
        for (const std::byte flip : {std::byte{0xff}, std::byte{0x40}, std::byte{1}}) {
            std::vector<std::byte> bytes = valid;
            bytes[at] ^= flip;
            const auto read = read_fracture(sealed(bytes));
            refused += !read.ok();
            if (!read.ok() || at % 7 != 0) continue;
            Stage stage;
            const auto id = stage.destruction->add(stage.world, *read, standing());
            EXPECT_TRUE(id.ok()) << id.error().message;
            static_cast<void>(stage.world.step(1.0 / 60).ok());
            added++;
        }
        if (at % 11 == 0) {
            std::vector<std::byte> cut(valid.begin(),
                                       valid.begin() + static_cast<std::ptrdiff_t>(at));
            cut.resize(std::max(cut.size(), fracture_header_bytes + 8));
            EXPECT_FALSE(read_fracture(sealed(cut)).ok());
        }
    }
    RecordProperty("refused", refused);
    RecordProperty("added", added);
    EXPECT_GT(refused, 1000);
    EXPECT_GT(added, 100);
}

}  // namespace
}  // namespace jostle::modules

// SPDX-License-Identifier: MIT
//
// What a client knows of the modules of its world, snapshot by snapshot.
#include "jostle/client/world_view.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

using Chunks = std::vector<std::pair<std::string, std::string>>;  // tag and data

// An empty world whose modules tell that, against the base.
v1::Snapshot snapshot(std::uint32_t number, std::uint32_t base, const Chunks& chunks) {
    const wire::QuantizedFrame before{.frame = base}, frame{.frame = number};
    const auto packed =
        wire::encode_frame(frame, {base != 0 ? &before : nullptr, nullptr, nullptr}, {});
    v1::Snapshot s;
    s.set_frame(number);
    s.set_base_frame(base);
    s.set_packed(packed.data(), packed.size());
    s.set_crc(wire::frame_crc(frame));
    for (const auto& [tag, data] : chunks) {
        v1::ModuleChunk& chunk = *s.add_modules();
        chunk.set_tag(tag);
        chunk.set_data(data);
    }
    return s;
}

class WorldViewTest : public testing::Test {
protected:
    void SetUp() override { welcome(); }
    void welcome() {
        v1::Welcome message;
        message.mutable_quant()->set_units_per_meter(512);
        message.mutable_quant()->set_rotation_component(511);
        view.begin(message);
    }
    bool take(const v1::Snapshot& message) { return view.apply(message).ok(); }
    std::string chunk(std::string_view tag) const {
        std::string text;
        for (const std::byte b : view.chunk(tag)) text += static_cast<char>(b);
        return text;
    }

    WorldView view;
};

}  // namespace

TEST_F(WorldViewTest, a_chunk_stays_until_it_changes_or_ends) {
    EXPECT_EQ(chunk("craft"), "") << "nothing was told yet";
    ASSERT_TRUE(take(snapshot(10, 0, {{"craft", "a"}, {"crane", "b"}})));
    EXPECT_EQ(chunk("craft"), "a");
    EXPECT_EQ(view.chunk_tags(), (std::vector<std::string>{"craft", "crane"}));
    ASSERT_TRUE(take(snapshot(11, 10, {{"craft", std::string("\0c", 2)}})));
    EXPECT_EQ(chunk("craft"), std::string("\0c", 2));
    EXPECT_EQ(chunk("crane"), "b");
    ASSERT_TRUE(take(snapshot(12, 11, {{"crane", ""}})));
    EXPECT_EQ(view.chunk_tags(), std::vector<std::string>{"craft"});
    EXPECT_TRUE(view.chunk("crane").empty());
}

TEST_F(WorldViewTest, chunks_follow_from_those_of_the_base_whichever_it_is) {
    ASSERT_TRUE(take(snapshot(10, 0, {{"craft", "a"}})));
    ASSERT_TRUE(take(snapshot(11, 10, {{"craft", "b"}, {"crane", "c"}})));
    ASSERT_TRUE(take(snapshot(12, 10, {})));
    EXPECT_EQ(chunk("craft"), "a") << "as it was in frame 10";
    EXPECT_EQ(view.chunk_tags(), std::vector<std::string>{"craft"});
}

TEST_F(WorldViewTest, a_snapshot_that_cannot_be_read_changes_no_chunk) {
    ASSERT_TRUE(take(snapshot(10, 0, {{"craft", "a"}})));
    v1::Snapshot damaged = snapshot(11, 10, {{"craft", "b"}});
    damaged.set_crc(damaged.crc() + 1);
    EXPECT_FALSE(take(damaged));
    EXPECT_FALSE(take(snapshot(12, 11, {{"craft", "c"}}))) << "its base was refused";
    EXPECT_EQ(chunk("craft"), "a");
}

TEST_F(WorldViewTest, an_absolute_snapshot_and_a_new_stream_leave_nothing_stale) {
    ASSERT_TRUE(take(snapshot(10, 0, {{"craft", "a"}, {"crane", "b"}})));
    ASSERT_TRUE(take(snapshot(14, 0, {{"crane", "c"}}))) << "the repair of a loss";
    EXPECT_EQ(view.chunk_tags(), std::vector<std::string>{"crane"});
    welcome();
    EXPECT_TRUE(view.chunk_tags().empty());
    EXPECT_TRUE(view.chunk("crane").empty());
}

TEST_F(WorldViewTest, tags_without_end_are_refused) {
    Chunks chunks;
    for (int k = 0; k < 64; k++) chunks.emplace_back("m" + std::to_string(k), "x");
    ASSERT_TRUE(take(snapshot(10, 0, chunks)));
    const Status more = view.apply(snapshot(11, 10, {{"another", "x"}}));
    ASSERT_FALSE(more.ok());
    EXPECT_EQ(more.error().message, "frame 11: more than 64 modules");
    EXPECT_TRUE(take(snapshot(12, 10, {{"m7", ""}, {"another", "x"}})));
}

TEST_F(WorldViewTest, a_large_shape_comes_in_parts_and_its_bodies_name_it) {
    v1::Shape mesh;
    for (int i = 0; i < 300; i++) mesh.mutable_mesh()->add_vertices()->set_x(i);
    const std::string bytes = mesh.SerializeAsString();
    v1::GeometryPart part;
    part.set_id(77);
    part.set_parts(2);
    part.set_data(bytes.substr(0, 100));
    EXPECT_TRUE(view.apply(part).ok());
    v1::Shape named;
    named.set_geometry(77);
    EXPECT_EQ(view.outline_of(named), nullptr) << "half of it is not it";
    part.set_part(1);
    part.set_data(bytes.substr(100));
    EXPECT_TRUE(view.apply(part).ok());
    ASSERT_NE(view.outline_of(named), nullptr);
    EXPECT_EQ(view.outline_of(named)->mesh().vertices_size(), 300);
    v1::Shape ball;
    ball.mutable_sphere()->set_radius(1);
    EXPECT_EQ(view.outline_of(ball), &ball);
}

TEST_F(WorldViewTest, a_part_out_of_order_is_refused_and_leaves_nothing_behind) {
    v1::GeometryPart part;
    part.set_id(77);
    part.set_part(1);
    part.set_parts(2);
    const Status told = view.apply(part);
    ASSERT_FALSE(told.ok());
    EXPECT_EQ(told.error().message, "geometry 77: part 1 of 2 does not follow the one before");
    part.set_part(0);
    part.set_parts(1);
    part.set_data("\xff no shape");
    EXPECT_EQ(view.apply(part).error().message, "geometry 77: its bytes are no Shape");
}

}  // namespace jostle::client

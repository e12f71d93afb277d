// SPDX-License-Identifier: MIT
//
// Channels and the controlled entity in a client's view, snapshot by snapshot.
#include "jostle/client/world_view.h"
#include "jostle/snapshot/baseline_frames.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

// Channels of entity 5 of two kinds, "craft" (0) and "crane" (1).
using Told = std::vector<std::pair<std::uint32_t, std::int32_t>>;  // kind and value

snapshot::Channels channels(const Told& told) {
    snapshot::Channels made;
    for (const auto& [kind, value] : told)
        made.push_back({kind, 5, std::make_shared<const std::vector<std::int32_t>>(1, value)});
    return made;
}

// An empty world with channels, encoded against those of the baseline.
v1::Snapshot snapshot(std::uint32_t number, std::uint32_t base, const Told& told,
                      const Told& base_told = {}) {
    const snapshot::QuantizedFrame before{.frame = base}, frame{.frame = number};
    const auto packed =
        snapshot::encode_frame(frame, {base != 0 ? &before : nullptr, nullptr, nullptr}, {});
    v1::Snapshot s;
    s.set_frame(number);
    s.set_baselines(snapshot::encode_baseline_frames(number, {.baseline = base}));
    s.set_packed(packed.data(), packed.size());
    s.set_crc(snapshot::frame_crc(frame));
    const snapshot::PackedChannels changed =
        snapshot::encode_channels(channels(told), channels(base_told), ~std::uint64_t{0});
    s.set_channels(changed.bytes.data(), changed.bytes.size());
    s.set_channels_crc(changed.crc);
    return s;
}

class WorldViewTest : public testing::Test {
protected:
    void SetUp() override { welcome(); }
    void welcome() {
        v1::Welcome message;
        message.mutable_quant()->set_units_per_meter(512);
        message.mutable_quant()->set_rotation_component(511);
        message.add_channels()->set_name("craft");
        message.add_channels()->set_name("crane");
        view.begin(message);
    }
    bool take(const v1::Snapshot& message) { return view.apply(message).ok(); }
    // The value of a channel; nothing: no such channel.
    std::optional<std::int32_t> told(std::string_view kind) const {
        const auto values = view.channel(kind, 5);
        return values.empty() ? std::nullopt : std::optional(values.front());
    }

    WorldView view;
};

// The controlled entity is delta-encoded; a state without a known baseline is rejected.
TEST_F(WorldViewTest, requires_a_complete_controlled_entity_state_first) {
    v1::ControlledEntityState part;
    part.set_entity(5);
    part.set_tick(7);
    part.set_module("vehicle");
    part.set_words(2);
    part.set_changed_mask("\x02");
    part.set_values(std::string("\x09\0\0\0", 4));
    EXPECT_EQ(view.apply(part).error().code, ErrorCode::failed_precondition);
    EXPECT_EQ(view.controlled_entity().entity, 0u);
    v1::ControlledEntityState whole = part;
    whole.set_keyframe(true);
    whole.set_changed_mask("\x01");
    ASSERT_TRUE(view.apply(whole).ok());
    ASSERT_TRUE(view.apply(part).ok());
    EXPECT_EQ(view.controlled_entity().words, (std::vector<std::uint32_t>{9, 9}));
    EXPECT_EQ(view.controlled_entity().module, "vehicle");
    part.set_values("short");
    EXPECT_EQ(view.apply(part).error().code, ErrorCode::corrupt_data);
    EXPECT_EQ(view.controlled_entity().entity, 0u)
        << "the next state must not use the rejected one as baseline";
    welcome();
    EXPECT_EQ(view.controlled_entity().tick, 0u);
}

}  // namespace

TEST_F(WorldViewTest, keeps_a_channel_until_it_changes_or_ends) {
    EXPECT_FALSE(told("craft")) << "no channel received yet";
    EXPECT_EQ(view.channel_kinds().size(), 2u);
    ASSERT_TRUE(take(snapshot(10, 0, {{0, 1}, {1, 2}})));
    EXPECT_EQ(told("craft"), 1);
    ASSERT_TRUE(take(snapshot(11, 10, {{0, 3}, {1, 2}}, {{0, 1}, {1, 2}})));
    EXPECT_EQ(told("craft"), 3);
    EXPECT_EQ(told("crane"), 2);
    ASSERT_TRUE(take(snapshot(12, 11, {{0, 3}}, {{0, 3}, {1, 2}})));
    EXPECT_EQ(view.channels().size(), 1u);
    EXPECT_FALSE(told("crane"));
    EXPECT_TRUE(view.channel("craft", 6).empty()) << "another entity";
    EXPECT_TRUE(view.channel("boat", 5).empty()) << "unknown kind";
}

TEST_F(WorldViewTest, decodes_channels_against_any_baseline) {
    ASSERT_TRUE(take(snapshot(10, 0, {{0, 1}})));
    ASSERT_TRUE(take(snapshot(11, 10, {{0, 2}, {1, 3}}, {{0, 1}})));
    ASSERT_TRUE(take(snapshot(12, 10, {{0, 1}}, {{0, 1}})));
    EXPECT_EQ(told("craft"), 1) << "unchanged since frame 10";
    EXPECT_EQ(view.channels().size(), 1u);
}

TEST_F(WorldViewTest, rejects_an_undecodable_snapshot_without_changing_channels) {
    ASSERT_TRUE(take(snapshot(10, 0, {{0, 1}})));
    v1::Snapshot damaged = snapshot(11, 10, {{0, 2}}, {{0, 1}});
    damaged.set_channels_crc(damaged.channels_crc() + 1);
    const Status refused = view.apply(damaged);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message, "frame 11: channels: CRC mismatch");
    EXPECT_FALSE(take(snapshot(12, 11, {{0, 3}}, {{0, 2}}))) << "its baseline was rejected";
    EXPECT_EQ(told("craft"), 1);
}

TEST_F(WorldViewTest, discards_stale_state_on_a_keyframe_and_on_a_new_stream) {
    ASSERT_TRUE(take(snapshot(10, 0, {{0, 1}, {1, 2}})));
    ASSERT_TRUE(take(snapshot(14, 0, {{1, 3}}))) << "a keyframe recovers from the loss";
    EXPECT_FALSE(told("craft"));
    EXPECT_EQ(told("crane"), 3);
    welcome();
    EXPECT_TRUE(view.channels().empty());
}

TEST_F(WorldViewTest, assembles_a_large_shape_from_parts) {
    v1::Shape mesh;
    for (int i = 0; i < 300; i++) mesh.mutable_mesh()->add_vertices()->set_x(i);
    const std::string bytes = mesh.SerializeAsString();
    v1::GeometryChunk part;
    part.set_id(77);
    part.set_chunk_count(2);
    part.set_data(bytes.substr(0, 100));
    EXPECT_TRUE(view.apply(part).ok());
    v1::Shape named;
    named.set_geometry(77);
    EXPECT_EQ(view.resolve_shape(named), nullptr) << "incomplete geometry is not resolved";
    part.set_chunk(1);
    part.set_data(bytes.substr(100));
    EXPECT_TRUE(view.apply(part).ok());
    ASSERT_NE(view.resolve_shape(named), nullptr);
    EXPECT_EQ(view.resolve_shape(named)->mesh().vertices_size(), 300);
    v1::Shape ball;
    ball.mutable_sphere()->set_radius(1);
    EXPECT_EQ(view.resolve_shape(ball), &ball);
}

TEST_F(WorldViewTest, rejects_an_out_of_order_part_and_discards_the_shape) {
    v1::GeometryChunk part;
    part.set_id(77);
    part.set_chunk(1);
    part.set_chunk_count(2);
    const Status told = view.apply(part);
    ASSERT_FALSE(told.ok());
    EXPECT_EQ(told.error().message, "geometry 77: chunk 1 of 2 does not follow the previous chunk");
    part.set_chunk(0);
    part.set_chunk_count(1);
    part.set_data("\xff no shape");
    EXPECT_EQ(view.apply(part).error().message, "geometry 77: not a valid Shape");
}

TEST_F(WorldViewTest, hides_entities_until_their_entity_update_arrives) {
    v1::Welcome welcome;
    welcome.mutable_quant()->set_units_per_meter(512);
    welcome.mutable_quant()->set_rotation_component(511);
    welcome.mutable_datagrams()->set_port(1);
    view.begin(welcome);
    const snapshot::QuantizedFrame first{.frame = 1,
                                         .entities = {snapshot::quantize(7, {}, false, {})}};
    const snapshot::QuantizedFrame second{.frame = 2, .entities = first.entities};
    const auto told = [](const snapshot::QuantizedFrame& frame,
                         const snapshot::QuantizedFrame* base) {
        const auto packed = snapshot::encode_frame(frame, {base, nullptr, nullptr}, {});
        v1::Snapshot s;
        s.set_frame(frame.frame);
        s.set_baselines(
            snapshot::encode_baseline_frames(frame.frame, {.baseline = base ? base->frame : 0}));
        s.set_packed(packed.data(), packed.size());
        s.set_crc(snapshot::frame_crc(frame));
        return s;
    };
    ASSERT_TRUE(view.apply(told(first, nullptr)).ok());
    EXPECT_EQ(view.frame().frame, 1u);
    EXPECT_TRUE(view.frame().entities.empty()) << "no EntityUpdate has added it yet";
    EXPECT_FALSE(view.pose_of(7));
    ASSERT_TRUE(view.apply(told(second, &first)).ok()) << "it is a baseline nevertheless";
    v1::EntityUpdate entity_update;
    entity_update.add_added()->set_id(7);
    EXPECT_TRUE(view.apply(entity_update).ok());
    EXPECT_EQ(view.frame().entities.size(), 1u) << "visible once the entity is known";
    EXPECT_EQ(view.ack_bits(), 1u);
    v1::EntityUpdate gone;
    gone.add_removed(7);
    EXPECT_TRUE(view.apply(gone).ok());
    EXPECT_TRUE(view.frame().entities.empty());
}

}  // namespace jostle::client

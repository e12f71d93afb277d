// SPDX-License-Identifier: MIT
#include "server/messages/entity_update_message.h"

#include <gtest/gtest.h>

#include "jostle/snapshot/entity_list.h"

#include <cmath>

#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "jostle/v1/play.pb.h"
#include "server/messages/server_message.h"

namespace jostle::server {
namespace {

v1::ServerMessage parse(const SharedBytes& bytes) {
    v1::ServerMessage message;
    EXPECT_TRUE(message.ParseFromString(*bytes));
    return message;
}

std::shared_ptr<const EntityDescription> entity_with(EntityId id,
                                                     const physics::Geometry& geometry) {
    EntityDescription entity{.id = id, .shapes = {}, .color = {}, .name = {}};
    entity.shapes.emplace_back();
    entity.shapes.back().geometry = geometry;
    return std::make_shared<const EntityDescription>(entity);
}

// A flat grid of `side` x `side` squares.
physics::Geometry mesh_of(int side, double height = 0) {
    std::vector<physics::Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int i = 0; i <= side; i++)
        for (int k = 0; k <= side; k++) vertices.push_back({i * 0.5, height, k * 0.5});
    const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (side + 1) + k); };
    for (int i = 0; i < side; i++)
        for (int k = 0; k < side; k++) {
            triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
            triangles.push_back({at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
        }
    return physics::Mesh{physics::build_mesh(vertices, triangles).value()};
}

TEST(EntityUpdateMessage, contains_render_data) {
    EntityDescription box{.id = 9,
                          .type = physics::BodyType::kinematic,
                          .shapes = {},
                          .owner = 4,
                          .color = 0xff8800,
                          .name = "lift",
                          .mass = 12};
    physics::ShapeState shape;
    shape.geometry = physics::Box{{1, 2, 3}};
    shape.pose.position = {0, 5, 0};
    box.shapes.push_back(shape);
    const EntityList previous{entity_with(2, physics::Box{}), entity_with(3, physics::Box{})};
    GeometryTable table;
    const auto messages = entity_update_messages(
        previous, {std::make_shared<const EntityDescription>(box)}, table, EntityForm::complete);
    EXPECT_TRUE(messages.geometry.empty());
    ASSERT_EQ(messages.entity_updates.size(), 1u);
    const v1::EntityUpdate entity_update = parse(messages.entity_updates[0]).entity_update();
    ASSERT_EQ(entity_update.added_size(), 1);
    const v1::Entity& entity = entity_update.added(0);
    EXPECT_EQ(entity.id(), 9u);
    EXPECT_EQ(entity.type(), v1::BODY_TYPE_KINEMATIC);
    EXPECT_EQ(entity.owner(), 4u);
    EXPECT_EQ(entity.color(), 0xff8800u);
    EXPECT_EQ(entity.name(), "lift");
    EXPECT_EQ(entity.mass(), 12);
    EXPECT_EQ(entity.shapes(0).box().half_extents().z(), 3);
    EXPECT_EQ(entity.shapes(0).position().y(), 5);
    ASSERT_EQ(entity_update.removed_size(), 2);
    EXPECT_EQ(entity_update.removed(1), 3u);
}

// Motion properties for clients that simulate. Default values are not sent.
TEST(EntityUpdateMessage, contains_non_default_motion_properties) {
    EntityDescription plain = *entity_with(1, physics::Box{}),
                      odd = *entity_with(2, physics::Box{});
    odd.jointed = true;
    odd.linear_damping = 0.05;
    odd.angular_damping = 0.2;
    odd.gravity_scale = 0;
    odd.locks = physics::lock_x | physics::lock_rotation_y;
    odd.shapes.push_back(odd.shapes.front());
    odd.shapes[0].density = 100;
    odd.shapes[1].mass = 7;
    GeometryTable table;
    const auto messages = entity_update_messages({},
                                                 {std::make_shared<const EntityDescription>(plain),
                                                  std::make_shared<const EntityDescription>(odd)},
                                                 table, EntityForm::complete);
    const v1::EntityUpdate entity_update = parse(messages.entity_updates[0]).entity_update();
    EXPECT_EQ(entity_update.added(0).ByteSizeLong(), 37u)
        << "expected an id, a type and a box of three numbers";
    const v1::Entity& sent = entity_update.added(1);
    EXPECT_TRUE(sent.jointed());
    EXPECT_EQ(sent.linear_damping(), 0.05);
    EXPECT_EQ(sent.angular_damping(), 0.2);
    EXPECT_TRUE(sent.has_gravity_scale());
    EXPECT_EQ(sent.gravity_scale(), 0);
    EXPECT_TRUE(sent.locks().x() && sent.locks().turn_y() && !sent.locks().turn_x());
    EXPECT_EQ(sent.shapes(0).density(), 100);
    EXPECT_EQ(sent.shapes(1).mass(), 7);
}

TEST(EntityUpdateMessage, sends_a_shared_mesh_once) {
    const physics::Geometry mesh = mesh_of(100);  // 0.6 MB when serialized
    EntityList entities;
    for (EntityId id = 1; id <= 2000; id++) entities.push_back(entity_with(id, mesh));
    GeometryTable table;
    const auto messages = entity_update_messages({}, entities, table, EntityForm::complete);
    ASSERT_EQ(messages.geometry.size(), 1u);
    std::size_t bytes = 0;
    std::string content;
    for (const SharedBytes& part : messages.geometry[0]->messages) {
        EXPECT_LE(part->size(), chunk_bytes_max + 64);
        bytes += part->size();
        content += parse(part).geometry().data();
    }
    EXPECT_GT(messages.geometry[0]->messages.size(), 1u);
    for (const SharedBytes& entity_update : messages.entity_updates) bytes += entity_update->size();
    EXPECT_LT(bytes, 900'000u) << "2,000 copies would need about 1 GB";
    v1::Shape shape;
    ASSERT_TRUE(shape.ParseFromString(content));
    EXPECT_EQ(shape.mesh().vertices_size(), 101 * 101);
    EXPECT_EQ(parse(messages.entity_updates[0]).entity_update().added(7).shapes(0).geometry(),
              messages.geometry[0]->id);
}

TEST(EntityUpdateMessage, geometry_id_depends_on_content) {
    GeometryTable table;
    const EntityList entities{entity_with(1, mesh_of(10)), entity_with(2, mesh_of(10)),
                              entity_with(3, mesh_of(10, 1))};
    const auto messages = entity_update_messages({}, entities, table, EntityForm::complete);
    EXPECT_EQ(messages.geometry.size(), 2u);
    const v1::EntityUpdate entity_update = parse(messages.entity_updates[0]).entity_update();
    EXPECT_EQ(entity_update.added(0).shapes(0).geometry(),
              entity_update.added(1).shapes(0).geometry());
    EXPECT_NE(entity_update.added(0).shapes(0).geometry(),
              entity_update.added(2).shapes(0).geometry());
}

TEST(EntityUpdateMessage, inlines_small_shapes) {
    std::vector<physics::Vec3> points;
    for (int i = 0; i < 32; i++)
        points.push_back({std::cos(i * 0.7), i / 16.0 - 1, std::sin(i * 0.7)});
    GeometryTable table;
    const physics::Geometry hull = physics::Hull{physics::build_hull(points).value()};
    const auto messages =
        entity_update_messages({}, {entity_with(1, hull)}, table, EntityForm::complete);
    EXPECT_TRUE(messages.geometry.empty());
    EXPECT_GT(
        parse(messages.entity_updates[0]).entity_update().added(0).shapes(0).hull().points_size(),
        20);
}

TEST(EntityUpdateMessage, packs_20000_equal_boxes_into_six_bytes_each_or_less) {
    EntityList entities;
    for (EntityId id = 1; id <= 20'000; id++) entities.push_back(entity_with(id, physics::Box{}));
    GeometryTable table;
    const auto messages = entity_update_messages({}, entities, table, EntityForm::packed);
    std::size_t bytes = 0, sent = 0;
    for (const SharedBytes& message : messages.entity_updates) {
        bytes += message->size();
        const v1::EntityUpdate update = parse(message).entity_update();
        EXPECT_EQ(update.added_size(), 0);
        EXPECT_EQ(update.prototypes_size(), 1);
        EXPECT_EQ(update.prototypes(0).id(), 0u);
        const auto listed =
            snapshot::decode_entity_list(std::as_bytes(std::span(update.packed())), 1, 100'000);
        ASSERT_TRUE(listed.ok()) << listed.error().message;
        sent += listed->size();
    }
    EXPECT_EQ(sent, 20'000u);
    EXPECT_LE(bytes, 6u * 20'000);
    EXPECT_LE(bytes, 4'000u);  // a bit each, and a prototype in each message
}

TEST(EntityUpdateMessage, splits_long_lists_into_bounded_messages) {
    EntityList entities;
    for (EntityId id = 1; id <= 20'000; id++) entities.push_back(entity_with(id, physics::Box{}));
    GeometryTable table;
    const auto messages = entity_update_messages({}, entities, table, EntityForm::complete);
    EXPECT_GT(messages.entity_updates.size(), 2u);
    int sent = 0;
    for (const SharedBytes& bytes : messages.entity_updates) {
        EXPECT_LE(bytes->size(), chunk_bytes_max + 1024);
        sent += parse(bytes).entity_update().added_size();
    }
    EXPECT_EQ(sent, 20'000);
    EXPECT_TRUE(entity_update_messages(entities, entities, table, EntityForm::complete)
                    .entity_updates.empty());
}

}  // namespace
}  // namespace jostle::server

// SPDX-License-Identifier: MIT
#include "server/world/point_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace physics;
using testing::ElementsAre;
using testing::HasSubstr;

class PointObjectsTest : public testing::Test {
protected:
    const PointObjects& publish(const std::vector<PointObject>& objects) {
        publisher.begin(++tick);
        for (const PointObject& object : objects) {
            const Status added = publisher.add(world, 2, 0, object);
            if (!added.ok()) refused = added.error().message;
        }
        publisher.end();
        return *publisher.objects();
    }

    World world = World::create().value();
    PointObjectPublisher publisher;
    std::uint32_t tick = 0;
    std::string refused;
};

TEST_F(PointObjectsTest, quantizes_to_steps_and_counts_states) {
    std::vector<Vec3> points{{0.0014, -0.0016, 1e30}, {1, 2, 3}};
    const std::uint32_t strands[] = {2};
    const PointObject rope{
        .key = 5, .form = PointForm::strands, .positions = points, .strands = strands};
    const auto first = publish({rope})[0];
    EXPECT_THAT(first->values, ElementsAre(1, -2, point_coordinate_max, 1000, 2000, 3000));
    EXPECT_EQ(first->number, 1u);
    EXPECT_EQ(publish({rope})[0], first) << "an unchanged object keeps its state";
    points[1].x = 1.001;
    const auto third = publish({rope})[0];
    EXPECT_EQ(third->number, 2u);
    EXPECT_EQ(third->tick, 3u);
    EXPECT_EQ(third->object, first->object);
    EXPECT_TRUE(publish({}).empty()) << "an object that is not written has ended";
}

TEST_F(PointObjectsTest, change_of_connections_makes_a_new_object) {
    const std::vector<Vec3> points(6);
    const auto sheet = [&](std::size_t columns) {
        return PointObject{.form = PointForm::grid, .positions = points, .columns = columns};
    };
    const std::uint32_t id = publish({sheet(2)})[0]->object->id;
    EXPECT_EQ(publish({sheet(2)})[0]->object->id, id);
    const auto torn = publish({sheet(3)})[0];
    EXPECT_GT(torn->object->id, id);
    EXPECT_EQ(torn->number, 1u);
}

TEST_F(PointObjectsTest, loose_points_keep_their_numbers_in_any_order) {
    std::vector<Vec3> points{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    std::vector<std::uint32_t> ids{10, 20, 30};
    const auto now = [&] { return publish({{.step = 1, .positions = points, .ids = ids}})[0]; };
    EXPECT_THAT(now()->ids, ElementsAre(1, 2, 3));
    // The second point ends, another takes its place in the module's list.
    points = {{1, 0, 0}, {9, 0, 0}, {3, 0, 0}};
    ids = {10, 5, 30};
    const auto second = now();
    EXPECT_THAT(second->ids, ElementsAre(1, 3, 4));
    EXPECT_THAT(second->values, ElementsAre(1, 0, 0, 3, 0, 0, 9, 0, 0));
    // An id that returns is another point.
    ids = {10, 20, 30};
    EXPECT_THAT(now()->ids, ElementsAre(1, 3, 5));
}

TEST_F(PointObjectsTest, refuses_what_clients_would_reject) {
    const std::vector<Vec3> three(3), many(PointObject::points_max + 1);
    const std::uint32_t twice[] = {1, 2, 1}, corners[] = {0, 1, 3};
    EXPECT_TRUE(publish({{.positions = three, .ids = twice}}).empty());
    EXPECT_THAT(refused, HasSubstr("point object 0 has two points with the id 1"));
    publish({{.positions = many}});
    EXPECT_THAT(refused, HasSubstr("has 65537 points; at most 65536 are sent"));
    publish({{.form = PointForm::grid, .positions = three, .columns = 2}});
    EXPECT_THAT(refused, HasSubstr("3 points in 2 columns"));
    publish({{.form = PointForm::triangles, .positions = three, .triangles = corners}});
    EXPECT_THAT(refused, HasSubstr("corner 3 of 3 points"));
    publish({{.step = 0, .positions = three}});
    EXPECT_THAT(refused, HasSubstr("step"));
    EXPECT_EQ(publish({{.positions = three}, {.positions = three}}).size(), 1u);
    EXPECT_THAT(refused, HasSubstr("is published twice"));
}

TEST_F(PointObjectsTest, limits_the_points_of_a_world) {
    const std::vector<Vec3> full(PointObject::points_max);
    EXPECT_EQ(publish({{.key = 1, .positions = full},
                       {.key = 2, .positions = full},
                       {.key = 3, .positions = std::span(full).first(1)}})
                  .size(),
              2u);
    EXPECT_THAT(refused, HasSubstr("exceeds the 131072 points of a world"));
}

TEST_F(PointObjectsTest, bounds_heights_between_their_corners) {
    const std::vector<double> heights{0, 1, 2, 0, 0, 0};
    const auto state = publish({{.form = PointForm::heights,
                                 .columns = 3,
                                 .heights = heights,
                                 .origin = {10, 5, 0},
                                 .spacing_x = 2,
                                 .spacing_z = 1}})[0];
    EXPECT_THAT(state->values, ElementsAre(0, 1000, 2000, 0, 0, 0));
    EXPECT_EQ(state->center, (Vec3{12, 6, 0.5}));
    EXPECT_NEAR(state->reach, 0.5 * length({4, 2, 1}), 1e-12);
}

}  // namespace
}  // namespace jostle::server

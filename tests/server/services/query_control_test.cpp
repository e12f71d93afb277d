// SPDX-License-Identifier: MIT
//
// Queries of a running world: a shelf with known entities, queried in every way of the protocol.
#include "server/services/query_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/query.pb.h"
#include "tests/server/server_parts.h"
#include "tests/support/error_of.h"
#include "tests/support/wait_until.h"

namespace jostle::server {

using test::error_of;
using test::wait_until;

namespace {

// Entities 1 to 6. Nothing moves; dynamic bodies have no gravity.
constexpr const char* scene_json = R"({
  "name": "shelf",
  "world": {"gravity": {}},
  "bodies": [
    {"name": "floor", "type": "BODY_TYPE_STATIC",
     "shapes": [{"plane": {}}, {"box": {"halfExtents": {"x": 1, "y": 1, "z": 1}}, "position": {"x": 20, "y": 1}}]},
    {"name": "box", "position": {"y": 2},
     "shapes": [{"box": {"halfExtents": {"x": 1, "y": 1, "z": 1}}}]},
    {"name": "ball", "position": {"y": 6}, "shapes": [{"sphere": {"radius": 0.5}}]},
    {"name": "gate", "type": "BODY_TYPE_STATIC", "position": {"y": 8},
     "shapes": [{"box": {"halfExtents": {"x": 1, "y": 0.5, "z": 1}}, "trigger": true}]},
    {"name": "left", "position": {"x": -10, "y": 5}, "shapes": [{"sphere": {"radius": 0.5}, "filter": {"category": 4}}]},
    {"name": "right", "position": {"x": -8, "y": 5}, "shapes": [{"sphere": {"radius": 0.5}}]}],
  "joints": [{"name": "rod", "bodyA": "left", "bodyB": "right", "frameA": {}, "frameB": {}, "distance": {"minLength": 2, "maxLength": 2}}]
})";
constexpr EntityId floor = 1, box = 2, ball = 3, gate = 4, left = 5, right = 6;

class QueryControlTest : public testing::Test, protected ServerParts {
protected:
    QueryControlTest() : ServerParts(10, 2) {}
    void SetUp() override {
        const auto scene = scenes::read_scene_json(scene_json);
        ASSERT_TRUE(scene.ok()) << scene.error().message;
        ASSERT_TRUE(worlds.create("", *scene).ok());
    }
    static void add_ray(v1::CastRaysRequest& request, physics::Vec3 from, physics::Vec3 motion) {
        v1::Ray& ray = *request.add_rays();
        ray.mutable_origin()->set_x(from.x);
        ray.mutable_origin()->set_y(from.y);
        ray.mutable_origin()->set_z(from.z);
        ray.mutable_motion()->set_x(motion.x);
        ray.mutable_motion()->set_y(motion.y);
        ray.mutable_motion()->set_z(motion.z);
    }
    // A ray straight down from 10 m through all entities at x = 0.
    static v1::CastRaysRequest down(v1::HitMode mode = v1::HIT_MODE_CLOSEST) {
        v1::CastRaysRequest request;
        add_ray(request, {0, 10, 0}, {0, -20, 0});
        request.set_mode(mode);
        return request;
    }
    v1::CastRaysResponse cast(const v1::CastRaysRequest& request) const {
        v1::CastRaysResponse response;
        const Status status = queries.cast_rays(request, response);
        EXPECT_TRUE(status.ok()) << status.error().message;
        return response;
    }
    static std::vector<EntityId> entities(const v1::Hits& hits) {
        std::vector<EntityId> out;
        for (const v1::Hit& hit : hits.hits()) out.push_back(hit.entity());
        return out;
    }

    QueryControl queries{context};
};

using Ids = std::vector<EntityId>;

TEST_F(QueryControlTest, ray_hits_box_top_at_the_expected_fraction) {
    v1::CastRaysRequest request;
    add_ray(request, {0.5, 10, 0.25}, {0, -20, 0});  // misses the top of the ball and hits the box
    request.mutable_filter()->set_ignore(ball);
    const v1::CastRaysResponse response = cast(request);
    ASSERT_EQ(response.rays_size(), 1);
    ASSERT_EQ(entities(response.rays(0)), Ids{box});
    const v1::Hit& hit = response.rays(0).hits(0);
    EXPECT_NEAR(hit.fraction(), 7.0 / 20, 1e-9);
    EXPECT_NEAR(hit.point().y(), 3, 1e-9);
    EXPECT_NEAR(hit.point().x(), 0.5, 1e-9);
    EXPECT_NEAR(hit.normal().y(), 1, 1e-9);
    EXPECT_GT(response.tick(), 0u);
    EXPECT_LE(response.tick(), worlds.find("")->frame()->tick);
}

TEST_F(QueryControlTest, returns_all_hits_sorted_by_distance) {
    const v1::CastRaysResponse response = cast(down(v1::HIT_MODE_ALL));
    EXPECT_EQ(entities(response.rays(0)), (Ids{ball, box, floor}));
    EXPECT_NEAR(response.rays(0).hits(0).fraction(), 3.5 / 20, 1e-9);
    EXPECT_NEAR(response.rays(0).hits(1).fraction(), 7.0 / 20, 1e-9);
    EXPECT_NEAR(response.rays(0).hits(2).fraction(), 10.0 / 20, 1e-9);
}

TEST_F(QueryControlTest, filter_ignores_entity_includes_triggers_and_selects_categories) {
    v1::CastRaysRequest request = down(v1::HIT_MODE_ALL);
    request.mutable_filter()->set_ignore(box);
    EXPECT_EQ(entities(cast(request).rays(0)), (Ids{ball, floor}));
    request.mutable_filter()->set_ignore(999);
    request.mutable_filter()->set_include_triggers(true);
    EXPECT_EQ(entities(cast(request).rays(0)), (Ids{gate, ball, box, floor}));
    v1::CastRaysRequest sideways;
    add_ray(sideways, {-20, 5, 0}, {20, 0, 0});
    EXPECT_EQ(entities(cast(sideways).rays(0)), Ids{left});
    sideways.mutable_filter()->set_categories(1);
    EXPECT_EQ(entities(cast(sideways).rays(0)), Ids{right}) << "left belongs to category 4";
    sideways.mutable_filter()->set_categories(0);
    EXPECT_EQ(entities(cast(sideways).rays(0)), Ids{})
        << "explicitly empty categories must differ from absent ones";
}

TEST_F(QueryControlTest, returns_one_result_per_ray_and_entity_only_for_any_hit) {
    v1::CastRaysRequest request = down(v1::HIT_MODE_ANY);
    add_ray(request, {0, 10, 0}, {0, 20, 0});
    add_ray(request, {20, 10, 0}, {0, -20, 0});
    v1::CastRaysResponse response = cast(request);
    ASSERT_EQ(response.rays_size(), 3);
    ASSERT_EQ(response.rays(0).hits_size(), 1);
    EXPECT_NE(response.rays(0).hits(0).entity(), 0u);
    EXPECT_FALSE(response.rays(0).hits(0).has_point());
    EXPECT_EQ(response.rays(1).hits_size(), 0) << "there is nothing above";
    request.set_mode(v1::HIT_MODE_UNSPECIFIED);
    response = cast(request);
    EXPECT_EQ(entities(response.rays(2)), Ids{floor});
    EXPECT_EQ(response.rays(2).hits(0).shape(), 1u) << "the second shape of the floor";
}

TEST_F(QueryControlTest, casts_a_sphere_onto_a_box) {
    v1::CastShapesRequest request;
    v1::MovingShape& moving = *request.add_shapes();
    moving.mutable_shape()->mutable_sphere()->set_radius(0.25);
    moving.mutable_shape()->mutable_position()->set_y(5);
    moving.mutable_motion()->set_y(-10);
    v1::CastShapesResponse response;
    ASSERT_TRUE(queries.cast_shapes(request, response).ok());
    ASSERT_EQ(entities(response.shapes(0)), Ids{box});
    EXPECT_NEAR(response.shapes(0).hits(0).fraction(), 0.175, 1e-5);  // (5 - 0.25 - 3) / 10
    request.set_mode(v1::HIT_MODE_ALL);
    response.Clear();
    ASSERT_TRUE(queries.cast_shapes(request, response).ok());
    EXPECT_EQ(entities(response.shapes(0)), (Ids{box, floor}));
    request.set_mode(v1::HIT_MODE_ANY);
    const Error any = error_of(queries.cast_shapes(request, response));
    EXPECT_EQ(any.code, ErrorCode::invalid_argument);
    EXPECT_NE(any.message.find("mode is 2"), std::string::npos) << any.message;
}

TEST_F(QueryControlTest, overlap_returns_entities_touching_a_shape_or_containing_a_point) {
    v1::OverlapRequest request;
    request.mutable_shape()->mutable_box()->mutable_half_extents()->set_x(0.1);
    request.mutable_shape()->mutable_box()->mutable_half_extents()->set_y(2);
    request.mutable_shape()->mutable_box()->mutable_half_extents()->set_z(0.1);
    request.mutable_shape()->mutable_position()->set_y(4);
    v1::OverlapResponse response;
    ASSERT_TRUE(queries.overlap(request, response).ok());
    EXPECT_EQ(Ids(response.entities().begin(), response.entities().end()), (Ids{box, ball}));
    request.mutable_point()->set_x(20);
    request.mutable_point()->set_y(0.5);
    response.Clear();
    ASSERT_TRUE(queries.overlap(request, response).ok());
    EXPECT_EQ(Ids(response.entities().begin(), response.entities().end()), Ids{floor});
    request.mutable_point()->set_y(-0.5);
    response.Clear();
    ASSERT_TRUE(queries.overlap(request, response).ok());
    EXPECT_EQ(response.entities_size(), 1)
        << "an entity with two overlapping shapes must be listed once";
    request.clear_what();
    EXPECT_EQ(error_of(queries.overlap(request, response)).message, "give shape or point");
}

TEST_F(QueryControlTest, returns_closest_point_with_distance_or_no_entity) {
    v1::ClosestPointsRequest request;
    request.add_points()->set_y(9);
    request.add_points()->set_y(2);
    request.add_points()->set_y(500);
    request.set_max_distance(4);
    v1::ClosestPointsResponse response;
    ASSERT_TRUE(queries.closest_points(request, response).ok());
    ASSERT_EQ(response.points_size(), 3);
    EXPECT_EQ(response.points(0).entity(), ball);
    EXPECT_NEAR(response.points(0).distance(), 2.5, 1e-6);
    EXPECT_NEAR(response.points(0).point().y(), 6.5, 1e-6);
    EXPECT_EQ(response.points(1).entity(), box);
    EXPECT_NEAR(response.points(1).distance(), -1, 1e-6)
        << "the point is inside, 1 m from the surface";
    EXPECT_EQ(response.points(2).entity(), 0u);
}

TEST_F(QueryControlTest, debug_returns_only_requested_layers) {
    v1::DebugRequest request;
    v1::DebugResponse response;
    EXPECT_EQ(error_of(queries.debug(request, response)).code, ErrorCode::invalid_argument);
    request.set_bounds(true);
    request.set_joints(true);
    ASSERT_TRUE(queries.debug(request, response).ok());
    EXPECT_EQ(response.bounds_size(), 6) << "planes have no bounding box";
    ASSERT_EQ(response.joints_size(), 1);
    EXPECT_EQ(response.joints(0).entity_a(), left);
    EXPECT_EQ(response.joints(0).entity_b(), right);
    EXPECT_NEAR(response.joints(0).anchor_b().x(), -8, 1e-6);
    EXPECT_EQ(response.joints(0).kind(), "distance");
    EXPECT_EQ(response.broad_phase_size() + response.islands_size() + response.contacts_size(), 0);
    EXPECT_FALSE(response.truncated());
    request.Clear();
    response.Clear();
    request.set_broad_phase(true);
    request.set_islands(true);
    ASSERT_TRUE(queries.debug(request, response).ok());
    EXPECT_GT(response.broad_phase_size(), 0);
    bool pair_is_there = false;
    for (const v1::DebugIsland& island : response.islands())
        pair_is_there |=
            Ids(island.entities().begin(), island.entities().end()) == Ids{left, right};
    EXPECT_TRUE(pair_is_there) << "a joint must connect two bodies to one island";
    EXPECT_EQ(response.bounds_size(), 0);
}

TEST_F(QueryControlTest, truncates_debug_layers_to_20000_items_and_reports_it) {
    scenes::SceneDescription scene;
    scene.name = "dust";
    scene.world.gravity = {};
    scene.hz = 20;
    physics::ShapeDef grain;
    grain.geometry = physics::Sphere{0.01};
    for (int row = 0; row < 1025; row++) {
        scene.bodies.push_back({.name = "row", .body = {.type = physics::BodyType::static_body}});
        for (int i = 0; i < 20; i++) {
            grain.pose.position = {i * 1.0, row * 1.0, 0};
            scene.bodies.back().shapes.push_back(grain);
        }
    }
    ASSERT_TRUE(worlds.create("dust", scene).ok());
    v1::DebugRequest request;
    request.set_world("dust");
    request.set_bounds(true);
    v1::DebugResponse response;
    const Status status = queries.debug(request, response);
    ASSERT_TRUE(status.ok()) << status.error().message;
    EXPECT_EQ(response.bounds_size(), 20000);
    EXPECT_TRUE(response.truncated());
}

TEST_F(QueryControlTest, rejects_oversized_requests_and_names_the_limit) {
    v1::CastRaysRequest rays;
    for (int i = 0; i < 1001; i++) add_ray(rays, {}, {0, 1, 0});
    v1::CastRaysResponse ray_hits;
    Error error = error_of(queries.cast_rays(rays, ray_hits));
    EXPECT_EQ(error.code, ErrorCode::invalid_argument);
    EXPECT_EQ(error.message, "rays has 1001 entries; at most 1000 are allowed");
    v1::CastShapesRequest shapes;
    for (int i = 0; i < 101; i++) shapes.add_shapes();
    v1::CastShapesResponse shape_hits;
    error = error_of(queries.cast_shapes(shapes, shape_hits));
    EXPECT_EQ(error.message, "shapes has 101 entries; at most 100 are allowed");
    v1::ClosestPointsRequest points;
    for (int i = 0; i < 1001; i++) points.add_points();
    v1::ClosestPointsResponse nearest;
    error = error_of(queries.closest_points(points, nearest));
    EXPECT_EQ(error.message, "points has 1001 entries; at most 1000 are allowed");
}

TEST_F(QueryControlTest, rejects_oversized_responses) {
    scenes::SceneDescription scene;
    scene.name = "row";
    physics::ShapeDef grain;
    grain.geometry = physics::Sphere{0.1};
    scene.bodies.push_back({.name = "row", .body = {.type = physics::BodyType::static_body}});
    for (int i = 0; i < 100; i++) {
        grain.pose.position = {i * 1.0, 0, 0};
        scene.bodies[0].shapes.push_back(grain);
    }
    ASSERT_TRUE(worlds.create("row", scene).ok());
    v1::CastRaysRequest request;
    request.set_world("row");
    request.set_mode(v1::HIT_MODE_ALL);
    for (int i = 0; i < 501; i++) add_ray(request, {-1, 0, 0}, {200, 0, 0});
    v1::CastRaysResponse response;
    const Error error = error_of(queries.cast_rays(request, response));
    EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
    EXPECT_NE(error.message.find("50000 hits"), std::string::npos) << error.message;
}

TEST_F(QueryControlTest, rejects_invalid_numbers_by_field) {
    const auto refusal = [&](auto method, const auto& request, auto response) {
        const Error error = error_of((queries.*method)(request, response, QueryControl::always));
        EXPECT_EQ(error.code, ErrorCode::invalid_argument) << error.message;
        return error.message;
    };
    v1::CastRaysRequest ray = down();
    ray.mutable_rays(0)->mutable_origin()->set_z(std::nan(""));
    EXPECT_EQ(refusal(&QueryControl::cast_rays, ray, v1::CastRaysResponse()),
              "rays[0].origin.z is nan; it must be from -1e+07 to 1e+07");
    ray.mutable_rays(0)->clear_origin();
    ray.mutable_rays(0)->mutable_motion()->set_y(std::numeric_limits<double>::infinity());
    EXPECT_EQ(refusal(&QueryControl::cast_rays, ray, v1::CastRaysResponse()),
              "rays[0].motion.y is inf; it must be from -1e+07 to 1e+07");
    ray.mutable_rays(0)->clear_motion();
    EXPECT_EQ(refusal(&QueryControl::cast_rays, ray, v1::CastRaysResponse()),
              "rays[0].motion is zero; it must have a length");
    ray = down(static_cast<v1::HitMode>(9));
    EXPECT_EQ(refusal(&QueryControl::cast_rays, ray, v1::CastRaysResponse()),
              "mode is 9; it must be a HitMode from 0 to 3");

    v1::CastShapesRequest cast;
    cast.add_shapes()->mutable_shape()->mutable_mesh();
    EXPECT_EQ(
        refusal(&QueryControl::cast_shapes, cast, v1::CastShapesResponse()),
        "shapes[0].shape is a mesh; it must be a sphere, capsule, box, cylinder, cone or hull");
    cast.mutable_shapes(0)->mutable_shape()->mutable_sphere()->set_radius(-1);
    EXPECT_NE(refusal(&QueryControl::cast_shapes, cast, v1::CastShapesResponse())
                  .find("shapes[0].shape.sphere.radius"),
              std::string::npos);
    for (int i = 0; i < 1001; i++)
        cast.mutable_shapes(0)->mutable_shape()->mutable_hull()->add_points();
    EXPECT_EQ(refusal(&QueryControl::cast_shapes, cast, v1::CastShapesResponse()),
              "shapes[0].shape.hull.points has 1001 entries; at most 1000 are allowed");
    v1::OverlapRequest overlap;
    overlap.mutable_shape();
    EXPECT_EQ(refusal(&QueryControl::overlap, overlap, v1::OverlapResponse()),
              "shape is empty; it must be a sphere, capsule, box, cylinder, cone or hull");
    v1::ClosestPointsRequest closest;
    closest.set_max_distance(-1);
    EXPECT_EQ(refusal(&QueryControl::closest_points, closest, v1::ClosestPointsResponse()),
              "max_distance is -1; it must be from 0 to 1e+07");
}

TEST_F(QueryControlTest, returns_unavailable_for_stopped_and_not_found_for_missing_worlds) {
    EXPECT_EQ(cast(down()).rays_size(), 1);
    worlds.find("")->stop();
    v1::CastRaysResponse response;
    Error error = error_of(queries.cast_rays(down(), response));
    EXPECT_EQ(error.code, ErrorCode::unavailable);
    EXPECT_EQ(error.message, "the world was closed");
    v1::CastRaysRequest elsewhere = down();
    elsewhere.set_world("elsewhere");
    error = error_of(queries.cast_rays(elsewhere, response));
    EXPECT_EQ(error.code, ErrorCode::not_found);
    EXPECT_EQ(error.message, "there is no world \"elsewhere\"");
}

TEST_F(QueryControlTest, inspects_a_body_with_its_contacts_and_joints) {
    const auto inspect = [&](auto set) {
        v1::InspectRequest request;
        set(request);
        v1::InspectResponse response;
        const Status status = queries.inspect(request, response);
        EXPECT_TRUE(status.ok()) << status.error().message;
        return response;
    };
    const auto body_of = [&](EntityId id, const char* world = "") {
        return inspect([&](v1::InspectRequest& request) {
                   request.set_entity(id);
                   request.set_world(world);
               })
            .body();
    };
    const v1::InspectedBody body = body_of(box);
    EXPECT_EQ(body.entity(), box);
    EXPECT_GT(body.mass(), 0);
    EXPECT_NEAR(body.inertia_x().x(), body.mass() * (4 + 4) / 12, 1e-6) << "a cube of 2 m";
    EXPECT_NEAR(body.inertia_x().y(), 0, 1e-9);
    EXPECT_EQ(body.materials_size(), 1);
    EXPECT_EQ(body.materials(0).friction(), 0.5);
    EXPECT_EQ(body.island(), box);
    EXPECT_EQ(body.island_bodies(), 1u);
    EXPECT_EQ(body.contact_count(), 0u);

    ASSERT_TRUE(worlds.create("stack", *scenes::find_scene("stack")).ok());
    constexpr EntityId lowest = 2;  // of the stack of ten boxes on entity 1
    ASSERT_TRUE(wait_until([&] { return body_of(lowest, "stack").contacts_size() == 2; }));
    const v1::InspectedBody stacked = body_of(lowest, "stack");
    EXPECT_EQ(stacked.island(), lowest);
    EXPECT_EQ(stacked.island_bodies(), 10u);
    for (const v1::InspectedContact& contact : stacked.contacts()) {
        EXPECT_NEAR(contact.normal().y(), contact.entity() == 1 ? -1 : 1, 1e-3)
            << "from the box to entity " << contact.entity();
        EXPECT_EQ(contact.points_size(), 4);
    }

    const v1::InspectedBody jointed = body_of(left);
    ASSERT_EQ(jointed.joints_size(), 1);
    const v1::InspectedJoint& rod = jointed.joints(0);
    EXPECT_EQ(rod.entity_a(), left);
    EXPECT_EQ(rod.entity_b(), right);
    EXPECT_NEAR(rod.coordinate(), 2, 1e-2);
    EXPECT_EQ(rod.joint().kind_case(), v1::Joint::kDistance);
    const v1::InspectResponse alone =
        inspect([&](v1::InspectRequest& request) { request.set_joint(rod.id()); });
    EXPECT_EQ(alone.joint().id(), rod.id());
    EXPECT_GT(alone.tick(), 0u);
}

TEST_F(QueryControlTest, inspect_refuses_unknown_targets) {
    const auto refused = [&](auto set) {
        v1::InspectRequest request;
        set(request);
        v1::InspectResponse response;
        return error_of(queries.inspect(request, response));
    };
    EXPECT_EQ(refused([](v1::InspectRequest&) {}).code, ErrorCode::invalid_argument);
    EXPECT_EQ(refused([](v1::InspectRequest& r) { r.set_entity(999); }).message,
              "entity 999 does not exist");
    EXPECT_EQ(refused([](v1::InspectRequest& r) { r.set_joint(999); }).message,
              "joint 999 does not exist");
    EXPECT_EQ(refused([](v1::InspectRequest& r) { r.set_world("none"), r.set_entity(1); }).code,
              ErrorCode::not_found);
}

class QueryDeformablesTest : public testing::Test, protected ServerParts {
protected:
    QueryDeformablesTest() : ServerParts(10, 2) {}
    void SetUp() override { ASSERT_TRUE(worlds.create("", *scenes::find_scene("flag")).ok()); }

    QueryControl queries{context};
};

// The flag is 1.8 m long and 1.2 m high; its upper corner is at (0, 4.9, 0).
TEST_F(QueryDeformablesTest, all_queries_find_a_flag_if_they_ask_for_deformables) {
    v1::CastRaysRequest rays;
    v1::CastShapesRequest shapes;
    v1::OverlapRequest overlap;
    v1::ClosestPointsRequest points;
    v1::ClosestPointsResponse closest;
    points.set_max_distance(100);
    points.add_points()->set_y(4.3);
    points.mutable_points(0)->set_x(0.6);
    points.mutable_filter()->set_include_deformables(true);
    ASSERT_TRUE(queries.closest_points(points, closest).ok());
    const std::uint32_t flag = closest.points(0).object();
    ASSERT_NE(flag, 0u) << closest.DebugString();
    const v1::Vec3& at = closest.points(0).point();

    v1::Ray& ray = *rays.add_rays();
    *ray.mutable_origin() = at;
    ray.mutable_origin()->set_z(at.z() + 1);
    ray.mutable_motion()->set_z(-2);
    v1::MovingShape& moving = *shapes.add_shapes();
    moving.mutable_shape()->mutable_sphere()->set_radius(0.1);
    *moving.mutable_shape()->mutable_position() = ray.origin();
    *moving.mutable_motion() = ray.motion();
    *overlap.mutable_shape() = moving.shape();
    *overlap.mutable_shape()->mutable_position() = at;
    for (const bool wanted : {false, true}) {
        rays.mutable_filter()->set_include_deformables(wanted);
        shapes.mutable_filter()->set_include_deformables(wanted);
        overlap.mutable_filter()->set_include_deformables(wanted);
        v1::CastRaysResponse along_rays;
        v1::CastShapesResponse along_shapes;
        v1::OverlapResponse inside;
        ASSERT_TRUE(queries.cast_rays(rays, along_rays).ok());
        ASSERT_TRUE(queries.cast_shapes(shapes, along_shapes).ok());
        ASSERT_TRUE(queries.overlap(overlap, inside).ok());
        const auto objects = [](const v1::Hits& hits) {
            std::vector<std::uint32_t> found;
            for (const v1::Hit& hit : hits.hits())
                if (hit.object() != 0) found.push_back(hit.object());
            return found;
        };
        const Ids expected = wanted ? Ids{flag} : Ids{};
        EXPECT_EQ(objects(along_rays.rays(0)), expected);
        EXPECT_EQ(objects(along_shapes.shapes(0)), expected);
        EXPECT_EQ(Ids(inside.objects().begin(), inside.objects().end()), expected);
    }
}

}  // namespace
}  // namespace jostle::server

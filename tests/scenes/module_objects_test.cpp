// SPDX-License-Identifier: MIT
//
// The modules that come with Jostle in scene files: lists of objects with ranges, and errors with
// line and field.
#include "scenes/src/module_objects.h"

#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <memory>

#include "jostle/modules/cloth.h"
#include "jostle/modules/crowd.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/fields.h"
#include "jostle/modules/fracture_file.h"
#include "jostle/modules/particles.h"
#include "jostle/modules/rope.h"
#include "jostle/modules/vehicle.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/scene.pb.h"
#include "scenes/src/module_message.h"

namespace jostle::scenes {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string with_modules(const std::string& modules) {
    return R"({
  "name": "test",
  "bodies": [
    {"name": "floor", "type": "BODY_TYPE_STATIC", "shapes": [{"plane": {}}]},
    {"name": "car", "type": "BODY_TYPE_DYNAMIC", "position": {"y": 1},
     "shapes": [{"box": {"half_extents": {"x": 0.8, "y": 0.3, "z": 2}}}]},
    {"name": "car", "type": "BODY_TYPE_DYNAMIC", "position": {"x": 9, "y": 1},
     "shapes": [{"box": {"half_extents": {"x": 0.8, "y": 0.3, "z": 2}}}]}
  ],
  "modules": [
)" + modules +
           "\n  ]\n}\n";
}

std::string error_of(const std::string& modules) {
    const auto scene = read_scene_json(with_modules(modules));
    if (!scene.ok()) return scene.error().message;
    const auto built = build_scene(*scene);
    return built.ok() ? "" : built.error().message;
}

TEST(ModuleObjects, two_cars_have_independent_wheels) {
    const auto scene = read_scene_json(with_modules(R"({"vehicle": {"cars": [
      {"body": "car", "radius": 0.3, "cast": "WHEEL_CAST_RAY"},
      {"body": "car[1]", "radius": 0.5}
    ]}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->modules[0].tag, "vehicle") << "the tag is implied";
    const auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* cars = dynamic_cast<const modules::Vehicles*>(built->world.module("vehicle"));
    ASSERT_EQ(cars->cars().size(), 2u);
    const auto wheel = [&](std::size_t car) { return cars->def(cars->cars()[car])->wheels[0]; };
    EXPECT_EQ(wheel(0).radius, 0.3);
    EXPECT_EQ(wheel(1).radius, 0.5);
    const auto cast = [&](std::size_t car) { return cars->def(cars->cars()[car])->cast; };
    EXPECT_NE(cast(0), cast(1));
}

// A pre-fractured shape is placed in the scene, and an error in it is reported with its line and
// chunk.
TEST(ModuleObjects, prefractured_shape_is_placed_in_the_scene) {
    modules::FracturedShape wall =
        modules::fracture_box({2, 1, 0.1}, modules::random_seeds({2, 1, 0.1}, 20, 1)).value();
    modules::anchor(wall, {0, -1, 0}, 0.999);
    std::vector<std::byte> file = modules::write_fracture(wall).value();
    const auto scene_with = [](const std::vector<std::byte>& bytes) {
        SceneDescription scene;
        scene.name = "test";
        SceneModule::ModuleObject thing{.list = "fractured", .settings = {}, .bodies = {}};
        thing.settings = {{"x", 5}, {"y", 1}, {"heading", 1.5}, {"tensile", 2e6}};
        thing.bytes["shape"] = bytes;
        scene.modules.push_back(
            {.tag = "destruction", .settings = {}, .bodies = {}, .objects = {thing}, .state = {}});
        return write_scene_json(scene);
    };
    const auto scene = read_scene_json(scene_with(file));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->modules[0].objects[0].bytes.at("shape"), file);
    const auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* destruction =
        dynamic_cast<const modules::Destruction*>(built->world.module("destruction"));
    EXPECT_EQ(destruction->intact_bonds({0, 1}).value(), wall.bonds.size());
    const physics::BodyId body = destruction->bodies({0, 1}).value()[0];
    EXPECT_EQ(built->world.body(body)->pose.position.x, 5);

    file[200] = std::byte(~std::to_integer<unsigned>(file[200]) & 0xff);
    const auto wrong = read_scene_json(scene_with(file));
    ASSERT_FALSE(wrong.ok());
    EXPECT_THAT(wrong.error().message, HasSubstr("line "));
    EXPECT_THAT(wrong.error().message, HasSubstr("modules[0].destruction.fractured[0].shape"));
    EXPECT_THAT(wrong.error().message, HasSubstr("checksum"));
    EXPECT_THAT(error_of(R"({"destruction": {"fractured": [{"x": 1}]}})"),
                HasSubstr("fractured[0].shape"));
}

TEST(ModuleObjects, supports_several_winds_and_waters_in_separate_volumes) {
    const auto scene = read_scene_json(with_modules(R"({"fields": {
      "turbulences": [{"wind": {"x": 5}}, {"speed": 2, "volume": {"center": {"y": 9}, "half_y": 4}}],
      "waters": [{"level": -3, "waves": [{"amplitude": 0.2, "length": 8}, {"amplitude": 0.1}]}],
      "blasts": [{"time": 1, "center": {"y": 2}}]
    }})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* fields = dynamic_cast<const modules::Fields*>(built->world.module("fields"));
    EXPECT_EQ(fields->charges().size(), 1u);
    EXPECT_EQ(scene->modules[0].objects.size(), 4u);
    EXPECT_EQ(scene->modules[0].objects[2].settings.at("wave2_amplitude"), 0.1);
    EXPECT_EQ(scene->modules[0].objects[1].settings.at("turbulence_half_y"), 4);
}

TEST(ModuleObjects, errors_name_line_and_field) {
    EXPECT_EQ(error_of(R"({"vehicle": {"cars": [{"body": "car"},
        {"body": "car[1]", "radius": 99}]}})"),
              "line 12, column 38: modules[0].vehicle.cars[1].radius: 99 is out of range; it must "
              "be from "
              "0.02 to 10");
    EXPECT_EQ(
        error_of(R"({"vehicle": {"cars": [{"body": "cart"}]}})"),
        "line 11, column 32: modules[0].vehicle.cars[0].body: is \"cart\"; no body has the name "
        "\"cart\"");
    EXPECT_EQ(error_of(R"({"vehicle": {"cars": []}})"),
              "line 11, column 22: modules[0].vehicle.cars: has 0 items; it must have 1 to 1000");
    EXPECT_THAT(error_of(R"({"vehicle": {"cars": [{"colour": 1}]}})"),
                HasSubstr("line 11, column 34: modules[0].vehicle.cars[0]"));
    EXPECT_EQ(error_of(R"({"tag": "fields", "vehicle": {"cars": [{"body": "car"}]}})"),
              "line 11, column 9: modules[0].tag: is \"fields\", but its objects belong to "
              "\"vehicle\"; remove "
              "the tag");
    EXPECT_THAT(error_of(R"({"vehicle": {"cars": [{"body": "car"}, {"body": "car"}]}})"),
                HasSubstr("modules[0] 'vehicle': cars[1]: "))
        << "detected by the module: a body belongs to one car";
    EXPECT_THAT(error_of(R"({"vehicle": {"cars": [{"body": "car", "cast": 7}]}})"),
                HasSubstr("modules[0].vehicle.cars[0].cast"));
}

TEST(ModuleObjects, particles_are_created_and_errors_name_line_and_field) {
    const auto scene = read_scene_json(with_modules(R"({"particles": {"groups": [
      {"integrator": "PARTICLE_INTEGRATOR_IMPLICIT_EULER", "radius": 0.1, "emitter": {"rate": 60, "shape": "EMITTER_SHAPE_SPHERE"},
       "attractors": [{"falloff": -1, "strength": 2}],
       "particles": [{"position": {"y": 2}}, {"position": {"y": 3}}], "springs": [{"from": 1, "to": 1}, {"anchor": {"y": 4}}]}
    ]}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* particles =
        dynamic_cast<const modules::Particles*>(built->world.module("particles"));
    ASSERT_EQ(particles->groups().size(), 1u);
    const modules::ParticleGroup& group = *particles->group(particles->groups()[0]);
    EXPECT_EQ(group.def().attractors[0].falloff, -1);
    EXPECT_EQ(group.springs().size(), 2u);
    for (int k = 0; k < 30; k++) ASSERT_TRUE(built->world.step(1.0 / 60).ok());
    EXPECT_EQ(group.size(), 32u);
    EXPECT_EQ(error_of(R"({"particles": {"groups": [{}, {"emitter":
        {"cone": 4}}]}})"),
              "line 12, column 18: modules[0].particles.groups[1].emitter.cone: 4 is out of range; "
              "it must be from 0 to 3.14159265");
    EXPECT_EQ(error_of(R"({"particles": {"groups": []}})"),
              "line 11, column 26: modules[0].particles.groups: has 0 items; it must have 1 to 64");
    EXPECT_THAT(error_of(R"({"particles": {"groups": [{"planes": [{"normal": {}}]}]}})"),
                HasSubstr("groups[0]: planes[0].normal has the length 0"));
    EXPECT_THAT(
        error_of(
            R"({"particles": {"groups": [{"particles": [{"lifetime": 1}], "springs": [{"to": 0}, {"from": 9}]}]}})"),
        HasSubstr("groups[0]: springs[1] is out of range"));
    EXPECT_THAT(
        error_of(R"({"particles": {"groups": [{"attractors": [{"falloff": 5}]}]}})"),
        HasSubstr("modules[0].particles.groups[0].attractors[0].falloff: 5 is out of range"));
}

TEST(ModuleObjects, round_trips) {
    const auto scene = read_scene_json(with_modules(R"({"fields": {
      "turbulences": [{"wind": {"x": 5, "z": -1}, "octaves": 3}],
      "waters": [{"level": -3, "waves": [{"amplitude": 0.2, "length": 8}], "volume": {"half_x": 3}}],
      "centers": [{"body": "car[1]", "perMass": true}]
    }}, {"destruction": {"walls": [{"count": 2, "chunks": 20, "x": -20}, {"chunks": 10, "z": 30}]}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto again = read_scene_json(write_scene_json(*scene));
    ASSERT_TRUE(again.ok()) << again.error().message;
    for (std::size_t m = 0; m < 2; m++) {
        const auto &a = scene->modules[m].objects, &b = again->modules[m].objects;
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); k++) {
            EXPECT_EQ(a[k].list, b[k].list);
            EXPECT_EQ(a[k].settings, b[k].settings);
            EXPECT_EQ(a[k].bodies, b[k].bodies);
        }
    }
    const auto built = build_scene(*again);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* walls =
        dynamic_cast<const modules::Destruction*>(built->world.module("destruction"));
    EXPECT_EQ(walls->size(), 3u);
}

// For every number of every message, the module has the setting and accepts both ends of its range,
// unless it requires other settings.
TEST(ModuleObjects, every_field_maps_to_a_known_module_setting) {
    register_catalog_modules();
    const auto& choice = *v1::Module::descriptor()->FindOneofByName("objects");
    int settings = 0;
    for (int m = 0; m < choice.field_count(); m++) {
        const auto& kind = *choice.field(m);
        for (int l = 0; l < kind.message_type()->field_count(); l++) {
            const auto& list = *kind.message_type()->field(l);
            for (int f = 0; f < list.message_type()->field_count(); f++) {
                const auto& field = *list.message_type()->field(f);
                if (field.cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE ||
                    field.cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_STRING)
                    continue;
                for (const bool high : {false, true}) {
                    const auto& range = field.options().GetExtension(v1::range);
                    const bool counts = !field.options().HasExtension(v1::range);
                    const double last =
                        field.enum_type() ? field.enum_type()->value_count() - 2 : 1;
                    const double value =
                        counts ? (high ? last : 0) : (high ? range.high() : range.low());
                    const std::string named = field.options().GetExtension(v1::setting);
                    const std::string name = named.empty() ? field.name() : named;
                    physics::World world;
                    auto module = physics::make_module(kind.name()).value();
                    physics::ModuleSettings given;
                    given.numbers.emplace_back(name, value);
                    const auto status = module->configure(world, given);
                    const std::string what = status.ok() ? "" : status.error().message;
                    EXPECT_EQ(what.find("unknown setting"), std::string::npos)
                        << kind.name() << ": " << what;
                    EXPECT_EQ(what.find(name + " is "), std::string::npos)
                        << kind.name() << " rejects an end of the range: " << what;
                    settings++;
                }
            }
        }
    }
    RecordProperty("settings", settings / 2);
    EXPECT_GT(settings, 120);
}

TEST(ModuleObjects, crowd_has_goals_walls_groups_and_agents) {
    const auto scene = read_scene_json(with_modules(R"({"crowd": {
      "rules": [{"seed": 4, "reach": 3}],
      "routes": [{"half": {"x": 10, "z": 10}, "cell": 0.5}],
      "walls": [{"from": {"x": -3, "z": 4}, "to": {"x": 3, "z": 4}}],
      "obstacles": [{"body": "car[1]"}],
      "goals": [{"number": 0, "center": {"z": 8}, "end": "CROWD_GOAL_END_LEAVE"},
                {"number": 0, "center": {"x": 8}}],
      "flocks": [{"roam": 9}],
      "groups": [{"count": 12, "bodies": "CROWD_BODIES_DYNAMIC", "goal": 0},
                 {"count": 5, "kind": "CROWD_KIND_FLYER", "center": {"y": 5}}],
      "agents": [{"body": "car", "radius": 1, "target": {"x": 5}}],
      "threats": [{"body": "car", "radius": 4}]
    }})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* crowd = dynamic_cast<const modules::Crowd*>(built->world.module("crowd"));
    EXPECT_EQ(crowd->counts().agents, 18u);
    EXPECT_EQ(crowd->settings().seed, 4u);
    EXPECT_EQ(read_scene_json(write_scene_json(*scene))->modules[0].objects.size(), 11u);
}

TEST(ModuleObjects, crowd_errors_name_line_and_field) {
    EXPECT_THAT(error_of(R"({"crowd": {"groups": [{"radius": 9}]}})"),
                AllOf(HasSubstr("line "), HasSubstr("modules[0].crowd.groups[0].radius: 9")));
    EXPECT_THAT(error_of(R"({"crowd": {"walls": [{"from": {"x": 1e9}}]}})"),
                HasSubstr("modules[0].crowd.walls[0].from.x"));
    EXPECT_THAT(error_of(R"({"crowd": {"agents": [{"body": "cat"}]}})"),
                HasSubstr("modules[0].crowd.agents[0].body"));
    EXPECT_THAT(error_of(R"({"crowd": {"groups": [{"count": 3, "goal": 2}]}})"),
                HasSubstr("groups[0]: destination: goal is 2; there are 0 goals"));
    EXPECT_THAT(error_of(R"({"crowd": {"obstacles": [{"body": "floor"}]}})"),
                HasSubstr("obstacles[0]: obstacle_body: the body has no outline"));
}

TEST(ModuleObjects, ropes_have_points_attachments_and_winches) {
    const auto scene = read_scene_json(with_modules(R"({"rope": {"ropes": [
      {"points": [{"position": {"y": 9}}, {"position": {"y": 5}}], "links": 16,
       "attachments": [{"node": 0, "point": {"y": 9}}, {"node": 16, "body": "car"}],
       "winch_first": -0.5},
      {"points": [{"position": {}}, {"position": {"x": 1}}]}
    ]}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* ropes = dynamic_cast<const modules::Ropes*>(built->world.module("rope"));
    ASSERT_EQ(ropes->ropes().size(), 2u);
    const modules::RopeKey first = ropes->ropes()[0];
    EXPECT_EQ(ropes->positions(first).size(), 17u);
    EXPECT_EQ(ropes->attachments(first)[1].node, 16u);
    EXPECT_EQ(ropes->rest_lengths(first)[0], 0.25);
    EXPECT_EQ(read_scene_json(write_scene_json(*scene))->modules[0].objects.size(), 2u);
}

TEST(ModuleObjects, cloth_has_a_grid_and_attachments) {
    const auto scene = read_scene_json(with_modules(R"({"cloth": {"cloths": [
      {"grid": {"rows": 4, "columns": 6, "origin": {"y": 9}, "across": {"x": 2}, "down": {"y": -1}},
       "hang": true, "attachments": [{"vertex": 23, "body": "car"}]},
      {}
    ]}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << built.error().message;
    const auto* cloths = dynamic_cast<const modules::Cloths*>(built->world.module("cloth"));
    ASSERT_EQ(cloths->cloths().size(), 2u);
    const modules::ClothKey first = cloths->cloths()[0];
    EXPECT_EQ(cloths->positions(first).size(), 24u);
    EXPECT_NEAR(cloths->positions(first)[23].x, 2, 1e-6);
    EXPECT_NEAR(cloths->positions(first)[23].y, 8, 1e-6);
    EXPECT_EQ(cloths->attachments(first).size(), 7u);
    EXPECT_EQ(cloths->positions(cloths->cloths()[1]).size(), 400u);
    EXPECT_EQ(read_scene_json(write_scene_json(*scene))->modules[0].objects.size(), 2u);
}

TEST(ModuleObjects, cloth_errors_name_line_and_field) {
    const auto of = [&](const std::string& fields) {
        return error_of(R"({"cloth": {"cloths": [{)" + fields + "}]}}");
    };
    EXPECT_THAT(of(R"("thickness": 0)"),
                AllOf(HasSubstr("line "), HasSubstr("modules[0].cloth.cloths[0].thickness: 0")));
    EXPECT_THAT(of(R"("grid": {"rows": 1})"), HasSubstr("modules[0].cloth.cloths[0].grid.rows: 1"));
    EXPECT_THAT(of(R"("grid": {"across": {"y": 1}})"), HasSubstr("are parallel or zero"));
    EXPECT_THAT(of(R"("attachments": [{"vertex": 0, "body": "cat"}])"),
                HasSubstr("modules[0].cloth.cloths[0].attachments[0].body"));
    EXPECT_THAT(of(R"("attachments": [{"vertex": 400}])"),
                HasSubstr("cloths[0]: attachments[0].vertex: 400 is out of range"));
}

TEST(ModuleObjects, rope_errors_name_line_and_field) {
    const std::string points = R"("points": [{"position": {"y": 9}}, {"position": {"y": 5}}])";
    const auto of = [&](const std::string& fields) {
        return error_of(R"({"rope": {"ropes": [{)" + fields + "}]}}");
    };
    EXPECT_THAT(of(points + R"(, "radius": 0)"),
                AllOf(HasSubstr("line "), HasSubstr("modules[0].rope.ropes[0].radius: 0")));
    EXPECT_THAT(of(R"("points": [{"position": {"y": 9}}])"),
                HasSubstr("modules[0].rope.ropes[0].points: has 1 items; it must have 2 to 256"));
    EXPECT_THAT(of(points + R"(, "attachments": [{"node": 0, "body": "cat"}])"),
                HasSubstr("modules[0].rope.ropes[0].attachments[0].body"));
    EXPECT_THAT(of(points + R"(, "attachments": [{"node": 21}])"),
                HasSubstr("ropes[0]: attachments[0].node: 21 is out of range"));
    EXPECT_THAT(of(points + R"(, "winch_last": 1)"), HasSubstr("the end is not attached"));
}

}  // namespace
}  // namespace jostle::scenes

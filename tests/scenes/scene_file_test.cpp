// SPDX-License-Identifier: MIT
#include "jostle/scenes/scene_file.h"

#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "jostle/v1/scene.pb.h"
#include "tests/scenes/turntable.h"

namespace jostle::scenes {
namespace {

std::string read(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Together they contain every field of jostle.v1.Scene.
constexpr const char* every_field_files[] = {PROJECT_FOLDER "/tests/scenes/data/every_field.json",
                                             PROJECT_FOLDER "/tests/scenes/data/every_module.json",
                                             PROJECT_FOLDER "/tests/scenes/data/planar.json"};

std::string name_of(const google::protobuf::FieldDescriptor& field) {
    return field.containing_type()->name() + "." + field.name();
}

// Adds the names of all fields of a message type and of its nested types, such as "Body.mass".
void add_fields(const google::protobuf::Descriptor& message, std::set<std::string>& names) {
    for (int i = 0; i < message.field_count(); i++) {
        const auto& field = *message.field(i);
        if (names.insert(name_of(field)).second && field.message_type())
            add_fields(*field.message_type(), names);
    }
}

// Adds the names of the fields that are present in a message.
void add_present(const google::protobuf::Message& message, std::set<std::string>& names) {
    const auto& reflection = *message.GetReflection();
    std::vector<const google::protobuf::FieldDescriptor*> fields;
    reflection.ListFields(message, &fields);
    for (const auto* field : fields) {
        names.insert(name_of(*field));
        if (!field->message_type()) continue;
        if (!field->is_repeated())
            add_present(reflection.GetMessage(message, field), names);
        else
            for (int i = 0; i < reflection.FieldSize(message, field); i++)
                add_present(reflection.GetRepeatedMessage(message, field, i), names);
    }
}

void expect_runs(const physics::Result<SceneDescription>& scene) {
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok()) << scene->name << ": " << built.error().message;
    for (double t = 0; t < 1; t += 1 / scene->hz) {
        ASSERT_TRUE(built->world.step(1 / scene->hz).ok());
        EXPECT_TRUE(built->world.events().quarantined.empty()) << scene->name;
    }
}

}  // namespace

TEST(SceneFile, catalogue_scenes_round_trip_bit_identically) {
    for (const CatalogEntry& entry : catalog()) {
        const SceneDescription scene = *find_scene(entry.name);
        const auto back = read_scene_json(write_scene_json(scene));
        ASSERT_TRUE(back.ok()) << entry.name << ": " << back.error().message;
        EXPECT_EQ(back->name, scene.name);
        EXPECT_EQ(back->hz, scene.hz);
        EXPECT_EQ(back->precision.position, scene.precision.position);
        EXPECT_EQ(back->precision.rotation, scene.precision.rotation);
        EXPECT_EQ(back->precision.far_factor, scene.precision.far_factor);
        const auto a = build_scene(scene), b = build_scene(*back);
        ASSERT_TRUE(a.ok() && b.ok());
        EXPECT_EQ(physics::first_difference(a->world, b->world).value_or(""), "") << entry.name;
    }
}

// A field that is neither read nor written would survive a round trip, so the test counts the
// fields. Repeats, solids and frames in the world are written in expanded form.
TEST(SceneFile, round_trip_preserves_every_field) {
    test::register_turntable();
    std::set<std::string> all, given, written;
    add_fields(*v1::Scene::descriptor(), all);
    all.erase("Shape.geometry");  // only in an EntityUpdate; scene files with it are rejected
    for (const char* file : every_field_files) {
        const std::string text = read(file);
        v1::Scene message;
        ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(text, &message).ok());
        add_present(message, given);
        const auto scene = read_scene_json(text);
        ASSERT_TRUE(scene.ok()) << scene.error().message;
        add_present(to_message(*scene), written);
    }
    EXPECT_EQ(given, all);
    for (const char* expanded : {"Body.repeat", "Repeat.count", "Repeat.offset", "Joint.frame",
                                 "Joint.repeat", "JointRepeat.count", "JointRepeat.offset",
                                 "Shape.solid", "Solid.mesh", "Solid.parts_max", "Solid.excess"})
        all.erase(expanded);
    EXPECT_EQ(written, all);
}

TEST(SceneFile, every_field_round_trips_to_the_same_world_after_30_steps) {
    test::register_turntable();
    for (const char* file : every_field_files) {
        const auto scene = load_scene(file);
        ASSERT_TRUE(scene.ok()) << scene.error().message;
        const auto back = read_scene_json(write_scene_json(*scene));
        ASSERT_TRUE(back.ok()) << back.error().message;
        EXPECT_TRUE(write_scene_json(*back) == write_scene_json(*scene)) << file;
        auto a = build_scene(*scene), b = build_scene(*back);
        ASSERT_TRUE(a.ok()) << a.error().message;
        ASSERT_TRUE(b.ok()) << b.error().message;
        EXPECT_EQ(physics::first_difference(a->world, b->world).value_or(""), "") << file;
        EXPECT_EQ(physics::state_hash(a->world), physics::state_hash(b->world)) << file;
        for (int step = 0; step < 30; step++) {
            ASSERT_TRUE(a->world.step(1 / scene->hz).ok());
            ASSERT_TRUE(b->world.step(1 / back->hz).ok());
        }
        EXPECT_EQ(physics::state_hash(a->world), physics::state_hash(b->world)) << file;
    }
}

TEST(SceneFile, legacy_fixed_body_type_is_read_as_static) {
    const auto scene = read_scene_json(R"({"name": "old", "bodies": [
        {"name": "floor", "type": "BODY_TYPE_FIXED", "shapes": [{"plane": {}}]}]})");
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->bodies[0].body.type, physics::BodyType::static_body);
    const std::string written = write_scene_json(*scene);
    EXPECT_NE(written.find("BODY_TYPE_STATIC"), std::string::npos) << written;
    EXPECT_EQ(written.find("BODY_TYPE_FIXED"), std::string::npos) << written;
}

// In JSON, "-0.0" has a sign and "-0" does not; both must be read as 0.
TEST(SceneFile, negative_zero_is_read_as_zero) {
    const std::string text =
        R"({"name": "a", "world": {"gravity": {"x": 0.0, "y": -9.81}}, "bodies": [
        {"type": "BODY_TYPE_STATIC", "rotation": {"x": 0.0, "w": 1}, "shapes": [
          {"plane": {"normal": {"x": 0.0, "y": 1}}, "surface_velocity": {"x": 0.0, "z": 1}},
          {"mesh": {"vertices": [{"x": 0.0}, {"x": 1, "y": 0.0}, {"z": 1}], "indices": [0, 1, 2]}},
          {"height_field": {"columns": 2, "rows": 2, "spacing_x": 1, "spacing_z": 1, "heights": [0.0, 1, 0.0, 1]}},
          {"hull": {"points": [{"x": 0.0}, {"x": 1}, {"y": 1, "x": 0.0}, {"z": 1}]}},
          {"compound": {"children": [
            {"sphere": {"radius": 1}, "position": {"x": 0.0, "y": 1}, "rotation": {"y": 0.0, "w": 1}}]}}]}]})";
    std::string negative = text;
    for (std::size_t at = 0; (at = negative.find(" 0.0", at)) != std::string::npos; at += 5)
        negative.insert(at + 1, "-");
    const auto a = read_scene_json(text), b = read_scene_json(negative);
    ASSERT_TRUE(a.ok() && b.ok()) << (a.ok() ? b : a).error().message;
    const auto world_a = build_scene(*a), world_b = build_scene(*b);
    ASSERT_TRUE(world_a.ok() && world_b.ok());
    EXPECT_EQ(physics::state_hash(world_a->world), physics::state_hash(world_b->world));
}

TEST(SceneFile, documentation_examples_run_for_one_second) {
    test::register_turntable();
    const std::string document = read(PROJECT_FOLDER "/docs/reference/scene_format.md");
    int examples = 0;
    for (std::size_t at = 0; (at = document.find("```json\n", at)) != std::string::npos;
         examples++) {
        at += 8;
        expect_runs(read_scene_json(document.substr(at, document.find("```", at) - at)));
    }
    EXPECT_GE(examples, 8);
}

TEST(SceneFile, files_in_data_run_for_one_second) {
    int files = 0;
    for (const auto& file : std::filesystem::directory_iterator(PROJECT_FOLDER "/scenes/data")) {
        expect_runs(load_scene(file.path().string()));
        files++;
    }
    EXPECT_GE(files, 5);
}

TEST(SceneFile, three_repeats_make_a_grid) {
    const auto scene = load_scene(PROJECT_FOLDER "/scenes/data/towers.json");
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene->bodies.size(), 1u + 6 * 3 * 3 + 1);
}

TEST(SceneFile, rejects_every_truncation_of_a_valid_file) {
    const std::string text = read(PROJECT_FOLDER "/scenes/data/carousel.json");
    for (std::size_t size = 0; size + 3 < text.size(); size += 7) {
        const auto scene = read_scene_json(std::string_view(text).substr(0, size));
        ASSERT_FALSE(scene.ok()) << size;
        EXPECT_FALSE(scene.error().message.empty());
    }
}

TEST(SceneFile, unknown_name_error_lists_known_names) {
    EXPECT_EQ(load_scene("sandbocks").error().message,
              "unknown scene \"sandbocks\"; did you mean \"sandbox\"?");
    const auto scene = load_scene("unlike_any");
    ASSERT_FALSE(scene.ok());
    EXPECT_NE(scene.error().message.find("sandbox, pyramid"), std::string::npos);
    EXPECT_FALSE(load_scene("no/such/file.json").ok());
}

}  // namespace jostle::scenes

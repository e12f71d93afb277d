// SPDX-License-Identifier: MIT
#include "jostle/scenes/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "jostle/physics/snapshot.h"
#include "jostle/scenes/catalog.h"

namespace jostle::scenes {
namespace {

std::string read(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(SceneFile, a_catalogue_scene_written_and_read_is_the_same_world_to_the_last_bit) {
    for (const CatalogEntry& entry : catalog()) {
        const SceneDescription scene = *find_scene(entry.name);
        const auto back = read_scene_json(write_scene_json(scene));
        ASSERT_TRUE(back.ok()) << entry.name << ": " << back.error().message;
        EXPECT_EQ(back->name, scene.name);
        EXPECT_EQ(back->hz, scene.hz);
        const auto a = build_scene(scene), b = build_scene(*back);
        ASSERT_TRUE(a.ok() && b.ok());
        EXPECT_EQ(physics::first_difference(a->world, b->world).value_or(""), "") << entry.name;
    }
}

TEST(SceneFile, the_example_of_the_document_and_every_file_in_data_build) {
    const std::string document = read(PROJECT_FOLDER "/docs/scene_format.md");
    const std::size_t begin = document.find("```json") + 7;
    const std::string example = document.substr(begin, document.find("```", begin) - begin);
    const auto scene = read_scene_json(example);
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->bodies.size(), 4u);  // floor, two boxes, dumbbell
    EXPECT_EQ(scene->bodies[2].body.pose.position.y, 2.0);
    EXPECT_TRUE(build_scene(*scene).ok());
    int files = 0;
    for (const auto& file : std::filesystem::directory_iterator(PROJECT_FOLDER "/scenes/data")) {
        const auto data = load_scene(file.path().string());
        ASSERT_TRUE(data.ok()) << data.error().message;
        EXPECT_TRUE(build_scene(*data).ok()) << file.path();
        files++;
    }
    EXPECT_GE(files, 2);
}

TEST(SceneFile, three_repeats_make_a_grid) {
    const auto scene = load_scene(PROJECT_FOLDER "/scenes/data/towers.json");
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene->bodies.size(), 1u + 6 * 3 * 3 + 1);
}

TEST(SceneFile, each_fault_is_named_with_its_line_and_field) {
    const struct {
        const char* text;
        const char* message;
    } cases[] = {
        {"{\"name\": \"a\",", "this is not JSON: parse error at line 1"},
        {"[]", "line 1: the scene: must be an object {...}, not array"},
        {"{}", "name: must be a text of 1 to 64 bytes"},
        {"{\"name\": 7}", "line 1: name: must be a text in quotes, not number"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"postion\": {}}]}",
         "line 3: bodies[0].postion: there is no such field; did you mean \"position\"?"},
        {"{\"name\": \"a\",\n \"bodies\": {}}", "line 2: bodies: must be a list [...], not object"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {}]}",
         "bodies[0].shapes: is empty; give the body at least one shape"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [\n {}]}]}",
         "line 4: bodies[0].shapes[0]: has no kind; give one of sphere, capsule, box, plane"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [\n {\"sphere\": {\n\"radius\": "
         "-1}}]}]}",
         "line 5: bodies[0].shapes[0].sphere.radius: -1 is out of range; it must be from 0.001 to "
         "10000"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [{\"plane\": {}}]}]}",
         "line 3: bodies[0].shapes[0].plane: is infinite; only a body of type BODY_TYPE_FIXED may "
         "have one"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"type\": \"FIXED\"}]}",
         "line 3: bodies[0].type: must be one of BODY_TYPE_FIXED, BODY_TYPE_KINEMATIC, "
         "BODY_TYPE_DYNAMIC"},
        {"{\"name\": \"a\",\n \"world\": {\"hz\": 1}}",
         "line 2: world.hz: 1 is out of range; it must be from 4 to 1000"},
        {"{\"name\": \"a\",\n \"world\": {\"substeps\": -1}}",
         "line 2: world.substeps: must be a whole number from 0 to 4294967295"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [{\"sphere\": {\"radius\": 1}}],\n"
         "   \"repeat\": [{\"count\": 100000}, {\"count\": 3}]}]}",
         "line 4: bodies[0].repeat[1].count: makes more than 200000 bodies"},
    };
    for (const auto& c : cases) {
        const auto scene = read_scene_json(c.text);
        ASSERT_FALSE(scene.ok()) << c.text;
        EXPECT_EQ(scene.error().message.substr(0, std::string(c.message).size()), c.message)
            << c.text;
    }
}

TEST(SceneFile, every_truncation_of_a_good_file_is_refused) {
    const std::string text = read(PROJECT_FOLDER "/scenes/data/carousel.json");
    for (std::size_t size = 0; size + 3 < text.size(); size += 7) {
        const auto scene = read_scene_json(std::string_view(text).substr(0, size));
        ASSERT_FALSE(scene.ok()) << size;
        EXPECT_FALSE(scene.error().message.empty());
    }
}

TEST(SceneFile, a_name_that_is_not_there_lists_those_that_are) {
    const auto scene = load_scene("sandbocks");
    ASSERT_FALSE(scene.ok());
    EXPECT_NE(scene.error().message.find("sandbox, pyramid"), std::string::npos);
    EXPECT_FALSE(load_scene("no/such/file.json").ok());
}

}  // namespace jostle::scenes

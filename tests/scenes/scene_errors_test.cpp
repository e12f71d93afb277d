// SPDX-License-Identifier: MIT
//
// Errors of invalid scene files: line, field, value and remedy.
#include <gtest/gtest.h>

#include <regex>

#include "jostle/scenes/scene_file.h"
#include "tests/scenes/turntable.h"

namespace jostle::scenes {
namespace {

struct Case {
    std::string text, message;
};

// The cases name lines only; reports_columns_and_all_errors has columns.
std::string without_columns(const std::string& message) {
    return std::regex_replace(message, std::regex(", column [0-9]+: "), ": ");
}

void expect_starts(const std::string& text, const std::string& message) {
    const auto scene = read_scene_json(text);
    ASSERT_FALSE(scene.ok()) << text;
    EXPECT_EQ(without_columns(scene.error().message).substr(0, message.size()), message) << text;
}

void expect_refused(const std::string& text, const std::string& message) {
    const auto scene = read_scene_json(text);
    ASSERT_FALSE(scene.ok()) << text;
    EXPECT_EQ(without_columns(scene.error().message), message) << text;
}

void expect_error(const std::string& text, const std::string& message) {
    const auto scene = read_scene_json(text);
    ASSERT_FALSE(scene.ok()) << text;
    EXPECT_EQ(scene.error().message, message) << text;
}

// The file is valid, but the world cannot be built.
void expect_not_built(const std::string& text, const std::string& message) {
    const auto scene = read_scene_json(text);
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto built = build_scene(*scene);
    ASSERT_FALSE(built.ok()) << text;
    EXPECT_EQ(built.error().message, message) << text;
}

// A scene with one body, whose shape begins on line 3.
std::string body(const std::string& shape, const std::string& type = "DYNAMIC") {
    return R"({"name": "a",
 "bodies": [{"name": "it", "type": "BODY_TYPE_)" +
           type + R"(", "shapes": [
)" + shape +
           "]}]}";
}

// The same in a planar world.
std::string planar(const std::string& shape) {
    std::string text = body(shape);
    return text.replace(text.find('\n'), 1, R"( "world": {"planar": true},)");
}

// Three bodies named link, and a joint that begins on line 5.
std::string links(const std::string& joint, const std::string& type = "DYNAMIC") {
    return R"({"name": "a",
 "bodies": [{"name": "link", "type": "BODY_TYPE_)" +
           type + R"(", "shapes": [{"sphere": {"radius": 0.1}}],
  "repeat": [{"count": 3, "offset": {"x": 1}}]}],
 "joints": [
{)" + joint +
           "}]}";
}

// A body named disc, and a module that begins on line 5.
std::string with_module(const std::string& module) {
    return R"({"name": "a",
 "bodies": [{"name": "disc", "type": "BODY_TYPE_KINEMATIC",
  "shapes": [{"sphere": {"radius": 1}}]}],
 "modules": [
{)" + module +
           "}]}";
}

const std::string neighbours = R"("name": "pin", "body_a": "link", "body_b": "link[1]",)";

}  // namespace

TEST(SceneErrors, reports_columns_and_all_errors) {
    expect_error("{\"name\": \"a\",\n  \"bodys\": [], \"world\": {\"hz\": true, \"gravty\": {}}}",
                 "line 2, column 12: bodys: unknown field; did you mean \"bodies\"?\n"
                 "line 2, column 48: world.gravty: unknown field; did you mean \"gravity\"?\n"
                 "line 2, column 32: world.hz: must be a number, not boolean");
    expect_error(R"({"name": "a", "world": {"hz": 1}, "bodies": [
{"shapes": [{"sphere": {"radius": -1}}], "mass": -2},
{"shapes": [{"sphere": {"radius": 1}}]},
{"shapes": [{"box": {"half_extents": {"x": 1, "y": 0, "z": 1}}}]}]})",
                 "line 1, column 31: world.hz: 1 is out of range; it must be from 4 to 1000\n"
                 "line 2, column 50: bodies[0].mass: -2 is out of range; it must be from 1e-09 to "
                 "1e+15\n"
                 "line 2, column 35: bodies[0].shapes[0].sphere.radius: -1 is out of range; it "
                 "must be from 0.0001 to 10000\n"
                 "line 4, column 52: bodies[2].shapes[0].box.half_extents.y: 0 is out of range; it "
                 "must be from 0.0001 to 10000");
}

TEST(SceneErrors, reports_at_most_twenty_errors) {
    std::string text = R"({"name": "a", "bodies": [)";
    for (int i = 0; i < 30; i++) text += std::string(i == 0 ? "" : ",") + "{\"mass\": \"1\"}";
    const auto scene = read_scene_json(text + "]}");
    ASSERT_FALSE(scene.ok());
    const std::string& message = scene.error().message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
    EXPECT_NE(message.find("bodies[19].mass"), std::string::npos);
    EXPECT_TRUE(message.ends_with("\nmore errors may follow")) << message;
}

TEST(SceneErrors, accepts_the_name_of_a_schema) {
    EXPECT_TRUE(read_scene_json(R"({"$schema": "./scene.json", "name": "a"})").ok());
    expect_error(R"({"$schema": 1, "name": "a"})",
                 "line 1, column 13: $schema: must be a string in quotes, not number");
    EXPECT_FALSE(read_scene_json(R"({"name": "a", "world": {"$schema": "x"}})").ok());
}

TEST(SceneErrors, errors_name_line_and_field) {
    const Case cases[] = {
        {"{\"name\": \"a\",", "not valid JSON: parse error at line 1"},
        {"[]", "line 1: scene: must be an object {...}, not array"},
        {"{}", "name: must be a string of 1 to 64 bytes"},
        {"{\"name\": 7}", "line 1: name: must be a string in quotes, not number"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"postion\": {}}]}",
         "line 3: bodies[0].postion: unknown field; did you mean \"position\"?"},
        {"{\"name\": \"a\",\n \"bodies\": {}}", "line 2: bodies: must be a list [...], not object"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {}]}",
         "bodies[0].shapes: is empty; it must have at least one shape"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [\n {}]}]}",
         "line 4: bodies[0].shapes[0]: has no kind; it must have one of sphere, capsule, box, "
         "plane"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [\n {\"sphere\": {\n\"radius\": "
         "-1}}]}]}",
         "line 5: bodies[0].shapes[0].sphere.radius: -1 is out of range; it must be from 0.0001 to "
         "10000"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [{\"plane\": {}}]}]}",
         "line 3: bodies[0].shapes[0].plane: is infinite; only a body of type BODY_TYPE_STATIC may "
         "have a plane"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"type\": \"FIXED\"}]}",
         "line 3: bodies[0].type: must be one of BODY_TYPE_STATIC, BODY_TYPE_KINEMATIC, "
         "BODY_TYPE_DYNAMIC"},
        {"{\"name\": \"a\",\n \"world\": {\"hz\": 1}}",
         "line 2: world.hz: 1 is out of range; it must be from 4 to 1000"},
        {"{\"name\": \"a\",\n \"world\": {\"tolerance\": -1}}",
         "line 2: world.tolerance: -1 is out of range; it must be from 1e-09 to 1000"},
        {"{\"name\": \"a\",\n \"world\": {\"precision\": {\"position\": 5, \"rotation\": 0.1}}}",
         "line 2: world.precision.position: 5 is out of range; it must be from 0.0001 to 1"},
        {"{\"name\": \"a\",\n \"world\": {\"precision\": {\"position\": 0.1, \"rotation\": 9}}}",
         "line 2: world.precision.rotation: 9 is out of range; it must be from 0.0002 to 0.5"},
        {"{\"name\": \"a\",\n \"view\": {\"eye\": {\"x\": 1}, \"target\": {\"x\": 1}}}",
         "line 2: view.target: must be at least 0.01 m from view.eye"},
        {"{\"name\": \"a\",\n \"view\": {\"eye\": {\"x\": 1e8}}}",
         "line 2: view.eye.x: 100000000 is out of range; it must be from -10000000 to 10000000"},
        {"{\"name\": \"a\",\n \"view\": {\"eye\": {\"x\": 1}, \"field_of_view\": 3}}",
         "line 2: view.field_of_view: 3 is out of range; it must be from 0.1 to 2.5"},
        {"{\"name\": \"a\",\n \"world\": {\"substeps\": -1}}",
         "line 2: world.substeps: must be an integer from 0 to 4294967295"},
        {"{\"name\": \"a\",\n \"bodies\": [\n  {\"shapes\": [{\"sphere\": {\"radius\": 1}}],\n"
         "   \"repeat\": [{\"count\": 100000}, {\"count\": 3}]}]}",
         "line 4: bodies[0].repeat[1].count: creates more than 200000 bodies"},
    };
    for (const auto& [text, message] : cases) expect_starts(text, message);
}

TEST(SceneErrors, rejects_hulls_with_coplanar_or_too_few_points) {
    expect_refused(body(R"({"hull": {"points": [{"x": 0}, {"x": 1}, {"y": 1}]}})"),
                   "line 3: bodies[0].shapes[0].hull: it has 3 points; it must have at least 4");
    expect_refused(
        body(R"({"hull": {"points": [{"x": 0}, {"x": 1}, {"y": 1}, {"x": 1, "y": 1}]}})"),
        "line 3: bodies[0].shapes[0].hull: its points lie in one plane; it has no volume");
}

TEST(SceneErrors, rejects_mesh_indices_out_of_range) {
    const std::string vertices = R"({"mesh": {"vertices": [{"x": 0}, {"x": 1}, {"z": 1}],)";
    expect_refused(
        body(vertices + "\n" + R"("indices": [0, 1, 3]}})", "FIXED"),
        "line 3: bodies[0].shapes[0].mesh: triangles[0] refers to vertex 3; there are 3 vertices");
    expect_refused(body(vertices + "\n" + R"("indices": [0, 1, 2, 0]}})", "FIXED"),
                   "line 4: bodies[0].shapes[0].mesh.indices: has 4 entries; it must have 3 per "
                   "triangle");
}

TEST(SceneErrors, rejects_surfaces_on_dynamic_bodies_and_triggers) {
    const std::string mesh =
        R"({"mesh": {"vertices": [{"x": 0}, {"x": 1}, {"z": 1}], "indices": [0, 1, 2]})";
    expect_refused(body(mesh + "}"),
                   "line 3: bodies[0].shapes[0]: is a surface without mass; use hulls or a "
                   "compound for a dynamic body");
    expect_not_built(body(mesh + R"(, "trigger": true})", "FIXED"),
                     "bodies[0] 'it': a mesh has no volume; a trigger needs a solid shape");
}

TEST(SceneErrors, rejects_height_fields_with_wrong_counts) {
    const std::string grid = R"({"height_field": {"columns": 2, "rows": 2, "spacing_x": 1,)";
    expect_refused(
        body(grid + R"("spacing_z": 1, "heights": [0, 0, 0]}})", "FIXED"),
        "line 3: bodies[0].shapes[0].height_field: it has 3 heights; 2 x 2 samples need 4");
    expect_refused(body(grid + R"("spacing_z": 1, "heights": [0, 0, 0, 0],
"holes": [0,
1]}})",
                        "FIXED"),
                   "line 5: bodies[0].shapes[0].height_field.holes[1]: is 1; there are 1 cells");
    expect_refused(body(grid + "\n" + R"("heights": [0, 0, 0, 0]}})", "FIXED"),
                   "bodies[0].shapes[0].height_field.spacing_z: 0 is out of range; it must be from "
                   "0.0001 to 10000");
}

TEST(SceneErrors, rejects_non_convex_compound_children) {
    expect_refused(
        body(R"({"compound": {"children": [
{"sphere": {"radius": 1}},
{"compound": {"children": [{"sphere": {"radius": 1}}]}}]}})"),
        "line 5: bodies[0].shapes[0].compound.children[1]: is a compound inside a compound; "
        "list its children directly");
    expect_refused(body(R"({"compound": {"children": [{"plane": {}}]}})"),
                   "line 3: bodies[0].shapes[0].compound: children[0] is a plane; it must be a "
                   "sphere, capsule, box, cylinder, cone or hull");
    expect_refused(body(R"({"compound": {}})"),
                   "line 3: bodies[0].shapes[0].compound: it has no children");
}

TEST(SceneErrors, rejects_joints_with_unknown_bodies) {
    expect_refused(links("\"body_a\": \"link\",\n\"body_b\": \"lnik\", \"ball\": {}"),
                   "line 6: joints[0].body_b: is \"lnik\"; no body has the name \"lnik\"");
    expect_refused(
        links("\"body_a\": \"link\",\n\"body_b\": \"link[9]\", \"ball\": {}"),
        "line 6: joints[0].body_b: is \"link[9]\"; there are only 3 bodies named \"link\"");
    expect_refused(
        links("\"body_a\": \"link\",\n\"body_b\": \"link[-1]\", \"ball\": {}"),
        "line 6: joints[0].body_b: is \"link[-1]\"; it must be name[index], counting from 0");
    expect_refused(links(neighbours + "\"ball\": {},\n\"repeat\": {\"count\": 3}"),
                   "line 6: joints[0].repeat.count: exceeds the last body; copy i joins "
                   "the bodies whose indices are larger by i");
}

TEST(SceneErrors, rejects_joints_with_several_kinds_or_frames) {
    expect_refused(
        links(neighbours + "\"collide_connected\": true"),
        "line 5: joints[0]: has no kind; it must have one of ball, hinge, cone_twist, fixed, "
        "distance, velocity_row, slider, six_dof, wheel, grab, gear, "
        "rack, pulley, path");
    expect_refused(links(neighbours + "\"ball\": {},\n\"hinge\": {}"),
                   "line 6: joints[0].hinge: is a second kind; only one is allowed");
    expect_refused(
        links(neighbours + "\"ball\": {}, \"frame_a\": {},\n\"frame\": {}"),
        "line 6: joints[0].frame: conflicts with frame_a and frame_b; use either frame, or "
        "frame_a and frame_b");
}

TEST(SceneErrors, rejects_unknown_joint_solvers) {
    expect_refused(links(neighbours + "\"ball\": {},\n\"solver\": 4"),
                   "line 6: joints[0].solver: must be one of JOINT_SOLVER_AUTOMATIC, "
                   "JOINT_SOLVER_ITERATIVE, JOINT_SOLVER_DIRECT");
    expect_refused("{\"name\": \"a\",\n\"world\": {\"joint_solver\": -1}}",
                   "line 2: world.joint_solver: must be one of JOINT_SOLVER_AUTOMATIC, "
                   "JOINT_SOLVER_ITERATIVE, JOINT_SOLVER_DIRECT");
}

TEST(SceneErrors, rejects_limits_with_lower_above_upper) {
    expect_refused(links(neighbours + R"("hinge": {"limit": {
"lower": 1,
"upper": -1}})"),
                   "line 6: joints[0].hinge.limit.lower: is greater than the upper limit");
    expect_refused(links(neighbours + R"("cone_twist": {"swing": 1, "twist": {
"lower": 0.2, "upper": 0.1}})"),
                   "line 6: joints[0].cone_twist.twist.lower: is greater than the upper limit");
    expect_refused(links(neighbours + "\"distance\": {\"min_length\": 2,\n\"max_length\": 1}"),
                   "line 6: joints[0].distance.max_length: is less than min_length");
}

TEST(SceneErrors, rejects_joints_without_a_dynamic_body_or_between_equal_bodies) {
    expect_not_built(links(neighbours + "\"ball\": {}", "FIXED"),
                     "joints[0] 'pin': neither body_a nor body_b is dynamic; a joint needs at "
                     "least one dynamic body");
    expect_not_built(links(R"("name": "pin", "body_a": "link", "body_b": "link[0]", "ball": {})"),
                     "joints[0] 'pin': body_a and body_b are the same body; a joint needs two "
                     "different bodies");
}

TEST(SceneErrors, accepts_negative_groups_and_rejects_negative_masks) {
    const auto scene =
        read_scene_json(body(R"({"sphere": {"radius": 1}, "filter": {"group": -2147483648}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->bodies[0].shapes[0].filter.group, -2147483647 - 1);
    expect_refused(body(R"({"sphere": {"radius": 1}, "filter": {"group": 2147483648}})"),
                   "line 3: bodies[0].shapes[0].filter.group: must be an integer from "
                   "-2147483648 to 2147483647");
    expect_refused(body(R"({"sphere": {"radius": 1}, "filter": {"mask": -1}})"),
                   "line 3: bodies[0].shapes[0].filter.mask: must be an integer from 0 to "
                   "4294967295");
}

TEST(SceneErrors, rejects_out_of_plane_values_in_planar_worlds) {
    expect_not_built(planar(R"({"cylinder": {"radius": 1, "half_length": 1}})"),
                     "bodies[0] 'it': a cylinder is not supported in a planar world; use "
                     "spheres (discs), capsules, boxes, hulls and planes");
    expect_not_built(
        planar(R"({"sphere": {"radius": 1}, "position": {"z": 0.5}})"),
        "bodies[0] 'it': shape pose.position.z is 0.5; it must be 0 in a planar world");
    expect_not_built(R"({"name": "a", "world": {"planar": true},
 "bodies": [{"name": "it", "position": {"z": 1}, "shapes": [{"sphere": {"radius": 1}}]}]})",
                     "bodies[0] 'it': pose.position.z is 1; it must be 0 in a planar world");
    expect_not_built(R"({"name": "a", "world": {"planar": true, "gravity": {"y": -9.81, "z": 1}}})",
                     "world: gravity.z is 1; it must be 0 in a planar world");
}

TEST(SceneErrors, rejects_unknown_and_duplicate_modules) {
    test::register_turntable();
    expect_refused(
        with_module("\n\"tag\": \"submarine\""),
        "line 6: modules[0].tag: is \"submarine\"; it must be one of asteroids, "
        "boat, character, cloth, crowd, destruction, fields, hovercraft, katamari, particles, "
        "ragdoll, rope, turntable, vehicle");
    expect_refused(
        with_module("\"settings\": {}"),
        "modules[0].tag: is \"\"; it must be one of asteroids, boat, "
        "character, cloth, crowd, destruction, fields, hovercraft, katamari, particles, ragdoll, "
        "rope, turntable, vehicle");
    expect_refused(
        with_module("\"tag\": \"turntable\"},\n{\"tag\": \"turntable\""),
        "line 6: modules[1].tag: is \"turntable\", a duplicate; a world has at most one module per "
        "tag");
    SceneDescription scene{.name = "a", .modules = {{.tag = "submarine"}}};
    const auto built = build_scene(scene);
    ASSERT_FALSE(built.ok());
    EXPECT_EQ(
        built.error().message,
        "modules[0] 'submarine': module \"submarine\" is not registered (registered: asteroids, "
        "boat, "
        "character, cloth, crowd, destruction, fields, hovercraft, katamari, particles, ragdoll, "
        "rope, turntable, vehicle); "
        "call register_module() first");
}

TEST(SceneErrors, rejects_invalid_module_settings_and_unknown_bodies) {
    test::register_turntable();
    const std::string tag = "\"tag\": \"turntable\", ";
    expect_refused(with_module(tag + "\"settings\": {\n\"speed\": \"2\"}"),
                   "line 6: modules[0].settings.speed: must be a number, not string");
    expect_refused(with_module(tag + "\"settings\": [1]"),
                   "line 5: modules[0].settings: must be an object {...}, not array");
    expect_refused(with_module(tag + "\"settings\": {\n\"top speed\": 2}"),
                   "line 5: modules[0].settings: \"top speed\" is not a valid name; it must be 1 "
                   "to 64 of a-z, "
                   "0-9 and _");
    expect_refused(with_module(tag + "\"settings\": {\"speed\": 1,\n\"speed\": 2}"),
                   "line 5: modules[0].settings.speed: is a duplicate; remove one of them");
    expect_refused(with_module(tag + "\"bodies\": {\n\"disc\": \"disk\"}"),
                   "line 6: modules[0].bodies.disc: is \"disk\"; no body has the name \"disk\"");
    expect_refused(with_module(tag + "\"bodies\": {\n\"disc\": 1}"),
                   "line 6: modules[0].bodies.disc: must be a string in quotes, not number");
}

TEST(SceneErrors, reports_settings_and_state_rejected_by_the_module) {
    test::register_turntable();
    const std::string tag = R"("tag": "turntable", "bodies": {"disc": "disc"}, )";
    expect_not_built(with_module(tag + R"("settings": {"speeed": 2})"),
                     "modules[0] 'turntable': has no setting \"speeed\"; it has gain and speed");
    expect_refused(with_module(tag + "\n\"state\": \"not bytes\""),
                   "line 6: modules[0].state: must be base64 bytes, a string in quotes");
    expect_not_built(with_module(tag + R"("state": "AAAA")"),
                     "modules[0] 'turntable': state of module \"turntable\": "
                     "turntable.state.disc.index is missing: the data ends before it (at byte 3)");
}

}  // namespace jostle::scenes

// SPDX-License-Identifier: MIT
//
// Scene file: reads a world from JSON, simulates it, and writes the scene back. Errors in a file
// are reported with file, line and field.
//
// Shows: load_scene, read_scene_json, build_scene, write_scene_json.
// Run:   build/dev/bin/jostle-scene-file                 a built-in scene text
//        build/dev/bin/jostle-scene-file my_scene.json   a file, or a name of the catalogue
#include <cstdio>

#include "jostle/scenes/scene_file.h"

using namespace jostle;

namespace {

constexpr const char* seesaw = R"({
  "name": "seesaw",
  "bodies": [
    { "name": "floor", "type": "BODY_TYPE_STATIC", "shapes": [ { "plane": {} } ] },
    { "name": "plank", "position": { "x": 0, "y": 0.6, "z": 0 },
      "shapes": [ { "box": { "half_extents": { "x": 2, "y": 0.05, "z": 0.3 } }, "mass": 20 } ] },
    { "name": "crate", "position": { "x": 1.7, "y": 2, "z": 0 },
      "shapes": [ { "box": { "half_extents": { "x": 0.2, "y": 0.2, "z": 0.2 } }, "mass": 10 } ] }
  ],
  "joints": [
    { "name": "pivot", "body_b": "plank",
      "frame": { "position": { "x": 0, "y": 0.6, "z": 0 } },
      "hinge": { "limit": { "lower": -0.3, "upper": 0.3 } } }
  ]
})";

}  // namespace

int main(int argc, char** argv) {
    const auto scene = argc > 1 ? scenes::load_scene(argv[1]) : scenes::read_scene_json(seesaw);
    if (!scene.ok()) {
        std::fprintf(stderr, "%s\n", scene.error().message.c_str());
        return 1;
    }
    scenes::BuiltScene built = scenes::build_scene(*scene).value();
    for (int step = 0; step < static_cast<int>(2 * scene->hz); step++)
        built.world.step(1 / scene->hz).expect();

    std::printf("scene \"%s\" after %.1f s:\n", scene->name.c_str(), built.world.time());
    for (std::size_t k = 0; k < built.bodies.size() && k < 10; k++) {
        const physics::Vec3 at = built.world.body(built.bodies[k])->pose.position;
        std::printf("  %-8s (%.2f, %.2f, %.2f) m\n", scene->bodies[k].name.c_str(), at.x, at.y,
                    at.z);
    }
    // A scene that is written and read again builds the same world.
    const std::string text = scenes::write_scene_json(*scene);
    const bool readable = scenes::read_scene_json(text).ok();
    std::printf("written as %s JSON\n", readable ? "valid" : "INVALID");
    return readable ? 0 : 1;
}

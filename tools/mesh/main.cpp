// SPDX-License-Identifier: MIT
//
// jostle-convert: a closed mesh becomes a body that may move.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>

#include "jostle/modules/convex_decomposition.h"
#include "jostle/physics/compound.h"
#include "jostle/scenes/scene_file.h"
#include "tools/mesh/obj_file.h"

namespace {

using namespace jostle;
using namespace jostle::physics;

constexpr const char* footer = R"(
The mesh must be closed: every edge has a triangle on each side. It is cut across its axes into parts, each of which gets
its convex hull, until the hulls together hold no more than --max-volume-error too much, or there are --max-hulls of them. What came of
it is said: how many hulls, how much more than the mesh they hold, and how far they reach beyond it.

The scene has a ground and the body, which falls on it; put its shape into a scene of your own.

Examples:
  jostle-convert teapot.obj --scene teapot.json
  jostle-convert teapot.obj --max-hulls 64 --max-volume-error 0.01
  jostle-convert chair.obj --scale 0.01 --scene chair.json && jostle-sim chair.json --seconds 3

Exit status: 0 done, 1 the mesh is no solid or a file could not be read or written, 2 wrong flags.)";

struct Flags {
    std::string file, scene;
    decomposition::Options options;
    double scale = 1, density = 1000;
};

int fail(const std::string& what) {
    std::fprintf(stderr, "jostle-convert: %s\n", what.c_str());
    return 1;
}

// Falls from its own height on the ground.
scenes::SceneDescription scene_of(const decomposition::Decomposition& parts, double density) {
    std::vector<CompoundChild> children;
    Aabb bounds = parts.parts.front()->bounds;
    for (const auto& part : parts.parts) {
        children.push_back({Hull{part}, {}});
        bounds = {min(bounds.low, part->bounds.low), max(bounds.high, part->bounds.high)};
    }
    const double height = bounds.high.y - bounds.low.y;
    scenes::SceneDescription scene;
    scene.name = "converted";
    scene.bodies.push_back({.name = "ground",
                            .body = {.type = BodyType::static_body},
                            .shapes = {{.geometry = Plane{}}}});
    scene.bodies.push_back({.name = "body",
                            .body = {.pose = {.position = {0, height - bounds.low.y, 0}}},
                            .shapes = {{.geometry = Compound{*build_compound(std::move(children))},
                                        .density = density}}});
    return scene;
}

int run(const Flags& flags) {
    std::ifstream in(flags.file, std::ios::binary);
    if (!in) return fail("cannot read " + flags.file);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    Result<convert::ObjMesh> mesh = convert::read_obj(text);
    if (!mesh.ok()) return fail(flags.file + ": " + mesh.error().message);
    for (Vec3& p : mesh->vertices) p = p * flags.scale;
    const auto parts = decomposition::decompose(mesh->vertices, mesh->indices, flags.options);
    if (!parts.ok()) return fail(flags.file + ": " + parts.error().message);
    std::printf(
        "triangles  %zu\nvolume     %.6g m^3\nhulls      %zu\nexcess     %.3g %% of the volume\n"
        "furthest   %.3g m beyond the mesh\n",
        mesh->indices.size() / 3, parts->mesh_volume, parts->parts.size(),
        100 * parts->max_volume_error, parts->max_distance);
    if (flags.scene.empty()) return 0;
    std::ofstream out(flags.scene, std::ios::binary);
    out << scenes::write_scene_json(scene_of(*parts, flags.density));
    out.close();
    return out ? 0 : fail("cannot write " + flags.scene);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Makes convex hulls of a closed mesh, so that a body with its shape may move."};
    Flags flags;
    app.footer(footer);
    app.add_option("file", flags.file, "A Wavefront OBJ file")
        ->required()
        ->check(CLI::ExistingFile);
    app.add_option("--max-hulls", flags.options.hulls_max, "Hulls at most")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_option("--max-volume-error", flags.options.max_volume_error,
                   "Of the volume, that hulls may hold too much")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    app.add_option("--planes-per-axis", flags.options.planes_per_axis,
                   "Cuts that are tried across each axis")
        ->check(CLI::Range(1, 127))
        ->capture_default_str();
    app.add_option("--scale", flags.scale, "Metres to a unit of the file")
        ->check(CLI::Range(1e-6, 1e6))
        ->capture_default_str();
    app.add_option("--density", flags.density, "kg/m^3")
        ->check(CLI::Range(1e-3, 1e6))
        ->capture_default_str();
    app.add_option("--scene", flags.scene, "Writes a scene with the body here");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    return run(flags);
}

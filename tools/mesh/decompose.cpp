// SPDX-License-Identifier: MIT
//
// jostle-mesh decompose: converts a closed mesh to a dynamic body of convex hulls.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>

#include "jostle/modules/convex_decomposition.h"
#include "jostle/physics/compound.h"
#include "jostle/scenes/scene_file.h"
#include "tools/mesh/commands.h"
#include "tools/mesh/obj_file.h"

namespace jostle::mesh {
namespace {

using namespace physics;

constexpr const char* footer = R"(
The mesh must be closed: every edge has a triangle on each side. It is cut into parts, and each part
is replaced by its convex hull, until the excess volume of the hulls is at most --max-volume-error
or there are --max-hulls of them. The output lists the number of hulls, their excess volume, and
their largest distance from the mesh.

The scene contains a ground plane and the body above it.

Examples:
  jostle-mesh decompose teapot.obj --scene teapot.json
  jostle-mesh decompose teapot.obj --max-hulls 64 --max-volume-error 0.01
  jostle-mesh decompose chair.obj --scale 0.01 --scene chair.json

Exit status: 0 success, 1 the mesh is not a solid or a file cannot be read or written, 2 invalid
flags.)";

struct Flags {
    std::string file, scene;
    modules::convex_decomposition::Options options;
    double scale = 1, density = 1000;
};

int fail(const std::string& what) {
    std::fprintf(stderr, "jostle-mesh: %s\n", what.c_str());
    return 1;
}

// The body falls onto the ground from its own height.
scenes::SceneDescription scene_of(const modules::convex_decomposition::Decomposition& parts,
                                  double density) {
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
    Result<ObjMesh> mesh = read_obj(text);
    if (!mesh.ok()) return fail(flags.file + ": " + mesh.error().message);
    for (Vec3& p : mesh->vertices) p = p * flags.scale;
    const auto parts =
        modules::convex_decomposition::decompose(mesh->vertices, mesh->indices, flags.options);
    if (!parts.ok()) return fail(flags.file + ": " + parts.error().message);
    std::printf(
        "triangles  %zu\nvolume     %.6g m^3\nhulls      %zu\nexcess     %.3g %% of the volume\n"
        "distance   %.3g m from the mesh (maximum)\n",
        mesh->indices.size() / 3, parts->mesh_volume, parts->parts.size(),
        100 * parts->max_volume_error, parts->max_distance);
    if (flags.scene.empty()) return 0;
    std::ofstream out(flags.scene, std::ios::binary);
    out << scenes::write_scene_json(scene_of(*parts, flags.density));
    out.close();
    return out ? 0 : fail("cannot write " + flags.scene);
}

}  // namespace

void add_decompose(CLI::App& app, int& status) {
    CLI::App& command = *app.add_subcommand(
        "decompose", "Decompose a closed mesh into convex hulls, for a dynamic body");
    const auto flags = std::make_shared<Flags>();
    command.footer(footer);
    command.add_option("FILE", flags->file, "Wavefront OBJ file")
        ->type_name("")
        ->required()
        ->check(CLI::ExistingFile.description(""));
    command
        .add_option("--max-hulls", flags->options.hulls_max,
                    "Create at most N hulls [default: 32; 1 to 1024]")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    command
        .add_option("--max-volume-error", flags->options.max_volume_error,
                    "Allow this share of excess volume [default: 0.03; 0 to 10]")
        ->type_name("RATIO")
        ->check(CLI::Range(0.0, 10.0).description(""));
    command
        .add_option("--planes-per-axis", flags->options.planes_per_axis,
                    "Try N cuts across each axis of a part [default: 15; 1 to 127]")
        ->type_name("N")
        ->check(CLI::Range(1, 127).description(""));
    command
        .add_option("--scale", flags->scale,
                    "Scale the mesh by FACTOR metres per unit [default: 1; 1e-6 to 1e6]")
        ->type_name("FACTOR")
        ->check(CLI::Range(1e-6, 1e6).description(""));
    command
        .add_option("--density", flags->density,
                    "Density of the body in kg/m^3 [default: 1000; 0.001 to 1e6]")
        ->type_name("DENSITY")
        ->check(CLI::Range(1e-3, 1e6).description(""));
    command.add_option("--scene", flags->scene, "Write a scene with the body to FILE")
        ->type_name("FILE");
    command.callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::mesh

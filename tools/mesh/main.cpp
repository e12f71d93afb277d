// SPDX-License-Identifier: MIT
//
// jostle-mesh: prepares closed meshes for scenes, as convex hulls or as breakable chunks.
#include "base/command_line/command_line.h"
#include "tools/mesh/commands.h"

namespace {

constexpr const char* footer = R"(
Meshes are Wavefront OBJ files. A mesh must be closed: every edge has a triangle on each side.

Examples:
  jostle-mesh decompose teapot.obj --scene teapot.json && jostle-sim teapot.json --seconds 3
  jostle-mesh fracture statue.obj --chunks 500 --anchor -y --out statue.fracture
  jostle-mesh fracture --help

Exit status: 0 success, 1 the mesh is not a solid or a file cannot be read or written, 2 invalid
flags.)";

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Prepare meshes for scenes: decompose them into convex hulls, or fracture them."};
    app.require_subcommand(1);
    app.footer(footer);
    int status = 0;
    jostle::mesh::add_decompose(app, status);
    jostle::mesh::add_fracture(app, status);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-mesh", JOSTLE_VERSION}, argc, argv))
        return *status;
    return status;
}

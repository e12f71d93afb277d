// SPDX-License-Identifier: MIT
//
// jostle-mesh fracture: cuts a solid into chunks with bonds, in advance.
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "jostle/base/base64.h"
#include "jostle/modules/fracture_file.h"
#include "tools/mesh/commands.h"
#include "tools/mesh/fracture_solid.h"

namespace jostle::mesh {
namespace {

using namespace physics;

constexpr const char* footer = R"(
A destructible body breaks along surfaces that are computed in advance. This program generates seed
points. The region of the solid that is closer to one seed than to all others becomes a chunk, a
convex hull (Voronoi cell). Chunks that share a face are connected by a bond: a short beam with
the cross-section of the face. The strength of bonds is set where the solid is added to a world
(docs/guides/game_developer/destruction.md).

Patterns:
  uniform    evenly distributed, like stone
  radial     rings and spokes about --center, across the shortest side, like glass
  grid       regular blocks, like masonry
  clustered  small chunks near --center, large ones elsewhere

A mesh must be closed, as for jostle-mesh decompose. A mesh that is not convex is decomposed into convex
parts first (--max-hulls, --max-volume-error). The same seeds cut each part, and bonds connect the
parts where they touch. The number of chunks is then larger than the number of seeds.

--anchor selects a side that is attached to the ground; -y is the bottom. Chunks that are connected
to an anchored chunk do not move.

--scene writes an item for the brackets of
  "modules": [{"destruction": {"fractured": [ ]}}]

Examples:
  jostle-mesh fracture --box 4 3 0.3 --chunks 200 --anchor -y --out wall.fracture
  jostle-mesh fracture --box 2 1.2 0.01 --pattern radial --center 0.3 0.1 0 --out window.fracture
  jostle-mesh fracture statue.obj --scale 0.01 --chunks 500 --anchor -y --out statue.fracture --json -
  jostle-mesh fracture --hull 0 0 0  1 0 0  0 1 0  0 0 1 --chunks 20 --out corner.fracture

Exit status: 0 success, 1 the solid cannot be cut or a file cannot be read or written, 2 invalid
flags.)";

const std::map<std::string, modules::SeedPattern> patterns = {
    {"uniform", modules::SeedPattern::uniform},
    {"radial", modules::SeedPattern::radial},
    {"grid", modules::SeedPattern::grid},
    {"clustered", modules::SeedPattern::clustered}};
const std::map<std::string, Vec3> sides = {{"-x", {-1, 0, 0}}, {"+x", {1, 0, 0}},
                                           {"-y", {0, -1, 0}}, {"+y", {0, 1, 0}},
                                           {"-z", {0, 0, -1}}, {"+z", {0, 0, 1}}};

struct Flags {
    std::string file, pattern = "uniform", anchor, out, scene, json;
    std::vector<double> box, hull, center;
    Solid solid;
    modules::SeedPatternOptions plan;
};

int fail(const std::string& what) {
    std::fprintf(stderr, "jostle-mesh: %s\n", what.c_str());
    return 1;
}

// Shows the progress on a terminal; prints nothing elsewhere.
void show(std::size_t done, std::size_t all) {
    if (isatty(2) == 0) return;
    std::fprintf(stderr, done == all ? "\r\033[K" : "\rcutting %zu of %zu", done, all);
}

std::vector<Vec3> points_of(const std::vector<double>& numbers) {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
        points.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    return points;
}

struct Summary {
    std::size_t chunks = 0, bonds = 0, anchored = 0, bytes = 0;
    double volume = 0, volume_error = 0, smallest = 1e300, largest = 0, bond_area = 0;
};

Summary summary_of(const FracturedSolid& solid, std::size_t bytes) {
    Summary sum{
        .chunks = solid.shape.chunks.size(), .bonds = solid.shape.bonds.size(), .bytes = bytes};
    for (const modules::FractureChunk& chunk : solid.shape.chunks) {
        sum.volume += chunk.volume;
        sum.smallest = std::min(sum.smallest, chunk.volume);
        sum.largest = std::max(sum.largest, chunk.volume);
        sum.anchored += chunk.anchored;
    }
    for (const modules::FractureBond& bond : solid.shape.bonds) sum.bond_area += bond.area;
    sum.volume_error = (sum.volume + solid.lost_volume) / solid.volume - 1;
    return sum;
}

void print(FILE* out, const FracturedSolid& solid, const Summary& sum) {
    std::fprintf(
        out,
        "parts      %zu, %.3g %% excess volume\nchunks     %zu, %.3g to %.3g m^3\nanchored   "
        "%zu\nbonds      %zu, %.6g m^2\nvolume     %.9g m^3, relative error %.2g\nsplinters  "
        "%.3g m^3 omitted\nbytes      %zu\n",
        solid.parts, 100 * solid.max_volume_error, sum.chunks, sum.smallest, sum.largest,
        sum.anchored, sum.bonds, sum.bond_area, sum.volume, sum.volume_error, solid.lost_volume,
        sum.bytes);
}

nlohmann::ordered_json to_json(const Flags& flags, const FracturedSolid& solid,
                               const Summary& sum) {
    return {{"pattern", flags.pattern},
            {"seed", flags.plan.seed},
            {"seeds", flags.plan.count},
            {"parts", solid.parts},
            {"excess", solid.max_volume_error},
            {"chunks", sum.chunks},
            {"anchored", sum.anchored},
            {"bonds", sum.bonds},
            {"bond_area_m2", sum.bond_area},
            {"volume_m3", sum.volume},
            {"volume_error", sum.volume_error},
            {"lost_m3", solid.lost_volume},
            {"smallest_m3", sum.smallest},
            {"largest_m3", sum.largest},
            {"bytes", sum.bytes}};
}

bool write_file(const std::string& path, const char* data, std::size_t size) {
    std::ofstream out(path, std::ios::binary);
    out.write(data, static_cast<std::streamsize>(size));
    out.close();
    return static_cast<bool>(out);
}

// An item of "fractured" for a scene file, without position and material.
std::string scene_item(std::span<const std::byte> bytes) {
    return nlohmann::ordered_json{{"shape", encode_base64(bytes)}}.dump() + "\n";
}

int report(const Flags& flags, const FracturedSolid& solid, std::size_t bytes) {
    const Summary sum = summary_of(solid, bytes);
    const std::string text = to_json(flags, solid, sum).dump(2) + "\n";
    if (flags.json == "-")
        std::fputs(text.c_str(), stdout);
    else
        print(stdout, solid, sum);
    if (flags.json.empty() || flags.json == "-") return 0;
    return write_file(flags.json, text.data(), text.size()) ? 0
                                                            : fail("cannot write " + flags.json);
}

int run(Flags& flags) {
    std::string text;
    if (!flags.file.empty()) {
        std::ifstream in(flags.file, std::ios::binary);
        if (!in) return fail("cannot read " + flags.file);
        text.assign((std::istreambuf_iterator<char>(in)), {});
        flags.solid.obj = text;
    }
    if (!flags.box.empty()) flags.solid.box = points_of(flags.box)[0];
    flags.solid.points = points_of(flags.hull);
    flags.plan.pattern = patterns.at(flags.pattern);
    if (!flags.center.empty()) flags.plan.center = points_of(flags.center)[0];
    const auto anchor =
        flags.anchor.empty() ? std::optional<Vec3>() : std::optional(sides.at(flags.anchor));
    const auto solid = fracture_solid(flags.solid, flags.plan, anchor, show);
    if (!solid.ok())
        return fail((flags.file.empty() ? "" : flags.file + ": ") + solid.error().message);
    const auto bytes = modules::write_fracture(solid->shape);
    if (!bytes.ok()) return fail(bytes.error().message);
    if (!flags.out.empty() &&
        !write_file(flags.out, reinterpret_cast<const char*>(bytes->data()), bytes->size()))
        return fail("cannot write " + flags.out);
    if (!flags.scene.empty()) {
        const std::string item = scene_item(*bytes);
        if (!write_file(flags.scene, item.data(), item.size()))
            return fail("cannot write " + flags.scene);
    }
    return report(flags, *solid, bytes->size());
}

void add_solid(CLI::App& app, Flags& flags) {
    CLI::Option_group* solid = app.add_option_group("Solid", "Select exactly one");
    solid->add_option("FILE", flags.file, "Wavefront OBJ file of a closed mesh")
        ->type_name("")
        ->check(CLI::ExistingFile.description(""));
    solid->add_option("--box", flags.box, "Cut a box with these edge lengths")
        ->type_name("METRES")
        ->expected(3);
    solid
        ->add_option("--hull", flags.hull,
                     "Cut the convex hull of points, each x y z [4 to 1000 points]")
        ->type_name("METRES")
        ->expected(12, 3000);
    solid->require_option(1);
    app.add_option("--scale", flags.solid.scale,
                   "Scale the mesh by FACTOR metres per unit [default: 1; 1e-6 to 1e6]")
        ->type_name("FACTOR")
        ->check(CLI::Range(1e-6, 1e6).description(""));
    app.add_option("--max-hulls", flags.solid.decomposition.hulls_max,
                   "Decompose a mesh into at most N convex parts [default: 32; 1 to 1024]")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    app.add_option("--max-volume-error", flags.solid.decomposition.max_volume_error,
                   "Allow this share of excess volume in parts [default: 0.03; 0 to 10]")
        ->type_name("RATIO")
        ->check(CLI::Range(0.0, 10.0).description(""));
}

void add_plan(CLI::App& app, Flags& flags) {
    std::vector<std::string> names;
    for (const auto& [name, pattern] : patterns) names.push_back(name);
    app.add_option("--pattern", flags.pattern,
                   "Distribute the seeds by PATTERN: uniform, radial, grid or clustered\n"
                   "[default: uniform]")
        ->type_name("PATTERN")
        ->check(CLI::IsMember(names).description(""));
    app.add_option(
           "--chunks", flags.plan.count,
           "Generate N seeds [default: 100; 1 to " + std::to_string(modules::chunks_max) + "]")
        ->type_name("N")
        ->check(CLI::Range(1, static_cast<int>(modules::chunks_max)).description(""));
    app.add_option("--seed", flags.plan.seed, "Seed of the random number generator [default: 1]")
        ->type_name("N");
    app.add_option(
           "--center", flags.center,
           "Centre of radial and clustered patterns, x y z\n[default: the centre of the solid]")
        ->type_name("METRES")
        ->expected(3);
    app.add_option("--spread", flags.plan.spread,
                   "Radius of a cluster as a share of the longest side\n"
                   "[default: 0.15; 0.001 to 1]")
        ->type_name("RATIO")
        ->check(CLI::Range(0.001, 1.0).description(""));
}

// CLI11 checks the number of values, but not that it is a multiple of three.
void check_hull(const Flags& flags) {
    if (flags.hull.size() % 3 != 0)
        throw CLI::ValidationError("--hull", "the number of values must be a multiple of three");
}

}  // namespace

void add_fracture(CLI::App& app, int& status) {
    CLI::App& command = *app.add_subcommand(
        "fracture", "Cut a solid into chunks with bonds, for destructible bodies");
    const auto flags = std::make_shared<Flags>();
    command.footer(footer);
    add_solid(command, *flags);
    add_plan(command, *flags);
    std::vector<std::string> names;
    for (const auto& [name, side] : sides) names.push_back(name);
    command
        .add_option("--anchor", flags->anchor,
                    "Anchor the chunks on SIDE: -x, +x, -y, +y, -z or +z [default: none]")
        ->type_name("SIDE")
        ->check(CLI::IsMember(names).description(""));
    command.add_option("--out", flags->out, "Write the fracture file to FILE")->type_name("FILE");
    command.add_option("--scene", flags->scene, "Write an item of a scene file to FILE")
        ->type_name("FILE");
    command
        .add_option("--json", flags->json,
                    "Write the summary to FILE as JSON; \"-\" replaces the table")
        ->type_name("FILE");
    command.callback([flags, &status] {
        check_hull(*flags);
        status = run(*flags);
    });
}

}  // namespace jostle::mesh

// SPDX-License-Identifier: MIT
//
// Families of floors that consist of many pieces, and of presses. A flat floor is a floor however
// it is modelled: bodies that slide or roll over it feel no bump.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/row_family.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

constexpr double floor_length = 16, floor_width = 6;  // m, centred on the origin
constexpr double run_length = 12;                     // m

// Triangles over squares, in the plane z = 0.
class SquareSheet {
public:
    enum class Diagonal { one, other, both };

    // Squares from (x, y) on.
    void add(double x, double y, int columns, int rows, double side, Diagonal diagonal) {
        const auto base = static_cast<std::uint32_t>(vertices.size());
        const auto width = static_cast<std::uint32_t>(columns + 1);
        for (int r = 0; r <= rows; r++)
            for (int c = 0; c <= columns; c++) vertices.push_back({x + c * side, y + r * side, 0});
        for (int r = 0; r < rows; r++)
            for (int c = 0; c < columns; c++) {
                const std::uint32_t at =
                    base + static_cast<std::uint32_t>(r) * width + static_cast<std::uint32_t>(c);
                add_square(at, at + width, diagonal);
            }
    }
    // The whole floor in squares of about this side, whole numbers of which fill it.
    void add_floor(double side, Diagonal diagonal) {
        const int columns = std::max(1, static_cast<int>(std::lround(floor_length / side)));
        const double exact = floor_length / columns;
        const int rows = static_cast<int>(std::ceil(floor_width / exact));
        add(-0.5 * floor_length, -0.5 * rows * exact, columns, rows, exact, diagonal);
    }
    Body body() const {
        return fixed_shape(physics::Mesh{physics::build_mesh(vertices, triangles).value()}, {});
    }

    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;

private:
    void add_square(std::uint32_t at, std::uint32_t next, Diagonal diagonal) {
        if (diagonal != Diagonal::other) {
            triangles.push_back({at, at + 1, next + 1});
            triangles.push_back({at, next + 1, next});
        }
        if (diagonal != Diagonal::one) {
            triangles.push_back({at, at + 1, next});
            triangles.push_back({at + 1, next + 1, next});
        }
    }
};

using Diagonal = SquareSheet::Diagonal;

Body welded_mesh(double side, Diagonal diagonal) {
    SquareSheet sheet;
    sheet.add_floor(side, diagonal);
    return sheet.body();
}

Body doubled_mesh(double side) {
    SquareSheet sheet;
    sheet.add_floor(side, Diagonal::one);
    const auto once = sheet.triangles;
    for (const auto& t : once) sheet.triangles.push_back({t[0], t[2], t[1]});
    return sheet.body();
}

// Every second triangle faces down.
Body mesh_of_mixed_winding(double side) {
    SquareSheet sheet;
    sheet.add_floor(side, Diagonal::one);
    for (std::size_t k = 0; k < sheet.triangles.size(); k += 2)
        std::swap(sheet.triangles[k][1], sheet.triangles[k][2]);
    return sheet.body();
}

// Each corner has its own vertex, up to 1e-5 m away.
Body mesh_of_loose_corners(double side) {
    SquareSheet sheet, loose;
    sheet.add_floor(side, Diagonal::one);
    std::mt19937 random{3};
    const auto jitter = [&] { return 2e-5 * (static_cast<double>(random()) / 0x1p32 - 0.5); };
    for (const auto& t : sheet.triangles) {
        const auto first = static_cast<std::uint32_t>(loose.vertices.size());
        for (const std::uint32_t corner : t) {
            const double x = jitter(), y = jitter();
            loose.vertices.push_back(sheet.vertices[corner] + Vec3{x, y, 0});
        }
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    return loose.body();
}

// Neighbouring strips have squares of different sizes, so that corners lie on edges.
Body mesh_of_uneven_strips() {
    SquareSheet sheet;
    for (int k = 0; k < static_cast<int>(floor_length); k++) {
        const int per_metre = k % 2 + 2;
        sheet.add(-0.5 * floor_length + k, -0.5 * floor_width, per_metre,
                  static_cast<int>(floor_width) * per_metre, 1.0 / per_metre, Diagonal::one);
    }
    return sheet.body();
}

std::vector<Body> strips_of_mesh(double side) {
    std::vector<Body> strips;
    for (int k = 0; k < static_cast<int>(floor_length); k++) {
        SquareSheet sheet;
        const int per_metre = std::max(1, static_cast<int>(std::lround(1 / side)));
        sheet.add(-0.5 * floor_length + k, -0.5 * floor_width, per_metre,
                  static_cast<int>(floor_width) * per_metre, 1.0 / per_metre, Diagonal::other);
        strips.push_back(sheet.body());
    }
    return strips;
}

// Cubes of this side, flush with each other.
std::vector<Vec3> tile_centres(double side) {
    std::vector<Vec3> centres;
    const int columns = static_cast<int>(std::ceil(floor_length / side));
    const int rows = static_cast<int>(std::ceil(floor_width / side));
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < columns; c++)
            centres.push_back(
                {(c - 0.5 * (columns - 1)) * side, (r - 0.5 * (rows - 1)) * side, -0.5 * side});
    return centres;
}

std::vector<Body> tiles_of(physics::Geometry tile, double side) {
    std::vector<Body> tiles;
    for (const Vec3 centre : tile_centres(side)) tiles.push_back(fixed_shape(tile, centre));
    return tiles;
}

physics::Geometry box_tile(double side) {
    return physics::Box{Vec3{0.5, 0.5, 0.5} * side};
}

physics::Geometry hull_tile(double side) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; k++)
        corners.push_back(Vec3{k % 2 - 0.5, k / 2 % 2 - 0.5, k / 4 - 0.5} * side);
    return physics::Hull{physics::build_hull(corners).value()};
}

Body compound_of_tiles(double side) {
    std::vector<physics::CompoundChild> children;
    for (const Vec3 centre : tile_centres(side)) children.push_back({box_tile(side), {centre, {}}});
    return fixed_shape(physics::Compound{physics::build_compound(children).value()}, {});
}

// Its heights are along y: rotated to z.
Body level_field(double side, double length, double x) {
    const auto columns = static_cast<std::uint32_t>(std::lround(length / side)) + 1;
    const double exact = length / (columns - 1);
    const auto rows = static_cast<std::uint32_t>(std::ceil(floor_width / exact)) + 1;
    const std::size_t count = std::size_t{columns} * rows;
    const auto grid = physics::build_height_field({.columns = columns,
                                                   .rows = rows,
                                                   .spacing_x = exact,
                                                   .spacing_z = exact,
                                                   .heights = std::vector<double>(count, 0.0)});
    return fixed_shape(physics::HeightField{grid.value()}, {x, 0, 0},
                       physics::from_axis_angle({1, 0, 0}, 0.5 * pi));
}

std::vector<Body> fields_and_boxes(double side) {
    std::vector<Body> bodies;
    for (int k = 0; k < 8; k++) {
        const double x = 2 * k - 7;
        bodies.push_back(k % 2 == 0 ? level_field(std::min(side, 1.0), 2, x)
                                    : fixed_box({1, 0.5 * floor_width, 0.5}, {x, 0, -0.5}));
    }
    return bodies;
}

const std::vector<std::string> floor_models = {
    "plane",           "mesh",       "doubled mesh",      "mesh with both diagonals",
    "mixed winding",   "loose mesh", "uneven mesh",       "strips of mesh",
    "box tiles",       "hull tiles", "compound of tiles", "height field",
    "fields and boxes"};

std::vector<Body> floor_of(const std::string& model, double side) {
    if (model == "mesh") return {welded_mesh(side, Diagonal::one)};
    if (model == "doubled mesh") return {doubled_mesh(side)};
    if (model == "mesh with both diagonals") return {welded_mesh(side, Diagonal::both)};
    if (model == "mixed winding") return {mesh_of_mixed_winding(side)};
    if (model == "loose mesh") return {mesh_of_loose_corners(side)};
    if (model == "uneven mesh") return {mesh_of_uneven_strips()};
    if (model == "strips of mesh") return strips_of_mesh(side);
    if (model == "box tiles") return tiles_of(box_tile(side), side);
    if (model == "hull tiles") return tiles_of(hull_tile(side), side);
    if (model == "compound of tiles") return {compound_of_tiles(side)};
    if (model == "height field") return {level_field(side, floor_length, 0)};
    if (model == "fields and boxes") return fields_and_boxes(side);
    return {fixed_plane()};
}

// Primary: largest deviation from the height at the start. Second: largest change of velocity.
class BumpMeter final : public Meter {
public:
    BumpMeter(double height, Vec3 velocity) : height_(height), velocity_(velocity) {}
    void sample(double, const Engine& engine) override {
        const BodyState now = engine.state(0);
        most_.primary = std::max(most_.primary, std::abs(now.position.z - height_));
        most_.secondary = std::max(most_.secondary, length(now.velocity - velocity_));
    }
    Errors errors() const override { return most_; }

private:
    double height_;
    Vec3 velocity_;
    Errors most_;
};

// Boxes, cans and lying capsules slide without friction; balls roll.
ExperimentRun ride(const Values& v) {
    const std::string& rider = v.choice("rider");
    const double size = v["size"], course = v["heading"] * pi / 180;
    const double yaw = v["yaw"] * pi / 180;
    const double speed = v["speed"] * (rider == "ball" ? 8 : rider == "capsule" ? 25 : 2);
    const Vec3 forward = azimuth(course);
    const Quat turned = physics::from_axis_angle({0, 0, 1}, course + yaw);
    Scene scene{.name = "floor", .friction = rider == "ball" ? 0.5 : 0.0};
    const Vec3 at = forward * (-0.5 * run_length) + Vec3{0, 0.137, size};
    Body body = solid_box(1, {size, size, size}, at);
    body.pose.rotation = turned;
    if (rider == "ball") body = solid_sphere(1, size, at);
    if (rider == "capsule") {
        body = solid_capsule(1, size, 2 * size, at);
        body.pose.rotation = turned;
    }
    if (rider == "can") {
        body = solid_cylinder(1, size, size, at);
        body.pose.rotation = turned * physics::from_axis_angle({1, 0, 0}, 0.5 * pi);
    }
    body.velocity = forward * speed;
    if (rider == "ball") body.spin = cross({0, 0, 1}, forward) * (speed / size);
    auto meter = std::make_unique<BumpMeter>(size, body.velocity);
    scene.bodies = {std::move(body)};
    for (Body& piece : floor_of(v.choice("floor"), v["side"]))
        scene.bodies.push_back(std::move(piece));
    return {std::move(scene), run_length / speed, std::move(meter)};
}

// A plate squeezes a crate to a part of its height, stays for half a second and rises again.
ExperimentRun press(const Values& v) {
    const double half = v["half"], speed = v["speed"], clearance = 0.1;
    const double depth = 2 * half * (1 - v["height"]), down = (clearance + depth) / speed;
    Scene scene{.name = "press", .friction = 0.5};
    Body plate = fixed_box({3 * half, 3 * half, 0.2}, {0, 0, 2 * half + clearance + 0.2});
    plate.motion = Motion::kinematic;
    scene.bodies = {
        solid_box(v["mass"], Vec3{1, 1, 1} * half, {0, 0, half}), plate,
        v.choice("floor") == "plane" ? fixed_plane() : fixed_box({20, 20, 1}, {0, 0, -1})};
    const auto travel = [=](double t) {  // m, downwards
        const double open = down + 0.5;
        return t < open ? std::min(t * speed, down * speed)
                        : std::max((down - (t - open)) * speed, -0.5);
    };
    auto meter = last_meter([=](double, const Engine& engine) {
        const Vec3 at = engine.state(0).position;
        return Errors{std::abs(at.z - half) / (2 * half), std::hypot(at.x, at.y) / (2 * half)};
    });
    return {.scene = std::move(scene),
            .seconds = 2 * down + 5,
            .meter = std::move(meter),
            .drive = [travel](double t, double dt, Engine& engine) {
                engine.set_velocity(1, {0, 0, (travel(t) - travel(t + dt)) / dt});
            }};
}

}  // namespace

std::vector<RowFamily> floor_families() {
    return {
        {.name = "floor",
         .about = "a body slides or rolls over a floor of many pieces",
         .measures = "largest bump, m; largest change of velocity, m/s",
         .tolerances = {0.002, 5e-4},  // a tenth of which is the depth of contacts at rest
         .parameters = {{.name = "floor", .choices = floor_models},
                        {.name = "rider", .choices = {"box", "ball", "capsule", "can"}},
                        {"side, m", 0.25, 1, Parameter::Scale::logarithmic},
                        {"size, m", 0.1, 0.4},
                        {"heading, deg", -8, 8},
                        {"yaw, deg", 0, 180},
                        {"speed", 0.7, 1.3}},
         .drawn = 26,
         .limit = 0.002,
         .second_limit = 0.02,
         .short_max_hz = 120,
         .start = [](const Values& v, double) { return ride(v); }},
        {.name = "press",
         .about = "a press squeezes a crate and opens again",
         .measures = "error of the height at the end / size; horizontal displacement / size",
         .tolerances = {0.01, 0.001},
         .parameters = {{.name = "floor", .choices = {"plane", "box"}},
                        {"half, m", 0.2, 1},
                        {"height", 0.3, 0.95},
                        {"speed, m/s", 0.3, 2},
                        {"mass, kg", 1, 1000, Parameter::Scale::logarithmic}},
         .limit = 0.01,
         .start = [](const Values& v, double) { return press(v); }},
    };
}

}  // namespace jostle::bench::accuracy

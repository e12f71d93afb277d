// SPDX-License-Identifier: MIT
//
// Cloth: a flag, a banner and a tablecloth in gusts of wind, and curtains to drive through.
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// Builds the settings of one cloth.
class ClothObject {
public:
    ClothObject(std::uint32_t rows, std::uint32_t columns, Vec3 origin, Vec3 across, Vec3 down) {
        settings_["grid_rows"] = rows;
        settings_["grid_columns"] = columns;
        vector("grid_origin", origin);
        vector("grid_across", across);
        vector("grid_down", down);
    }
    ClothObject& set(const std::string& name, double value) {
        settings_[name] = value;
        return *this;
    }
    // At a point of the world.
    ClothObject& attach(std::uint32_t vertex, Vec3 point) {
        const std::string name = "attachments" + std::to_string(++attachments_);
        settings_[name + "_vertex"] = vertex;
        vector(name + "_point", point);
        return *this;
    }
    ClothObject& attach(std::uint32_t vertex, std::size_t body, Vec3 point) {
        attach(vertex, point);
        bodies_["attachments" + std::to_string(attachments_) + "_body"] = body;
        return *this;
    }
    // Gusts that come from the side of the flags.
    ClothObject& blow(double speed, double gust) {
        vector("wind", {speed, 0, 0.1 * speed});
        vector("gust", {gust, 0, gust});
        return set("gust_period", 2.7);
    }
    void add_to(SceneModule& cloths) const {
        cloths.objects.push_back({.list = "cloths", .settings = settings_, .bodies = bodies_});
    }

private:
    void vector(const std::string& name, Vec3 v) {
        settings_[name + "_x"] = v.x;
        settings_[name + "_y"] = v.y;
        settings_[name + "_z"] = v.z;
    }

    std::map<std::string, double> settings_;
    std::map<std::string, std::size_t> bodies_;
    int attachments_ = 0;
};

SceneModule cloth_module() {
    return {.tag = "cloth", .settings = {}, .bodies = {}, .state = {}};
}

void add_walker(SceneDescription& scene, Vec3 at) {
    SceneBody walker = dynamic_body("walker1", at, Capsule{0.28, 0.6});
    walker.body.type = BodyType::kinematic;
    scene.modules.push_back({.tag = "character",
                             .settings = {},
                             .bodies = {{"walker1", scene.bodies.size()}},
                             .state = {}});
    scene.bodies.push_back(colored(walker, 0xf4a261));
}

// Strips of cloth that hang from a beam across the road.
void add_curtain(SceneDescription& scene, SceneModule& cloths, double z, std::uint32_t color) {
    constexpr double height = 3.2, width = 0.55;
    const std::string name = std::to_string(static_cast<int>(z));
    scene.bodies.push_back(
        colored(fixed_box("beam " + name, {0, height + 0.1, z}, {3.2, 0.1, 0.1}), 0x6c757d));
    for (const double x : {-3.1, 3.1})
        scene.bodies.push_back(colored(fixed_box((x < 0 ? "left " : "right ") + name,
                                                 {x, height / 2, z}, {0.1, height / 2, 0.1}),
                                       0x6c757d));
    for (int k = 0; k < 10; k++)
        ClothObject(21, 5, {-2.8 + 0.56 * k, height - 0.02, z}, {width, 0, 0}, {0, -3, 0})
            .set("hang", 1)
            .set("thickness", 0.02)
            .set("friction", 0.2)
            .set("damping", 0.5)
            .set("mass_per_area", 0.4)
            .set("color", color)
            .add_to(cloths);
}

}  // namespace

SceneDescription flag() {
    SceneDescription scene;
    scene.bodies.push_back(ground());
    SceneModule cloths = cloth_module();
    scene.bodies.push_back(
        colored(fixed_box("pole", {-0.06, 2.5, 0}, {0.04, 2.5, 0.04}), 0xadb5bd));
    ClothObject flag(16, 24, {0, 4.9, 0}, {1.8, 0, 0}, {0, -1.2, 0});
    flag.set("color", 0xd62828).set("mass_per_area", 0.12).set("collide_bodies", 0).blow(9, 3);
    for (std::uint32_t r = 0; r < 16; r++) flag.attach(24 * r, {0, 4.9 - 0.08 * r, 0});
    flag.add_to(cloths);
    // A banner that carries a bar.
    for (const double x : {4.0, 6.0})
        scene.bodies.push_back(
            colored(fixed_box(x < 5 ? "post 1" : "post 2", {x, 2, 0}, {0.05, 2, 0.05}), 0xadb5bd));
    SceneBody bar = dynamic_body("bar", {5, 2.47, 0}, Box{{0.8, 0.03, 0.03}});
    bar.shapes[0].density = 400;
    scene.bodies.push_back(colored(bar, 0x7f5539));
    ClothObject banner(16, 17, {4.2, 3.9, 0}, {1.6, 0, 0}, {0, -1.4, 0});
    banner.set("hang", 1).set("color", 0x1d3557).blow(1, 5);
    for (std::uint32_t c = 0; c < 17; c += 2)
        banner.attach(15 * 17 + c, scene.bodies.size() - 1, {0.1 * c - 0.8, 0.03, 0});
    banner.add_to(cloths);
    // A cloth over a table, out of the wind.
    scene.bodies.push_back(colored(fixed_box("table", {-4, 0.4, 2}, {0.6, 0.4, 0.6}), 0x7f5539));
    ClothObject(31, 31, {-4.9, 1, 1.1}, {1.8, 0, 0}, {0, 0, 1.8})
        .set("thickness", 0.01)
        .set("damping", 1)
        .set("collide_self", 1)
        .set("color", 0xf1faee)
        .add_to(cloths);
    for (int k = 0; k < 3; k++) {
        SceneBody ball =
            dynamic_body("ball " + std::to_string(k + 1), {5, 0.2, 2.0 + 0.6 * k}, Sphere{0.2});
        ball.shapes[0].density = 60;
        scene.bodies.push_back(colored(ball, 0xe9c46a));
    }
    scene.modules.push_back(cloths);
    add_walker(scene, {2, 0.9, 3});
    return scene;
}

SceneDescription curtain() {
    SceneDescription scene;
    scene.bodies.push_back(ground());
    SceneModule cloths = cloth_module();
    add_curtain(scene, cloths, 6, 0xc1121f);
    add_curtain(scene, cloths, -6, 0x2a9d8f);
    // A net that stops the car, held by posts.
    ClothObject net(13, 25, {-3, 2.6, -30}, {6, 0, 0}, {0, -2.4, 0});
    net.set("thickness", 0.03)
        .set("stretch_stiffness", 60000)
        .set("mass_per_area", 1)
        .set("damping", 1)
        .set("breaking_load", 40000)
        .set("color", 0xffb703);
    for (std::uint32_t r = 0; r < 13; r++) {
        net.attach(25 * r, {-3, 2.6 - 0.2 * r, -30});
        net.attach(25 * r + 24, {3, 2.6 - 0.2 * r, -30});
    }
    net.add_to(cloths);
    for (const double x : {-3.2, 3.2})
        scene.bodies.push_back(
            colored(fixed_box(x < 0 ? "left post" : "right post", {x, 1.4, -30}, {0.15, 1.4, 0.15}),
                    0x343a40));
    SceneBody car = dynamic_body("car", {0, 0.75, 16}, Box{{0.85, 0.3, 2.0}});
    car.shapes[0].mass = 1200;
    car.body.sleep_allowed = false;
    scene.modules.push_back(
        {.tag = "vehicle", .settings = {}, .bodies = {{"car", scene.bodies.size()}}, .state = {}});
    scene.bodies.push_back(colored(car, 0x457b9d));
    scene.modules.push_back(cloths);
    add_walker(scene, {5, 0.9, 10});
    return scene;
}

}  // namespace jostle::scenes

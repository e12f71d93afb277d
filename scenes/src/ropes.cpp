// SPDX-License-Identifier: MIT
//
// Ropes: a bridge of planks on two ropes over a canyon, and a playground with swings, a tyre, a
// climbing rope and a crane with a winch.
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

using Settings = std::map<std::string, double>;

// Builds the settings of one rope.
class RopeObject {
public:
    RopeObject(std::uint32_t links, double radius, double mass_per_length) {
        settings_["links"] = links;
        settings_["radius"] = radius;
        settings_["mass_per_length"] = mass_per_length;
    }
    RopeObject& set(const std::string& name, double value) {
        settings_[name] = value;
        return *this;
    }
    RopeObject& point(Vec3 at) {
        vector("points" + std::to_string(++points_) + "_position", at);
        return *this;
    }
    // Without a body: at a point of the world.
    RopeObject& attach(std::uint32_t node, Vec3 point) {
        const std::string name = "attachments" + std::to_string(++attachments_);
        settings_[name + "_node"] = node;
        vector(name + "_point", point);
        return *this;
    }
    RopeObject& attach(std::uint32_t node, std::size_t body, Vec3 point) {
        attach(node, point);
        bodies_["attachments" + std::to_string(attachments_) + "_body"] = body;
        return *this;
    }
    void add_to(SceneModule& ropes) const {
        ropes.objects.push_back({.list = "ropes", .settings = settings_, .bodies = bodies_});
    }

private:
    void vector(const std::string& name, Vec3 v) {
        settings_[name + "_x"] = v.x;
        settings_[name + "_y"] = v.y;
        settings_[name + "_z"] = v.z;
    }

    Settings settings_;
    std::map<std::string, std::size_t> bodies_;
    int points_ = 0, attachments_ = 0;
};

SceneModule rope_module() {
    return {.tag = "rope", .settings = {}, .bodies = {}, .state = {}};
}

// Characters in a row that stand until a client controls them.
SceneModule walkers(SceneDescription& scene, Vec3 first, int count) {
    SceneModule module{.tag = "character", .settings = {}, .bodies = {}, .state = {}};
    for (int k = 0; k < count; k++) {
        const std::string name = "walker" + std::to_string(k + 1);
        SceneBody walker = dynamic_body(name, first + Vec3{-1.2 * k, 0, 0}, Capsule{0.28, 0.6});
        walker.body.type = BodyType::kinematic;
        module.bodies[name] = scene.bodies.size();
        scene.bodies.push_back(colored(walker, 0xf4a261));
    }
    return module;
}

// Half of the span of the bridge, the height of its banks, the distance of its ropes and its sag.
constexpr double half_span = 6, bank = 6, rope_side = 0.7, sag = 0.6;
constexpr int planks = 20, links_per_plank = 2;

// Height of the ropes, a parabola.
double deck_height(double x) {
    return bank - sag * (1 - x * x / (half_span * half_span));
}

// The line of a rope from bank to bank.
std::vector<Vec3> deck_line(double height, double z) {
    std::vector<Vec3> line;
    for (int k = -8; k <= 8; k++) {
        const double x = half_span * k / 8;
        line.push_back({x, deck_height(x) + height, z});
    }
    return line;
}

// The point at a fraction of the length of a line, where the module places its nodes.
Vec3 point_of(const std::vector<Vec3>& line, double fraction) {
    double whole = 0;
    for (std::size_t k = 1; k < line.size(); k++) whole += length(line[k] - line[k - 1]);
    double left = fraction * whole;
    for (std::size_t k = 1; k < line.size(); k++) {
        const double piece = length(line[k] - line[k - 1]);
        if (left <= piece) return line[k - 1] + (line[k] - line[k - 1]) * (left / piece);
        left -= piece;
    }
    return line.back();
}

// A rope from bank to bank at a height above the deck.
RopeObject side_rope(std::uint32_t links, double radius, double height, double z) {
    RopeObject rope(links, radius, 0.6);
    rope.set("stretch_stiffness", 2e7).set("damping", 0.5);
    for (const Vec3 point : deck_line(height, z)) rope.point(point);
    rope.attach(0, {-half_span, bank + height, z}).attach(links, {half_span, bank + height, z});
    return rope;
}

// The ropes are attached to the sides of the planks.
void add_bridge(SceneDescription& scene, SceneModule& ropes) {
    const std::uint32_t links = links_per_plank * (planks + 1);
    RopeObject sides[2] = {side_rope(links, 0.03, 0, -rope_side),
                           side_rope(links, 0.03, 0, rope_side)};
    const double spacing = 2 * half_span / (planks + 1);
    for (int k = 0; k < planks; k++) {
        SceneBody plank = dynamic_body("plank " + std::to_string(k + 1),
                                       point_of(deck_line(0, 0), (k + 1.0) / (planks + 1)),
                                       Box{{0.42 * spacing, 0.03, rope_side + 0.05}});
        plank.shapes[0].density = 300;
        plank.shapes[0].material.friction = 0.9;
        plank.body.linear_damping = 0.3;
        plank.body.angular_damping = 1;
        scene.bodies.push_back(colored(plank, 0x9c6644));
        const auto node = static_cast<std::uint32_t>(links_per_plank * (k + 1));
        for (int s = 0; s < 2; s++)
            sides[s].attach(node, scene.bodies.size() - 1, {0, 0, s == 0 ? -rope_side : rope_side});
    }
    for (RopeObject& side : sides) side.set("breaking_load", 30000).add_to(ropes);
    for (const double z : {-rope_side, rope_side}) side_rope(40, 0.02, 1, z).add_to(ropes);
}

}  // namespace

SceneDescription rope_bridge() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x588157));
    for (const double side : {-1.0, 1.0})
        scene.bodies.push_back(colored(
            fixed_box("bank", {side * (half_span + 5), bank / 2, 0}, {5, bank / 2, 5}), 0x6a994e));
    for (const double x : {-half_span - 0.2, half_span + 0.2})
        for (const double z : {-rope_side - 0.1, rope_side + 0.1})
            scene.bodies.push_back(
                colored(fixed_box("post", {x, bank + 0.6, z}, {0.1, 0.6, 0.1}), 0x582f0e));
    SceneModule ropes = rope_module();
    add_bridge(scene, ropes);
    // Sacks to carry across or to drop, and a rope that hangs from the bank.
    for (int k = 0; k < 4; k++) {
        SceneBody sack =
            dynamic_body("sack", {-half_span - 2 - 0.8 * k, bank + 0.4, 2.5}, Sphere{0.35});
        sack.shapes[0].density = 200;
        sack.shapes[0].material = {.friction = 0.9, .rolling_friction = 0.1};
        scene.bodies.push_back(colored(sack, 0xc9ada7));
    }
    RopeObject(40, 0.025, 0.4)
        .point({half_span + 0.5, bank + 0.05, 3})
        .point({half_span - 0.1, bank + 0.1, 3})
        .point({half_span - 0.1, bank - 4.5, 3})
        .attach(0, {half_span + 0.5, bank + 0.05, 3})
        .add_to(ropes);
    scene.modules.push_back(ropes);
    scene.modules.push_back(walkers(scene, {-half_span - 1.5, bank + 0.91, 0}, 3));
    return scene;
}

SceneDescription swings() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x6a994e));
    SceneModule ropes = rope_module();
    // A frame with three swings.
    scene.bodies.push_back(colored(fixed_box("beam", {0, 4, 0}, {4, 0.1, 0.1}), 0x7f5539));
    for (const double x : {-3.9, 3.9})
        scene.bodies.push_back(colored(fixed_box("leg", {x, 2, 0}, {0.1, 2, 0.1}), 0x7f5539));
    for (int k = 0; k < 3; k++) {
        const double x = 2.4 * (k - 1);
        SceneBody seat =
            dynamic_body("seat " + std::to_string(k + 1), {x, 0.8, 0}, Box{{0.35, 0.04, 0.2}});
        seat.shapes[0].density = 400;
        seat.shapes[0].material.friction = 0.9;
        // They swing from the start.
        seat.body.linear_velocity = {0, 0, 1.5 + k};
        scene.bodies.push_back(colored(seat, 0xbc4749));
        for (const double side : {-0.32, 0.32})
            RopeObject(24, 0.015, 0.2)
                .set("collide_bodies", 0)
                .set("damping", 0.02)
                .point({x + side, 4, 0})
                .point({x + side, 0.84, 0})
                .attach(0, {x + side, 4, 0})
                .attach(24, scene.bodies.size() - 1, {side, 0.04, 0})
                .add_to(ropes);
    }
    // A tyre on one rope, and a rope to climb.
    SceneBody tyre =
        dynamic_body("tyre", {7, 1.2, 0}, Cylinder{0.5, 0.15}, from_axis_angle({1, 0, 0}, pi / 2));
    tyre.shapes[0].density = 120;
    scene.bodies.push_back(colored(tyre, 0x343a40));
    RopeObject(30, 0.03, 0.5)
        .point({7, 5, 0})
        .point({7, 1.7, 0})
        .attach(0, {7, 5, 0})
        .attach(30, scene.bodies.size() - 1, {0, 0, -0.5})
        .add_to(ropes);
    scene.bodies.push_back(colored(fixed_box("branch", {8.5, 5.1, 0}, {2.5, 0.1, 0.1}), 0x7f5539));
    RopeObject(40, 0.03, 0.5)
        .point({9.5, 5, 0})
        .point({9.7, 0.2, 0})
        .attach(0, {9.5, 5, 0})
        .add_to(ropes);
    // A crane that lifts a crate, over a pulley that does not turn.
    scene.bodies.push_back(colored(fixed_box("mast", {-9, 3, 0}, {0.15, 3, 0.15}), 0x457b9d));
    SceneBody crate = dynamic_body("crate", {-7, 0.5, 0}, Box{{0.5, 0.5, 0.5}});
    crate.shapes[0].density = 150;
    scene.bodies.push_back(colored(crate, 0xe9c46a));
    RopeObject(40, 0.025, 0.4)
        .set("winch_first", -0.2)
        .point({-7, 6, 0})
        .point({-7, 1, 0})
        .attach(0, {-7, 6, 0})
        .attach(40, scene.bodies.size() - 1, {0, 0.5, 0})
        .add_to(ropes);
    scene.modules.push_back(ropes);
    scene.modules.push_back(walkers(scene, {2, 0.91, 4}, 2));
    return scene;
}

}  // namespace jostle::scenes

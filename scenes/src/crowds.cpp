// SPDX-License-Identifier: MIT
//
// Scenes of the module "crowd": people that walk, flee and leave, and a flock.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

using Object = SceneModule::ModuleObject;

// A static box that is a wall for the crowd as well.
void add_wall(SceneDescription& scene, SceneModule& crowd, const char* name, Vec3 center,
              Vec3 half_extents, std::uint32_t color) {
    crowd.objects.push_back(
        {.list = "obstacles", .settings = {}, .bodies = {{"obstacle_body", scene.bodies.size()}}});
    scene.bodies.push_back(colored(fixed_box(name, center, half_extents), color));
}

void add_goal(SceneModule& crowd, int number, Vec3 center, Vec3 half, int end, int next = 0) {
    crowd.objects.push_back({.list = "goals",
                             .settings = {{"goal_number", number},
                                          {"goal_center_x", center.x},
                                          {"goal_center_z", center.z},
                                          {"goal_half_x", half.x},
                                          {"goal_half_y", 1},
                                          {"goal_half_z", half.z},
                                          {"goal_end", end},
                                          {"goal_next", next}},
                             .bodies = {}});
}

void add_routes(SceneModule& crowd, double half_x, double half_z, double cell) {
    crowd.objects.push_back({.list = "routes",
                             .settings = {{"route_half_x", half_x},
                                          {"route_half_z", half_z},
                                          {"route_cell", cell},
                                          {"route_clearance", 0.3}},
                             .bodies = {}});
}

constexpr int leave = 1, next_goal = 2;                  // GoalEnd
constexpr int dynamic_bodies = 1, kinematic_bodies = 0;  // bodies of a group

}  // namespace

// A market square with stalls and four streets. People stroll between two corners until a bull, a
// blow or an explosion frightens them.
SceneDescription stampede() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0xa39a86));
    scene.bodies.front().shapes.front().material = {.friction = 0.3};
    SceneModule crowd{.tag = "crowd",
                      .settings = {{"panic_time", 5}, {"panic_speed", 4}, {"contagion", 0.6}},
                      .bodies = {},
                      .objects = {},
                      .state = {}};
    add_routes(crowd, 26, 26, 0.5);
    // Houses around the square leave a street of 6 m on each side.
    constexpr std::uint32_t brick = 0x9c6b4f, roof = 0xc8553d;
    for (int k = 0; k < 4; k++) {
        const double x = k % 2 ? 13 : -13, z = k / 2 ? 22 : -22;
        add_wall(scene, crowd, "house", {x, 3, z}, {10, 3, 2}, brick);
        add_wall(scene, crowd, "house", {k / 2 ? 22.0 : -22.0, 3, k % 2 ? 11.5 : -11.5},
                 {2, 3, 8.5}, brick);
    }
    for (int k = 0; k < 6; k++)
        add_wall(scene, crowd, "stall", {-10.0 + 10 * (k % 3), 0.5, k / 3 ? 7.0 : -7.0},
                 {1.6, 0.5, 0.9}, roof);
    add_goal(crowd, 0, {-16, 0, -16}, {2.5, 0, 2.5}, next_goal, 1);
    add_goal(crowd, 1, {16, 0, 16}, {2.5, 0, 2.5}, next_goal, 2);
    add_goal(crowd, 2, {16, 0, -16}, {2.5, 0, 2.5}, next_goal, 3);
    add_goal(crowd, 3, {-16, 0, 16}, {2.5, 0, 2.5}, next_goal, 0);
    crowd.objects.push_back(
        {.list = "flocks",
         .settings = {{"flock_roam", 16}, {"flock_home_y", 14}, {"flock_reach", 5}},
         .bodies = {}});
    for (int k = 0; k < 4; k++)
        crowd.objects.push_back({.list = "groups",
                                 .settings = {{"group_count", 75},
                                              {"group_seed", k + 1},
                                              {"group_center_x", k % 2 ? 9.0 : -9.0},
                                              {"group_center_z", k / 2 ? 13.0 : -13.0},
                                              {"group_half_x", 8},
                                              {"group_half_z", 4},
                                              {"group_bodies", dynamic_bodies},
                                              {"group_goal", k},
                                              {"group_acceleration", 12},
                                              {"group_slows_in_crowds", 1}},
                                 .bodies = {}});
    crowd.objects.push_back({.list = "groups",
                             .settings = {{"group_count", 60},
                                          {"group_kind", 1},
                                          {"group_bodies", kinematic_bodies},
                                          {"group_center_y", 14},
                                          {"group_half_x", 4},
                                          {"group_half_y", 2},
                                          {"group_half_z", 4},
                                          {"group_radius", 0.12},
                                          {"group_speed", 5},
                                          {"group_max_speed", 8},
                                          {"group_acceleration", 12}},
                             .bodies = {}});
    // The bull walks across the square; a client can take or throw it.
    crowd.objects.push_back({.list = "agents",
                             .settings = {{"agent_radius", 0.9},
                                          {"agent_speed", 2.5},
                                          {"agent_max_speed", 5},
                                          {"agent_goal", 2}},
                             .bodies = {{"agent_body", scene.bodies.size()}}});
    crowd.objects.push_back({.list = "threats",
                             .settings = {{"threat_radius", 4.5}},
                             .bodies = {{"threat_body", scene.bodies.size()}}});
    SceneBody bull = dynamic_body("bull", {-23, 0.75, 0}, Box{{0.9, 0.6, 0.45}});
    bull.shapes[0].mass = 600;
    bull.shapes[0].material = {.friction = 0, .friction_rule = Combine::multiply};
    bull.body.sleep_allowed = false;
    scene.bodies.push_back(colored(bull, 0x3b2417));
    Random random(3);
    for (int k = 0; k < 24; k++) {
        const double x = -10.0 + 10 * (k % 3) + random.in(-2.4, 2.4);
        const double z = (k / 3 % 2 ? 9.0 : -9.0) + random.in(-0.5, 0.5);
        SceneBody crate = dynamic_body("crate", {x, 0.26, z}, Box{{0.25, 0.25, 0.25}});
        crate.shapes[0].density = 250;
        scene.bodies.push_back(colored(crate, 0xd9a441));
    }
    scene.modules.push_back(crowd);
    return scene;
}

// A pitch between four stands. The spectators leave through the gates between the stands, and a
// character stands on the pitch for a client to take.
SceneDescription stadium() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x4f7942));
    scene.bodies.front().shapes.front().material = {.friction = 0.3};
    SceneModule crowd{.tag = "crowd", .settings = {}, .bodies = {}, .objects = {}, .state = {}};
    add_routes(crowd, 40, 32, 0.5);
    constexpr std::uint32_t concrete = 0x9aa0a6, rail = 0xd9dde1;
    // The outer wall, with a gate of 3 m in the middle of each side.
    for (const double side : {-1.0, 1.0})
        for (const double half : {-1.0, 1.0}) {
            add_wall(scene, crowd, "wall", {half * 15.75, 1.5, side * 22}, {14.25, 1.5, 0.25},
                     concrete);
            add_wall(scene, crowd, "wall", {side * 30, 1.5, half * 11.75}, {0.25, 1.5, 10.25},
                     concrete);
        }
    // Railings between the blocks of seats and the pitch.
    for (const double side : {-1.0, 1.0})
        for (int k = -2; k <= 2; k++) {
            add_wall(scene, crowd, "railing", {k * 9.0, 0.5, side * 12}, {3, 0.5, 0.1}, rail);
            if (k == 0) continue;
            add_wall(scene, crowd, "railing", {k * 9.0, 0.5, side * 17}, {2, 0.5, 0.1}, rail);
        }
    const Vec3 gates[] = {{0, 0, -26}, {0, 0, 26}, {-34, 0, 0}, {34, 0, 0}};
    for (const Vec3 gate : gates) add_goal(crowd, 0, gate, {2, 0, 2}, leave);
    for (int k = 0; k < 8; k++)
        crowd.objects.push_back({.list = "groups",
                                 .settings = {{"group_count", 75},
                                              {"group_seed", k + 1},
                                              {"group_center_x", -18.0 + 12 * (k % 4)},
                                              {"group_center_z", k / 4 ? 14.5 : -14.5},
                                              {"group_half_x", 4.5},
                                              {"group_half_z", 1.9},
                                              {"group_bodies", dynamic_bodies},
                                              {"group_goal", 0},
                                              {"group_acceleration", 12},
                                              {"group_slows_in_crowds", 1}},
                                 .bodies = {}});
    SceneModule walkers{.tag = "character", .settings = {}, .bodies = {}, .state = {}};
    walkers.bodies["steward"] = scene.bodies.size();
    SceneBody steward = dynamic_body("steward", {0, 0.91, 0}, Capsule{0.28, 0.6});
    steward.body.type = BodyType::kinematic;
    scene.bodies.push_back(colored(steward, 0xffb703));
    SceneBody ball = dynamic_body("ball", {1, 0.12, 0}, Sphere{0.11});
    ball.shapes[0].mass = 0.43;
    ball.shapes[0].material = {.friction = 0.6, .restitution = 0.7};
    scene.bodies.push_back(colored(ball, 0xffffff));
    scene.modules.push_back(crowd);
    scene.modules.push_back(walkers);
    return scene;
}

}  // namespace jostle::scenes

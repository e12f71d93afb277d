// SPDX-License-Identifier: MIT
#include "bench/speed/speed_scenes.h"

#include <cstdio>
#include <stdexcept>
#include <string>

#include "jostle/scenes/bench_scenes.h"
#include "jostle/scenes/catalog.h"

namespace jostle::bench {
namespace {

double value(const ParameterValues& values, Parameter parameter) {
    return *values[static_cast<std::size_t>(parameter)];
}
int count_of(const ParameterValues& values) {
    return static_cast<int>(value(values, Parameter::count));
}
int wheels_of(const ParameterValues& values) {
    return static_cast<int>(value(values, Parameter::wheels));
}
double cell_of(const ParameterValues& values) {
    return value(values, Parameter::cell);
}

// A scene whose only parameter is its size.
template <scenes::SceneDescription (*make)(int)>
scenes::SceneDescription of_size(const ParameterValues& values) {
    return make(count_of(values));
}

scenes::SceneDescription drum(const ParameterValues& values) {
    return scenes::bench_drum(value(values, Parameter::drum_speed));
}
scenes::SceneDescription hull_heap(const ParameterValues& values) {
    return scenes::bench_hull_heap(count_of(values),
                                   static_cast<int>(value(values, Parameter::vertices)));
}
scenes::SceneDescription wheels(const ParameterValues& values) {
    return scenes::bench_wheels(wheels_of(values));
}
scenes::SceneDescription wheels_mesh(const ParameterValues& values) {
    return scenes::bench_wheels_mesh(wheels_of(values), cell_of(values));
}
scenes::SceneDescription hills(const ParameterValues& values) {
    return scenes::bench_mesh(count_of(values), cell_of(values));
}

constexpr ParameterRange level_chain_ranges[] = {{Parameter::count, 1000, 2, 20000}};
constexpr ParameterRange chain_ranges[] = {{Parameter::count, 1000, 1, 20000}};
constexpr ParameterRange drum_ranges[] = {{Parameter::drum_speed, 90, 0, 360}};
constexpr ParameterRange hull_heap_ranges[] = {{Parameter::count, 1000, 1, 20000},
                                               {Parameter::vertices, 64, 8, 128, true}};
constexpr ParameterRange wheels_ranges[] = {{Parameter::wheels, 10, 2, 32, true}};
constexpr ParameterRange wheels_mesh_ranges[] = {{Parameter::wheels, 4, 2, 32, true},
                                                 {Parameter::cell, 0.4, 0.2, 10}};
constexpr ParameterRange tree_ranges[] = {{Parameter::count, 10, 1, 200}};
constexpr ParameterRange debris_ranges[] = {{Parameter::count, 1200, 1, 20000}};
constexpr ParameterRange mesh_ranges[] = {{Parameter::count, 300, 1, 5000},
                                          {Parameter::cell, 0.5, 0.2, 10}};
constexpr ParameterRange figure_ranges[] = {{Parameter::count, 100, 1, 2000}};
constexpr ParameterRange mass_ranges[] = {{Parameter::count, 1500, 1, 20000}};
constexpr ParameterRange stack_ranges[] = {{Parameter::count, 2000, 1, 20000}};
constexpr ParameterRange sphere_ranges[] = {{Parameter::count, 10000, 1, 100000}};
constexpr ParameterRange capsule_ranges[] = {{Parameter::count, 4000, 1, 50000}};

constexpr SpeedScene table[] = {
    {.letter = "a", .name = "bench_pyramid_465"},
    {.letter = "b", .name = "bench_pyramid_5050"},
    {.letter = "c", .name = "bench_boxes_1000"},
    {.letter = "d", .name = "bench_pile_5000"},
    {.letter = "e", .name = "bench_player_901", .player = "player"},
    {.letter = "f", .name = "bench_ragdolls_40"},
    {.letter = "g", .name = "bench_joint_grid_10000"},
    {.letter = "h", .name = "bench_asleep_10000", .asleep_first = true},
    {.letter = "i", .name = "bench_bullets_1000", .steps = 120, .tunnelled_beyond_x = 0},
    {.letter = "trees", .name = "bench_trees", .all_move = true},
    {.letter = "convex_pile", .name = "bench_convex_pile", .all_move = true},
    {.letter = "washer", .name = "bench_washer", .all_move = true},
    {.letter = "hull_terrain", .name = "bench_hull_terrain", .all_move = true},
    {.letter = "chain",
     .name = "bench_chain",
     .all_move = true,
     .parameters = level_chain_ranges,
     .make = of_size<scenes::bench_chain>},
    {.letter = "rain", .name = "bench_rain", .all_move = true},
    {.letter = "vehicles", .name = "bench_vehicles", .all_move = true},
    {.letter = "rods", .name = "bench_rods", .all_move = true},
    {.letter = "box_shot",
     .name = "bench_box_shot",
     .all_move = true,
     .steps = 240,
     .tunnelled_beyond_x = 0.25},
    {.letter = "brick_wall", .name = "bench_brick_wall", .all_move = true, .sleeps = true},
    {.letter = "l_shapes", .name = "bench_l_shapes", .all_move = true},
    {.letter = "junkyard", .name = "bench_junkyard", .all_move = true},
    {.letter = "drum",
     .name = "bench_drum",
     .all_move = true,
     .steps = 250,
     .parameters = drum_ranges,
     .make = drum,
     .description =
         "2000 boxes, balls and capsules in a drum of 36 staves that turns (benchmark drum)."},
    {.letter = "hull_heap",
     .name = "bench_hull_heap",
     .all_move = true,
     .steps = 180,
     .parameters = hull_heap_ranges,
     .make = hull_heap,
     .description = "Hulls with many vertices poured between four walls (benchmark hull_heap)."},
    {.letter = "wheels",
     .name = "bench_wheels",
     .all_move = true,
     .steps = 400,
     .parameters = wheels_ranges,
     .make = wheels,
     .description = "60 vehicles with motors drive on flat ground, every second one backwards "
                    "(benchmark wheels)."},
    {.letter = "wheels_mesh",
     .name = "bench_wheels_mesh",
     .all_move = true,
     .steps = 400,
     .parameters = wheels_mesh_ranges,
     .make = wheels_mesh,
     .description =
         "60 vehicles with motors drive on a mesh of low hills (benchmark wheels_mesh)."},
    {.letter = "hanging_chain",
     .name = "bench_hanging_chain",
     .all_move = true,
     .steps = 300,
     .parameters = chain_ranges,
     .make = of_size<scenes::bench_hanging_chain>,
     .description = "A chain of ball joints hangs and waves (benchmark hanging_chain)."},
    {.letter = "hinge_chain",
     .name = "bench_hinge_chain",
     .all_move = true,
     .steps = 300,
     .parameters = chain_ranges,
     .make = of_size<scenes::bench_hinge_chain>,
     .description =
         "A chain of hinges, fixed at one end, falls from level (benchmark hinge_chain)."},
    {.letter = "joint_tree",
     .name = "bench_joint_tree",
     .all_move = true,
     .steps = 300,
     .parameters = tree_ranges,
     .make = of_size<scenes::bench_joint_tree>,
     .description = "Trees of 88 jointed links hang and swing (benchmark joint_tree)."},
    {.letter = "debris",
     .name = "bench_debris",
     .all_move = true,
     .steps = 300,
     .parameters = debris_ranges,
     .make = of_size<scenes::bench_debris>,
     .description = "A block of stones of 12 corners bursts at 10 to 40 m/s (benchmark debris)."},
    {.letter = "mesh",
     .name = "bench_mesh",
     .all_move = true,
     .steps = 300,
     .parameters = mesh_ranges,
     .make = hills,
     .description =
         "Balls, boxes, capsules and stones fall on a mesh of hills, 150 m wide (benchmark mesh)."},
    {.letter = "ragdoll_pile",
     .name = "bench_ragdoll_pile",
     .all_move = true,
     .steps = 300,
     .parameters = figure_ranges,
     .make = of_size<scenes::bench_ragdoll_pile>,
     .description = "Figures of eleven bones poured between four walls (benchmark ragdoll_pile)."},
    {.letter = "mixed_masses",
     .name = "bench_mixed_masses",
     .all_move = true,
     .steps = 300,
     .parameters = mass_ranges,
     .make = of_size<scenes::bench_mixed_masses>,
     .description =
         "Bodies of 10 to 10,000 kg/m^3 poured between four walls (benchmark mixed_masses)."},
    {.letter = "stacks",
     .name = "bench_stacks",
     .all_move = true,
     .steps = 300,
     .parameters = stack_ranges,
     .make = of_size<scenes::bench_stacks>,
     .description = "Stacks of three boxes land on a floor (benchmark stacks)."},
    {.letter = "spheres",
     .name = "bench_spheres",
     .all_move = true,
     .steps = 180,
     .parameters = sphere_ranges,
     .make = of_size<scenes::bench_spheres>,
     .description = "Spheres poured between four walls (benchmark spheres)."},
    {.letter = "capsules",
     .name = "bench_capsules",
     .all_move = true,
     .steps = 250,
     .parameters = capsule_ranges,
     .make = of_size<scenes::bench_capsules>,
     .description = "Capsules poured between four walls (benchmark capsules)."},
};

// "wheels (2 to 32, even), wheels_mesh (2 to 32, even)"
std::string scenes_with(Parameter parameter) {
    std::string text;
    for (const SpeedScene& scene : table)
        for (const ParameterRange& range : scene.parameters)
            if (range.parameter == parameter)
                text += (text.empty() ? "" : ", ") + std::string(scene.letter) + " (" +
                        range_text(range) + ")";
    return text;
}

// With more digits than the limits of a range, so that a value just outside differs from them.
std::string refused(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

physics::Status check_parameter(std::span<const SpeedScene* const> selected, Parameter parameter,
                                double chosen) {
    const std::string option = parameter_kinds()[static_cast<std::size_t>(parameter)].option;
    bool is_used = false;
    for (const SpeedScene* scene : selected)
        for (const ParameterRange& range : scene->parameters) {
            if (range.parameter != parameter) continue;
            is_used = true;
            if (!accepts(range, chosen))
                return invalid_argument(option + ": " + refused(chosen) + " is out of range for " +
                                        scene->letter + "; must be " + range_text(range) +
                                        "; scenes with " + option + ": " + scenes_with(parameter));
        }
    if (is_used) return {};
    return invalid_argument(option + ": no selected scene has this parameter; select one of " +
                            scenes_with(parameter));
}

}  // namespace

std::span<const SpeedScene> speed_scenes() {
    return table;
}

const SpeedScene* find_speed_scene(std::string_view letter_or_name) {
    for (const SpeedScene& scene : table)
        if (letter_or_name == scene.letter || letter_or_name == scene.name) return &scene;
    return nullptr;
}

bool is_in_catalogue(const SpeedScene& speed_scene) {
    return speed_scene.description == nullptr;
}

std::string description_of(const SpeedScene& speed_scene) {
    if (!is_in_catalogue(speed_scene)) return speed_scene.description;
    for (const scenes::CatalogEntry& entry : scenes::catalog())
        if (entry.name == speed_scene.name) return std::string(entry.description);
    throw std::logic_error(std::string("the catalogue has no scene ") + speed_scene.name);
}

scenes::SceneDescription build(const SpeedScene& speed_scene, const ParameterValues& chosen) {
    if (!speed_scene.make) return scenes::find_scene(speed_scene.name).value();
    scenes::SceneDescription scene = speed_scene.make(values_of(speed_scene.parameters, chosen));
    scene.name = speed_scene.name;
    scene.description = description_of(speed_scene);
    return scene;
}

physics::Status check_parameters(std::span<const SpeedScene* const> selected,
                                 const ParameterValues& chosen) {
    for (std::size_t k = 0; k < parameter_count; k++) {
        if (!chosen[k]) continue;
        if (auto status = check_parameter(selected, static_cast<Parameter>(k), *chosen[k]); !status)
            return status;
    }
    return {};
}

std::optional<std::uint32_t> player_of(const SpeedScene& speed_scene,
                                       const scenes::SceneDescription& scene) {
    if (!speed_scene.player) return std::nullopt;
    for (std::uint32_t body = 0; body < scene.bodies.size(); body++)
        if (scene.bodies[body].name == *speed_scene.player) return body;
    throw std::logic_error(scene.name + " has no body " + std::string(*speed_scene.player));
}

physics::Vec3 player_velocity(double seconds) {
    const physics::SinCos turned = physics::sin_cos(seconds < 2.5 ? 0 : (seconds - 2.5) * 0.8);
    return physics::Vec3{turned.cos, 0, turned.sin} * 6;
}

}  // namespace jostle::bench

// SPDX-License-Identifier: MIT
//
// Golden channels of modules, each from a small world after some steps. The
// renderers of clients/web also read the file proto/golden_modules.txt. A line is a channel: the
// module, the kind (index in Module::channels()), the entity and the values, separated by spaces.
// The name of a body is its index + 1, in the order of creation.
#pragma once

#include <string>
#include <vector>

#include "jostle/modules/boats.h"
#include "jostle/modules/character.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/fields.h"
#include "jostle/modules/ragdoll.h"
#include "jostle/modules/vehicle.h"
#include "jostle/physics/physics.h"

namespace jostle::modules {

using namespace physics;

using Channels = std::vector<ChannelWriter::Channel>;

struct GoldenModule {
    std::string tag;
    Channels channels;
};

template <class M>
M& add_to(World& world) {
    auto made = std::make_unique<M>();
    M& module = *made;
    world.add_module(std::move(made)).expect();
    return module;
}

inline World golden_world() {
    World world;
    world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    return world;
}

inline Channels channels_after(World& world, const Module& module, int steps) {
    for (int k = 0; k < steps; k++) world.step(1.0 / 60).expect();
    ChannelWriter writer([](BodyId body) { return body.index + 1; });
    module.publish(world, writer);
    return writer.channels();
}

// Full throttle with the rudder to the right, in still water.
inline Channels golden_boat() {
    World world;
    const BodyId hull = world
                            .create_body({.pose = {.position = {0, 0.2, 0}}},
                                         {.geometry = Box{{1, 0.45, 2.6}}, .density = 200})
                            .value();
    add_to<Fields>(world).add(world, {.law = Waves{}}).value();
    Boats& boats = add_to<Boats>(world);
    boats.add(world, {.hull = hull}).expect();
    boats.steer(world, hull, 1, 0.5).expect();
    return channels_after(world, boats, 60);
}

// One walks to the right, a rigid one crouches, one has just jumped.
inline Channels golden_character() {
    World world = golden_world();
    Characters& crowd = add_to<Characters>(world);
    const CharacterId walks = crowd.add(world, {.feet = {0, 0, 0}}).value();
    const CharacterId crouches =
        crowd.add(world, {.kind = CharacterKind::rigid, .feet = {3, 0, 0}}).value();
    const CharacterId jumps = crowd.add(world, {.feet = {6, 0, 0}}).value();
    for (int k = 0; k < 30; k++) world.step(1.0 / 60).expect();
    crowd.set_controls(walks, {.walk = {3, 0, 0}}).expect();
    crowd.set_controls(crouches, {.crouch = true}).expect();
    crowd.set_controls(jumps, {.jump = true}).expect();
    return channels_after(world, crowd, 20);
}

// An intact wall, and one with a broken middle.
inline Channels golden_destruction() {
    World world = golden_world();
    Destruction& destruction = add_to<Destruction>(world);
    const Vec3 half{1, 1, 0.15};
    FracturedShape wall = fracture_box(half, random_seeds(half, 24, 3)).value();
    anchor(wall, {0, -1, 0}, half.y - 1e-6);
    destruction.add(world, wall, {.pose = {.position = {0, 1, 0}}}).value();
    const DestructibleId broken =
        destruction.add(world, wall, {.pose = {.position = {5, 1, 0}}}).value();
    destruction.break_near(world, broken, {5, 1, 0}, 0.5).value();
    return channels_after(world, destruction, 2);
}

// Water with two waves, wind, an attracting point, and an explosion in the last step.
inline Channels golden_fields() {
    World world = golden_world();
    Fields& fields = add_to<Fields>(world);
    fields
        .add(world,
             {.law = Waves{.level = 0.5,
                           .components =
                               {{.amplitude = 0.25, .length = 16, .heading = 0.4},
                                {.amplitude = 0.125, .length = 6, .heading = -0.5, .phase = 1}}}})
        .value();
    fields.add(world, {.law = Turbulence{.wind = {2, 0, -1}, .speed = 1.5}}).value();
    fields.add(world, {.law = Central{.point = {1, 2, 3}}}).value();
    fields.add_charge({.time = 0.49, .explosion = {.center = {4, 5, 6}, .radius = 7}}).expect();
    return channels_after(world, fields, 31);
}

// A limp figure and a powered one.
inline Channels golden_ragdoll() {
    World world = golden_world();
    Ragdolls& ragdolls = add_to<Ragdolls>(world);
    ragdolls.add(world, human_figure(1.8), {.position = {0, 0.1, 0}}).value();
    const RagdollId powered =
        ragdolls.add(world, human_figure(1.8), {.position = {3, 0.1, 0}}).value();
    ragdolls.set_mode(world, powered, RagdollMode::powered, 0).expect();
    return channels_after(world, ragdolls, 5);
}

// A saloon that accelerates to the right.
inline Channels golden_vehicle() {
    World world = golden_world();
    const BodyId chassis = world
                               .create_body({.pose = {.position = {0, 0.67, 0}}},
                                            {.geometry = Box{{0.8, 0.25, 2}}, .mass = 1500})
                               .value();
    Vehicles& vehicles = add_to<Vehicles>(world);
    const CarId car = vehicles.add(world, saloon({.chassis = chassis})).value();
    vehicles.set_controls(world, car, {.throttle = 0.6, .steering = 0.5}).expect();
    return channels_after(world, vehicles, 150);
}

inline std::vector<GoldenModule> golden_modules() {
    return {{"boat", golden_boat()},
            {"character", golden_character()},
            {"destruction", golden_destruction()},
            {"fields", golden_fields()},
            {"ragdoll", golden_ragdoll()},
            {"vehicle", golden_vehicle()}};
}

// A line of the file.
inline std::string line_of(const std::string& tag, const ChannelWriter::Channel& channel) {
    std::string line =
        tag + " " + std::to_string(channel.kind) + " " + std::to_string(channel.entity);
    for (const std::int32_t value : channel.values) line += " " + std::to_string(value);
    return line;
}

}  // namespace jostle::modules

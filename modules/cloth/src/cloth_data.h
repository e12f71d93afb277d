// SPDX-License-Identifier: MIT
//
// A cloth of the module: its sheet, what it is attached to, and the data of one step.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jostle/modules/cloth_def.h"
#include "jostle/modules/island_ties.h"
#include "jostle/physics/nearby_shapes.h"
#include "jostle/physics/queries.h"
#include "jostle/physics/step_listener.h"
#include "modules/cloth/src/self_contacts.h"
#include "modules/cloth/src/sheet.h"

namespace jostle::modules::cloth_detail {

// A vertex that pressed against a shape in the last sub-step.
struct Pressed {
    std::uint32_t vertex = 0;
    physics::ShapeId shape = {};
};

// A dynamic body that the cloth touched in the last steps.
struct TouchedBody {
    physics::BodyId body = {};
    std::uint32_t steps_since = 0;
};

// A body in a sub-step of the cloth. Its motion includes the impulses of the cloth.
struct CarriedBody {
    physics::BodyId id = {};
    physics::BodyType type = physics::BodyType::dynamic;
    bool in_group = false;  // otherwise it gets the impulses after the step
    physics::Vec3 center = {}, velocity = {}, spin = {};
    physics::Vec3 start_center = {};  // of the sub-step of the group: impulses act about it
    physics::Quat rotation = {};
    physics::Transform origin = {};  // of the body relative to its centre
    physics::BodyResponse response = {};
    physics::Vec3 impulse = {}, angular_impulse = {};  // of the cloth in this sub-step
    std::uint32_t attached = 0, pressed = 0;           // vertices that share its mass
};

// A vertex near a shape in a part of a sub-step.
struct VertexContact {
    std::uint32_t vertex = 0, body = 0, shape = 0;
    physics::Vec3 point = {}, normal = {};  // on the shape, at the start of the part; out of it
    double gap = 0;                         // m
    double friction = 0;
    double impulse = 0;       // N s, along the normal on the vertex
    bool pressed = false;     // solved together with the body
    double common = 0;        // m, motion along the normal of the vertex with its share of the body
    double inverse_mass = 0;  // 1/kg, of both
};

// An edge near a shape in a part of a sub-step.
struct EdgeContact {
    std::uint32_t a = 0, b = 0, body = 0;
    double fraction = 0;  // from a to b
    physics::Vec3 point = {}, normal = {};
    double gap = 0;  // m
    double friction = 0;
};

struct Cloth {
    ClothKey key;
    ClothDef def;
    Sheet sheet;
    std::vector<ClothAttachment> attachments;  // sorted by vertex
    bool awake = true;
    double rest_time = 0;              // s
    std::vector<Pressed> pressed;      // sorted by vertex
    std::vector<TouchedBody> touched;  // sorted by body
    IslandTies ties;

    // Data of the current step. Not state.
    int substeps_done = 0;
    physics::NearbyShapes nearby;
    std::vector<CarriedBody> bodies;
    std::vector<std::uint32_t> attached_body;  // per attachment: index in `bodies`, or none
    std::vector<std::uint32_t> nearby_body;    // per body of `nearby`
    std::vector<physics::Vec3> points;
    std::vector<std::optional<physics::ClosestPoint>> nearest;
    std::vector<VertexContact> contacts;
    std::vector<EdgeContact> edge_contacts;
    std::vector<physics::CapsuleContact> found;
    std::vector<physics::Vec3> own_moved, common_moved;  // per attachment
    std::vector<std::uint32_t> overloaded;               // threads above the breaking load
    double overload = 0;                                 // N/m, of the first
    SelfContacts self;
};

inline constexpr std::uint32_t no_body = 0xffffffff;

}  // namespace jostle::modules::cloth_detail

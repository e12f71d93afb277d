// SPDX-License-Identifier: MIT
//
// A cloth of the module: its sheet, what it is attached to, and the data of one step.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jostle/modules/carried_bodies.h"
#include "jostle/modules/cloth_def.h"
#include "jostle/physics/nearby_shapes.h"
#include "jostle/physics/queries.h"
#include "modules/cloth/src/sheet.h"
#include "modules/cloth/src/sheet_contacts.h"

namespace jostle::modules::cloth_detail {

// A vertex that pressed against a shape in the last sub-step.
struct Pressed {
    std::uint32_t vertex = 0;
    physics::ShapeId shape = {};
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
    double rest_time = 0;          // s
    std::vector<Pressed> pressed;  // sorted by vertex
    CarriedBodies bodies;

    // Data of the current step. Not state.
    int substeps_done = 0;
    physics::NearbyShapes nearby;
    std::vector<physics::Vec3> points;
    std::vector<std::optional<physics::ClosestPoint>> nearest;
    std::vector<VertexContact> contacts;
    std::vector<EdgeContact> edge_contacts;
    std::vector<physics::CapsuleContact> found;
    std::vector<physics::Vec3> own_moved, common_moved;  // per attachment
    std::vector<std::uint32_t> overloaded;               // threads above the breaking load
    double overload = 0;                                 // N/m, of the first
    SheetContacts sheet_contacts;
    std::vector<ContactSheet> contact_sheets;
    // The cloths that may touch each other in this step advance together. The first of them leads.
    Cloth* leader = nullptr;         // of others than this one; null: it leads
    std::vector<Cloth*> companions;  // of a leader, by key
    std::vector<Cloth*> obstacles;   // of a leader: asleep, by key
};

inline std::vector<Support> supports_of(const Cloth& cloth) {
    std::vector<Support> supports;
    for (const ClothAttachment& attachment : cloth.attachments)
        supports.push_back({attachment.body, attachment.holder});
    return supports;
}

}  // namespace jostle::modules::cloth_detail

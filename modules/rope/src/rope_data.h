// SPDX-License-Identifier: MIT
//
// A rope of the module: its strand, what it is attached to, and the data of one step.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/modules/carried_bodies.h"
#include "jostle/modules/rope_def.h"
#include "jostle/physics/nearby_shapes.h"
#include "modules/rope/src/strand.h"

namespace jostle::modules::rope_detail {

// A contact at the end of a sub-step, to start the next one with.
struct SavedContact {
    std::uint32_t link = 0;
    physics::ShapeId shape = {};
    ContactGrip grip = ContactGrip::open;
    physics::Vec3 slip = {};
    double pressure = 0;
};

// A contact of a link with a link of another rope, or of the same one, at the end of a sub-step.
struct LinkContact {
    std::uint32_t link = 0;
    std::uint32_t other = 0;  // number of the key of the other rope
    std::uint32_t other_link = 0;
    physics::Vec3 normal = {};  // unit, towards `link`
    double distance = 0;        // m, of the axes, that it demands
    physics::Vec3 force = {};   // N, on `link`
};

class RopeContacts;

struct Rope {
    RopeKey key;
    RopeDef def;
    Strand strand;
    std::vector<RopeAttachment> attachments;  // sorted by node
    double winch[2] = {0, 0};                 // m/s, by end
    double link_length = 0;                   // m, of links that a winch adds
    bool awake = true;
    double rest_time = 0;                    // s
    std::vector<SavedContact> contacts;      // of the last sub-step
    std::vector<LinkContact> link_contacts;  // likewise, sorted
    CarriedBodies bodies;

    // Data of the current step. Not state.
    int substeps_done = 0;
    double peak_tension = 0;  // N
    std::size_t peak_link = 0;
    physics::NearbyShapes nearby;
    std::vector<physics::Vec3> forces;  // of fields, N per node; empty without fields
    std::vector<NodeLoad> loads;
    std::vector<Clamp> clamps;
    std::vector<std::size_t> clamp_attachment;  // per clamp: index of its attachment
    std::vector<StrandContact> strand_contacts;
    std::vector<physics::CapsuleContact> found;
    bool may_touch = false;  // `nearby` has bodies that the rope is not attached to
    std::vector<std::uint32_t> contact_body, contact_shape;  // per strand contact
    std::vector<physics::Vec3> contact_point;
    StrandScratch scratch;
    // The ropes that may touch each other in this step advance together. The first of them leads.
    Rope* leader = nullptr;         // of others than this one; null: it leads
    std::vector<Rope*> companions;  // of a leader, by key
    std::vector<Rope*> obstacles;   // of a leader: asleep, by key
    // Of a leader that may touch others or itself; null otherwise.
    std::shared_ptr<RopeContacts> rope_contacts;
};

inline std::vector<Support> supports_of(const Rope& rope) {
    std::vector<Support> supports;
    for (const RopeAttachment& attachment : rope.attachments)
        supports.push_back({attachment.body, attachment.holder});
    return supports;
}

}  // namespace jostle::modules::rope_detail

// SPDX-License-Identifier: MIT
//
// A rope of the module: its strand, what it is attached to, and the data of one step.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/modules/island_ties.h"
#include "jostle/modules/rope_def.h"
#include "jostle/physics/nearby_shapes.h"
#include "jostle/physics/step_listener.h"
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

// A dynamic body that the rope touched in the last steps.
struct TouchedBody {
    physics::BodyId body = {};
    std::uint32_t steps_since = 0;
};

// The impulse that the rope gave to a body in its last sub-step. Ropes that share a body start from
// these, so that each carries its part.
struct BodyPush {
    physics::BodyId body = {};
    physics::Vec3 impulse = {}, angular_impulse = {};  // N s, N m s about the centre
};

// A body in a sub-step of the rope. Its motion includes the impulses of the rope.
struct CarriedBody {
    physics::BodyId id = {};
    physics::BodyType type = physics::BodyType::dynamic;
    bool in_group = false;  // otherwise it gets the impulses after the step
    physics::Vec3 center = {}, velocity = {}, spin = {};
    physics::Vec3 start_center = {};  // of the sub-step of the group: impulses act about it
    physics::Quat rotation = {};
    physics::Transform origin = {};  // of the body relative to its centre
    physics::BodyResponse response = {};
    physics::Vec3 impulse = {}, angular_impulse = {};    // of the rope in this sub-step
    physics::Vec3 expected = {}, expected_angular = {};  // of the last sub-step
    std::uint32_t shares = 0;  // attachments and contacts that share its mass
};

struct Rope {
    RopeKey key;
    RopeDef def;
    Strand strand;
    std::vector<RopeAttachment> attachments;  // sorted by node
    double winch[2] = {0, 0};                 // m/s, by end
    double link_length = 0;                   // m, of links that a winch adds
    bool awake = true;
    double rest_time = 0;                // s
    std::vector<SavedContact> contacts;  // of the last sub-step
    std::vector<TouchedBody> touched;    // sorted by body
    std::vector<BodyPush> pushes;        // of the last sub-step, sorted by body
    IslandTies ties;

    // Data of the current step. Not state.
    int substeps_done = 0;
    bool owned = false;       // a group moves it
    double peak_tension = 0;  // N
    std::size_t peak_link = 0;
    physics::NearbyShapes nearby;
    std::vector<CarriedBody> bodies;  // first those of the attachments, then those of `nearby`
    std::vector<std::uint32_t> attached_body;  // per attachment: index in `bodies`, or none
    std::vector<std::uint32_t> nearby_body;    // per body of `nearby`
    std::vector<physics::Vec3> forces;         // of fields, N per node; empty without fields
    std::vector<NodeLoad> loads;
    std::vector<Clamp> clamps;
    std::vector<std::uint32_t> clamp_body;
    std::vector<StrandContact> strand_contacts;
    std::vector<physics::CapsuleContact> found;
    bool may_touch = false;  // `nearby` has bodies that the rope is not attached to
    std::vector<std::uint32_t> contact_body, contact_shape;  // per strand contact
    std::vector<physics::Vec3> contact_point;
    StrandScratch scratch;
};

inline constexpr std::uint32_t no_body = 0xffffffff;

}  // namespace jostle::modules::rope_detail

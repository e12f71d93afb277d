// SPDX-License-Identifier: MIT
//
// Descriptions of ropes, rods and strands of hair for the module Ropes (rope.h).
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Identifies a rope of a module. Keys are never reused.
struct RopeKey {
    std::uint32_t number = 0;

    auto operator<=>(const RopeKey&) const = default;
};

/// An end of a rope.
enum class RopeEnd : std::uint8_t { first, last };

/// A rope or an elastic rod: nodes in a row, connected by links of equal length.
struct RopeDef {
    static constexpr std::uint32_t links_max = 2000;
    static constexpr std::size_t points_max = 256;

    /// The initial line, m: 2 to points_max points, each component within 1e6. The nodes are placed
    /// evenly along it.
    std::vector<physics::Vec3> points = {};
    std::uint32_t links = 20;      ///< 1 to links_max
    double length = 0;             ///< m, rest length, 0 to 1e5; 0: that of the initial line
    double radius = 0.02;          ///< m, 1e-4 to 10
    double mass_per_length = 0.2;  ///< kg/m, 1e-6 to 1e6
    /// E A, tension per relative stretch, N, 1 to 1e12. Short links under much load need more
    /// sub-steps to vibrate accurately, but are stable with any stiffness.
    double stretch_stiffness = 1e6;
    /// E I, bending torque per curvature, N m^2, 0 to 1e9; 0: a rope that bends freely and does not
    /// push. Above 0 it also resists compression, as a rod.
    double bending_stiffness = 0;
    double damping = 0.1;        ///< 1/s, 0 to 1e4: decay of velocities, as by air
    double friction = 0.5;       ///< 0 to 10, combined with that of others by the geometric mean
    double breaking_load = 0;    ///< N, 0 to 1e12; 0: unbreakable
    std::uint32_t substeps = 8;  ///< least sub-steps per step, 1 to 64
    bool collide_bodies = true;  ///< whether it touches the shapes of the world
    bool collide_self = false;   ///< whether its links touch each other, as in a knot
    bool collide_ropes = false;  ///< whether it touches other ropes of which this is true
    /// Touches shapes with one of these categories, except those of bodies that it is attached to.
    std::uint32_t body_categories = 0xffffffff;
    std::uint32_t color = 0xc8a060;  ///< 0xRRGGBB, for clients

    bool operator==(const RopeDef&) const = default;
};

/// Holds a node of a rope at a body, in the world, or with a grab.
struct RopeAttachment {
    std::uint32_t node = 0;     ///< 0 is the first end, the number of links the last end
    physics::BodyId body = {};  ///< null: the world
    physics::Vec3 point = {};   ///< m, in the body's frame or in the world, within 1e6
    /// If not zero: the direction of an elastic rod at this end, from the end into the rod, in the
    /// same frame; any length. Only at the ends.
    physics::Vec3 direction = {};
    /// The holder whose grab holds the node (Ropes::grab()); 0 in attach().
    std::uint32_t holder = 0;

    bool operator==(const RopeAttachment&) const = default;
};

/// Kinds of changes of ropes.
enum class RopeEventKind : std::uint8_t { cut, broken, joined };

/// A change of ropes in a call or in the last step.
struct RopeEvent {
    RopeEventKind kind = RopeEventKind::cut;
    RopeKey rope = {};            ///< the rope that was cut, broke or was extended
    RopeKey other = {};           ///< the new rope behind the cut, or the rope that was joined
    physics::Vec3 position = {};  ///< m
    double tension = 0;           ///< N, if it broke
};

}  // namespace jostle::modules

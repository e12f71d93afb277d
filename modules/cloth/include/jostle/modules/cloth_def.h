// SPDX-License-Identifier: MIT
//
// Descriptions of cloth for the module Cloths (cloth.h).
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Identifies a cloth of a module. Keys are never reused.
struct ClothKey {
    std::uint32_t number = 0;

    auto operator<=>(const ClothKey&) const = default;
};

/// A rectangular piece of woven cloth: rows x columns vertices with threads along and across.
/// Vertex r * columns + c starts at origin + across * c / (columns - 1) + down * r / (rows - 1).
struct ClothGrid {
    std::uint32_t rows = 20, columns = 20;  ///< 2 to 1000 each; 0 if the cloth is a mesh
    physics::Vec3 origin = {};              ///< m, each component within 1e6
    physics::Vec3 across = {1, 0, 0};       ///< m, along the rows, not parallel to `down`
    physics::Vec3 down = {0, -1, 0};        ///< m, along the columns
    double width = 0;   ///< m, rest length of the rows, 0 to 1e5; 0: the length of `across`
    double height = 0;  ///< m, rest length of the columns; 0: the length of `down`

    bool operator==(const ClothGrid&) const = default;
};

/// A sheet of cloth.
struct ClothDef {
    static constexpr std::uint32_t vertices_max = 20000;

    /// The cloth, unless `triangles` is set.
    ClothGrid grid = {};
    /// Any triangle mesh at rest, m: indices of vertices, three per triangle. An edge has at most
    /// two triangles. Each edge is a thread.
    std::vector<physics::Vec3> vertices = {};
    std::vector<std::uint32_t> triangles = {};

    double mass_per_area = 0.2;       ///< kg/m^2, 1e-4 to 1e4
    double stretch_stiffness = 5000;  ///< N/m, tension per width and relative stretch, 1 to 1e7
    double shear_stiffness = 200;     ///< N/m, 0 to 1e7; not used by meshes, whose edges resist it
    /// Torque per width and curvature, N m, 0 to 1e4: cotton has about 1e-5. Bends about flat.
    double bending_stiffness = 1e-5;
    double damping = 0.1;  ///< 1/s, 0 to 1e4: decay of velocities, as by air at rest
    double drag = 1;       ///< coefficient of the pressure of wind on its faces, 0 to 100
    /// Wind on this cloth besides the winds of the world, in air of 1.2 kg/m^3: velocity, and gusts
    /// that add `gust` times sin(2 pi t / gust_period). m/s, each component within 1e4; s, 1e-3 to
    /// 1e12.
    physics::Vec3 wind = {}, gust = {};
    double gust_period = 1;
    double thickness = 0.005;    ///< m, distance from bodies and half that from cloth, 1e-4 to 1
    double friction = 0.5;       ///< 0 to 10, combined with that of shapes by the geometric mean
    double breaking_load = 0;    ///< N/m, tension per width at which threads break; 0: never
    std::uint32_t substeps = 8;  ///< least sub-steps per step, 1 to 64; more under high tension
    bool collide_bodies = true;  ///< whether it touches the shapes of the world
    bool collide_self = false;   ///< whether its parts touch each other
    bool collide_cloths = true;  ///< whether it touches other cloths of which this is true
    /// Touches shapes with one of these categories, except those of bodies that it is attached to.
    std::uint32_t body_categories = 0xffffffff;
    std::uint32_t color = 0xb04040;  ///< 0xRRGGBB, for clients

    bool operator==(const ClothDef&) const = default;
};

/// Holds a vertex of a cloth at a body, in the world, or with a grab.
struct ClothAttachment {
    std::uint32_t vertex = 0;
    physics::BodyId body = {};  ///< null: the world
    physics::Vec3 point = {};   ///< m, in the body's frame or in the world, within 1e6
    /// The holder whose grab holds the vertex (Cloths::grab()); 0 in attach().
    std::uint32_t holder = 0;

    bool operator==(const ClothAttachment&) const = default;
};

/// A change of a cloth.
enum class ClothEventKind : std::uint8_t { torn, released };

/// An event of a step.
struct ClothEvent {
    ClothEventKind kind = ClothEventKind::torn;
    ClothKey cloth = {};
    std::uint32_t threads = 0;  ///< threads that broke in the step, or attachments that ended
    physics::Vec3 point = {};   ///< m, world, of the first one
    double tension = 0;         ///< N/m, of the first one
};

}  // namespace jostle::modules

// SPDX-License-Identifier: MIT
//
// Contacts of sheets with themselves and with each other, and bounds of displacement that keep them
// free of crossings.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/vec3.h"
#include "modules/cloth/src/sheet.h"

namespace jostle::modules::cloth_detail {

// A sheet that may touch itself or the other sheets of a call.
struct ContactSheet {
    Sheet* sheet = nullptr;
    std::uint32_t number = 0;   // identifies the sheet in later calls
    double thickness = 0;       // m: two sheets touch at the sum of their thicknesses
    double friction = 0;        // combined by the geometric mean
    bool collide_self = false;  // its parts touch each other
    bool is_fixed = false;      // an obstacle at rest, which does not move
};

// Finds all vertices near faces and edges near edges that are apart by less than a reach, and
// bounds the motion of each vertex until the next search to a share of the distance to the nearest
// of them, or to the reach. Two primitives that both move by less than half of their distance
// cannot cross (displacement bounds of Offset Geometric Contact, Chen et al. 2025). A common motion
// of all vertices changes no distance, so the mean motion is free, and the momentum that bounds
// take from vertices is distributed over all of them. Not state: the search of a step depends on
// the positions at its start.
class SheetContacts {
public:
    // Starts a step: forgets earlier searches.
    void begin_step() { valid_ = false; }
    // Pushes apart, in the sub-step and with friction, what comes closer than its thickness, and
    // bounds the displacements: the last change of them in a sub-step. The sheets are the same ones
    // in all sub-steps of a step.
    void resolve(std::span<const ContactSheet> sheets);

    std::size_t searches() const { return searches_; }
    std::size_t pairs() const { return faces_.size() + edges_.size(); }

private:
    // Vertices are numbered through all sheets.
    struct Faces {
        std::uint32_t vertex = 0;
        std::array<std::uint32_t, 3> face = {};
    };
    struct Edges {
        std::uint32_t a0 = 0, a1 = 0, b0 = 0, b1 = 0;
    };
    // A sheet in this call.
    struct Part {
        ContactSheet of;
        std::uint32_t first = 0;    // vertex
        physics::Vec3 shift = {};   // m, of its root from that of the first sheet
        std::size_t triangles = 0;  // when the mesh was read
        physics::Aabb box = {};     // m, at the search
    };

    void take(std::span<const ContactSheet> sheets);
    void read_meshes();
    std::uint32_t part_of(std::uint32_t vertex) const;
    bool may_touch(std::uint32_t part, std::uint32_t other) const;
    double gap(std::uint32_t part, std::uint32_t other) const;
    double friction(std::uint32_t part, std::uint32_t other) const;
    // In the cloth at rest, or, for contacts of different cloths, where it started, m.
    physics::Vec3 rest(std::uint32_t vertex, bool in_cloth) const;
    physics::Vec3 start_of(std::uint32_t vertex) const;
    physics::Vec3 moved_of(std::uint32_t vertex) const;
    physics::Vec3 end_of(std::uint32_t vertex) const { return start_of(vertex) + moved_of(vertex); }
    double inverse_mass(std::uint32_t vertex) const;

    void search(double reach);
    // Whether something of a sheet in this box can touch anything.
    bool may_touch_in(physics::Vec3 low, physics::Vec3 high, std::uint32_t part,
                      double reach) const;
    void find_faces(double reach, double longest);
    void find_edges(double reach, double longest);
    void limit(std::uint32_t vertex, double distance);
    void push_apart();
    void separate(std::span<const std::uint32_t> vertices, std::span<const double> weights,
                  std::uint32_t part, std::uint32_t other);
    // The mean motion in this sub-step, weighted by mass; 0 if something is held.
    physics::Vec3 mean_motion() const;
    bool leaves_bounds() const;
    bool bound();
    void move_all(physics::Vec3 by);

    bool valid_ = false;
    std::size_t searches_ = 0;
    std::vector<Part> parts_;
    std::vector<SheetNode*> nodes_;           // per vertex
    std::vector<std::uint32_t> vertex_part_;  // per vertex
    std::vector<std::array<std::uint32_t, 3>> mesh_faces_;
    std::vector<std::array<std::uint32_t, 2>> mesh_edges_;
    std::vector<Faces> faces_;
    std::vector<Edges> edges_;
    std::vector<float> bounds_;         // m, per vertex
    std::vector<physics::Vec3> start_;  // m, relative to the root of the first sheet, at the search
    physics::Vec3 common_ = {};         // m, motion of all vertices since the search
    bool is_free_ = false;              // no vertex is held
};

}  // namespace jostle::modules::cloth_detail

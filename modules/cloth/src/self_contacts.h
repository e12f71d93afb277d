// SPDX-License-Identifier: MIT
//
// Contacts of a sheet with itself, and bounds of displacement that keep it free of crossings.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec3.h"
#include "modules/cloth/src/sheet.h"

namespace jostle::modules::cloth_detail {

// Finds all vertices near faces and edges near edges that are apart by less than a reach, and
// bounds the motion of each vertex until the next search to a share of the distance to the nearest
// of them, or to the reach. Two primitives that both move by less than half of their distance
// cannot cross (displacement bounds of Offset Geometric Contact, Chen et al. 2025). Not state: the
// search of a step depends on the positions at its start.
class SelfContacts {
public:
    // Starts a step: forgets earlier searches.
    void begin_step() { valid_ = false; }
    // Pushes parts apart that come closer than `gap` (m) in the sub-step, with friction, and bounds
    // the displacements. The last change of the displacements in a sub-step.
    void resolve(Sheet& sheet, double gap, double friction);

    std::size_t searches() const { return searches_; }
    std::size_t pairs() const { return faces_.size() + edges_.size(); }

private:
    struct VertexFace {
        std::uint32_t vertex = 0;
        std::array<std::uint32_t, 3> face = {};
    };
    struct EdgeEdge {
        std::uint32_t a0 = 0, a1 = 0, b0 = 0, b1 = 0;
    };

    void search(const Sheet& sheet, double reach);
    void find_edges(const Sheet& sheet);
    void push_apart(Sheet& sheet, double gap, double friction);
    bool bound(Sheet& sheet);

    bool valid_ = false;
    std::size_t searches_ = 0;
    std::size_t triangle_count_ = 0;
    std::vector<std::array<std::uint32_t, 2>> mesh_edges_;
    std::vector<VertexFace> faces_;
    std::vector<EdgeEdge> edges_;
    std::vector<float> bounds_;         // m, per vertex
    std::vector<physics::Vec3> start_;  // relative to the root, at the search
};

}  // namespace jostle::modules::cloth_detail

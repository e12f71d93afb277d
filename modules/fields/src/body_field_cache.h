// SPDX-License-Identifier: MIT
//
// What fields ask of a body in each sub-step, found out once: its panels, what it shows to a flow,
// its inertia. Follows from the world alone and is no state. A body's record is made when a
// sub-step first meets it, and again when its shapes are others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/world.h"
#include "modules/fields/src/panel_surface.h"

namespace jostle::modules::fields_detail {

// A convex shape as a flow sees it, in the body's frame.
struct ProjectedShape {
    enum class Kind : std::uint8_t { ball, capsule, cylinder, cone, faces };
    Kind kind = Kind::ball;
    physics::Vec3 axis = {};                // of what is round about one, unit
    double round = 0;                       // m^2, of the disc
    double side = 0;                        // m^2, of capsules and cylinders seen from aside
    double radius = 0, height = 0;          // m, of cones
    std::vector<physics::Vec3> areas = {};  // m^2, outward, of flat faces
};

struct BodyFieldData {
    physics::BodyId body = {};
    std::vector<physics::ShapeId> shapes = {};
    std::uint32_t categories = 0;
    // About the centre of mass, body axes, kg m^2; the inverse is zero where it has none.
    physics::Mat3 inertia, inverse_inertia;
    std::vector<ProjectedShape> projected_shapes = {};
    bool has_panels = false;
    std::vector<PanelSurface> panels = {};  // in the body's frame, about its origin
    double reach = 0;                       // m: of the furthest vertex from the origin
};

// The area, m^2, of the shadow along a unit direction of the body's frame: exact for a convex shape
// (half of what all faces show; Cauchy), of several the sum.
double projected_area(const BodyFieldData& record, physics::Vec3 direction);

class BodyFieldCache {
public:
    void clear() { records_.clear(); }
    // Panels no longer than that, for bodies that are met from now on. 0: none are needed.
    void set_longest_panel(double longest) { longest_panel_ = longest; }

    // For bodies below that index. Only then may several threads refresh bodies at once.
    void reserve(std::uint32_t index_end) {
        if (records_.size() < index_end) records_.resize(index_end);
    }
    // Before the first sub-step of a group, with the world as it was when the step began. Bodies
    // that there is no room for have none in this step: they came after before_step().
    void refresh(const physics::World& world, std::span<const physics::BodyId> bodies);
    bool has(physics::BodyId body) const {
        return body.index < records_.size() && records_[body.index].body == body;
    }
    // Of a body that was refreshed in this step.
    const BodyFieldData& of(physics::BodyId body) const { return records_[body.index]; }

private:
    void rebuild(const physics::World& world, BodyFieldData& record);

    std::vector<BodyFieldData> records_;  // by the body's index
    double longest_panel_ = 0;
};

// Bits of all categories of the shapes.
std::uint32_t categories_of(const physics::World& world, std::span<const physics::ShapeId> shapes);
std::uint32_t categories_of(const physics::World& world, physics::BodyId body);

}  // namespace jostle::modules::fields_detail

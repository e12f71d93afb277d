// SPDX-License-Identifier: MIT
//
// Cached data of bodies that fields use in each sub-step: panels, projected areas and inertia. It
// is derived from the world and is not state. A record is created when a sub-step first contains
// the body, and rebuilt when its shapes change.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/world.h"
#include "modules/fields/src/panel_surface.h"

namespace jostle::modules::fields_detail {

// The projected area of a convex shape, in the body's frame.
struct ProjectedShape {
    enum class Kind : std::uint8_t { ball, capsule, cylinder, cone, faces };
    Kind kind = Kind::ball;
    physics::Vec3 axis = {};                // unit, for shapes with an axis of rotation
    double round = 0;                       // m^2, area of the disc
    double side = 0;                        // m^2, side view of capsules and cylinders
    double radius = 0, height = 0;          // m, for cones
    std::vector<physics::Vec3> areas = {};  // m^2, outward, for flat faces
};

struct BodyFieldData {
    physics::BodyId body = {};
    std::vector<physics::ShapeId> shapes = {};
    std::uint32_t categories = 0;
    // About the centre of mass, body axes, kg m^2. The inverse is zero if the body has none.
    physics::Mat3 inertia, inverse_inertia;
    std::vector<ProjectedShape> projected_shapes = {};
    bool has_panels = false;
    std::vector<PanelSurface> panels = {};  // in the body's frame, relative to its origin
    double reach = 0;                       // m, distance of the farthest vertex from the origin
};

// Projected area along a unit direction of the body's frame, m^2. Exact for a convex shape (half
// the sum over all faces; Cauchy). For several shapes, the sum of their areas.
double projected_area(const BodyFieldData& record, physics::Vec3 direction);

class BodyFieldCache {
public:
    void clear() { records_.clear(); }
    // Maximum panel length, m, for bodies that are added from now on; 0 means that no panels are
    // needed.
    void set_longest_panel(double longest) { longest_panel_ = longest; }

    // Reserves records for body indices below `index_end`. refresh() may run on several threads
    // concurrently only for these.
    void reserve(std::uint32_t index_end) {
        if (records_.size() < index_end) records_.resize(index_end);
    }
    // Call before the first sub-step of a group, with the world as it was at the start of the step.
    // Bodies without a reserved record are skipped in this step: they were created after
    // before_step().
    void refresh(const physics::World& world, std::span<const physics::BodyId> bodies);
    bool has(physics::BodyId body) const {
        return body.index < records_.size() && records_[body.index].body == body;
    }
    // The body must have been refreshed in this step.
    const BodyFieldData& of(physics::BodyId body) const { return records_[body.index]; }

private:
    void rebuild(const physics::World& world, BodyFieldData& record);

    std::vector<BodyFieldData> records_;  // by body index
    double longest_panel_ = 0;
};

// Union of the category bits of the shapes.
std::uint32_t categories_of(const physics::World& world, std::span<const physics::ShapeId> shapes);
std::uint32_t categories_of(const physics::World& world, physics::BodyId body);

}  // namespace jostle::modules::fields_detail

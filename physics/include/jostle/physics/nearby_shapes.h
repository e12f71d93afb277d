// SPDX-License-Identifier: MIT
//
// Shapes near matter that a module simulates itself, such as a rope: collected once before a step
// and then tested in each sub-step at the poses of that time, without the broad phase and without
// allocation.
//
//     shapes.collect(world, bounds_of_my_matter, dt);         // in before_step()
//     shapes.move_to(substep);                                // in before_substep()
//     shapes.closest_points(points, radius, nearest);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "jostle/physics/defs.h"
#include "jostle/physics/queries.h"
#include "jostle/physics/step_listener.h"

namespace jostle::physics {

/// A point at which a capsule touches or nearly touches a shape.
struct CapsuleContact {
    std::uint32_t shape = 0;  ///< index in NearbyShapes
    double fraction = 0;      ///< of the capsule's axis, 0 to 1
    Vec3 point = {};          ///< m, world, midway between the surfaces
    Vec3 normal = {};         ///< unit vector out of the shape
    double gap = 0;           ///< m, of the surfaces; negative: overlap
};

/// A set of shapes and their bodies. Keeps its memory from step to step. Not thread-safe; different
/// sets are independent.
class NearbyShapes {
public:
    /// A body of the set and its motion.
    struct Body {
        BodyId id = {};
        BodyType type = BodyType::dynamic;
        bool awake = false;
        Vec3 start_center = {};                            ///< m, world, before the step
        Quat start_rotation = {};                          ///< before the step
        Vec3 linear_velocity = {}, angular_velocity = {};  ///< m/s, rad/s, before the step
        Transform origin = {};  ///< of the body's origin relative to its centre, body axes
        double radius = 0;      ///< m, about the centre of mass; infinite for planes
        Vec3 center = {};       ///< current centre of mass, m, world
        Quat rotation = {};     ///< current rotation
    };

    NearbyShapes();
    NearbyShapes(NearbyShapes&&) noexcept;
    NearbyShapes& operator=(NearbyShapes&&) noexcept;
    ~NearbyShapes();

    /// Replaces the set by the shapes that may come within the box (m, world) in a step of dt
    /// seconds, by their velocities before the step and gravity; impacts may take a body further.
    /// Call it between steps or in before_step(). The set is a copy: it does not change with the
    /// world. Order: by ids.
    void collect(const World& world, const Aabb& box, double dt, const QueryFilter& filter = {});
    /// Removes all shapes.
    void clear();

    std::size_t size() const;                           ///< number of shapes
    ShapeId shape(std::size_t index) const;             ///< id of a shape
    const Material& material(std::size_t index) const;  ///< surface properties of a shape
    std::uint32_t body_of(std::size_t index) const;     ///< index of its body in bodies()
    /// Bodies of the shapes, each once, sorted by id.
    std::span<const Body> bodies() const;

    /// Moves the kinematic bodies to the time `seconds` after the start of the step, and the bodies
    /// of the group to their current poses. Other bodies keep their poses.
    void move_to(const SubstepContext& substep);
    /// Same without a group.
    void move_to(double seconds);
    /// Moves one body.
    void place(std::size_t body, Vec3 center, Quat rotation);

    /// Finds the closest shape within `radius` (m) of each point. nearest[k] is that of points[k];
    /// `nearest` has at least as many elements. Of equal distances the lower id wins.
    void closest_points(std::span<const Vec3> points, double radius,
                        std::span<std::optional<ClosestPoint>> nearest) const;
    /// Appends the contacts of a capsule from a to b (m, world, at least 1e-9 m apart) whose gap is
    /// at most `margin` (m): up to two per convex shape and per flat piece of other shapes, in the
    /// order of the shapes.
    void capsule_contacts(Vec3 a, Vec3 b, double radius, double margin,
                          std::vector<CapsuleContact>& contacts) const;

private:
    struct Shape;
    struct Scratch;
    void place_shapes(std::size_t body);

    std::vector<Shape> shapes_;
    std::vector<Body> bodies_;
    std::unique_ptr<Scratch> scratch_;
};

}  // namespace jostle::physics

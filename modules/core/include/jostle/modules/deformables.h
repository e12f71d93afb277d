// SPDX-License-Identifier: MIT
//
// Interfaces of modules whose matter is not rigid, for tools and explosions that do not know the
// module: rays hit ropes and cloths, and users grab, push and cut them.
//
//     if (const auto hit = cast_ray_at_deformables(world, {.origin = eye, .motion = view * 50}))
//         deformables_of(world, hit->module)->grab(world, holder, hit->at).expect();
//
// Call on the thread that steps the world, between steps.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/physics/queries.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// A pulse of pressure, such as that of an explosion.
struct PressurePulse {
    physics::Vec3 center = {};  ///< m
    double radius = 0;          ///< m; the pulse is zero beyond it
    double max_speed = 0;       ///< m/s: no part gains more speed than this
    /// Impulse per area that faces the centre at a point (m), away from the centre, N s/m^2.
    std::function<physics::Vec3(physics::Vec3 point)> impulse_per_area = {};

    /// Velocity change (m/s) of a mass (kg) with an area (m^2) that faces the centre.
    physics::Vec3 change_of(physics::Vec3 point, double area, double mass) const;
};

/// A module with matter that pressure moves.
class PulseReceiver {
public:
    virtual ~PulseReceiver() = default;
    /// Applies a pulse to all matter within its radius, and wakes what it moves.
    virtual void apply_pulse(physics::World& world, const PressurePulse& pulse) = 0;
};

/// A point of a deformable object: a node of a rope or a vertex of a cloth.
struct DeformablePoint {
    std::uint32_t object = 0;   ///< key of the object in its module
    std::uint32_t element = 0;  ///< index of the node or vertex

    bool operator==(const DeformablePoint&) const = default;
};

/// The intersection of a ray with a deformable object.
struct DeformableHit {
    DeformablePoint at = {};      ///< the nearest node or vertex
    double fraction = 0;          ///< of the motion of the ray, 0 to 1
    physics::Vec3 position = {};  ///< m, world, of the intersection
};

/// A module that owns deformable objects. All calls but queries wake the object.
class Deformables : public PulseReceiver {
public:
    /// Returns the first intersection of a ray, nothing if there is none.
    virtual std::optional<DeformableHit> cast_ray(const physics::Ray& ray) const = 0;
    /// Returns the node or vertex of an object that is nearest to a point (m), of those that are
    /// neither attached nor held if there are any; nothing for an unknown object or a point that is
    /// not finite.
    virtual std::optional<DeformablePoint> nearest(std::uint32_t object,
                                                   physics::Vec3 point) const = 0;
    /// Applies an impulse (N s), spread over the nodes or vertices within push_radius. None of them
    /// gains more than push_speed_max. Errors: not_found for an unknown object or element;
    /// invalid_argument for an impulse that is not finite.
    virtual physics::Status push(physics::World& world, DeformablePoint at,
                                 physics::Vec3 impulse) = 0;
    /// Grabs a node or vertex, instead of the previous grab of the same holder in this module. The
    /// target of the grab is the present position (point_grab.h). Errors, without effect:
    /// not_found; failed_precondition if it is attached or held already, or if the object cannot
    /// have more attachments; invalid_argument for the holder 0.
    virtual physics::Status grab(physics::World& world, std::uint32_t holder,
                                 DeformablePoint at) = 0;
    /// Moves the target of a grab (m, world; each component within 1e6). Returns false if the
    /// holder has no grab in this module, or if the target is out of range.
    virtual bool drag(std::uint32_t holder, physics::Vec3 target) = 0;
    /// Releases the grab of a holder, if there is one.
    virtual void release(std::uint32_t holder) = 0;
    /// Cuts an object at a point (m): a rope in two, or the threads of a cloth around the nearest
    /// vertex. Errors: not_found; failed_precondition if it cannot be cut there;
    /// resource_exhausted if the module cannot own more objects.
    virtual physics::Status cut_at(physics::World& world, std::uint32_t object,
                                   physics::Vec3 point) = 0;

    static constexpr double push_radius = 0.3;    ///< m
    static constexpr double push_speed_max = 20;  ///< m/s
};

/// The first intersection of a ray with the deformable objects of all modules of a world.
struct ModuleHit {
    std::string module;  ///< tag
    DeformablePoint at = {};
    double fraction = 0;
    physics::Vec3 position = {};
};

/// Returns the module with a tag if it owns deformable objects, otherwise null.
Deformables* deformables_of(physics::World& world, std::string_view tag);
const Deformables* deformables_of(const physics::World& world, std::string_view tag);
/// Returns the first intersection of a ray (its motion is not zero) with deformable objects.
std::optional<ModuleHit> cast_ray_at_deformables(const physics::World& world,
                                                 const physics::Ray& ray);
/// Applies a pulse to the matter of all modules.
void apply_pulse(physics::World& world, const PressurePulse& pulse);

}  // namespace jostle::modules

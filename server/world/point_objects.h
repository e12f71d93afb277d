// SPDX-License-Identifier: MIT
//
// The point objects that the modules of a world publish (jostle/physics/channels.h), quantized. An
// unchanged object keeps its state pointer, so comparing frames means comparing pointers. Owned by
// ModuleChannels; one thread. States are immutable and shared by all threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/channels.h"
#include "jostle/physics/world.h"
#include "server/world/command.h"

namespace jostle::server {

inline constexpr std::size_t point_objects_max = 1024;       // of a world
inline constexpr std::size_t world_points_max = 128 * 1024;  // of all objects of a world
// Largest magnitude of a coordinate, in steps of the object.
inline constexpr std::int32_t point_coordinate_max = 1 << 30;

// The constant properties of a point object, which clients receive once.
struct PointObjectDescription {
    std::uint32_t id = 0;    // never reused in a world
    std::uint32_t kind = 0;  // index in the world's list of channel kinds
    std::uint32_t key = 0;   // of the module
    EntityId entity = 0;     // 0: positions are in the world
    physics::PointForm form = physics::PointForm::loose;
    std::uint32_t step_um = 0;
    double radius = 0;                   // m
    std::optional<std::uint32_t> color;  // 0xRRGGBB
    std::uint32_t points = 0;            // 0 for loose points
    std::uint32_t columns = 0;
    std::vector<std::uint32_t> strands, triangles;
    physics::Vec3 origin;                 // m, of heights
    double spacing_x = 0, spacing_z = 0;  // m, of heights
};

struct PointObjectState {
    std::shared_ptr<const PointObjectDescription> object;
    std::uint32_t number = 0;  // counts the states of the object, from 1
    std::uint32_t tick = 0;    // in which the object had this state first
    // In steps: a height, or x, y and z of each point.
    std::vector<std::int32_t> values;
    // Loose points: ascending, in the order of the points; a number is never reused in an object.
    std::vector<std::uint32_t> ids;
    physics::Vec3 center;  // of a sphere around the points in the world
    double reach = 0;      // m, its radius
};

// In ascending order of object id.
using PointObjects = std::vector<std::shared_ptr<const PointObjectState>>;

class PointObjectPublisher {
public:
    // Starts the objects of a tick.
    void begin(std::uint32_t tick);
    // Takes over the objects of a kind that is not published in this tick.
    void keep(std::uint32_t kind);
    // Adds an object. Returns why clients do not receive it, if a limit or a rule is violated.
    Status add(const physics::World& world, std::uint32_t kind, EntityId entity,
               const physics::PointObject& object);
    // Completes the objects of the tick. All others have ended.
    void end();
    // Never null.
    const std::shared_ptr<const PointObjects>& objects() const { return objects_; }

private:
    using Key = std::pair<std::uint32_t, std::uint32_t>;  // kind and key

    // An object with what identifies its points from tick to tick.
    struct Known {
        std::shared_ptr<const PointObjectState> state;
        // Loose points: the module's ids in ascending order, and the id of each in the state.
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ids;
        std::uint32_t next_id = 0;
    };

    Status add_points(Known& to, const Known* known, const physics::PointObject& object,
                      PointObjectState& state);

    std::map<Key, Known> known_, next_;
    std::size_t next_points_ = 0;
    std::uint32_t tick_ = 0, next_object_ = 1;
    std::shared_ptr<const PointObjects> objects_ = std::make_shared<const PointObjects>();
};

}  // namespace jostle::server

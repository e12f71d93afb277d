// SPDX-License-Identifier: MIT
//
// The channels and point objects that the modules of a world publish per tick, and the velocities
// of its bodies while a client subscribes to them. An unchanged channel keeps its values pointer,
// so that comparing frames means comparing pointers. Owned by HostedWorld; one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/point_objects.h"

namespace jostle::server {

// Clients hold the channels of every frame that can be a baseline, so their size has limits.
inline constexpr std::size_t channel_kinds_max = 64;          // of a world
inline constexpr std::size_t channels_max = 4096;             // of a frame
inline constexpr std::size_t channel_values_max = 16 * 1024;  // of a channel
inline constexpr std::size_t frame_values_max = 256 * 1024;   // of a frame

// The channel of velocities, in addition to those of modules: for clients that simulate, six values
// per awake body that is not static: the velocity of the centre of mass in 1/128 m/s and the
// angular velocity in 1/128 rad/s.
inline constexpr const char* motion_kind = "jostle.motion";
inline constexpr double velocity_units = 128;

using ChannelValues = std::shared_ptr<const std::vector<std::int32_t>>;

struct Channel {
    std::uint32_t kind = 0;  // index in the world's list of kinds
    EntityId entity = 0;     // 0: the module itself
    ChannelValues values;    // never null
};
// In ascending order of kind and entity, without duplicates.
using Channels = std::vector<Channel>;

class ModuleChannels {
public:
    // The kinds of the world's modules in module order, with full names (TAG.NAME), and the kind
    // `jostle.motion` if the limit allows another kind. Errors name the module and the channel.
    static Result<ModuleChannels> of(const physics::World& world);
    ModuleChannels() = default;

    const std::vector<physics::ChannelKind>& kinds() const { return kinds_; }
    // Whether publish() includes `jostle.motion`.
    void publish_motion(bool wanted) { publishes_motion_ = wanted; }
    // Whether publish() includes point objects.
    void publish_points(bool wanted) {
        begins_points_ = wanted && (begins_points_ || !publishes_points_);
        publishes_points_ = wanted;
    }
    bool publishes_points() const { return publishes_points_; }
    // After a step: publishes the kinds of each module that are due. Skips oversized channels.
    void publish(const physics::World& world, std::uint32_t tick,
                 const physics::ChannelWriter::NameOf& name_of);
    // Never null.
    const std::shared_ptr<const Channels>& channels() const { return channels_; }
    // Never null.
    const std::shared_ptr<const PointObjects>& points() const { return points_.objects(); }

    // The module that published a point object in the last tick, and its key there.
    struct PointObjectOrigin {
        std::string module;  // tag
        std::uint32_t key = 0;
    };
    std::optional<PointObjectOrigin> point_object(std::uint32_t id) const;

    // A channel or a point object (its entity is then 0).
    struct OversizedChannel {
        std::string kind;
        EntityId entity = 0;
        std::string reason;
    };
    // The channels that the last publish() skipped, each kind reported once.
    const std::vector<OversizedChannel>& newly_oversized() const { return newly_oversized_; }

private:
    struct ModuleKinds {
        std::string tag;
        std::uint32_t first = 0, count = 0;  // of kinds_
    };

    // For each kind of the module, whether it is published in this tick.
    std::vector<bool> due(const ModuleKinds& module, std::uint32_t tick) const;
    void add_motion(const physics::World& world, const physics::ChannelWriter::NameOf& name_of);
    void publish_module(const physics::World& world, const ModuleKinds& module,
                        const std::vector<bool>& due,
                        const physics::ChannelWriter::NameOf& name_of);
    // Reuses the previous values if they are equal.
    void add(Channel channel);
    void skip_oversized(const Channel& channel, std::size_t size, std::size_t max,
                        const char* noun);

    std::vector<physics::ChannelKind> kinds_;
    std::vector<ModuleKinds> modules_;
    std::optional<std::uint32_t> motion_;  // the kind of `jostle.motion`
    bool publishes_motion_ = false, publishes_points_ = false;
    bool begins_points_ = false;  // no step since publishes_points_ became true
    PointObjectPublisher points_;
    std::vector<physics::BodyState> bodies_;  // reused by add_motion()
    std::shared_ptr<const Channels> channels_ = std::make_shared<const Channels>();
    std::shared_ptr<Channels> next_;
    std::size_t next_values_ = 0;
    std::vector<OversizedChannel> newly_oversized_;
    std::set<std::uint32_t> warned_;  // kinds that newly_oversized() has reported
};

}  // namespace jostle::server

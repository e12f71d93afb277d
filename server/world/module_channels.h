// SPDX-License-Identifier: MIT
//
// What the modules of a world tell clients, tick by tick, and how its bodies move while somebody
// asks. A channel that says what it said before
// keeps the same values, so that who compares frames compares pointers. Owned by HostedWorld; one
// thread.
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

namespace jostle::server {

// Clients hold every channel of every frame that may be a base: what one world tells is bounded.
inline constexpr std::size_t channel_kinds_max = 64;  // of a world
inline constexpr std::size_t channels_max = 4096;     // of a frame
inline constexpr std::size_t channel_values_max = 16 * 1024;
inline constexpr std::size_t frame_values_max = 256 * 1024;

// Beside those of modules: how bodies move that are awake and not static, for clients that
// simulate. Six numbers each: the velocity of the centre of mass and the spin, in 1/128 m/s and
// 1/128 rad/s.
inline constexpr const char* motion_kind = "jostle.motion";
inline constexpr double velocity_units = 128;

using ChannelValues = std::shared_ptr<const std::vector<std::int32_t>>;

struct Channel {
    std::uint32_t kind = 0;  // place in the world's list of kinds
    EntityId entity = 0;     // 0: of the module itself
    ChannelValues values;    // never null
};
// In rising order of kind and entity, each once.
using Channels = std::vector<Channel>;

class ModuleChannels {
public:
    // The kinds of the world's modules, in their order, each under its full name; then the motion
    // of bodies, if there is room for another kind.
    static Result<ModuleChannels> of(const physics::World& world);
    ModuleChannels() = default;

    const std::vector<physics::ChannelKind>& kinds() const { return kinds_; }
    // Whether what is published next has the motion of bodies, too.
    void publish_motion(bool wanted) { publishes_motion_ = wanted; }
    // After a step: asks each module for the kinds that are due. Too large ones are left out.
    void publish(const physics::World& world, std::uint32_t tick,
                 const physics::ChannelWriter::NameOf& name_of);
    // Never null.
    const std::shared_ptr<const Channels>& channels() const { return channels_; }

    struct OversizedChannel {
        std::string kind;
        EntityId entity = 0;
        std::string what;  // how large, and what is the most
    };
    // What the last publish() left out, each kind told once.
    const std::vector<OversizedChannel>& newly_oversized() const { return newly_oversized_; }

private:
    struct ModuleKinds {
        std::string tag;
        std::uint32_t first = 0, count = 0;  // of kinds_
    };

    // Whether a kind is told in that tick: the first one, and so on.
    std::vector<bool> due(const ModuleKinds& module, std::uint32_t tick) const;
    void add_motion(const physics::World& world, const physics::ChannelWriter::NameOf& name_of);
    // Keeps the values that say the same as before.
    void add(Channel channel);
    void skip_oversized(const Channel& channel, std::size_t size, std::size_t most,
                        const char* noun);

    std::vector<physics::ChannelKind> kinds_;
    std::vector<ModuleKinds> modules_;
    std::optional<std::uint32_t> motion_;  // its kind
    bool publishes_motion_ = false;
    std::vector<physics::BodyState> bodies_;  // memory of add_motion()
    std::shared_ptr<const Channels> channels_ = std::make_shared<const Channels>();
    std::shared_ptr<Channels> next_;
    std::size_t next_values_ = 0;
    std::vector<OversizedChannel> newly_oversized_;
    std::set<std::uint32_t> warned_;  // kinds of whom newly_oversized() told
};

}  // namespace jostle::server

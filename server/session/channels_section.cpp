// SPDX-License-Identifier: MIT
#include "server/session/channels_section.h"

#include "jostle/base/check.h"
#include "server/world/module_channels.h"

namespace jostle::server {

std::uint64_t requested_channels(const std::vector<physics::ChannelKind>& kinds,
                                 const std::vector<std::string>& names) {
    ASSERT(kinds.size() <= 64);
    std::uint64_t requested = 0;
    for (std::size_t k = 0; k < kinds.size(); k++)
        for (const std::string& name : names)
            if (name == kinds[k].name || (name == "*" && kinds[k].name != motion_kind))
                requested |= std::uint64_t{1} << k;
    return requested;
}

std::uint64_t motion_channel(const std::vector<physics::ChannelKind>& kinds) {
    return requested_channels(kinds, {motion_kind});
}

ChannelsSection::ChannelsSection(std::uint64_t kinds, std::uint64_t motion)
    : kinds_(kinds), has_motion_((kinds & motion) != 0) {
    ASSERT(kinds_ != 0);
}

void ChannelsSection::on_enter(FrameListeners& listeners) {
    if (has_motion_) listeners.motion++;
}

void ChannelsSection::on_leave(FrameListeners& listeners) {
    if (!has_motion_) return;
    ASSERT(listeners.motion > 0);
    listeners.motion--;
}

}  // namespace jostle::server

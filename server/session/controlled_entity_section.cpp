// SPDX-License-Identifier: MIT
#include "server/session/controlled_entity_section.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr double updates_per_second = 16;

}  // namespace

ControlledEntitySection::ControlledEntitySection(ClientId client, double hz)
    : client_(client),
      period_(static_cast<std::uint32_t>(std::max(1.0, std::round(hz / updates_per_second)))) {
    ASSERT(client_ != 0);
}

void ControlledEntitySection::on_leave(FrameListeners& listeners) {
    ASSERT(listeners.controlled_entities > 0);
    listeners.controlled_entities--;
}

void ControlledEntitySection::append(const FramePtr& frame, Clock::time_point,
                                     SnapshotParts& parts) {
    if (!frame->controlled_entities) return;
    const auto mine =
        std::ranges::find(*frame->controlled_entities, client_, &ControlledEntityState::client);
    if (mine == frame->controlled_entities->end() || mine->entity == 0) return;
    const bool keyframe = sent_entity_ != mine->entity;
    if (!keyframe && frame->tick < sent_tick_ + period_) return;
    parts.fields += encode_controlled_entity_field(*mine, frame->tick, sent_words_, keyframe);
    sent_entity_ = mine->entity;
    sent_tick_ = frame->tick;
    sent_words_ = mine->words;
}

}  // namespace jostle::server

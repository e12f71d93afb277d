// SPDX-License-Identifier: MIT
#include "server/session/events_section.h"

#include <string>
#include <utility>

#include "jostle/base/check.h"
#include "server/messages/event_message.h"

namespace jostle::server {

void EventsSection::on_leave(FrameListeners& listeners) {
    ASSERT(listeners.events > 0);
    listeners.events--;
}

void EventsSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    const auto& [count, ticks] = *frame->events;
    ASSERT(ticks.size() <= count);
    const std::uint32_t dropped = count - static_cast<std::uint32_t>(ticks.size());
    if (cursor_ < dropped) {
        missed_ += dropped - cursor_;
        cursor_ = dropped;
    }
    std::string fields;
    for (; cursor_ < count; cursor_++) {
        const SharedBytes shared = broadcast_.events(ticks[cursor_ - dropped]);
        if (shared->size() > bytes_max) {
            missed_++;
            continue;
        }
        if (fields.size() + shared->size() > bytes_max) break;  // the next snapshot carries it
        fields += encode_events_header(std::exchange(missed_, 0), shared->size());
        fields += *shared;
    }
    parts.fields += fields;
}

}  // namespace jostle::server

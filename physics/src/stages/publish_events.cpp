// SPDX-License-Identifier: MIT
#include "stages/publish_events.h"

#include <algorithm>

namespace jostle::physics {
namespace {

template <class Event>
void sort_by_shapes(std::vector<Event>& events) {
    std::sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
        return std::pair(x.shape_a, x.shape_b) < std::pair(y.shape_a, y.shape_b);
    });
}

}  // namespace

void publish_events(StepContext& step) {
    EventStore& events = step.world.events;
    sort_by_shapes(events.contacts_began);
    sort_by_shapes(events.contacts_ended);
    std::sort(events.fell_asleep.begin(), events.fell_asleep.end());
    std::sort(events.woke.begin(), events.woke.end());
    std::sort(events.quarantined.begin(), events.quarantined.end());
}

}  // namespace jostle::physics

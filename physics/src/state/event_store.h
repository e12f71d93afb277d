// SPDX-License-Identifier: MIT
//
// Events of the last step, readable until the next step. Not part of the state: never saved or
// hashed.
#pragma once

#include <vector>

#include "jostle/physics/events.h"

namespace jostle::physics {

// Events between steps, caused by destroying or moving a body; published by the next step.
struct PendingEvents {
    std::vector<ContactEnd> ended;
    std::vector<TriggerEvent> left;
    std::vector<BodyId> woke, fell_asleep;
};

struct EventStore {
    std::vector<ContactBegin> contacts_began;
    std::vector<ContactEnd> contacts_ended;
    std::vector<ContactStay> contacts;
    std::vector<ContactHit> hits;
    std::vector<TriggerEvent> triggers_entered, triggers_stayed, triggers_left;
    std::vector<JointBreak> joints_broke;
    std::vector<BodyId> fell_asleep, woke, quarantined;
    PendingEvents pending;

    // True if the step published no events.
    bool empty() const {
        return contacts_began.empty() && contacts_ended.empty() && contacts.empty() &&
               hits.empty() && triggers_entered.empty() && triggers_stayed.empty() &&
               triggers_left.empty() && joints_broke.empty() && fell_asleep.empty() &&
               woke.empty() && quarantined.empty();
    }

    void clear_published() {
        contacts_began.clear();
        contacts_ended.clear();
        contacts.clear();
        hits.clear();
        triggers_entered.clear();
        triggers_stayed.clear();
        triggers_left.clear();
        joints_broke.clear();
        fell_asleep.clear();
        woke.clear();
        quarantined.clear();
    }

    void begin_step() {
        clear_published();
        contacts_ended.swap(pending.ended);
        triggers_left.swap(pending.left);
        woke.swap(pending.woke);
        fell_asleep.swap(pending.fell_asleep);
    }
};

}  // namespace jostle::physics

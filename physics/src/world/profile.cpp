// SPDX-License-Identifier: MIT
#include "jostle/physics/profile.h"

namespace jostle::physics {

const char* stage_name(Stage stage) {
    switch (stage) {
        case Stage::update_pairs:
            return "update_pairs";
        case Stage::update_contacts:
            return "update_contacts";
        case Stage::wake_bodies:
            return "wake_bodies";
        case Stage::begin_contacts:
            return "begin_contacts";
        case Stage::prepare_islands:
            return "prepare_islands";
        case Stage::solve_constraints:
            return "solve_constraints";
        case Stage::merge_islands:
            return "merge_islands";
        case Stage::integrate_free:
            return "integrate_free";
        case Stage::finalize:
            return "finalize";
        case Stage::solve_continuous:
            return "solve_continuous";
        case Stage::quarantine:
            return "quarantine";
        case Stage::update_sleep:
            return "update_sleep";
        case Stage::update_triggers:
            return "update_triggers";
        case Stage::publish_events:
            return "publish_events";
    }
    return "unknown";
}

}  // namespace jostle::physics

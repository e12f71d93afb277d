// SPDX-License-Identifier: MIT
//
// Order of the events of solve_continuous: impacts and ends of legs, by their times. Of
// simultaneous impacts the hardest comes first, so a row of balls propagates an impact from one
// ball to the next. Also records which TOI bodies expect to hit a body next. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/src/stages/continuous/toi_dependents.h"
#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

class ImpactQueue {
public:
    // Enters the next event of a TOI body, which replaces its previous one.
    void update(const ToiState& state, std::size_t index);
    // Returns the TOI body with the first event of the rest of the step. The event stays in the
    // queue until its body is updated.
    std::optional<std::size_t> next();

    // Calls visit(index) for all TOI bodies that were entered with an impact on a body. Such an
    // impact may be outdated. Each is visited once.
    template <class Visit>
    void take_dependents(std::uint32_t body, Visit&& visit) {
        dependents_.take(body, std::forward<Visit>(visit));
    }

private:
    struct Event {
        double at = 0, closing = 0;  // fraction of the step, m/s
        std::size_t index = 0;       // of the TOI body
        friend bool operator>(const Event& x, const Event& y) {
            if (x.at != y.at) return x.at > y.at;
            if (x.closing != y.closing) return x.closing < y.closing;
            return x.index > y.index;
        }
    };

    std::vector<double> next_at_;  // by TOI body: the time of its next event
    std::vector<Event> heap_;      // an event is outdated if its time differs from next_at_
    ToiDependents dependents_;
};

}  // namespace jostle::physics

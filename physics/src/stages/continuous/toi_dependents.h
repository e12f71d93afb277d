// SPDX-License-Identifier: MIT
//
// Records which bodies expect to hit a body next, so that they can be notified when it is
// deflected. Outdated entries remain until they are taken; the caller checks whether an entry is
// still valid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace jostle::physics {

class ToiDependents {
public:
    void add(std::uint32_t body, std::size_t dependent) {
        if (body >= latest_.size()) latest_.resize(body + 1, no_index);
        chain_.push_back({dependent, latest_[body]});
        latest_[body] = static_cast<std::uint32_t>(chain_.size() - 1);
    }

    // Calls visit(dependent) for all entries of a body, and removes them.
    template <class Visit>
    void take(std::uint32_t body, Visit&& visit) {
        if (body >= latest_.size()) return;
        for (std::uint32_t at = std::exchange(latest_[body], no_index); at != no_index;
             at = chain_[at].previous)
            visit(chain_[at].dependent);
    }

private:
    static constexpr std::uint32_t no_index = 0xffffffff;

    struct Node {
        std::size_t dependent;
        std::uint32_t previous;
    };
    std::vector<std::uint32_t> latest_;  // indexed by body
    std::vector<Node> chain_;
};

}  // namespace jostle::physics

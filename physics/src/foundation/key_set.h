// SPDX-License-Identifier: MIT
//
// A set of 64-bit keys in one flat array, so that a copy is a single block of memory: open
// addressing with linear probing (Knuth, The Art of Computer Programming 3, 6.4). Supports lookup
// only, no iteration: the order of the slots depends on the order of insertion.
#pragma once

#include <cstddef>
#include <cstdint>

#include "jostle/base/check.h"
#include "physics/src/foundation/flat_array.h"

namespace jostle::physics {

class KeySet {
public:
    // The only key that the set cannot contain.
    static constexpr std::uint64_t no_key = ~std::uint64_t{0};

    bool contains(std::uint64_t key) const {
        return !slots_.empty() && slots_[slot_of(key)] == key;
    }

    // No effect if the key is present.
    void insert(std::uint64_t key) {
        ASSERT(key != no_key);
        if (4 * (size_ + 1) > 3 * slots_.size()) grow();
        std::uint64_t& slot = slots_[slot_of(key)];
        if (slot == key) return;
        slot = key;
        size_++;
    }

    // No effect if the key is absent.
    void erase(std::uint64_t key) {
        if (!contains(key)) return;
        std::size_t hole = slot_of(key);
        size_--;
        // No tombstones: keys that probing had moved past the hole are moved back into it.
        for (std::size_t at = next(hole); slots_[at] != no_key; at = next(at)) {
            if (distance(home_of(slots_[at]), at) < distance(hole, at)) continue;
            slots_[hole] = slots_[at];
            hole = at;
        }
        slots_[hole] = no_key;
    }

    std::size_t size() const { return size_; }

private:
    // Keys often consist of two small numbers; the product mixes both into its upper half.
    std::size_t home_of(std::uint64_t key) const {
        const std::uint64_t mixed = (key ^ key >> 32) * 0x9e3779b97f4a7c15ull;
        return static_cast<std::size_t>(mixed >> 32) & (slots_.size() - 1);
    }
    std::size_t next(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
    std::size_t distance(std::size_t from, std::size_t to) const {
        return (to - from) & (slots_.size() - 1);
    }
    // Returns the slot of the key, or the empty slot where it would be inserted. An empty slot
    // always exists.
    std::size_t slot_of(std::uint64_t key) const {
        std::size_t at = home_of(key);
        while (slots_[at] != key && slots_[at] != no_key) at = next(at);
        return at;
    }
    void grow() {
        FlatArray<std::uint64_t> old(slots_.empty() ? 16 : 2 * slots_.size(), no_key);
        old.swap(slots_);
        for (const std::uint64_t key : old)
            if (key != no_key) slots_[slot_of(key)] = key;
    }

    FlatArray<std::uint64_t> slots_;  // size is a power of two, at most three quarters full
    std::size_t size_ = 0;
};

}  // namespace jostle::physics

// SPDX-License-Identifier: MIT
//
// Three broad phases with one interface and identical query results: a dynamic tree (good in
// general), sort and sweep (good when boxes are spread along one axis) and a uniform grid (good
// when boxes have similar sizes).
#pragma once

#include <memory>
#include <typeinfo>
#include <utility>

#include "physics/src/collision/broadphase/broad_phase_index.h"

namespace jostle::physics {

std::unique_ptr<BroadPhaseIndex> make_broad_phase(BroadPhase kind);

// A broad-phase index with value semantics. Copying the owner copies the index; copy assignment
// reuses memory if both indices have the same kind.
class OwnedBroadPhase {
public:
    OwnedBroadPhase(std::unique_ptr<BroadPhaseIndex> index) : index_(std::move(index)) {}
    OwnedBroadPhase(const OwnedBroadPhase& other) : index_(other->clone()) {}
    OwnedBroadPhase(OwnedBroadPhase&&) noexcept = default;
    OwnedBroadPhase& operator=(const OwnedBroadPhase& other) {
        if (this == &other) return *this;
        if (index_ && of_one_kind(*index_, *other))
            index_->assign(*other);
        else
            index_ = other->clone();
        return *this;
    }
    OwnedBroadPhase& operator=(OwnedBroadPhase&&) noexcept = default;
    ~OwnedBroadPhase() = default;

    BroadPhaseIndex& operator*() { return *index_; }
    const BroadPhaseIndex& operator*() const { return *index_; }
    BroadPhaseIndex* operator->() { return index_.get(); }
    const BroadPhaseIndex* operator->() const { return index_.get(); }

private:
    static bool of_one_kind(const BroadPhaseIndex& a, const BroadPhaseIndex& b) {
        return typeid(a) == typeid(b);
    }

    std::unique_ptr<BroadPhaseIndex> index_;
};

}  // namespace jostle::physics

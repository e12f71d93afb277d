// SPDX-License-Identifier: MIT
//
// Three broad phases behind one face, with the same answers: a dynamic tree (good at everything),
// sort and sweep (good while all is spread along one axis), a uniform grid (good while boxes are of
// like size).
#pragma once

#include <memory>
#include <typeinfo>
#include <utility>

#include "physics/src/collision/broadphase/broad_phase_index.h"

namespace jostle::physics {

std::unique_ptr<BroadPhaseIndex> make_broad_phase(BroadPhase kind);

// An index as a value: copied when its owner is, in place where both are of one kind.
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

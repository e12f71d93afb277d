// SPDX-License-Identifier: MIT
//
// The stores are plain arrays, so a copy of them is a dozen blocks of memory. No list of fields
// here: what is added to a store is kept without further ado.
#include "jostle/physics/restore_point.h"

#include <type_traits>

#include "jostle/physics/world.h"
#include "state/world_access.h"

namespace jostle::physics {

// What there are thousands of is copied as bytes; a shape is not, because it shares its geometry.
static_assert(std::is_trivially_copyable_v<BodyCold> && std::is_trivially_copyable_v<BodyWarm> &&
              std::is_trivially_copyable_v<MotionBound> && std::is_trivially_copyable_v<Contact> &&
              std::is_trivially_copyable_v<SeparationBound> &&
              std::is_trivially_copyable_v<Joint> &&
              std::is_trivially_copyable_v<ContactConstraintWide> &&
              std::is_trivially_copyable_v<SavedContact>);

struct RestorePoint::Kept {
    WorldStores stores;
    PendingEvents pending;  // the next step publishes them
};

RestorePoint::RestorePoint() = default;
RestorePoint::RestorePoint(RestorePoint&&) noexcept = default;
RestorePoint& RestorePoint::operator=(RestorePoint&&) noexcept = default;
RestorePoint::~RestorePoint() = default;

void RestorePoint::keep(const World& world) {
    if (!kept_) kept_ = std::make_unique<Kept>();
    kept_->stores = state_of(world);
    kept_->pending = state_of(world).events.pending;
}

Status RestorePoint::restore(World& world) const {
    if (!kept_)
        return Error{ErrorCode::failed_precondition, "restore point: nothing was kept in it yet"};
    WorldState& state = state_of(world);
    const int threads = state.def.threads;
    static_cast<WorldStores&>(state) = kept_->stores;
    state.def.threads = threads;
    state.events.clear_published();
    state.events.pending = kept_->pending;
    state.wake_requests.clear();
    return {};
}

}  // namespace jostle::physics

// SPDX-License-Identifier: MIT
//
// The stores are plain arrays, so a copy consists of a dozen blocks of memory. No field list is
// needed: a new field of a store is copied automatically.
#include "jostle/physics/restore_point.h"

#include <algorithm>
#include <type_traits>

#include "jostle/physics/world.h"
#include "physics/src/serialization/field_list.h"
#include "physics/src/serialization/saved_world.h"
#include "physics/src/state/world_access.h"

namespace jostle::physics {

// Numerous records are copied as bytes. Exceptions are shapes, which share geometry, and joints,
// some kinds of which allocate memory.
static_assert(std::is_trivially_copyable_v<BodyCold> && std::is_trivially_copyable_v<BodyWarm> &&
              std::is_trivially_copyable_v<MotionBound> && std::is_trivially_copyable_v<Contact> &&
              std::is_trivially_copyable_v<SeparationBound> &&
              std::is_trivially_copyable_v<ContactConstraintWide> &&
              std::is_trivially_copyable_v<SavedContact>);

struct RestorePoint::CapturedState {
    WorldStores stores;
    PendingEvents pending;  // published by the next step
    struct ModuleState {
        std::string tag;
        std::vector<std::byte> state;
    };
    std::vector<ModuleState> modules;  // in their order
};

RestorePoint::RestorePoint() = default;
RestorePoint::RestorePoint(RestorePoint&&) noexcept = default;
RestorePoint& RestorePoint::operator=(RestorePoint&&) noexcept = default;
RestorePoint::~RestorePoint() = default;

std::size_t RestorePoint::module_bytes() const {
    std::size_t bytes = 0;
    if (state_)
        for (const CapturedState::ModuleState& module : state_->modules)
            bytes += module.state.capacity();
    return bytes;
}

void RestorePoint::capture(const World& world) {
    if (!state_) state_ = std::make_unique<CapturedState>();
    state_->stores = state_of(world);
    state_->pending = state_of(world).events.pending;
    state_->modules.clear();
    for (const std::unique_ptr<Module>& module : state_of(world).listeners.modules)
        state_->modules.push_back({std::string(module->tag()), save_module(*module)});
}

Status RestorePoint::restore(World& world) const {
    if (!state_)
        return Error{ErrorCode::failed_precondition,
                     "restore point: it is empty; call capture() first"};
    WorldState& state = state_of(world);
    if (state.listeners.stepping != nullptr)
        return Error{ErrorCode::failed_precondition,
                     "restore point: the world is stepping; call restore() between two steps"};
    // Everything that can fail precedes the first change.
    std::vector<std::unique_ptr<Module>> missing;
    for (const CapturedState::ModuleState& captured : state_->modules) {
        if (state.listeners.module(captured.tag) != nullptr) continue;
        Result<std::unique_ptr<Module>> made = make_module(captured.tag);
        if (!made.ok()) return Error{made.error().code, "restore point: " + made.error().message};
        missing.push_back(std::move(made).value());
    }
    const int threads = state.def.threads;
    const std::uint64_t joint_revision = state.joints.revision;
    static_cast<WorldStores&>(state) = state_->stores;
    state.joints.revision = joint_revision + 1;
    state.def.threads = threads;
    state.events.clear_published();
    state.events.pending = state_->pending;
    state.wake_requests.clear();
    state.static_revision++;
    return restore_modules(world, std::move(missing));
}

Result<RestorePoint::Saved> RestorePoint::save() const {
    if (!state_)
        return Error{ErrorCode::failed_precondition,
                     "restore point: it is empty; call capture() first"};
    ListenerStore modules;
    for (const CapturedState::ModuleState& captured : state_->modules) {
        Result<std::unique_ptr<Module>> made = make_module(captured.tag);
        if (!made.ok()) return Error{made.error().code, "restore point: " + made.error().message};
        if (Status s = load_module(**made, captured.state); !s.ok()) return s.error();
        modules.add(std::move(made).value());
    }
    SaverAndHash visitor;
    begin_saved_world(visitor.saver, state_->stores);
    visit_stores(visitor, state_->stores);
    visit_modules(visitor, modules);
    return Saved{end_saved_world(visitor.saver), visitor.hash.hasher.value};
}

// Replaces the modules of the world with the captured ones, in their order.
Status RestorePoint::restore_modules(World& world,
                                     std::vector<std::unique_ptr<Module>> missing) const {
    ListenerStore& listeners = state_of(world).listeners;
    const auto captured = [&](std::string_view tag) {
        return std::any_of(
            state_->modules.begin(), state_->modules.end(),
            [&](const CapturedState::ModuleState& state) { return state.tag == tag; });
    };
    std::vector<std::string> gone;
    for (const std::unique_ptr<Module>& module : listeners.modules)
        if (!captured(module->tag())) gone.emplace_back(module->tag());
    for (const std::string& tag : gone) listeners.remove_module(tag);
    for (std::unique_ptr<Module>& module : missing) listeners.add(std::move(module));
    std::vector<std::string> order;
    for (const CapturedState::ModuleState& state : state_->modules) order.push_back(state.tag);
    listeners.sort_modules(order);
    for (const CapturedState::ModuleState& state : state_->modules) {
        Module& module = *listeners.module(state.tag);
        if (Status s = load_module(module, state.state); !s.ok()) return s;
        module.restored(world);
    }
    return {};
}

}  // namespace jostle::physics

// SPDX-License-Identifier: MIT
//
// Listeners and modules of a world.
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"
#include "physics/src/state/module_registry.h"
#include "physics/src/state/world_state.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {

Status World::add_listener(StepListener& listener) {
    ListenerStore& store = state_->listeners;
    if (Status s = check_not_stepping(state_->listeners, "add a listener"); !s.ok()) return s;
    if (store.contains(listener))
        return Error{ErrorCode::failed_precondition,
                     "the listener has already been added; add it once"};
    store.add(listener);
    return {};
}

Status World::remove_listener(StepListener& listener) {
    ListenerStore& store = state_->listeners;
    if (Status s = check_not_stepping(state_->listeners, "remove a listener"); !s.ok()) return s;
    const auto is_it = [&](const auto& module) { return module.get() == &listener; };
    if (std::any_of(store.modules.begin(), store.modules.end(), is_it))
        return Error{ErrorCode::failed_precondition,
                     "the listener is a module owned by the world; call remove_module()"};
    if (!store.contains(listener))
        return Error{ErrorCode::not_found, "the listener is not registered with this world"};
    store.remove(listener);
    return {};
}

Status World::add_module(std::unique_ptr<Module> module) {
    ListenerStore& store = state_->listeners;
    if (Status s = check_not_stepping(state_->listeners, "add a module"); !s.ok()) return s;
    if (!module) return Error{ErrorCode::invalid_argument, "module is null"};
    if (Status s = check_module_tag(module->tag()); !s.ok()) return s;
    if (store.module(module->tag()) != nullptr)
        return Error{ErrorCode::failed_precondition,
                     "the world already has a module \"" + std::string(module->tag()) + "\""};
    store.add(std::move(module));
    return {};
}

Status World::remove_module(std::string_view tag) {
    if (Status s = check_not_stepping(state_->listeners, "remove a module"); !s.ok()) return s;
    if (state_->listeners.module(tag) == nullptr)
        return Error{ErrorCode::not_found, "the world has no module \"" + std::string(tag) + "\""};
    state_->listeners.remove_module(tag);
    return {};
}

Module* World::module(std::string_view tag) {
    return state_->listeners.module(tag);
}
const Module* World::module(std::string_view tag) const {
    return state_->listeners.module(tag);
}

std::vector<std::string> World::modules() const {
    std::vector<std::string> tags;
    for (const std::unique_ptr<Module>& module : state_->listeners.modules)
        tags.emplace_back(module->tag());
    return tags;
}

}  // namespace jostle::physics

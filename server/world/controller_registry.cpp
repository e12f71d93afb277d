// SPDX-License-Identifier: MIT
#include "server/world/controller_registry.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

using namespace physics;

Module* controlling_module(World& world, BodyId body) {
    for (const std::string& tag : world.modules()) {
        Module* const module = world.module(tag);
        if (module->is_controllable(body)) return module;
    }
    return nullptr;
}

bool is_controllable(const World& world, BodyId body) {
    const std::vector<std::string> tags = world.modules();
    return std::ranges::any_of(
        tags, [&](const std::string& tag) { return world.module(tag)->is_controllable(body); });
}

Status ControllerRegistry::possess(World& world, ClientId client, BodyId body) {
    if (controlling_module(world, body) == nullptr)
        return Error{ErrorCode::permission_denied, "the entity is not controllable"};
    const auto is_other_client = [&](const auto& entry) {
        return entry.second == body && entry.first != client;
    };
    if (std::ranges::any_of(controlled_, is_other_client))
        return Error{ErrorCode::permission_denied, "another client controls the entity"};
    const auto at = controlled_.find(client);
    if (at != controlled_.end() && at->second == body) return {};
    release(world, client);
    ASSERT(!is_null(body) && !controlled_.contains(client));
    controlled_[client] = body;
    return {};
}

std::optional<BodyId> ControllerRegistry::control(World& world, ClientId client,
                                                  const Controls& controls) {
    const auto at = controlled_.find(client);
    if (at == controlled_.end()) return std::nullopt;
    Module* const module = controlling_module(world, at->second);
    if (module == nullptr) {  // no module controls the body any longer
        controlled_.erase(at);
        return std::nullopt;
    }
    module->control(world, at->second, controls);
    return at->second;
}

void ControllerRegistry::release(World& world, ClientId client) {
    if (controlled_.contains(client)) static_cast<void>(control(world, client, {}));
    controlled_.erase(client);
}

void ControllerRegistry::release_body(World& world, BodyId body) {
    const auto at =
        std::ranges::find_if(controlled_, [&](const auto& entry) { return entry.second == body; });
    if (at != controlled_.end()) release(world, at->first);
}

std::vector<ControlledEntityState> ControllerRegistry::controlled_states(
    World& world, const modules::BodyNameLookup& name_of) const {
    std::vector<ControlledEntityState> states;
    for (const auto& [client, body] : controlled_) {
        Module* const module = controlling_module(world, body);
        if (module == nullptr) continue;
        auto words = modules::encode_controlled_entity(world, *module, body, name_of);
        if (words)
            states.push_back(
                {client, name_of(body), std::string(module->tag()), *std::move(words)});
    }
    return states;
}

void ControllerRegistry::write(SavedHostState& host_state) const {
    for (const auto& [client, body] : controlled_)
        host_state.controlled_entities.push_back({client, body});
}

void ControllerRegistry::restore(const SavedHostState& host_state) {
    ASSERT(controlled_.empty());
    for (const SavedHostState::Controlled& controlled : host_state.controlled_entities)
        controlled_[controlled.client] = controlled.body;
}

}  // namespace jostle::server

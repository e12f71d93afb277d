// SPDX-License-Identifier: MIT
#include "host/world_directory.h"

#include "base/log.h"

namespace jostle::server {

namespace {

// "w" and digits: as a name it would hide the world that has, or will have, that id.
bool looks_like_id(const std::string& name) {
    return name.size() > 1 && name[0] == 'w' &&
           name.find_first_not_of("0123456789", 1) == std::string::npos;
}

Status check_name(const std::string& name) {
    if (name.empty() || name.size() > 64)
        return Error{ErrorCode::invalid_argument, "a world's name has 1 to 64 bytes"};
    if (looks_like_id(name))
        return Error{ErrorCode::invalid_argument,
                     "\"" + name + "\" is how ids look; choose another name"};
    return {};
}

Error name_taken(const std::string& name) {
    return {ErrorCode::already_exists, "there is a world \"" + name + "\" already"};
}

}  // namespace

Result<std::shared_ptr<WorldHost>> WorldDirectory::create(const std::string& wanted,
                                                          const scenes::SceneDescription& scene) {
    const std::string name = wanted.empty() ? scene.name : wanted;
    std::uint32_t number;
    {
        const std::lock_guard lock(mutex_);
        if (!name.empty() && find_locked(name)) return name_taken(name);
        if (static_cast<int>(worlds_.size()) >= worlds_max_)
            return Error{ErrorCode::resource_exhausted,
                         "the server holds " + std::to_string(worlds_max_) +
                             " worlds, the most allowed; delete one first"};
        if (Status s = check_name(name); !s.ok()) return s.error();
        number = next_++;
        worlds_.emplace(number,
                        nullptr);  // holds the place while the world is built without the lock
    }
    const std::string id = "w" + std::to_string(number);
    auto host = WorldHost::start(id, name, scene, settings_);
    const std::lock_guard lock(mutex_);
    // Another call may have taken the name meanwhile.
    if (!host.ok() || find_locked(name)) {
        worlds_.erase(number);
        if (!host.ok()) return host.error();
        return name_taken(name);
    }
    worlds_[number] = *host;
    log_info("world {} \"{}\" runs scene {} at {} Hz with {} bodies", id, name, scene.name,
             scene.hz, scene.bodies.size());
    return host;
}

std::shared_ptr<WorldHost> WorldDirectory::find_locked(const std::string& key) const {
    for (const auto& [number, world] : worlds_)
        if (world && (key.empty() || world->id() == key || world->name() == key)) return world;
    return nullptr;
}

std::shared_ptr<WorldHost> WorldDirectory::find(const std::string& id_or_name) const {
    const std::lock_guard lock(mutex_);
    return find_locked(id_or_name);
}

std::vector<std::shared_ptr<WorldHost>> WorldDirectory::list() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<WorldHost>> out;
    for (const auto& [number, world] : worlds_)
        if (world) out.push_back(world);
    return out;
}

std::shared_ptr<WorldHost> WorldDirectory::remove(const std::string& id_or_name) {
    std::shared_ptr<WorldHost> world;
    {
        const std::lock_guard lock(mutex_);
        if (id_or_name.empty()) return nullptr;
        world = find_locked(id_or_name);
        if (!world) return nullptr;
        std::erase_if(worlds_, [&](const auto& entry) { return entry.second == world; });
    }
    world->stop();
    log_info("world {} \"{}\" was deleted", world->id(), world->name());
    return world;
}

void WorldDirectory::stop_all() {
    for (const auto& world : list()) world->stop();
}

}  // namespace jostle::server

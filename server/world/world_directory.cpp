// SPDX-License-Identifier: MIT
#include "server/world/world_directory.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "jostle/base/check.h"
#include "server/auth/identity.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

constexpr std::size_t restarts_max = 3;  // within restart_span; the next failure closes the world
constexpr auto restart_span = std::chrono::minutes(1);

// "w" and digits, optionally followed by "-" and more. Such a name could hide the world with that
// id.
bool looks_like_id(const std::string& name) {
    if (name.size() < 2 || name[0] != 'w') return false;
    const std::size_t end = name.find_first_not_of("0123456789", 1);
    return end == std::string::npos || (end > 1 && name[end] == '-');
}

Status check_name(const std::string& name) {
    if (name.empty() || name.size() > 64)
        return Error{ErrorCode::invalid_argument, "the name of the world has " +
                                                      std::to_string(name.size()) +
                                                      " bytes; must have 1 to 64"};
    if (looks_like_id(name))
        return Error{ErrorCode::invalid_argument,
                     "the name \"" + name +
                         "\" has the form of a world id (wN or wN-...); choose "
                         "another name"};
    return {};
}

Error not_persisted() {
    return {ErrorCode::failed_precondition,
            "the world is not persisted, so only its current state is available; "
            "set persistence.database to persist worlds"};
}

Error name_taken(const std::string& name) {
    return {ErrorCode::already_exists,
            "a world named \"" + name + "\" exists; choose another name or delete it first"};
}

std::optional<RoomState> make_room(std::optional<RoomProperties> properties,
                                   const std::string& owner) {
    if (!properties) return std::nullopt;
    return new_room(*std::move(properties), owner == anonymous_subject ? std::string() : owner);
}

// Running out of memory fails the creation of this world only.
template <class Work>
auto built(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::exception& error) {
        return Error{ErrorCode::resource_exhausted,
                     std::string("cannot build the world: ") + error.what()};
    }
}

}  // namespace

template <class Start>
Result<std::shared_ptr<WorldHost>> WorldDirectory::create_with(const std::string& name,
                                                               const std::string& owner,
                                                               std::size_t bodies, Start start) {
    std::uint32_t number;
    {
        const std::lock_guard lock(mutex_);
        if (!name.empty() && find_locked(name)) return name_taken(name);
        if (static_cast<int>(worlds_.size()) >= worlds_max_)
            return Error{ErrorCode::resource_exhausted,
                         "the server has " + std::to_string(worlds_.size()) +
                             " worlds; world.worlds_max allows " + std::to_string(worlds_max_) +
                             "; delete a world first"};
        if (Status s = check_name(name); !s.ok()) return s.error();
        if (Status s = check_totals(bodies, 0); !s.ok()) return s.error();
        number = next_++;
        ASSERT(!worlds_.contains(number));
        worlds_.emplace(number, nullptr);  // reserved while the world is built without the lock
    }
    const std::string id = "w" + std::to_string(number) + (process_.empty() ? "" : "-" + process_);
    const Result<std::shared_ptr<WorldHost>> host = built([&] {
        return start(WorldLabel{id, name, owner});
    });
    const std::lock_guard lock(mutex_);
    // Another call may have taken the name or reached a limit meanwhile.
    Status fits = host.ok() ? check_totals(0, (*host)->properties().work_per_second) : host.error();
    if (fits.ok() && find_locked(name)) fits = name_taken(name);
    if (!fits.ok()) {
        worlds_.erase(number);
        if (host.ok() && settings_.world_persistence) {
            (*host)->skip_final_checkpoint();
            (*host)->stop();
            settings_.world_persistence->drop(id);
        }
        return fits.error();
    }
    ASSERT(worlds_.contains(number) && !worlds_.at(number));
    worlds_[number] = *host;
    return host;
}

Result<std::shared_ptr<WorldHost>> WorldDirectory::create(const std::string& requested_name,
                                                          const scenes::SceneDescription& scene,
                                                          const std::string& owner,
                                                          std::optional<RoomProperties> room) {
    const std::string name = requested_name.empty() ? scene.name : requested_name;
    auto host = create_with(name, owner, scene.bodies.size(), [&](WorldLabel label) {
        return WorldHost::start(std::move(label),
                                std::make_shared<const scenes::SceneDescription>(scene), settings_,
                                make_room(std::move(room), owner));
    });
    if (host.ok())
        log_info("world {} \"{}\" runs scene {} at {} Hz with {} bodies", (*host)->id(), name,
                 scene.name, scene.hz, scene.bodies.size());
    return host;
}

Result<std::shared_ptr<WorldHost>> WorldDirectory::create_from(const std::string& name,
                                                               const WorldHost& world,
                                                               std::uint32_t tick,
                                                               const std::string& owner,
                                                               std::optional<RoomProperties> room) {
    Result<HostedWorld> past = world_at(world, tick);
    if (!past.ok()) return past.error();
    past->release_all_clients();
    past->set_room(make_room(std::move(room), owner));
    const std::size_t bodies = past->entities();
    auto host = create_with(name, owner, bodies, [&](WorldLabel label) {
        return WorldHost::begin(
            {std::move(label), world.properties().scene, *std::move(past), tick}, settings_);
    });
    if (host.ok())
        log_info("world {} \"{}\" continues from tick {} of world {} with {} bodies", (*host)->id(),
                 name, tick, world.id(), bodies);
    return host;
}

std::shared_ptr<WorldHost> WorldDirectory::adopt(WorldStart start) {
    const std::string& id = start.label.id;
    const std::size_t end = std::min(id.find('-'), id.size());
    std::uint32_t number = 0;
    const bool is_id = end > 1 && id[0] == 'w' &&
                       std::from_chars(id.data() + 1, id.data() + end, number).ec == std::errc();
    const std::lock_guard lock(mutex_);
    if (!is_id || worlds_.contains(number)) number = next_;
    next_ = std::max(next_, number + 1);
    ASSERT(!worlds_.contains(number));
    return worlds_[number] = WorldHost::start(std::move(start), settings_);
}

Status WorldDirectory::check_totals(std::size_t bodies, double work) const {
    for (const auto& [number, world] : worlds_) {
        if (!world) continue;
        bodies += world->frame()->entities.size();
        work += world->properties().work_per_second;
    }
    const TotalLimits& totals = settings_.totals;
    if (bodies > static_cast<std::size_t>(totals.bodies_max))
        return Error{ErrorCode::resource_exhausted,
                     "all worlds together would have " + std::to_string(bodies) +
                         " bodies; world.bodies_total_max allows " +
                         std::to_string(totals.bodies_max) + "; delete a world first"};
    if (work > totals.work_per_second_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("all worlds together would need {:.3g} units of work per second; "
                                 "scene.work_total_per_second_max allows {:.3g}; delete a world "
                                 "first",
                                 work, totals.work_per_second_max)};
    return {};
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

Result<HostedWorld> WorldDirectory::world_at(const WorldHost& world, std::uint32_t tick) const {
    if (!world.is_persisted()) return not_persisted();
    return built([&] { return settings_.world_persistence->world_at(world.id(), tick); });
}

Result<ExportedScene> WorldDirectory::scene_at(const WorldHost& world, std::uint32_t tick) const {
    Result<HostedWorld> past = world_at(world, tick);
    if (!past.ok()) return past.error();
    return past->exported(*world.properties().scene);
}

Result<std::shared_ptr<WorldHost>> WorldDirectory::rewind(const std::shared_ptr<WorldHost>& world,
                                                          std::uint32_t tick) {
    Result<HostedWorld> past = world_at(*world, tick);  // the world ticks meanwhile
    if (!past.ok()) return past.error();
    auto host = replace_stopped(world, [&] {
        return settings_.world_persistence->rewind(world->id(), tick, *std::move(past));
    });
    if (host.ok())
        log_info("world {} \"{}\" was rewound to tick {}", world->id(), world->name(), tick);
    return host;
}

Result<WorldDirectory::Undone> WorldDirectory::undo(const std::shared_ptr<WorldHost>& world,
                                                    ClientId client, double seconds) {
    if (!world->is_persisted()) return not_persisted();
    const std::uint32_t now = world->frame()->tick, oldest = world->oldest_restorable_tick();
    const double ticks = std::ceil(seconds * world->hz());
    std::uint32_t first = ticks < now ? now - static_cast<std::uint32_t>(ticks) + 1 : 1;
    first = std::max(first, oldest + 1);
    WorldPersistence& persistence = *settings_.world_persistence;
    // The world ticks meanwhile.
    Result<std::unique_ptr<PreparedUndo>> prepared =
        built([&] { return persistence.prepare_undo(world->id(), client, first); });
    if (!prepared.ok()) return prepared.error();
    auto host = replace_stopped(world, [&] { return persistence.undo(world->id(), **prepared); });
    if (!host.ok()) return host.error();
    return Undone{*std::move(host), first, (*prepared)->inputs};
}

Result<std::shared_ptr<WorldHost>> WorldDirectory::reset(const std::shared_ptr<WorldHost>& world) {
    const WorldProperties& properties = world->properties();
    // The world ticks meanwhile.
    Result<HostedWorld> fresh = built([&] {
        return HostedWorld::create(*properties.scene, settings_.limits, settings_.physics_threads);
    });
    if (!fresh.ok()) return fresh.error();
    auto host = replace_stopped(world, [&]() -> Result<WorldStart> {
        if (world->is_persisted())
            return settings_.world_persistence->rewind(world->id(), 0, *std::move(fresh));
        fresh->continue_from(world->stopped_world());
        return WorldStart{.label = properties.label,
                          .scene = properties.scene,
                          .world = *std::move(fresh),
                          .tick = world->frame()->tick + 1};
    });
    if (host.ok()) log_info("world {} \"{}\" was reset to its scene", world->id(), world->name());
    return host;
}

Result<std::shared_ptr<WorldHost>> WorldDirectory::rewind_room(
    const std::shared_ptr<WorldHost>& world, std::uint32_t tick) {
    if (world->is_persisted()) return rewind(world, tick);
    auto host = replace_stopped(world, [&]() -> Result<WorldStart> {
        Result<HostedWorld> past = built([&] {
            return world->stopped_timeline()->world_at(tick, settings_.limits,
                                                       settings_.physics_threads,
                                                       world->properties().work_per_second);
        });
        if (!past.ok()) return past.error();
        past->continue_from(world->stopped_world());
        return WorldStart{.label = world->properties().label,
                          .scene = world->properties().scene,
                          .world = *std::move(past),
                          .tick = world->frame()->tick + 1};
    });
    if (host.ok())
        log_info("world {} \"{}\" was rewound to tick {}", world->id(), world->name(), tick);
    return host;
}

void WorldDirectory::reset_requested() {
    for (const auto& world : list()) {
        if (world->lifecycle().stopped()) continue;
        if (const std::uint32_t tick = world->requested_rewind(); tick != 0) {
            if (const auto host = rewind_room(world, tick); !host.ok()) {
                log_error("world {}: cannot be rewound: {}", world->id(), host.error().message);
                world->cancel_rewind();
            }
        }
    }
    for (const auto& world : list())
        if (world->is_reset_requested() && !world->lifecycle().stopped())
            if (const auto host = reset(world); !host.ok())
                log_error("world {}: cannot be reset: {}", world->id(), host.error().message);
}

Result<std::shared_ptr<WorldHost>> WorldDirectory::replace_stopped(
    const std::shared_ptr<WorldHost>& world, const std::function<Result<WorldStart>()>& start) {
    if (!world->stop_for_replacement())
        return Error{ErrorCode::aborted,
                     "the world was stopped or is being rewound by another request"};
    Status replaced;
    Result<Replacement> replacement = built([&]() -> Result<Replacement> {
        Result<WorldStart> started = start();
        if (!started.ok()) return started.error();
        started->paused = world->lifecycle().paused();
        started->speed_percent = world->speed_percent();
        started->timeline = world->stopped_timeline();
        started->reports = world->reports();
        return start_replacement(*std::move(started));
    });
    if (!replacement.ok()) {
        replaced = replacement.error();
        replacement = restart_failed_world(*world);
    }
    if (!replacement.ok()) {
        const std::lock_guard lock(mutex_);
        std::erase_if(worlds_, [&](const auto& entry) { return entry.second == world; });
        log_error(
            "world {} \"{}\" is closed because it cannot be restarted; it remains in the "
            "database: {}",
            world->id(), world->name(), replacement.error().message);
        return replacement.error();
    }
    if (!replace(world, *replacement))
        return Error{ErrorCode::not_found, "the world was deleted meanwhile"};
    if (!replaced.ok()) return replaced.error();
    return replacement->host;
}

bool WorldDirectory::replace(const std::shared_ptr<WorldHost>& stopped,
                             const Replacement& replacement) {
    {
        const std::lock_guard lock(mutex_);
        const auto at = std::ranges::find_if(
            worlds_, [&](const auto& entry) { return entry.second == stopped; });
        if (at == worlds_.end()) {
            replacement.host->skip_final_checkpoint();
            replacement.host->stop();
            return false;
        }
        ASSERT(replacement.host);
        at->second = replacement.host;
    }
    if (on_replaced_) on_replaced_(replacement.host, replacement.clients);
    return true;
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
    world->skip_final_checkpoint();
    world->stop();
    if (settings_.world_persistence) settings_.world_persistence->drop(world->id());
    log_info("world {} \"{}\" was deleted", world->id(), world->name());
    return world;
}

void WorldDirectory::restart_failed(Clock::time_point now) {
    std::vector<std::pair<std::uint32_t, std::shared_ptr<WorldHost>>> failed;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [number, world] : worlds_)
            if (world && world->lifecycle().failed()) failed.emplace_back(number, world);
    }
    for (const auto& [number, world] : failed) restart(number, world, now);
}

void WorldDirectory::restart(std::uint32_t number, const std::shared_ptr<WorldHost>& failed,
                             Clock::time_point now) {
    std::vector<Clock::time_point>& before = restarts_[number];
    std::erase_if(before, [&](Clock::time_point at) { return at + restart_span <= now; });
    failed->stop();
    const Result<Replacement> replacement =
        before.size() < restarts_max
            ? restart_failed_world(*failed)
            : Error{ErrorCode::resource_exhausted,
                    "it failed more than " + std::to_string(restarts_max) + " times in a minute"};
    before.push_back(now);
    ASSERT(before.size() <= restarts_max + 1);
    if (replacement.ok()) {
        if (!replace(failed, *replacement)) return;
        if (settings_.metrics) settings_.metrics->world_restarts.Increment();
        log_warn("world {} \"{}\" was restarted from its {}", failed->id(), failed->name(),
                 failed->is_persisted() ? "last persisted tick" : "scene");
        return;
    }
    const std::lock_guard lock(mutex_);
    const auto at = worlds_.find(number);
    if (at == worlds_.end() || at->second != failed) return;  // deleted meanwhile
    worlds_.erase(at);
    restarts_.erase(number);
    log_error("world {} \"{}\" is closed because it cannot be restarted: {}", failed->id(),
              failed->name(), replacement.error().message);
}

Result<WorldDirectory::Replacement> WorldDirectory::restart_failed_world(
    const WorldHost& failed) const {
    return built([&]() -> Result<Replacement> {
        if (failed.is_persisted()) {
            Result<WorldStart> start = settings_.world_persistence->reload(failed.id());
            if (!start.ok()) return start.error();
            start->paused = failed.lifecycle().paused();
            start->reports = failed.reports();
            return start_replacement(*std::move(start));
        }
        const RoomView room = failed.frame()->room;
        auto host = WorldHost::start(failed.properties().label, failed.properties().scene,
                                     settings_, room ? std::optional(*room) : std::nullopt);
        if (!host.ok()) return host.error();
        return Replacement{*std::move(host), {}};
    });
}

WorldDirectory::Replacement WorldDirectory::start_replacement(WorldStart start) const {
    Replacement replacement;
    for (const auto& [client, sequence] : clients_of(start.world.host_state(start.tick)))
        replacement.clients.push_back(client);
    replacement.host = WorldHost::start(std::move(start), settings_);
    return replacement;
}

void WorldDirectory::stop_all() {
    for (const auto& world : list()) world->stop();
}

}  // namespace jostle::server

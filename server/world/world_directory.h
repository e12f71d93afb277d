// SPDX-License-Identifier: MIT
//
// The worlds of this process: create, find, list, rewind, restart and remove. Any thread.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/world/world_host.h"

namespace jostle::server {

class WorldDirectory {
public:
    // `process`: letters and digits at the end of world ids, which distinguish the worlds of this
    // process from those of other processes behind the same address.
    WorldDirectory(WorldHostSettings settings, int worlds_max, std::string process = {})
        : settings_(std::move(settings)), worlds_max_(worlds_max), process_(std::move(process)) {}
    ~WorldDirectory() { stop_all(); }

    // Creates a world from a scene; an empty name stands for the name of the scene. `owner`: the
    // subject of the creator; empty: the server itself. Errors: the name is taken or has the form
    // of an id, a limit is reached, or the scene cannot be built.
    // `room`: nothing: the world is no room.
    Result<std::shared_ptr<WorldHost>> create(const std::string& name,
                                              const scenes::SceneDescription& scene,
                                              const std::string& owner = {},
                                              std::optional<RoomProperties> room = {});
    // An empty key finds the oldest world. Null: not found.
    std::shared_ptr<WorldHost> find(const std::string& id_or_name) const;
    // Null: worlds end with the process.
    WorldPersistence* persistence() const { return settings_.world_persistence; }
    // Creates a world that starts from the state of another world after `tick`, without clients.
    // Replays the ticks since the previous checkpoint on the calling thread. Errors: those of
    // create() and scene_at().
    Result<std::shared_ptr<WorldHost>> create_from(const std::string& name, const WorldHost& world,
                                                   std::uint32_t tick,
                                                   const std::string& owner = {},
                                                   std::optional<RoomProperties> room = {});
    // Starts a persisted world under its id. Call it before any other function.
    std::shared_ptr<WorldHost> adopt(WorldStart start);
    std::vector<std::shared_ptr<WorldHost>> list() const;  // in order of creation
    // Exports the state of the world after `tick`. Replays the ticks since the previous checkpoint.
    // Errors: the world is not persisted, or the tick is not in its history.
    Result<ExportedScene> scene_at(const WorldHost& world, std::uint32_t tick) const;
    // Replaces the world by its state after `tick`, in a new host with the same id. Tick numbers,
    // entity ids and input sequences continue. Errors: those of scene_at(); the world then
    // continues unchanged.
    Result<std::shared_ptr<WorldHost>> rewind(const std::shared_ptr<WorldHost>& world,
                                              std::uint32_t tick);
    // Replaces the world by one without the inputs of `client` in its last seconds, in a new host
    // like rewind(). The history bounds the time. Errors: those of scene_at(); not_found: the
    // client has no inputs in that time. The world then continues unchanged.
    struct Undone {
        std::shared_ptr<WorldHost> host;
        std::uint32_t first_tick = 0;  // whose inputs were undone
        std::size_t inputs = 0;
    };
    Result<Undone> undo(const std::shared_ptr<WorldHost>& world, ClientId client, double seconds);
    // Replaces the world by a new one of its scene, in a new host like rewind(). A room retains its
    // members and its decisions. The world then continues unchanged if the scene cannot be built.
    Result<std::shared_ptr<WorldHost>> reset(const std::shared_ptr<WorldHost>& world);
    // Replaces a room by an earlier state of its timeline, in a new host like rewind(). not_found:
    // the timeline does not contain the tick.
    Result<std::shared_ptr<WorldHost>> rewind_room(const std::shared_ptr<WorldHost>& world,
                                                   std::uint32_t tick);
    // Resets and rewinds the worlds whose members requested it. Call it periodically from one
    // thread.
    void reset_requested();
    // `callback` is called when a new host replaces a world, with the clients of its saved state.
    // Set it before the first world.
    using OnReplaced = std::function<void(const std::shared_ptr<WorldHost>& world,
                                          const std::vector<ClientId>& clients)>;
    void on_replaced(OnReplaced callback) { on_replaced_ = std::move(callback); }
    // The threads of the ticks of all worlds; null: each world has one of its own.
    TickPool* tick_pool() const { return settings_.tick_pool.get(); }
    // Stops and forgets the world; its sessions end. Null: not found.
    std::shared_ptr<WorldHost> remove(const std::string& id_or_name);
    void stop_all();
    // Replaces each world that an error ended by a new one with the same scene, id and name.
    // Removes a world that fails a fourth time within a minute. Call it periodically from one
    // thread.
    void restart_failed(Clock::time_point now);

private:
    std::shared_ptr<WorldHost> find_locked(const std::string& id_or_name) const;

    struct Replacement {
        std::shared_ptr<WorldHost> host;
        std::vector<ClientId> clients;
    };

    // `start` makes a host for a label; it is called without the lock.
    template <class Start>
    Result<std::shared_ptr<WorldHost>> create_with(const std::string& name,
                                                   const std::string& owner, std::size_t bodies,
                                                   Start start);
    Result<Replacement> restart_failed_world(const WorldHost& failed) const;
    Replacement start_replacement(WorldStart start) const;
    // Stops the world and continues it in a new host from what `start` returns. If it fails, the
    // world continues unchanged.
    Result<std::shared_ptr<WorldHost>> replace_stopped(
        const std::shared_ptr<WorldHost>& world, const std::function<Result<WorldStart>()>& start);
    Result<HostedWorld> world_at(const WorldHost& world, std::uint32_t tick) const;
    // False: the stopped world was deleted meanwhile.
    bool replace(const std::shared_ptr<WorldHost>& stopped, const Replacement& replacement);
    // Checks the limits of all worlds plus `bodies` and `work`. Under the lock.
    Status check_totals(std::size_t bodies, double work) const;
    void restart(std::uint32_t number, const std::shared_ptr<WorldHost>& failed,
                 Clock::time_point now);

    const WorldHostSettings settings_;
    const int worlds_max_;
    const std::string process_;
    OnReplaced on_replaced_;
    mutable std::mutex mutex_;
    std::map<std::uint32_t, std::shared_ptr<WorldHost>> worlds_;  // by number, "w1" is 1
    std::uint32_t next_ = 1;
    std::map<std::uint32_t, std::vector<Clock::time_point>> restarts_;  // by number; times
};

}  // namespace jostle::server

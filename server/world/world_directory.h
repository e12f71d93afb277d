// SPDX-License-Identifier: MIT
//
// The worlds of this process: create, find, list, retire. Any thread.
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
    // `process`: a word of letters and digits that tells this process's worlds from those of others
    // behind the same address; it is the end of their ids.
    WorldDirectory(WorldHostSettings settings, int worlds_max, std::string process = {})
        : settings_(std::move(settings)), worlds_max_(worlds_max), process_(std::move(process)) {}
    ~WorldDirectory() { stop_all(); }

    // A world of that scene; an empty name takes the scene's. Errors: the name is taken or
    // looks like an id, the directory is full, the scene cannot be built.
    // `owner`: the subject of whoever creates it; empty: the server itself.
    Result<std::shared_ptr<WorldHost>> create(const std::string& name,
                                              const scenes::SceneDescription& scene,
                                              const std::string& owner = {});
    // By id or name; empty: the first. Null when there is none.
    std::shared_ptr<WorldHost> find(const std::string& id_or_name) const;
    // One that begins as that world was after that tick, with nobody in it. Takes as long as all
    // that was done since the checkpoint before it. Errors: as of create() and world_at().
    Result<std::shared_ptr<WorldHost>> create_from(const std::string& name, const WorldHost& world,
                                                   std::uint32_t tick,
                                                   const std::string& owner = {});
    // Before any other: a world that goes on.
    std::shared_ptr<WorldHost> adopt(WorldStart start);
    std::vector<std::shared_ptr<WorldHost>> list() const;  // in order of creation
    // The world as it was after that tick. Takes as long as all that was done since the checkpoint
    // before it. Errors: worlds are not kept here, or that tick is not.
    Result<ExportedScene> scene_at(const WorldHost& world, std::uint32_t tick) const;
    // The world becomes what it was after that tick: another host, under the same id, goes on with
    // it. Ticks, ids of entities and inputs are counted on. Errors: as of scene_at(), and then the
    // world goes on as it is.
    Result<std::shared_ptr<WorldHost>> rewind(const std::shared_ptr<WorldHost>& world,
                                              std::uint32_t tick);
    // Called when another host goes on with a world, and who played when that was kept. Set before
    // any world is there.
    using OnReplaced = std::function<void(const std::shared_ptr<WorldHost>& world,
                                          const std::vector<ClientId>& clients)>;
    void on_replaced(OnReplaced told) { on_replaced_ = std::move(told); }
    // Stops the world; its clients notice. Null when there is none.
    std::shared_ptr<WorldHost> remove(const std::string& id_or_name);
    void stop_all();
    // In the place of worlds that an error ended come new ones of the same scene, id and name. One
    // that ends three times in a minute is given up. To be called now and then, from one thread.
    void restart_failed(Clock::time_point now);

private:
    std::shared_ptr<WorldHost> find_locked(const std::string& id_or_name) const;

    struct Replacement {
        std::shared_ptr<WorldHost> host;
        std::vector<ClientId> clients;
    };

    // `start` makes a host for that label, without the lock.
    template <class Start>
    Result<std::shared_ptr<WorldHost>> create_with(const std::string& name,
                                                   const std::string& owner, std::size_t bodies,
                                                   Start start);
    Result<Replacement> restart_failed_world(const WorldHost& failed) const;
    Replacement start_replacement(WorldStart start) const;
    Result<HostedWorld> world_at(const WorldHost& world, std::uint32_t tick) const;
    // In the place of one that was stopped. False: that was deleted meanwhile.
    bool replace(const std::shared_ptr<WorldHost>& stopped, const Replacement& again);
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
    std::map<std::uint32_t, std::vector<Clock::time_point>> restarts_;  // by number, the newest
};

}  // namespace jostle::server

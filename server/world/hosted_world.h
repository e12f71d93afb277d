// SPDX-License-Identifier: MIT
//
// A hosted world: inputs go in, each at most once, and what clients may see comes out, as frames,
// events and copies to ask. Owned by one thread (host/world_host).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"
#include "server/world/apply_action.h"
#include "server/world/command.h"
#include "server/world/export_scene.h"
#include "server/world/frame.h"
#include "server/world/frame_ring.h"
#include "server/world/journaled_command.h"
#include "server/world/module_channels.h"
#include "server/world/query_frame.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class HostedWorld {
public:
    // resource_exhausted: the scene costs more than the limits allow.
    static Result<HostedWorld> create(const scenes::SceneDescription& scene,
                                      const HostLimits& limits, int threads);

    // One that goes on as the kept one would have: `world` is its world, to the bit. corrupt_data:
    // the two do not belong together.
    static Result<HostedWorld> restore(physics::World world, const SavedHostState& host_state,
                                       const HostLimits& limits, double hz, double work_per_second);
    // All but the bodies; `tick` is the last one that was stepped.
    SavedHostState host_state(std::uint32_t tick) const;

    // Takes the place of a later one: ids that were given and inputs that were counted stay so.
    void continue_from(const HostedWorld& later);
    // All clients are gone, and their bodies stay.
    void release_all_clients();
    // Before its first tick in this process.
    void set_limits(const HostLimits& limits);

    // Applies an input at most once: a sequence that is not above the client's last one is refused.
    InputResult apply(const Command& command, std::uint32_t tick);
    // From now on what is applied is kept for take_journal().
    void enable_journal() { journal_enabled_ = true; }
    // What was applied since it was last asked.
    std::vector<JournaledCommand> take_journal() { return std::exchange(journal_, {}); }
    // As apply() did, of a world that is as it was then.
    void replay(const JournaledCommand& command);
    // Pulls what is held, then steps, and asks modules what they tell of that tick, from 1.
    // `aborted`: it took too long and was told to end.
    Status step(double dt, std::uint32_t tick = 1);
    // Whether its frames say how bodies move (module_channels.h).
    void publish_motion(bool wanted) { channels_.publish_motion(wanted); }
    // Whether they say what is driven.
    void publish_controlled_entities(bool wanted) { publishes_controlled_entities_ = wanted; }
    // Any thread: physics::World::stop_stepping().
    void stop_stepping() { state_.world.stop_stepping(); }
    void resume_stepping() { state_.world.resume_stepping(); }
    // Fills what a world knows of a frame; the host adds times. `frame.tick` is set.
    void copy_into(Frame& frame);
    // What happened in the last step; nothing when nothing did. Before the next command.
    std::optional<TickEvents> events_of_step(std::uint32_t tick) const;
    // Those whose state stopped being a number in the last step and that were not told before.
    std::vector<std::shared_ptr<const EntityDescription>> newly_quarantined();
    // What modules tell, for as long as the world is there.
    const std::vector<physics::ChannelKind>& channel_kinds() const { return channels_.kinds(); }
    // Kinds whose channels of the last step were too large for clients, each told once.
    const std::vector<ModuleChannels::OversizedChannel>& newly_oversized() const {
        return channels_.newly_oversized();
    }
    QueryFramePtr query_frame(std::uint32_t tick, CopyLayers layers);
    // As it is now; `origin` is the scene that it was created of.
    ExportedScene exported(const scenes::SceneDescription& origin) {
        return export_scene(state_, origin, ids_);
    }

    const physics::World& world() const { return state_.world; }
    std::size_t entities() const { return state_.entities.size(); }
    // Where its frames go, for what clients saw. Any thread.
    FrameRing& frame_history() const { return *frame_history_; }
    // As estimated when it was created (scene_budget.h).
    double work_per_second() const { return work_per_second_; }

private:
    HostedWorld(HostedState state, double hz)
        : state_(std::move(state)),
          hz_(hz),
          frame_history_(std::make_shared<FrameRing>(state_.limits.lag_compensation_ms_max, hz)) {}
    Status act(const Command& command, InputResult& result);

    Status accept_sequence(ClientId client, std::uint32_t sequence);

    HostedState state_;
    double hz_;
    std::shared_ptr<FrameRing> frame_history_;  // never null
    SceneIds ids_;
    double work_per_second_ = 0;
    ModuleChannels channels_;
    bool publishes_controlled_entities_ = false;
    std::map<ClientId, std::uint32_t> last_sequences_;  // of the inputs of each client
    std::set<EntityId> quarantined_;                    // told
    bool journal_enabled_ = false;
    std::vector<JournaledCommand> journal_;
    void copy_poses(bool all);

    std::vector<physics::BodyState> bodies_;  // reused from tick to tick
    // As of the last frame.
    PoseEditor poses_;
    std::vector<std::size_t> index_of_body_;  // in the entity list, by index of the body
    std::vector<physics::BodyId> awake_;
    std::uint64_t static_revision_ = 0;
    std::shared_ptr<const EntityList> entity_list_;
    std::shared_ptr<const Channels> published_channels_;
    std::uint32_t changed_at_ = 0;
};

}  // namespace jostle::server

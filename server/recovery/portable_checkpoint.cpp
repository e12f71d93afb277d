// SPDX-License-Identifier: MIT
#include "server/recovery/portable_checkpoint.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/scene_file.h"
#include "server/storage/compression.h"
#include "server/util/bytes.h"

namespace jostle::server {
namespace {

// Raise it only if a reader must not ignore the fields that a version appends.
constexpr std::uint64_t portable_version = 1;
constexpr std::size_t portable_bytes_max = std::size_t{1} << 30;  // decompressed

Error not_portable(const std::string& why) {
    return {ErrorCode::corrupt_data, "corrupt portable checkpoint: " + why};
}

struct Content {
    std::string owner, scene;
    std::uint32_t module_format = 0;  // of the module states in the scene
    double work_per_second = 0;
    EntityId next_id = 1;
    std::vector<EntityId> entities;  // one for each body of the scene
    std::vector<ClientId> owners;    // likewise
    std::vector<SavedHostState::Owned> owned;
    std::vector<SavedHostState::Owned> controlled;
    std::vector<SavedHostState::ProcessedInput> processed;
    std::vector<EntityId> quarantined;
    std::vector<std::string> omitted;
    std::string
        data;  // a host state with players, attributes, messages and the room only; or empty
};

struct Writer {
    ByteWriter to;

    void operator()(std::uint32_t value) { to.number(value); }
    void operator()(double value) { to.real(value); }
    void operator()(const std::string& value) { to.text(value); }
    template <class Item, class Each>
    void list(const std::vector<Item>& items, Each&& each) {
        to.number(items.size());
        for (const Item& item : items) each(item);
    }
};
struct Reader {
    ByteReader from;

    void operator()(std::uint32_t& value) { value = from.small(); }
    void operator()(double& value) { value = from.real(); }
    void operator()(std::string& value) { value = from.text(); }
    template <class Item, class Each>
    void list(std::vector<Item>& items, Each&& each) {
        items.resize(from.count());
        for (Item& item : items) each(item);
    }
};

// Lists the fields once, for both. Append new fields at the end.
template <class Visitor, class AnyContent>
void visit(Visitor& v, AnyContent& content) {
    const auto value = [&](auto& item) { v(item); };
    v(content.owner);
    v(content.scene);
    v(content.module_format);
    v(content.work_per_second);
    v(content.next_id);
    v.list(content.entities, value);
    v.list(content.owners, value);
    v.list(content.owned, [&](auto& o) { v(o.client), v(o.entity); });
    v.list(content.controlled, [&](auto& c) { v(c.client), v(c.entity); });
    v.list(content.processed, [&](auto& p) { v(p.client), v(p.sequence); });
    v.list(content.quarantined, value);
    v.list(content.omitted, value);
    if constexpr (std::is_same_v<Visitor, Reader>)
        if (v.from.at_end()) return;  // of an earlier version
    v(content.data);
}

Result<Content> read(std::string_view bytes) {
    const Result<std::string> decompressed = decompress(bytes, portable_bytes_max);
    if (!decompressed.ok()) return decompressed.error();
    Reader reader{ByteReader(*decompressed)};
    if (const std::uint64_t version = reader.from.number();
        reader.from.ok() && version != portable_version)
        return Error{ErrorCode::failed_precondition,
                     "unsupported portable checkpoint: version " + std::to_string(version) +
                         "; this server reads version " + std::to_string(portable_version)};
    Content content;
    visit(reader, content);
    if (!reader.from.ok()) return not_portable("unexpected end of data");
    if (!(content.work_per_second >= 0 && std::isfinite(content.work_per_second)))
        return not_portable("a value is out of range");
    return content;
}

// The host state of a world that was built from the scene.
Result<SavedHostState> host_state_of(const Content& content, std::uint32_t tick,
                                     const scenes::SceneDescription& scene,
                                     scenes::BuiltScene& built) {
    const std::size_t bodies = built.bodies.size();
    if (content.entities.size() != bodies || content.owners.size() != bodies)
        return not_portable("the scene has " + std::to_string(bodies) + " bodies, but there are " +
                            std::to_string(content.entities.size()) + " entities and " +
                            std::to_string(content.owners.size()) + " owners");
    // Reuses the description of masses and bounds that a new world computes.
    EntityRegistry described;
    std::map<EntityId, SavedHostState::Entity> entities;
    for (std::size_t i = 0; i < bodies; i++) {
        const EntityId id = content.entities[i];
        const Entity& entity =
            *described.find(described.add(built.world, built.bodies[i], content.owners[i],
                                          scene.bodies[i].color, scene.bodies[i].name));
        if (id == 0 || id >= content.next_id || entities.contains(id))
            return not_portable("entity id " + std::to_string(id) + " of bodies[" +
                                std::to_string(i) + "] is 0, repeated, or not below " +
                                std::to_string(content.next_id));
        entities[id] = {.id = id,
                        .body = built.bodies[i],
                        .owner = content.owners[i],
                        .color = scene.bodies[i].color,
                        .name = scene.bodies[i].name,
                        .mass = entity.description->mass,
                        .bounding_radius = entity.description->bounding_radius};
    }
    SavedHostState host_state{.tick = tick,
                              .next_id = content.next_id,
                              .processed = content.processed,
                              .scene_bodies = built.bodies,
                              .scene_joints = built.joints};
    for (const auto& [id, entity] : entities) host_state.entities.push_back(entity);
    for (const SavedHostState::Owned& owned : content.owned) {
        if (!entities.contains(owned.entity))
            return not_portable("client " + std::to_string(owned.client) + " owns entity " +
                                std::to_string(owned.entity) + ", which does not exist");
        host_state.owned.push_back(owned);
    }
    for (const SavedHostState::Owned& controlled : content.controlled) {
        const auto at = entities.find(controlled.entity);
        if (at == entities.end())
            return not_portable("client " + std::to_string(controlled.client) +
                                " controls entity " + std::to_string(controlled.entity) +
                                ", which does not exist");
        host_state.controlled_entities.push_back({controlled.client, at->second.body});
    }
    for (const EntityId id : content.quarantined)
        if (entities.contains(id)) host_state.quarantined.push_back(id);
    if (content.data.empty()) return host_state;
    Result<SavedHostState> data = decode_host_state(content.data);
    if (!data.ok()) return data.error();
    host_state.players = std::move(data->players);
    host_state.attributes = std::move(data->attributes);
    host_state.messages = data->messages;
    host_state.room = std::move(data->room);
    // Owners of joints and undo logs end here, because they name joints and hold saved bodies.
    host_state.revisions = data->revisions;
    for (const SavedHostState::Updated& updated : data->updated_entities)
        if (entities.contains(updated.entity)) host_state.updated_entities.push_back(updated);
    return host_state;
}

void reset_modules(scenes::SceneDescription& scene, std::vector<std::string>& omitted) {
    std::size_t reset = 0;
    for (scenes::SceneModule& module : scene.modules) {
        reset += module.state.empty() ? 0 : 1;
        module.state.clear();
    }
    if (reset > 0)
        omitted.push_back(std::to_string(reset) +
                          " module states: this version has another format, so the modules start "
                          "from their initial state");
}

// Modules create their bodies again with other ids, so the attributes of those are omitted.
std::string portable_data(const SavedHostState& host_state, const std::set<EntityId>& included,
                          std::vector<std::string>& omitted) {
    SavedHostState data{
        .players = host_state.players, .messages = host_state.messages, .room = host_state.room};
    data.revisions = host_state.revisions;
    for (const SavedHostState::Updated& updated : host_state.updated_entities)
        if (included.contains(updated.entity)) data.updated_entities.push_back(updated);
    std::size_t lost = 0;
    for (const SavedHostState::SavedAttribute& saved : host_state.attributes) {
        if (saved.target.kind == AttributeTargetKind::entity && !included.contains(saved.target.id))
            lost++;
        else
            data.attributes.push_back(saved);
    }
    if (lost > 0)
        omitted.push_back(std::to_string(lost) +
                          " attributes of module bodies: their modules create them again");
    const bool is_empty = data.players.empty() && data.attributes.empty() && data.messages == 0 &&
                          !data.room && !data.has_edits();
    return is_empty ? std::string() : encode_host_state(data);
}

}  // namespace

PortableForm encode_portable(HostedWorld& world, std::uint32_t tick,
                             const WorldDefinition& definition) {
    ExportedScene exported = world.exported(*definition.scene);
    const SavedHostState host_state = world.host_state(tick);
    std::map<physics::BodyId, const SavedHostState::Entity*> by_body;
    for (const SavedHostState::Entity& entity : host_state.entities) by_body[entity.body] = &entity;
    Content content{.owner = definition.owner,
                    .scene = scenes::write_scene_json(exported.scene),
                    .module_format = physics::saved_format_version(),
                    .work_per_second = world.work_per_second(),
                    .next_id = host_state.next_id,
                    .entities = {},
                    .owners = {},
                    .owned = {},
                    .controlled = {},
                    .processed = host_state.processed,
                    .quarantined = host_state.quarantined,
                    .omitted = std::move(exported.omitted)};
    std::set<EntityId> included;
    for (const physics::BodyId body : exported.bodies) {
        const SavedHostState::Entity& entity = *by_body.at(body);
        included.insert(entity.id);
        content.entities.push_back(entity.id);
        content.owners.push_back(entity.owner);
    }
    std::ranges::copy_if(host_state.owned, std::back_inserter(content.owned),
                         [&](const auto& owned) { return included.contains(owned.entity); });
    std::size_t released = 0;
    for (const SavedHostState::Controlled& controlled : host_state.controlled_entities) {
        const auto at = by_body.find(controlled.body);
        if (at != by_body.end() && included.contains(at->second->id))
            content.controlled.push_back({controlled.client, at->second->id});
        else
            released++;
    }
    if (released > 0)
        content.omitted.push_back(std::to_string(released) +
                                  " controlled entities: their modules create them again");
    content.data = portable_data(host_state, included, content.omitted);
    Writer writer;
    writer.to.number(portable_version);
    visit(writer, std::as_const(content));
    const std::string bytes = writer.to.take();
    return {compress(bytes), std::move(content.omitted)};
}

Result<PortableWorld> decode_portable(std::string_view bytes, std::uint32_t tick,
                                      const HostLimits& limits, int threads) {
    Result<Content> content = read(bytes);
    if (!content.ok()) return content.error();
    Result<scenes::SceneDescription> scene = scenes::read_scene_json(content->scene);
    if (!scene.ok()) return not_portable("invalid scene: " + scene.error().message);
    if (content->module_format != physics::saved_format_version())
        reset_modules(*scene, content->omitted);
    Result<scenes::BuiltScene> built = scenes::build_scene(*scene);
    if (!built.ok()) return not_portable("invalid scene: " + built.error().message);
    if (Status s = built->world.set_threads(threads); !s.ok()) return s.error();
    const Result<SavedHostState> host_state = host_state_of(*content, tick, *scene, *built);
    if (!host_state.ok()) return host_state.error();
    const double hz = scene->hz;
    Result<HostedWorld> world = HostedWorld::restore(std::move(built->world), *host_state, limits,
                                                     hz, content->work_per_second);
    if (!world.ok()) return world.error();
    return PortableWorld{
        .world = *std::move(world),
        .definition = {.owner = std::move(content->owner),
                       .scene = std::make_shared<const scenes::SceneDescription>(*std::move(scene)),
                       .limits = limits,
                       .work_per_second = content->work_per_second},
        .omitted = std::move(content->omitted)};
}

}  // namespace jostle::server

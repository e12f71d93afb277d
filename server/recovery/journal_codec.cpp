// SPDX-License-Identifier: MIT
#include "server/recovery/journal_codec.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "jostle/scenes/joint_definition.h"
#include "jostle/scenes/shape_message.h"
#include "server/util/bytes.h"
#include "server/world/attribute_bytes.h"
#include "server/world/room_codec.h"

namespace jostle::server {
namespace {

using physics::Vec3;

// See docs/design/format_changes.md. Version 2 has no rewinds, version 3 no undos, version 4 no
// targets on ropes and cloths, version 5 no players, attributes and messages, version 6 no room
// commands, version 7 no edits, clones, joints and undos of clients. Segments are written in the
// oldest version that can hold them, which older servers read.
constexpr std::uint64_t version_of_rewinds = 3, version_of_undos = 4, version_of_deformables = 5,
                        version_of_players = 6, version_of_rooms = 7, version_of_edits = 8;
constexpr std::uint64_t journal_version = version_of_edits, oldest_version = 2;
constexpr std::uint64_t no_action = 255;  // in place of an action kind
// Elements of a list in a command; inputs have fewer.
constexpr std::size_t list_max = 4096;

// visit_action() lists the fields of each kind of action once; a JournalWriter writes them, a
// JournalReader reads them.
struct JournalWriter {
    ByteWriter to;
    std::uint64_t version = journal_version;

    void operator()(std::uint32_t value) { to.number(value); }
    void operator()(bool value) { to.number(value ? 1 : 0); }
    void operator()(double value) { to.real(value); }
    void operator()(const std::string& value) { to.text(value); }
    template <class Value>
    void operator()(const std::optional<Value>& value) {
        (*this)(value.has_value());
        if (value) (*this)(*value);
    }
    void operator()(const DeformableTarget& target) {
        (*this)(target.module), (*this)(target.object), (*this)(target.element);
    }
    void operator()(const Vec3& v) {
        for (int k = 0; k < 3; k++) to.real(v[k]);
    }
    void operator()(const physics::Quat& q) {
        for (const double value : {q.x, q.y, q.z, q.w}) to.real(value);
    }
    void room(const RoomCommand& command) { to.text(encode_room_command(command)); }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void operator()(Enum value) { to.number(static_cast<std::uint32_t>(value)); }
    void operator()(const AttributeValue& value) { write_attribute_value(to, value); }
    template <class Item, class Each>
    void list(const std::vector<Item>& items, Each&& each) {
        to.number(items.size());
        for (const Item& item : items) each(item);
    }
    void joint(const CreateJointCommand& c) { to.text(scenes::joint_bytes({c.joint, c.frame})); }
    void shape(const SpawnCommand& spawn) {
        to.text(spawn.shape_bytes.empty() ? scenes::shape_bytes(spawn.shape) : spawn.shape_bytes);
    }
};
struct JournalReader {
    ByteReader from;
    Status status;
    std::uint64_t version = journal_version;

    void operator()(std::uint32_t& value) { value = from.small(); }
    void operator()(bool& value) { value = from.number() != 0; }
    void operator()(double& value) { value = from.real(); }
    void operator()(std::string& value) { value = from.text(); }
    template <class Value>
    void operator()(std::optional<Value>& value) {
        bool present = false;
        (*this)(present);
        if (present) (*this)(value.emplace());
    }
    void operator()(DeformableTarget& target) {
        (*this)(target.module), (*this)(target.object), (*this)(target.element);
    }
    void operator()(Vec3& v) { v.x = from.real(), v.y = from.real(), v.z = from.real(); }
    void operator()(physics::Quat& q) {
        q.x = from.real(), q.y = from.real(), q.z = from.real(), q.w = from.real();
    }
    // The last enumerator of each enumeration bounds it.
    template <class Enum>
    requires std::is_enum_v<Enum>
    void operator()(Enum& value) {
        const std::uint32_t number = from.small();
        if (number > static_cast<std::uint32_t>(last_of(value))) from.fail();
        if (std::is_same_v<Enum, AttributeVisibility> && number == 0) from.fail();
        value = static_cast<Enum>(number);
    }
    static constexpr PlayerRole last_of(PlayerRole) { return PlayerRole::owner; }
    static constexpr AttributeTargetKind last_of(AttributeTargetKind) {
        return AttributeTargetKind::entity;
    }
    static constexpr AttributeVisibility last_of(AttributeVisibility) {
        return AttributeVisibility::roles;
    }
    void operator()(AttributeValue& value) { value = read_attribute_value(from); }
    template <class Item, class Each>
    void list(std::vector<Item>& items, Each&& each) {
        items.resize(std::min(from.count(), list_max));
        for (Item& item : items) each(item);
    }
    void room(RoomCommand& command) {
        const std::string_view bytes = from.text();
        if (!from.ok() || !status.ok()) return;
        Result<RoomCommand> decoded = decode_room_command(bytes);
        if (decoded.ok())
            command = *std::move(decoded);
        else
            status = decoded.error();
    }
    void joint(CreateJointCommand& c) {
        const std::string_view bytes = from.text();
        if (!from.ok() || !status.ok()) return;
        Result<scenes::JointDefinition> joint = scenes::joint_from_bytes(bytes, "joint");
        if (joint.ok()) {
            c.joint = std::move(joint->joint);
            c.frame = joint->frame;
        } else {
            status = joint.error();
        }
    }
    void shape(SpawnCommand& spawn) {
        spawn.shape_bytes = from.text();
        if (!from.ok() || !status.ok()) return;
        Result<physics::ShapeDef> shape = scenes::shape_from_bytes(spawn.shape_bytes, "shape");
        if (shape.ok())
            spawn.shape = *std::move(shape);
        else
            status = shape.error();
    }
};

template <class Visitor, class Command>
void visit_action(Visitor& v, Command& c) {
    using Kind = std::remove_const_t<Command>;
    if constexpr (std::is_same_v<Kind, SpawnCommand>) {
        v.shape(c);
        v(c.pose.position), v(c.pose.rotation);
        v(c.linear_velocity), v(c.angular_velocity);
        v(c.color);
    } else if constexpr (std::is_same_v<Kind, ImpulseCommand>) {
        v(c.entity), v(c.impulse), v(c.point);
        if (v.version >= version_of_deformables) v(c.deformable);
    } else if constexpr (std::is_same_v<Kind, GrabCommand>) {
        v(c.entity), v(c.point);
        if (v.version >= version_of_deformables) v(c.deformable);
    } else if constexpr (std::is_same_v<Kind, CutCommand>) {
        v(c.point), v(c.deformable);
    } else if constexpr (std::is_same_v<Kind, DragCommand>) {
        v(c.target);
    } else if constexpr (std::is_same_v<Kind, DeleteCommand> ||
                         std::is_same_v<Kind, PossessCommand>) {
        v(c.entity);
    } else if constexpr (std::is_same_v<Kind, ExplodeCommand>) {
        v(c.center), v(c.radius), v(c.speed);
    } else if constexpr (std::is_same_v<Kind, ControlCommand>) {
        for (auto& axis : c.controls.axes) v(axis);
        v(c.controls.buttons);
    } else if constexpr (std::is_same_v<Kind, RoomCommand>) {
        v.room(c);
    } else if constexpr (std::is_same_v<Kind, LeaveCommand>) {
        v(c.retain_bodies);
    } else if constexpr (std::is_same_v<Kind, JoinCommand>) {
        v(c.name), v(c.role), v(c.color), v(c.tick);
    } else if constexpr (std::is_same_v<Kind, RenameCommand>) {
        v(c.name);
    } else if constexpr (std::is_same_v<Kind, SetRoleCommand>) {
        v(c.player), v(c.role);
    } else if constexpr (std::is_same_v<Kind, SetAttributesCommand>) {
        v(c.target.kind), v(c.target.id);
        v.list(c.changes, [&](auto& change) {
            v(change.key), v(change.value), v(change.visibility), v(change.roles);
        });
    } else if constexpr (std::is_same_v<Kind, SendMessageCommand>) {
        v(c.topic), v(c.data), v(c.to_server);
        v.list(c.to, [&](auto& client) { v(client); });
    } else if constexpr (std::is_same_v<Kind, EditCommand>) {
        v(c.entity), v(c.position), v(c.rotation), v(c.linear_velocity), v(c.angular_velocity);
        v(c.mass), v(c.density), v(c.friction), v(c.restitution), v(c.color), v(c.frozen);
        v(c.gravity_scale);
    } else if constexpr (std::is_same_v<Kind, CloneCommand>) {
        v(c.entity), v(c.offset), v(c.jointed);
    } else if constexpr (std::is_same_v<Kind, CreateJointCommand>) {
        v(c.entity_a), v(c.entity_b), v.joint(c);
    } else if constexpr (std::is_same_v<Kind, DeleteJointCommand>) {
        v(c.target.index), v(c.target.generation);
    } else {
        static_assert(std::is_same_v<Kind, ReleaseCommand> || std::is_same_v<Kind, UndoCommand> ||
                      std::is_same_v<Kind, DisconnectCommand>);
    }
}

// The number of a kind is its index in Action: append new kinds at the end.
template <std::size_t kind = 0>
bool make_action(std::uint64_t index, Action& action) {
    if constexpr (kind < std::variant_size_v<Action>) {
        if (index != kind) return make_action<kind + 1>(index, action);
        action.emplace<kind>();
        return true;
    } else {
        return false;
    }
}

bool is_edit(const JournaledCommand& command) {
    return command.action && command.action->index() >= Action(EditCommand{}).index();
}

bool is_about_players(const JournaledCommand& command) {
    return command.action && command.action->index() >= Action(JoinCommand{}).index();
}

bool is_at_deformable(const JournaledCommand& command) {
    if (!command.action) return false;
    const Action& action = *command.action;
    if (const auto* impulse = std::get_if<ImpulseCommand>(&action))
        return impulse->deformable.has_value();
    if (const auto* grab = std::get_if<GrabCommand>(&action)) return grab->deformable.has_value();
    return std::holds_alternative<CutCommand>(action);
}

bool is_about_room(const JournaledCommand& command) {
    return command.action && std::holds_alternative<RoomCommand>(*command.action);
}

std::uint64_t version_of(const JournalSegment& segment) {
    std::uint64_t version = segment.undo ? version_of_undos : version_of_rewinds;
    const auto needs = [&](std::uint64_t at_least) { version = std::max(version, at_least); };
    for (const JournaledTick& tick : segment.ticks) {
        if (std::ranges::any_of(tick.commands, is_at_deformable)) needs(version_of_deformables);
        if (std::ranges::any_of(tick.commands, is_about_players)) needs(version_of_players);
        if (std::ranges::any_of(tick.commands, is_about_room)) needs(version_of_rooms);
        if (std::ranges::any_of(tick.commands, is_edit)) needs(version_of_edits);
    }
    return version;
}

Error not_a_journal(const std::string& why) {
    return {ErrorCode::corrupt_data, "corrupt journal record: " + why};
}

Status read_command(JournalReader& reader, JournaledCommand& command) {
    command.client = reader.from.small();
    command.sequence = reader.from.small();
    const std::uint64_t kind = reader.from.number();
    if (reader.from.ok() && kind != no_action) {
        if (!make_action(kind, command.action.emplace()))
            return not_a_journal("unknown command kind " + std::to_string(kind));
        std::visit([&](auto& action) { visit_action(reader, action); }, *command.action);
    }
    if (!reader.status.ok()) return not_a_journal(reader.status.error().message);
    if (!reader.from.ok()) return not_a_journal("unexpected end of data");
    return {};
}

void write_ticks(JournalWriter& writer, const std::vector<JournaledTick>& ticks) {
    writer.to.number(ticks.size());
    for (const JournaledTick& tick : ticks) {
        writer.to.number(tick.tick);
        writer.to.number(tick.commands.size());
        for (const JournaledCommand& command : tick.commands) {
            writer.to.number(command.client);
            writer.to.number(command.sequence);
            writer.to.number(command.action ? command.action->index() : no_action);
            if (command.action)
                std::visit([&](const auto& action) { visit_action(writer, action); },
                           *command.action);
        }
    }
}

Status read_ticks(JournalReader& reader, std::vector<JournaledTick>& ticks) {
    for (std::size_t left = reader.from.count(); left > 0; left--) {
        JournaledTick& tick = ticks.emplace_back();
        tick.tick = reader.from.small();
        const std::uint32_t last = ticks.size() > 1 ? ticks[ticks.size() - 2].tick : 0;
        if (reader.from.ok() && tick.tick <= last)
            return not_a_journal("tick " + std::to_string(tick.tick) + " is out of order");
        for (std::size_t more = reader.from.count(); more > 0; more--)
            if (Status s = read_command(reader, tick.commands.emplace_back()); !s.ok()) return s;
    }
    return {};
}

Status read_paused_ticks(JournalReader& reader, std::vector<TickRange>& paused_ticks) {
    std::uint32_t previous = 0;
    for (std::size_t left = reader.from.count(); left > 0; left--) {
        const std::uint32_t first = reader.from.small(), last = reader.from.small();
        if (!reader.from.ok()) return not_a_journal("unexpected end of data");
        if (first <= previous || last < first)
            return not_a_journal("ticks " + std::to_string(first) + " to " + std::to_string(last) +
                                 " are out of order");
        paused_ticks.push_back({first, previous = last});
    }
    return {};
}

Status read_rewind(JournalReader& reader, JournalSegment& segment) {
    bool present = false;
    reader(present);
    if (!present) return {};
    Rewind& rewind = segment.rewind.emplace();
    reader(rewind.tick), reader(rewind.to);
    if (!reader.from.ok()) return not_a_journal("unexpected end of data");
    if (rewind.to >= rewind.tick)
        return not_a_journal("invalid rewind from tick " + std::to_string(rewind.tick) +
                             " to tick " + std::to_string(rewind.to));
    if (!segment.ticks.empty() || !segment.paused_ticks.empty())
        return not_a_journal("rewind mixed with other ticks");
    return {};
}

Status read_undo(JournalReader& reader, JournalSegment& segment) {
    Undo& undo = segment.undo.emplace();
    reader(undo.tick), reader(undo.first_tick), reader(undo.client);
    if (!reader.from.ok()) return not_a_journal("unexpected end of data");
    if (undo.first_tick >= undo.tick)
        return not_a_journal("invalid undo in tick " + std::to_string(undo.tick) + " from tick " +
                             std::to_string(undo.first_tick));
    if (!segment.ticks.empty() || !segment.paused_ticks.empty() || segment.rewind)
        return not_a_journal("undo mixed with other ticks");
    return {};
}

}  // namespace

std::string encode_journal(const JournalSegment& segment) {
    JournalWriter writer;
    writer.version = version_of(segment);
    writer.to.number(writer.version);
    write_ticks(writer, segment.ticks);
    writer.to.number(segment.paused_ticks.size());
    for (const TickRange& range : segment.paused_ticks)
        writer.to.number(range.first), writer.to.number(range.last);
    writer(segment.rewind.has_value());
    if (segment.rewind) writer(segment.rewind->tick), writer(segment.rewind->to);
    if (writer.version >= version_of_deformables) writer(segment.undo.has_value());
    if (segment.undo)
        writer(segment.undo->tick), writer(segment.undo->first_tick), writer(segment.undo->client);
    return writer.to.take();
}

Result<JournalSegment> decode_journal(std::string_view bytes) {
    JournalReader reader{ByteReader(bytes), {}};
    const std::uint64_t version = reader.version = reader.from.number();
    if (version < oldest_version || version > journal_version)
        return not_a_journal("version " + std::to_string(version) +
                             "; this server reads versions " + std::to_string(oldest_version) +
                             " to " + std::to_string(journal_version));
    JournalSegment segment;
    if (Status s = read_ticks(reader, segment.ticks); !s.ok()) return s.error();
    if (Status s = read_paused_ticks(reader, segment.paused_ticks); !s.ok()) return s.error();
    if (version >= version_of_rewinds)
        if (Status s = read_rewind(reader, segment); !s.ok()) return s.error();
    bool has_undo = version == version_of_undos;
    if (version >= version_of_deformables) reader(has_undo);
    if (has_undo)
        if (Status s = read_undo(reader, segment); !s.ok()) return s.error();
    if (!reader.from.ok()) return not_a_journal("unexpected end of data");
    if (!reader.from.at_end()) return not_a_journal("data after the end");
    return segment;
}

}  // namespace jostle::server

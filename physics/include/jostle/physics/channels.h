// SPDX-License-Identifier: MIT
//
// Channels: data that a module (module.h) publishes to clients after a step. A module declares its
// channel kinds and writes integers, one list per kind and body, or point objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

/// Layout of a channel's values, so that a client can display a channel without knowing its module.
enum class ChannelForm : std::uint8_t {
    params,  ///< values in an order defined by the module: a gear, the travel of each wheel
    points,  ///< no values: the kind has point objects (PointObject)
    /// Parameters from which the client computes the display itself, such as waves. Sent when they
    /// change.
    seed,
};

/// A channel kind: one type of data that a module publishes about its bodies or about itself.
struct ChannelKind {
    /// Channel name suffix: 1 to 32 characters of a-z, 0-9 and _. The full name is the module's
    /// tag, or "tag.name" if this is not empty.
    std::string name = {};
    ChannelForm form = ChannelForm::params;  ///< layout of the values
    /// Publishing interval in steps, 1 to 255. Clients keep the last values between updates.
    int divisor = 1;
};

/// Connections of the points of a point object.
enum class PointForm : std::uint8_t {
    loose,      ///< unconnected points whose number may change: particles, agents
    strands,    ///< ropes and hair: polylines
    grid,       ///< a sheet of columns x rows points, row by row
    triangles,  ///< a mesh
    heights,    ///< columns x rows heights above a horizontal grid, row by row
};

/// The points of one object, such as a rope, a cloth or a group of particles. Clients receive the
/// connections once, and positions predicted and compressed; a client with little bandwidth
/// receives coarse levels of an object before all of its points. The spans need to be valid only
/// during ChannelWriter::points().
struct PointObject {
    static constexpr std::size_t points_max = 65536;      ///< per object
    static constexpr std::size_t triangles_max = 131072;  ///< per object

    /// Identifies the object among those of its kind. A change of anything but the positions makes
    /// it a new object for clients.
    std::uint32_t key = 0;
    BodyId body = {};     ///< positions are in the local frame of this body; none: in the world
    double step = 0.001;  ///< m, 1e-6 to 10: positions are rounded to multiples of it
    double radius = 0;    ///< m, of each point or strand, for display
    std::optional<std::uint32_t> color = {};  ///< 0xRRGGBB, for display

    PointForm form = PointForm::loose;
    /// m; of all forms but heights. Components beyond 2^30 steps are clamped.
    std::span<const Vec3> positions = {};
    /// Loose points: identifies each point from step to step. Ids are unique; ascending ids cost
    /// least. Empty: a point is identified by its index.
    std::span<const std::uint32_t> ids = {};
    std::span<const std::uint32_t> strands = {};    ///< number of points of each strand
    std::size_t columns = 0;                        ///< of a grid or of heights
    std::span<const std::uint32_t> triangles = {};  ///< three indices of points each

    std::span<const double> heights = {};  ///< m above the y of the origin
    Vec3 origin = {};                      ///< m, of the first height
    double spacing_x = 1, spacing_z = 1;   ///< m, between columns and between rows
};

/// Receives the channels of one module after a step: for each kind and body, a list of 32-bit
/// integers, or point objects. The server encodes them once for all clients subscribed to the kind
/// and sends only changes. Not thread-safe: one thread at a time.
class ChannelWriter {
public:
    /// Maps a body to its entity number on the clients; 0 if clients do not know the body.
    using NameOf = std::function<std::uint32_t(BodyId)>;
    /// The values written for one kind and one body.
    struct Channel {
        /// Index in Module::channels(), and the entity number (0: the module itself).
        std::uint32_t kind = 0, entity = 0;
        std::vector<std::int32_t> values;  ///< in the layout of the kind's ChannelForm
    };

    /// Receives a point object. `entity`: the entity number of its body; 0: no body.
    using OnPoints =
        std::function<void(std::uint32_t kind, std::uint32_t entity, const PointObject& object)>;

    /// `due` states for each kind of the module whether it is published in this step. An empty
    /// vector publishes all kinds. Without `on_points`, points() does nothing.
    explicit ChannelWriter(NameOf name_of, std::vector<bool> due = {}, OnPoints on_points = {})
        : name_of_(std::move(name_of)), due_(std::move(due)), on_points_(std::move(on_points)) {}

    /// Starts the channel of a kind (an index in Module::channels()) and a body. Omit the body for
    /// data about the module itself. Values written until the next begin() belong to this channel.
    ///
    /// Returns false if the kind is not due or clients do not know the body. Values written until
    /// the next begin() are then discarded. Call it at most once per kind and body.
    bool begin(std::size_t kind, BodyId body = {});
    /// Appends one value.
    void value(std::int32_t value);
    /// Appends `value` quantized to 2^bits even steps from low to high, as an integer from 0 to
    /// 2^bits - 1. Values outside the range are clamped; NaN becomes 0. Preconditions: bits is 1 to
    /// 31, low < high.
    void quantized(double value, double low, double high, int bits);
    /// Appends the bit pattern of a float.
    void f32(float value);
    /// Appends the entity number of a body; 0 if clients do not know it.
    void body(BodyId body) { value(static_cast<std::int32_t>(name_of_(body))); }
    /// Publishes a point object of a kind of the form points. An object that is not written has
    /// ended. Returns false if the kind is not due, so that its points need not be computed, or if
    /// clients do not know the body.
    bool points(std::size_t kind, const PointObject& object);
    /// Whether points() of this kind has an effect.
    bool wants_points(std::size_t kind) const { return on_points_ && is_due(kind); }

    /// Returns the channels in the order of their begin() calls.
    std::vector<Channel>& channels() { return channels_; }

private:
    bool is_due(std::size_t kind) const { return kind >= due_.size() || due_[kind]; }

    NameOf name_of_;
    std::vector<bool> due_;
    OnPoints on_points_;
    std::vector<Channel> channels_;
    bool skipping_ = true;
};

}  // namespace jostle::physics

// SPDX-License-Identifier: MIT
//
// Channels: integer data that a module (module.h) publishes to clients after a step. A module
// declares its channel kinds and writes their values; each channel belongs to one kind and one
// body.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
    /// Units per metre, then x, y, z of each point in these units. Coordinates are in the local
    /// frame of the body, or in world coordinates if the channel has no body.
    points,
    field,  ///< columns, rows, units per metre, then a height per cell in these units, row by row
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

/// Receives the channels of one module after a step: for each kind and body, a list of 32-bit
/// integers. The server encodes them once for all clients subscribed to the kind and sends only
/// changes. Not thread-safe: one thread at a time.
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

    /// `due` states for each kind of the module whether it is published in this step. An empty
    /// vector publishes all kinds.
    explicit ChannelWriter(NameOf name_of, std::vector<bool> due = {})
        : name_of_(std::move(name_of)), due_(std::move(due)) {}

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
    /// Append the complete contents of a channel of the form `points` or `field`. Coordinates that
    /// exceed the range of 32-bit units are clamped. heights has columns x rows entries, row by
    /// row.
    void points(int units_per_meter, std::span<const Vec3> points);
    void field(int units_per_meter, std::size_t columns, std::span<const double> heights);

    /// Returns the channels in the order of their begin() calls.
    std::vector<Channel>& channels() { return channels_; }

private:
    NameOf name_of_;
    std::vector<bool> due_;
    std::vector<Channel> channels_;
    bool skipping_ = true;
};

}  // namespace jostle::physics

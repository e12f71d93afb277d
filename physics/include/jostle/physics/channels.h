// SPDX-License-Identifier: MIT
//
// What a module (module.h) tells clients: channels of whole numbers, one for each kind and body.
// A module declares its kinds and writes their values after a step. One thread.
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

// What the numbers of a channel are, for those who show it without knowing its module.
enum class ChannelForm : std::uint8_t {
    params,  // in an order of the module's own: a gear, the travel of wheels
    points,  // units a metre, then x y z of each point in those units, in the frame of the body, or
             // of the world where there is none
    field,   // columns, rows, units a metre, then a height for each cell in those units, row by row
    seed,    // what a client shows by itself from then on, such as waves; told when it changes
};

// A kind of channel: what a module tells of one of its bodies, or of itself.
struct ChannelKind {
    // Its name is the module's tag or, where this is not empty, "tag.name": 1 to 32 of a-z, 0-9, _.
    std::string name = {};
    ChannelForm form = ChannelForm::params;
    int divisor = 1;  // told every so many steps, 1 to 255; between them it stays as it was told
};

// What a module tells clients after a step: for each kind and body a list of whole numbers of 32
// bits. All clients that asked for the kind share it, and are sent what changed.
class ChannelWriter {
public:
    // How clients name bodies; 0: they do not know it.
    using NameOf = std::function<std::uint32_t(BodyId)>;
    struct Channel {
        std::uint32_t kind = 0, entity = 0;
        std::vector<std::int32_t> values;
    };

    // `due`: for each kind of the module whether this step tells it; none: all of them.
    explicit ChannelWriter(NameOf name_of, std::vector<bool> due = {})
        : name_of_(std::move(name_of)), due_(std::move(due)) {}

    // What follows is of that kind (a place in Module::channels()) and body; of the module itself
    // where there is no body. False: it is not due, or clients do not know the body; what is
    // written until the next begin() is left out. Each kind and body once.
    bool begin(std::size_t kind, BodyId body = {});
    void value(std::int32_t value);
    // The nearest of 2^bits even steps from low to high, as 0 to 2^bits - 1; clamped; NaN is low.
    // bits: 1 to 31.
    void quantized(double value, double low, double high, int bits);
    // The four bytes of a float.
    void f32(float value);
    // What clients call a body; 0 for one that they do not know.
    void body(BodyId body) { value(static_cast<std::int32_t>(name_of_(body))); }
    // A whole channel of the forms `points` and `field`; what is too large for the units is
    // clamped. heights: columns x rows.
    void points(int units_per_meter, std::span<const Vec3> points);
    void field(int units_per_meter, std::size_t columns, std::span<const double> heights);

    // In the order in which they were begun.
    std::vector<Channel>& channels() { return channels_; }

private:
    NameOf name_of_;
    std::vector<bool> due_;
    std::vector<Channel> channels_;
    bool skipping_ = true;
};

}  // namespace jostle::physics

// SPDX-License-Identifier: MIT
//
// A module: a step listener with a state of its own that belongs to the world. It is saved, loaded,
// hashed, compared and restored with it, and may tell clients about itself. Written on public
// headers alone (examples/hovercraft.h is one).
//
//     register_module("hovercraft", [] { return std::make_unique<Hovercraft>(); });
//     world.add_module(std::make_unique<Hovercraft>(craft));
//     auto* hovercraft = dynamic_cast<Hovercraft*>(world.module("hovercraft"));
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jostle/physics/channels.h"
#include "jostle/physics/result.h"
#include "jostle/physics/state_visitor.h"
#include "jostle/physics/step_listener.h"

namespace jostle::physics {

// What a scene says of a module, in its order.
struct ModuleSettings {
    std::vector<std::pair<std::string, double>> numbers = {};
    std::vector<std::pair<std::string, BodyId>> bodies = {};
    std::vector<std::pair<std::string, std::vector<std::byte>>> bytes = {};  // files' contents
};

// What somebody who drives holds, until he holds it otherwise: sticks and buttons. What they mean
// is the module's; those of ours keep to this, so that one set of keys does for all.
struct Controls {
    static constexpr std::size_t axes_max = 8;
    // -1 to 1. 0: to the right; 1: ahead; 2: up. 3: where the driver looks, about the world's y
    // axis, in half turns from -z, to the left.
    std::array<double, axes_max> axes = {};
    // A bit each. 0: jump, or hold by hand; 1: crouch, or faster; 2: a gear up; 3: a gear down.
    std::uint32_t buttons = 0;

    bool operator==(const Controls&) const = default;
};

class Module : public StepListener {
public:
    // Names its kind in saved worlds, scenes and messages: 1 to 32 of a-z, 0-9 and _. A world has
    // at most one module of a tag.
    virtual std::string_view tag() const = 0;
    // Every field that the next step depends on.
    virtual void visit(StateVisitor& v) = 0;
    // After its state was read by a visitor: makes anew what follows from it.
    virtual void restored(const World& world) { static_cast<void>(world); }

    // From a scene, after its bodies exist and before the module is added. The error names the
    // setting. The default takes none.
    virtual Status configure(World& world, const ModuleSettings& settings);
    // Whether somebody may drive a body that is there.
    virtual bool is_controllable(BodyId body) const {
        static_cast<void>(body);
        return false;
    }
    // Between steps, of such a body: held from the next step on, and part of the module's state.
    // Axes are within their range.
    virtual void control(World& world, BodyId body, const Controls& controls) {
        static_cast<void>(world), static_cast<void>(body), static_cast<void>(controls);
    }
    // The one thing that such a body is: all that its next step depends on, for who foresees it in
    // a world of his own. Between steps. A loading visitor makes it of that body, or puts it right.
    // False: this thing is not told of, or what was read makes none; then nothing has changed.
    virtual bool visit_controlled_entity(World& world, BodyId body, StateVisitor& v) {
        static_cast<void>(world), static_cast<void>(body), static_cast<void>(v);
        return false;
    }
    // What it tells clients, and how often: the same as long as it lives.
    virtual std::vector<ChannelKind> channels() const { return {}; }
    // Tells it, after a step. A channel that is not written any more has ended.
    virtual void publish(const World& world, ChannelWriter& channels) const {
        static_cast<void>(world), static_cast<void>(channels);
    }
};

// The kinds of modules that this process knows: load() and scenes make them by their tags. Any
// thread.
using MakeModule = std::function<std::unique_ptr<Module>()>;
// A tag that is known already is refused (failed_precondition).
Status register_module(std::string tag, MakeModule make);
// An unknown tag is an error that lists the known ones.
Result<std::unique_ptr<Module>> make_module(std::string_view tag);
std::vector<std::string> module_tags();  // sorted

// The state of one module as bytes, for scenes that keep it, and back. Foreign bytes are checked;
// an error names the field. After an error the module's fields are of no use.
std::vector<std::byte> save_module(Module& module);
Status load_module(Module& module, std::span<const std::byte> bytes);

}  // namespace jostle::physics

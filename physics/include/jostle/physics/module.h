// SPDX-License-Identifier: MIT
//
// Modules: step listeners whose state belongs to the world. The state is saved, loaded, hashed,
// compared and restored with the world, and a module can publish data to clients. Modules are
// written against the public headers only (example: examples/hovercraft.h).
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

/// Settings of a module in a scene, in the order of the scene file.
struct ModuleSettings {
    std::vector<std::pair<std::string, double>> numbers = {};  ///< numeric settings by name
    std::vector<std::pair<std::string, BodyId>> bodies = {};  ///< bodies by the name of the setting
    /// Contents of referenced files.
    std::vector<std::pair<std::string, std::vector<std::byte>>> bytes = {};
};

/// Driver input of a controlled entity: axes and buttons, held until the next input. Each module
/// defines their meaning. The modules of Jostle follow the meanings below, so one key map serves
/// all of them.
struct Controls {
    static constexpr std::size_t axes_max = 8;  ///< number of axes
    /// Axes, each from -1 to 1. 0: right; 1: forward; 2: up; 3: view direction about the world's y
    /// axis, in half turns from -z, positive to the left.
    std::array<double, axes_max> axes = {};
    /// Buttons, one bit each. 0: jump, or handbrake; 1: crouch, or boost; 2: gear up; 3: gear down.
    std::uint32_t buttons = 0;

    bool operator==(const Controls&) const = default;
};

/// A step listener with a state that belongs to the world.
///
///     register_module("hovercraft", [] { return std::make_unique<Hovercraft>(); });
///     world.add_module(std::make_unique<Hovercraft>(craft));
///     auto* hovercraft = dynamic_cast<Hovercraft*>(world.module("hovercraft"));
///
/// Thread rule: the world calls a module on the thread that calls the world (see
/// StepHooks::concurrent for the exception).
class Module : public StepListener {
public:
    /// Returns the tag that names this kind of module in saved worlds, scenes and messages: 1 to 32
    /// characters of a-z, 0-9 and _. A world has at most one module per tag.
    virtual std::string_view tag() const = 0;
    /// Visits every field that the next step depends on.
    virtual void visit(StateVisitor& v) = 0;
    /// Called after a visitor has loaded the state. Recompute derived data.
    virtual void restored(const World& world) { static_cast<void>(world); }

    /// Applies settings from a scene, after the scene's bodies exist and before the module is
    /// added. Returns an error that names the setting if it is not accepted. The default accepts no
    /// settings.
    virtual Status configure(World& world, const ModuleSettings& settings);
    /// Returns whether clients may control a body of the world.
    virtual bool is_controllable(BodyId body) const {
        static_cast<void>(body);
        return false;
    }
    /// Applies driver input to a controllable body between steps. The input is held from the next
    /// step on and is part of the module's state. Axes are within their range.
    virtual void control(World& world, BodyId body, const Controls& controls) {
        static_cast<void>(world), static_cast<void>(body), static_cast<void>(controls);
    }
    /// Visits the state of one controlled entity, which is everything that its next step depends
    /// on, so that a client can predict it in a world of its own. Called between steps. A loading
    /// visitor creates the entity for that body or corrects it. Returns false if this entity is not
    /// predicted or the loaded data is invalid; nothing has changed then.
    virtual bool visit_controlled_entity(World& world, BodyId body, StateVisitor& v) {
        static_cast<void>(world), static_cast<void>(body), static_cast<void>(v);
        return false;
    }
    /// Returns the channels that this module publishes, with their intervals. The result is
    /// constant during the lifetime of the module.
    virtual std::vector<ChannelKind> channels() const { return {}; }
    /// Publishes the channels after a step. A channel that is not written has ended.
    virtual void publish(const World& world, ChannelWriter& channels) const {
        static_cast<void>(world), static_cast<void>(channels);
    }
};

/// Creates an empty module of one kind.
using MakeModule = std::function<std::unique_ptr<Module>()>;
/// Registers a kind of module, so that load() and scenes can create it by its tag. Process-wide and
/// thread-safe.
///
/// Errors: invalid_argument for an invalid tag or an empty function; failed_precondition if the tag
/// is registered already.
Status register_module(std::string tag, MakeModule make);
/// Creates a module by its tag. Thread-safe. Errors: not_found, listing the registered tags;
/// failed_precondition if the registered function creates no module or one with another tag.
Result<std::unique_ptr<Module>> make_module(std::string_view tag);
/// Returns the registered tags in alphabetical order. Thread-safe.
std::vector<std::string> module_tags();

/// Saves the state of one module as bytes, for scenes that contain it.
std::vector<std::byte> save_module(Module& module);
/// Loads the state of one module from untrusted bytes. Errors: corrupt_data, naming the field; the
/// state of the module is then undefined.
Status load_module(Module& module, std::span<const std::byte> bytes);

}  // namespace jostle::physics

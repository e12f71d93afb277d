// SPDX-License-Identifier: MIT
//
// The scene catalogue: scenes by name, listed and accepted by all programs.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

/// An entry of the catalogue.
struct CatalogEntry {
    std::string_view name;
    std::string_view description;
};

/// All scenes of the catalogue, in display order. Any thread.
std::span<const CatalogEntry> catalog();

/// Returns the scene with this name; nullopt if there is none.
std::optional<SceneDescription> find_scene(std::string_view name);

/// Returns "; did you mean "NAME"?" for a misspelled name, or nothing if no scene has a similar
/// name.
std::string scene_suggestion(std::string_view wrong);

/// Registers the modules that scenes of the catalogue use. build_scene() calls it. A program that
/// loads saved worlds must call it first. Thread-safe and idempotent.
void register_catalog_modules();

}  // namespace jostle::scenes

// SPDX-License-Identifier: MIT
//
// Scenes by name: what every program lists and takes.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

struct CatalogEntry {
    std::string_view name;
    std::string_view description;
};

std::span<const CatalogEntry> catalog();

// Nothing when the catalogue has no such name.
std::optional<SceneDescription> find_scene(std::string_view name);

// Makes known the modules that scenes of the catalogue have. build_scene() does; a program that
// loads saved worlds calls it before. Any thread, any number of times.
void register_catalog_modules();

}  // namespace jostle::scenes

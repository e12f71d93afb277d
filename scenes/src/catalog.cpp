// SPDX-License-Identifier: MIT
#include "jostle/scenes/catalog.h"

#include "parts.h"

namespace jostle::scenes {
namespace {

using Make = SceneDescription (*)();

constexpr Make makers[] = {sandbox,   pyramid,  stack,      wall,    dominoes, pile,     rain,
                           billiards, incline,  free_space, shapes,  terrain,  ragdolls, bridge,
                           workshop,  conveyor, gates,      bullets, locked,   flatland};

// Each scene says its own name and description; they are asked once.
struct Listed {
    std::vector<SceneDescription> scenes;
    std::vector<CatalogEntry> entries;

    Listed() {
        for (const Make make : makers) {
            scenes.push_back(make());
            scenes.back().bodies.clear();
        }
        for (const SceneDescription& scene : scenes)
            entries.push_back({scene.name, scene.description});
    }
};

const Listed& listed() {
    static const Listed once;
    return once;
}

}  // namespace

std::span<const CatalogEntry> catalog() {
    return listed().entries;
}

std::optional<SceneDescription> find_scene(std::string_view name) {
    for (std::size_t i = 0; i < std::size(makers); i++)
        if (listed().entries[i].name == name) return makers[i]();
    return std::nullopt;
}

}  // namespace jostle::scenes

// SPDX-License-Identifier: MIT
#include "jostle/scenes/catalog.h"

#include <array>

#include "parts.h"

namespace jostle::scenes {
namespace {

struct Listed {
    CatalogEntry entry;
    SceneDescription (*make)();  // all but its name and description
};

constexpr Listed listed[] = {
    {{"sandbox", "A walled yard with stacks, balls, ramps and dominoes to play with."}, sandbox},
    {{"pyramid", "A wall pyramid of 465 boxes, thirty rows high."}, pyramid},
    {{"stack", "Ten boxes of one metre on top of each other."}, stack},
    {{"wall", "A brick wall in running bond and a heavy ball that meets it."}, wall},
    {{"dominoes", "120 dominoes in a spiral; the first is pushed."}, dominoes},
    {{"pile", "1000 spheres, boxes and capsules poured into a bin."}, pile},
    {{"rain", "300 bodies fall from up to 60 m onto ramps."}, rain},
    {{"billiards", "Fifteen balls on a table with cushions; the cue ball breaks them."}, billiards},
    {{"incline", "Boxes on a slope of 20 degrees, slippery to rough."}, incline},
    {{"free_space", "64 boxes collide where nothing falls: momentum is kept."}, free_space},
    {{"shapes",
      "Every kind of moving shape poured into a yard: dice, drums, cones, jacks, stones."},
     shapes},
    {{"terrain", "Hills with a shaft, stairs and a slide; balls, wheels and stones on them."},
     terrain},
    {{"ragdolls", "Twelve people of eleven bones fall down a flight of stairs."}, ragdolls},
    {{"bridge",
      "A bridge of 20 planks, a chain with a wrecking ball, and a gate of boards whose joints "
      "break."},
     bridge},
    {{"workshop",
      "A mixer on a motor, doors with limits and springs, weights on ropes, rods and springs."},
     workshop},
    {{"conveyor", "Four belts in a ring carry crates, drums and balls round."}, conveyor},
    {{"gates",
      "Balls fall through triggers; red and blue pass each other's sieve; a turning cross sweeps "
      "them up."},
     gates},
    {{"bullets",
      "Bullets at 200 m/s, walls of 5 cm, spinning rods and thin posts: nothing passes."},
     bullets},
    {{"locked", "Pistons that only rise, sliders that only slide, wheels that only turn."}, locked},
    {{"flatland", "A planar world: a pyramid, discs, sticks and a hinge, all in one plane."},
     flatland},
};

constexpr auto entries = [] {
    std::array<CatalogEntry, std::size(listed)> all;
    for (std::size_t i = 0; i < all.size(); i++) all[i] = listed[i].entry;
    return all;
}();

}  // namespace

std::span<const CatalogEntry> catalog() {
    return entries;
}

std::optional<SceneDescription> find_scene(std::string_view name) {
    for (const auto& [entry, make] : listed) {
        if (entry.name != name) continue;
        SceneDescription scene = make();
        scene.name = entry.name;
        scene.description = entry.description;
        return scene;
    }
    return std::nullopt;
}

}  // namespace jostle::scenes

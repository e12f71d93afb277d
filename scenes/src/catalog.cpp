// SPDX-License-Identifier: MIT
#include "jostle/scenes/catalog.h"

#include <array>

#include "jostle/base/nearest_name.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {
namespace {

struct CatalogItem {
    CatalogEntry entry;
    SceneDescription (*make)();  // everything except name and description
};

constexpr CatalogItem catalog_items[] = {
    {{"sandbox", "A walled yard with stacks, balls, ramps and dominoes to play with."}, sandbox},
    {{"pyramid", "A wall pyramid of 465 boxes, thirty rows high."}, pyramid},
    {{"stack", "Ten boxes of one metre on top of each other."}, stack},
    {{"wall", "A brick wall in running bond, hit by a heavy ball."}, wall},
    {{"dominoes", "120 dominoes in a spiral; the first is pushed."}, dominoes},
    {{"pile", "1000 spheres, boxes and capsules poured into a bin."}, pile},
    {{"rain", "300 bodies fall from up to 60 m onto ramps."}, rain},
    {{"billiards", "Fifteen balls on a table with cushions; the cue ball breaks them."}, billiards},
    {{"incline", "Boxes on a slope of 20 degrees, slippery to rough."}, incline},
    {{"free_space", "64 boxes collide without gravity: momentum is conserved."}, free_space},
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
    {{"machines",
      "A car on wheels, gears and a rack, a pulley, a bead on a wire, a lift, a gimbal, a grabbed "
      "body."},
     machines},
    {{"conveyor", "Four belts in a ring carry crates, drums and balls round."}, conveyor},
    {{"gates",
      "Balls fall through triggers; red and blue balls pass different sieves; a rotating cross "
      "sweeps them up."},
     gates},
    {{"bullets",
      "Bullets at 200 m/s, walls of 5 cm, spinning rods and thin posts: nothing tunnels."},
     bullets},
    {{"locked", "Pistons that only rise, sliders that only slide, wheels that only turn."}, locked},
    {{"flatland", "A planar world: a pyramid, discs, sticks and a hinge, all in one plane."},
     flatland},
    {{"hovercraft", "A module flies a craft on four jets of air over waves and loose buoys."},
     hovercraft},
    {{"harbour", "Boats to drive round buoys, crates and barrels on a swell; a breeze blows."},
     harbour},
    {{"fountain",
      "A fountain of 3000 particles on a hill pushes balls and a mill wheel; smoke and a rope."},
     fountain},
    {{"parkour",
      "Stairs, gaps and a beam up to a flag, ramps, a roundabout; five characters to control."},
     parkour},
    {{"race_track", "Six cars drive around a ring road over a hill; drive one of them."},
     race_track},
    {{"demolition",
      "Three walls of chunks held together by bonds, two wrecking balls, a digger to drive."},
     demolition},
    {{"stampede",
      "300 people on a market square flee from a bull and from explosions; a flock circles above."},
     stampede},
    {{"stadium", "600 spectators leave a stadium through four gates; walk among them."}, stadium},
    {{"rope_bridge",
      "A bridge of planks on two ropes over a canyon: walk across, drop sacks onto it."},
     rope_bridge},
    {{"flag", "A flag and a banner in gusts of wind, and a sheet over a table."}, flag},
    {{"curtain", "Drive through curtains of cloth strips, and into a net."}, curtain},
    {{"swings", "Three swings, a tyre, a climbing rope and a crane with a winch."}, swings},
    {{"ragdoll_stairs", "Twelve figures tip off a ramp and fall down the stairs; walk up to them."},
     ragdoll_stairs},
    {{"katamari",
      "901 cubes: a large one rolls by itself and attracts the small ones; a benchmark of snapshot "
      "codecs."},
     katamari},
    {{"asteroids",
      "250 asteroids around a planetoid: the rules of a public benchmark of network transforms."},
     asteroids},
    {{"asteroids_1000", "The scene asteroids with 1000 bodies in a sphere of 50 m."},
     asteroids_1000},
    {{"asteroids_10000", "The scene asteroids with 10,000 bodies in a sphere of 108 m."},
     asteroids_10000},
    // The scenes that jostle-bench measures, by letter.
    {{"bench_pyramid_465",
      "A flat pyramid of 30 rows of 1 m boxes with gaps of 5 cm (benchmark a)."},
     bench_pyramid_465},
    {{"bench_pyramid_5050", "A flat pyramid of 100 rows of 1 m boxes without gaps (benchmark b)."},
     bench_pyramid_5050},
    {{"bench_boxes_1000", "10 x 10 x 10 boxes dropped in a block (benchmark c)."},
     bench_boxes_1000},
    {{"bench_pile_5000",
      "5000 spheres, boxes and capsules poured between four walls (benchmark d)."},
     bench_pile_5000},
    {{"bench_player_901",
      "900 cubes on a floor and a larger one, which jostle-bench drives through them (benchmark "
      "e)."},
     bench_player_901},
    {{"bench_ragdolls_40",
      "40 figures of 11 capsules and 10 joints fall on each other (benchmark f)."},
     bench_ragdolls_40},
    {{"bench_joint_grid_10000",
      "A cloth of 100 x 100 balls and 19,794 joints hangs from seven static balls (benchmark g)."},
     bench_joint_grid_10000},
    {{"bench_asleep_10000",
      "10,000 boxes at rest, which jostle-bench times once all are asleep (benchmark h)."},
     bench_asleep_10000},
    {{"bench_bullets_1000", "1000 spheres at 200 m/s against a wall of 5 cm (benchmark i)."},
     bench_bullets_1000},
    {{"bench_trees",
      "50 trees of 22 hulls, up to 45 m long, roll over a mesh of waves (benchmark trees)."},
     bench_trees},
    {{"bench_convex_pile",
      "5120 stones of 32 corners poured between four walls (benchmark convex_pile)."},
     bench_convex_pile},
    {{"bench_washer", "8000 cubes in a drum of 36 staves that turns (benchmark washer)."},
     bench_washer},
    {{"bench_hull_terrain",
      "300 stones of 24 corners fall on a rough mesh (benchmark hull_terrain)."},
     bench_hull_terrain},
    {{"bench_chain",
      "A chain of 1000 links, fixed at one end, falls from level (benchmark chain)."},
     bench_chain},
    {{"bench_rain", "72 figures rain on bowls and rings of mesh (benchmark rain)."}, bench_rain},
    {{"bench_vehicles", "100 cars on four wheels drive over a mesh of hills (benchmark vehicles)."},
     bench_vehicles},
    {{"bench_rods",
      "2000 rods 6 cm thick and 96 cm long poured between four walls (benchmark rods)."},
     bench_rods},
    {{"bench_box_shot", "1000 boxes at 150 m/s against a wall (benchmark box_shot)."},
     bench_box_shot},
    {{"bench_brick_wall", "A wall of 400 bricks, hit by a heavy ball (benchmark brick_wall)."},
     bench_brick_wall},
    {{"bench_l_shapes", "500 bodies of two boxes poured between four walls (benchmark l_shapes)."},
     bench_l_shapes},
    {{"bench_junkyard",
      "10,584 stones of 14 corners and an arm that sweeps through them (benchmark junkyard)."},
     bench_junkyard},
};

constexpr auto entries = [] {
    std::array<CatalogEntry, std::size(catalog_items)> all;
    for (std::size_t i = 0; i < all.size(); i++) all[i] = catalog_items[i].entry;
    return all;
}();

}  // namespace

std::span<const CatalogEntry> catalog() {
    return entries;
}

std::string scene_suggestion(std::string_view wrong) {
    std::vector<std::string_view> names;
    for (const CatalogEntry& entry : catalog()) names.push_back(entry.name);
    return did_you_mean(wrong, names);
}

std::optional<SceneDescription> find_scene(std::string_view name) {
    for (const auto& [entry, make] : catalog_items) {
        if (entry.name != name) continue;
        SceneDescription scene = make();
        scene.name = entry.name;
        scene.description = entry.description;
        return scene;
    }
    return std::nullopt;
}

}  // namespace jostle::scenes

// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "jostle/modules/boats.h"
#include "jostle/modules/character.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/fields.h"
#include "jostle/modules/ragdoll.h"
#include "jostle/modules/vehicle.h"
#include "jostle/physics/physics.h"

namespace jostle::bench {
namespace {

using namespace physics;

constexpr const char* footer = R"(
Two worlds contain the same boxes, 10 x 10 stacks of 10, and never sleep. One world has no feature,
the other one contains the feature, idle, 1 km away. The worlds step in turn; the CPU time of the
thread is measured. Each round creates both worlds again, at other addresses, and repeats the same
work; the shortest time of a step over all rounds is its undisturbed time. The result is the
relative difference of the summed times, in percent, for all rounds and for each half of the rounds;
the difference between the halves is the noise. 'nothing' compares two equal worlds: smaller
differences than its result are not significant.

Features:  continuous  enabled, all bodies slow     joints     one joint between sleeping bodies
           triggers    one empty trigger            events     one sleeping contact reporter
           kinematics  one kinematic body at rest   meshes     200 triangles, a box asleep on them
           listeners   one pre-solve listener       fields     wind in an empty box
                       that does nothing
           mod-NAME    a module without objects

Scenes of the same number of boxes, relative to the boxes that stand on each other in the world
without features:
           planar      the same stacks side by side in a planar world
           locked      all rotations of the boxes are locked
           free-fall   the boxes fall, 3 m apart

Examples:
  jostle-bench features
  jostle-bench features --feature joints,meshes --rounds 100
  jostle-bench features --max-percent 1 --json features.json

Exit status: 0 success, 1 a feature costs more than --max-percent, or the file could not be written,
2 invalid flags.)";

struct Flags {
    int rounds = 40, steps = 60;
    double max_percent = 0;         // limit in percent; 0: none
    std::vector<std::string> only;  // empty: all features
    std::string json;
};

template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

constexpr double far = 1000;  // m: distance of the idle objects

BodyId add(World& world, BodyType type, Vec3 position, const ShapeDef& shape) {
    return must(world.create_body({.type = type, .pose = {position, {}}}, shape));
}

void add_joint(World& world) {
    const BodyId a = add(world, BodyType::dynamic, {far, 0.5, 0}, {});
    const BodyId b = add(world, BodyType::dynamic, {far + 1.5, 0.5, 0}, {});
    must(world.create_joint({.body_a = a,
                             .body_b = b,
                             .frame_a = {{0.75, 0, 0}, {}},
                             .frame_b = {{-0.75, 0, 0}, {}},
                             .kind = FixedJoint{}}));
}

void add_trigger(World& world) {
    add(world, BodyType::static_body, {far, 5, 0}, {.trigger = true});
}

void add_reporter(World& world) {
    add(world, BodyType::dynamic, {far, 0.5, 0}, {.report_stays = true});
}

void add_kinematic(World& world) {
    add(world, BodyType::kinematic, {far, 5, 0}, {});
}

void add_mesh(World& world) {
    std::vector<Vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 0; i <= 10; i++)
        for (std::uint32_t j = 0; j <= 10; j++) corners.push_back({i - 5.0, 0, j - 5.0});
    for (std::uint32_t i = 0; i < 10; i++)
        for (std::uint32_t j = 0; j < 10; j++) {
            const std::uint32_t at = i * 11 + j;
            triangles.push_back({at, at + 1, at + 11});
            triangles.push_back({at + 11, at + 1, at + 12});
        }
    const Mesh mesh{must(build_mesh(corners, triangles))};
    add(world, BodyType::static_body, {far, 3, 0}, {.geometry = mesh});
    add(world, BodyType::dynamic, {far, 3.5, 0}, {});
}

// One stateless listener for all worlds.
struct IdleListener : StepListener {
    StepHooks hooks() const override { return {.pre_solve = true}; }
};
void add_listener(World& world) {
    static IdleListener listener;
    world.add_listener(listener).expect();
}

void add_field(World& world) {
    must(world.create_field({.force = UniformWind{.velocity = {10, 0, 0}},
                             .region = Aabb{{far, 0, 0}, {far + 10, 10, 10}}}));
}

// Adds the module without objects.
template <class Module>
void add_module(World& world) {
    world.add_module(std::make_unique<Module>()).expect();
}

// The boxes of a world.
enum class Boxes : unsigned char { stacked, planar, locked, falling };

struct Feature {
    const char* name;
    void (*add)(World&);  // null: the feature is a flag of the world, or belongs to the boxes
    Boxes boxes = Boxes::stacked;
};
constexpr Feature features[] = {{"nothing", nullptr},
                                {"continuous", nullptr},
                                {"joints", add_joint},
                                {"triggers", add_trigger},
                                {"events", add_reporter},
                                {"kinematics", add_kinematic},
                                {"meshes", add_mesh},
                                {"listeners", add_listener},
                                {"fields", add_field},
                                {"mod-fields", add_module<modules::Fields>},
                                {"mod-boats", add_module<modules::Boats>},
                                {"mod-characters", add_module<modules::Characters>},
                                {"mod-ragdolls", add_module<modules::Ragdolls>},
                                {"mod-vehicles", add_module<modules::Vehicles>},
                                {"mod-destruction", add_module<modules::Destruction>},
                                {"planar", nullptr, Boxes::planar},
                                {"locked", nullptr, Boxes::locked},
                                {"free-fall", nullptr, Boxes::falling}};

// Position of the k-th of 1000 boxes.
Vec3 place_of(Boxes boxes, int k) {
    const double layer = k / 100;
    if (boxes == Boxes::planar) return {1.5 * (k % 100), 0.5 + layer, 0};
    const double apart = boxes == Boxes::falling ? 3 : 1.5;
    const double height = boxes == Boxes::falling ? 500 + 3 * layer : 0.5 + layer;
    return {apart * (k % 10), height, apart * (k / 10 % 10)};
}

AxisLocks locks_of(Boxes boxes) {
    if (boxes == Boxes::locked) return lock_rotation_x | lock_rotation_y | lock_rotation_z;
    return 0;
}

World make_world(const Feature* feature) {
    const bool continuous = feature != nullptr && feature->name == std::string("continuous");
    const Boxes boxes = feature != nullptr ? feature->boxes : Boxes::stacked;
    World world = must(World::create({.continuous = continuous, .planar = boxes == Boxes::planar}));
    add(world, BodyType::static_body, {0, -1, 0}, {.geometry = Box{{2000, 1, 2000}}});
    for (int k = 0; k < 1000; k++)
        must(world.create_body(
            {.pose = {place_of(boxes, k), {}}, .sleep_allowed = false, .locks = locks_of(boxes)},
            ShapeDef{}));
    if (feature != nullptr && feature->add != nullptr) feature->add(world);
    for (int k = 0; k < 200; k++)
        if (Status s = world.step(1.0 / 60); !s.ok()) throw std::runtime_error(s.error().message);
    return world;
}

double time_step(World& world) {
    const double began = cpu_seconds();
    (void)world.step(1.0 / 60);
    return cpu_seconds() - began;
}

// The shortest time of each step, for one kind of world.
class LeastTimes {
public:
    explicit LeastTimes(int steps) : least_(static_cast<std::size_t>(steps), 1e300) {}
    void note(int step, double seconds) {
        double& least = least_[static_cast<std::size_t>(step)];
        least = std::min(least, seconds);
    }
    double sum() const { return std::accumulate(least_.begin(), least_.end(), 0.0); }

private:
    std::vector<double> least_;
};

// The times of the worlds without and with the feature.
struct Pair {
    LeastTimes without, with;

    explicit Pair(int steps) : without(steps), with(steps) {}
    double percent() const { return 100 * (with.sum() / without.sum() - 1); }
};

struct Row {
    const char* feature;
    double percent = 0, low = 0, high = 0;  // of all rounds; of the two halves
};

Row measure(const Feature& feature, const Flags& flags) {
    Pair all(flags.steps), odd(flags.steps), even(flags.steps);
    for (int round = 0; round < flags.rounds; round++) {
        show_progress(std::string(feature.name) + ", round " + std::to_string(round + 1));
        // The order in which the worlds are created and stepped alternates.
        const bool first = round / 2 % 2 == 0;
        std::optional<World> without, with;
        if (first) without = make_world(nullptr);
        with = make_world(&feature);
        if (!first) without = make_world(nullptr);
        for (int k = 0; k < flags.steps; k++) {
            double a = 0, b = 0;
            if (first) a = time_step(*without);
            b = time_step(*with);
            if (!first) a = time_step(*without);
            for (Pair* pair : {&all, round % 2 == 0 ? &even : &odd}) {
                pair->without.note(k, a);
                pair->with.note(k, b);
            }
        }
    }
    show_progress("");
    const auto [low, high] = std::minmax({odd.percent(), even.percent()});
    return {feature.name, all.percent(), low, high};
}

int run(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    bool within = true;
    std::printf("%-12s %8s %20s\n", "idle feature", "cost, %", "(halves of rounds)");
    for (const Feature& feature : features) {
        if (!flags.only.empty() && std::ranges::count(flags.only, feature.name) == 0) continue;
        const Row row = measure(feature, flags);
        std::printf("%-12s %8.2f   (%6.2f to %6.2f)\n", row.feature, row.percent, row.low,
                    row.high);
        std::fflush(stdout);
        rows.push_back({{"feature", row.feature},
                        {"percent", rounded(row.percent)},
                        {"low", rounded(row.low)},
                        {"high", rounded(row.high)}});
        if (flags.max_percent <= 0 || row.percent <= flags.max_percent) continue;
        within = false;
        std::fprintf(stderr,
                     "jostle-bench: idle feature %s costs %.2f %%; must be at most %.2f %%\n",
                     row.feature, row.percent, flags.max_percent);
    }
    if (flags.json.empty()) return within ? 0 : 1;
    const nlohmann::ordered_json head = {{"benchmark", "features"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"rounds", flags.rounds},
                                         {"steps", flags.steps}};
    return write_result(flags.json, head, rows) && within ? 0 : 1;
}

}  // namespace

void add_features(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("features", "Measure the cost of idle features in a world");
    const auto flags = std::make_shared<Flags>();
    std::vector<std::string> names;
    for (const Feature& feature : features) names.push_back(feature.name);
    command
        ->add_option("--feature", flags->only, "Measure features by name; see below [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::IsMember(names).description(""));
    command
        ->add_option("--rounds", flags->rounds,
                     "Create and step both worlds N times [default: 40; 2 to 100000]")
        ->type_name("N")
        ->check(CLI::Range(2, 100000).description(""));
    command->add_option("--steps", flags->steps, "Steps per round [default: 60; 1 to 10000]")
        ->type_name("N")
        ->check(CLI::Range(1, 10000).description(""));
    command
        ->add_option("--max-percent", flags->max_percent,
                     "Fail if a feature costs more [0 to 1000; 0: no limit]")
        ->type_name("PERCENT")
        ->check(CLI::Range(0.0, 1000.0).description(""));
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    command->footer(footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench

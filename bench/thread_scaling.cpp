// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "bench/speed/engine_kinds.h"
#include "bench/speed/speed_scenes.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
One world per number of threads; the worlds step in turn, in an order that rotates from step to
step, so that other load on the machine affects all of them equally. Each round creates the worlds
again and repeats the same work; the shortest wall-clock time of a step over all rounds is its
undisturbed time. The table contains the mean of these times, and its ratio to that of the first
number of threads. At the end all worlds must be bit-identical.

Examples:
  jostle-bench threads --scene a,c,e
  jostle-bench threads --threads 1,2,4,8 --rounds 5 --json threads.json
  jostle-bench threads --max-ratio 1.01

Exit status: 0 success, 1 worlds differ, a ratio exceeds --max-ratio, or the file could not be
written, 2 invalid flags.)";

struct Flags {
    std::vector<std::string> scenes = {"all"};
    std::vector<int> threads = {1, 2};
    int rounds = 3, steps = 0;  // 0: the scene's default
    double max_ratio = 0;       // 0: no limit
    std::string json;
};

// A step of a sleeping world takes less time than reading the clock.
constexpr int steps_per_reading_asleep = 100;
constexpr int sleep_steps_max = 600;

// The world of a scene, with the scene's number of threads at the time of construction.
class TimedWorld {
public:
    TimedWorld(const SpeedScene& speed_scene, const scenes::SceneDescription& scene)
        : scene_(scene),
          asleep_first_(speed_scene.asleep_first),
          player_(player_of(speed_scene, scene)),
          engine_(engine_kinds().front().make()) {
        const auto status = engine_->init(scene);
        if (!status) throw std::runtime_error(status.error().message);
        if (!asleep_first_) return;
        for (int k = 0; k < sleep_steps_max && engine_->awake() > 0; k++) engine_->step();
    }

    double time_step(int step) {
        if (player_) {
            physics::Vec3 velocity = player_velocity(step * (1 / scene_.hz));
            velocity.y = engine_->velocity(*player_).y;
            engine_->set_velocity(*player_, velocity);
        }
        const int count = asleep_first_ ? steps_per_reading_asleep : 1;
        const double began = wall_seconds();
        for (int k = 0; k < count; k++) engine_->step();
        return (wall_seconds() - began) / count;
    }

    bool same_as(const TimedWorld& other) const {
        for (std::uint32_t k = 0; k < scene_.bodies.size(); k++)
            if (engine_->pose(k) != other.engine_->pose(k)) return false;
        return true;
    }

private:
    const scenes::SceneDescription& scene_;
    bool asleep_first_;
    std::optional<std::uint32_t> player_;
    std::unique_ptr<Engine> engine_;
};

struct Row {
    const SpeedScene* scene;
    int steps = 0;
    std::vector<double> ms;  // by number of threads
    bool same = true;
};

Row measure(const SpeedScene& speed_scene, const Flags& flags) {
    scenes::SceneDescription scene = build(speed_scene);
    scene.world.sleeping = speed_scene.asleep_first;
    Row row{.scene = &speed_scene, .steps = flags.steps > 0 ? flags.steps : speed_scene.steps};
    const std::size_t count = flags.threads.size();
    std::vector<std::vector<double>> least(
        count, std::vector<double>(static_cast<std::size_t>(row.steps), 1e300));
    for (int round = 0; round < flags.rounds; round++) {
        std::vector<TimedWorld> all;
        for (const int threads : flags.threads) {
            scene.world.threads = threads;
            all.emplace_back(speed_scene, scene);
        }
        for (int step = 0; step < row.steps; step++) {
            if (step % 20 == 0)
                show_progress(std::string(speed_scene.letter) + " " + speed_scene.name +
                              ", round " + std::to_string(round + 1) + ", step " +
                              std::to_string(step));
            for (std::size_t k = 0; k < count; k++) {
                const std::size_t turn = (k + static_cast<std::size_t>(step + round)) % count;
                double& ms = least[turn][static_cast<std::size_t>(step)];
                ms = std::min(ms, 1e3 * all[turn].time_step(step));
            }
        }
        for (const TimedWorld& one : all) row.same = row.same && one.same_as(all.front());
    }
    show_progress("");
    for (const std::vector<double>& steps : least)
        row.ms.push_back(std::accumulate(steps.begin(), steps.end(), 0.0) / row.steps);
    return row;
}

void print_row(const Row& row) {
    std::printf("%s  %-20s", row.scene->letter, row.scene->name);
    for (const double ms : row.ms) std::printf(" %10.5f (%.3f)", ms, ms / row.ms.front());
    std::printf("\n");
    std::fflush(stdout);
}

// Reports errors on stderr.
bool is_right(const Row& row, const Flags& flags) {
    const std::string name = std::string(row.scene->letter) + " " + row.scene->name;
    if (!row.same)
        std::fprintf(stderr, "jostle-bench: %s: the worlds differ at the end\n", name.c_str());
    bool within = true;
    for (std::size_t k = 1; k < row.ms.size(); k++) {
        const double share = row.ms[k] / row.ms.front();
        if (flags.max_ratio <= 0 || share <= flags.max_ratio) continue;
        within = false;
        std::fprintf(stderr,
                     "jostle-bench: %s: with %d threads a step takes %.3f of the time; must be at "
                     "most %.3f\n",
                     name.c_str(), flags.threads[k], share, flags.max_ratio);
    }
    return row.same && within;
}

std::string check_scene(const std::string& name) {
    if (name == "all" || find_speed_scene(name)) return "";
    return "unknown scene " + name + "; 'jostle-bench speed --help' lists the scenes";
}

bool is_chosen(const SpeedScene& scene, const Flags& flags) {
    return std::any_of(flags.scenes.begin(), flags.scenes.end(), [&](const std::string& name) {
        return name == "all" || find_speed_scene(name) == &scene;
    });
}

int run(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    std::printf("%-23s", "scene");
    for (const int threads : flags.threads)
        std::printf(" %5d thread%s ms  ", threads, threads == 1 ? " " : "s");
    std::printf("\n");
    bool right = true;
    for (const SpeedScene& scene : speed_scenes()) {
        if (!is_chosen(scene, flags)) continue;
        const Row row = measure(scene, flags);
        print_row(row);
        right = is_right(row, flags) && right;
        for (std::size_t k = 0; k < row.ms.size(); k++)
            rows.push_back({{"scene", scene.letter},
                            {"name", scene.name},
                            {"threads", flags.threads[k]},
                            {"steps", row.steps},
                            {"ms_mean", rounded(row.ms[k])},
                            {"share", rounded(row.ms[k] / row.ms.front())}});
    }
    if (flags.json.empty()) return right ? 0 : 1;
    const nlohmann::ordered_json head = {{"benchmark", "threads"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"rounds", flags.rounds}};
    return write_result(flags.json, head, rows) && right ? 0 : 1;
}

}  // namespace

void add_threads(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "threads", "Measure the effect of threads on step times, on the scenes of 'speed'");
    const auto flags = std::make_shared<Flags>();
    command
        ->add_option("--scene", flags->scenes,
                     "Run scenes by letter or name, or all [default: all]")
        ->type_name("NAME")
        ->delimiter(',')
        ->check(CLI::Validator(check_scene, ""));
    command
        ->add_option("--threads", flags->threads,
                     "Numbers of threads; the first is the reference\n[default: 1,2; 1 to 64]")
        ->type_name("N")
        ->delimiter(',')
        ->check(CLI::Range(1, 64).description(""));
    command
        ->add_option("--rounds", flags->rounds,
                     "Repeat N times; use the shortest time of each step\n"
                     "[default: 3; 1 to 1000]")
        ->type_name("N")
        ->check(CLI::Range(1, 1000).description(""));
    command
        ->add_option("--steps", flags->steps,
                     "Steps per round [default: those of the scene; 1 to 1000000]")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000).description(""));
    command
        ->add_option("--max-ratio", flags->max_ratio,
                     "Fail if a ratio is larger [0 to 1000; 0: no limit]")
        ->type_name("RATIO")
        ->check(CLI::Range(0.0, 1000.0).description(""));
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    command->footer(footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench

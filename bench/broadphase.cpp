// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/broadphase/kd_tree.h"
#include "bench/broadphase/loose_octree.h"
#include "bench/broadphase_workload.h"
#include "bench/measure.h"
#include "bench/result_file.h"
#include "physics/src/collision/broadphase/broad_phase.h"

namespace jostle::bench {
namespace {

using physics::BroadPhase;
using physics::BroadPhaseIndex;

template <BroadPhase kind>
std::unique_ptr<BroadPhaseIndex> of_world() {
    return physics::make_broad_phase(kind);
}
template <class Index>
std::unique_ptr<BroadPhaseIndex> of_bench() {
    return std::make_unique<Index>();
}
const std::map<std::string, std::unique_ptr<BroadPhaseIndex> (*)()> kind_names = {
    {"tree", of_world<BroadPhase::dynamic_tree>},
    {"sweep", of_world<BroadPhase::sort_and_sweep>},
    {"grid", of_world<BroadPhase::uniform_grid>},
    {"octree", of_bench<LooseOctree>},
    {"kdtree", of_bench<KdTree>}};
const std::map<std::string, Arrangement> arrangement_names = {
    {"pile", Arrangement::pile}, {"flat", Arrangement::flat}, {"sizes", Arrangement::sizes}};
const std::map<std::string, Moving> moving_names = {
    {"all", Moving::all}, {"few", Moving::few}, {"none", Moving::none}};

constexpr const char* footer = R"(
A broad phase finds the boxes that overlap. A world stores a fat box for each body and updates the
broad phase only when a body leaves its fat box. One step of this benchmark: move_all() of the
changed fat boxes, flush(), and a query() for each moved body; every pair is counted once. Bodies
move straight at 0.5 to 3 m/s, at 60 steps per second. All kinds replay the same recorded moves in
turn, from a copy of the same initial state.

Arrangements:  pile   a cube filled to 60 %, sides of 0.8 to 1.2 m
               flat   one layer along x and z, 2 m apart, sides of 0.8 to 1.2 m
               sizes  a cube filled to 60 %, sides of 0.1 to 10 m
Moving:        all, few (1 in 100), none (no moves and no queries: the cost in an idle world)
Kinds:         tree (dynamic tree, the default of a world), sweep (sort and sweep along x), grid
               (uniform grid); octree (loose octree) and kdtree (k-d tree of space) exist for
               comparison only: worlds do not support them

Columns: moves (changed fat boxes per step), pairs (found per step), then for each kind microseconds
of one core per step and thousands of rays per second: medians over the repetitions, in CPU time of
the thread. A ray searches the nearest box. The JSON file also contains the smallest and the largest
repetition, and the build times.

Examples:
  jostle-bench broadphase
  jostle-bench broadphase --bodies 1000,10000 --arrangements flat --kinds tree,sweep

Exit status: 0 success, 1 the kinds returned different pairs or hits, or the file could not be
written, 2 invalid flags.)";

struct Flags {
    std::vector<std::uint32_t> bodies = {100, 1000, 10000, 100000};
    std::vector<std::string> kinds = {"tree", "sweep", "grid", "octree", "kdtree"};
    std::vector<std::string> arrangements = {"pile", "flat", "sizes"};
    std::vector<std::string> moving = {"all", "few", "none"};
    int repetitions = 5;
    std::string json;
};

// Results of the queries, to compare the kinds. The kinds return pairs in different orders, so
// pairs are added up.
struct QueryCounts {
    std::size_t pairs = 0;
    // of the hashes of the pairs; detects different pairs in equal numbers
    std::uint64_t pair_sum = 0;
    std::size_t ray_hits = 0;
    double ray_sum = 0;  // of the hit fractions, in ray order: equal hits give equal bits

    bool operator==(const QueryCounts&) const = default;
};

std::uint64_t pair_hash(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
    const std::uint64_t mixed = key * 0x9e3779b97f4a7c15ull;
    return mixed ^ (mixed >> 29);
}

// One kind in one cell of the table.
struct Candidate {
    std::string name;
    // as built; each repetition replays the steps on a copy
    std::unique_ptr<BroadPhaseIndex> start;
    std::vector<std::int32_t> handles;  // by body
    std::vector<double> build_ms, step_us, rays_per_second;
    QueryCounts query_counts;
};

struct Cell {
    std::string arrangement, moving;
    std::uint32_t bodies = 0;
};

void build(Candidate& candidate, const Workload& work) {
    const double began = cpu_seconds();
    auto index = kind_names.at(candidate.name)();
    candidate.handles.clear();
    for (std::uint32_t body = 0; body < work.fat.size(); body++)
        candidate.handles.push_back(index->insert(work.fat[body], body, 1));
    index->flush();
    candidate.build_ms.push_back(1e3 * (cpu_seconds() - began));
    candidate.start = std::move(index);
}

// A pair of two moved bodies is found from both sides; it is counted from the side with the larger
// number.
void count_pairs(QueryCounts& query_counts, std::uint32_t body,
                 const std::vector<std::uint32_t>& found,
                 const std::vector<std::uint32_t>& moved_in, std::uint32_t step) {
    for (const std::uint32_t other : found) {
        if (other == body || (moved_in[other] == step && other > body)) continue;
        query_counts.pairs++;
        query_counts.pair_sum += pair_hash(body, other);
    }
}

QueryCounts replay_steps(BroadPhaseIndex& index, const Candidate& candidate, const Workload& work,
                         std::vector<std::uint32_t>& found, std::vector<std::uint32_t>& moved_in) {
    QueryCounts query_counts;
    std::uint32_t step = 0;
    std::vector<BroadPhaseIndex::Move> left;
    for (const auto& moves : work.steps) {
        step++;
        left.clear();
        for (const Move& move : moves) {
            left.push_back({candidate.handles[move.body], move.fat});
            moved_in[move.body] = step;
        }
        index.move_all(left);
        index.flush();
        for (const Move& move : moves) {
            found.clear();
            index.query(move.fat, 1, found);
            count_pairs(query_counts, move.body, found, moved_in, step);
        }
    }
    return query_counts;
}

void cast_rays(const BroadPhaseIndex& index, const Workload& work, QueryCounts& query_counts) {
    for (const BoxRay& ray : work.rays) {
        double nearest = 2;
        index.cast_ray(ray.origin, ray.motion, 1, [&](std::uint32_t body, double limit) {
            const double at = physics::ray_enters(work.tight[body], ray.origin, ray.motion, limit);
            if (at > limit) return limit;
            return nearest = at;
        });
        if (nearest > 1) continue;
        query_counts.ray_hits++;
        query_counts.ray_sum += nearest;
    }
}

void repeat_once(Candidate& candidate, const Workload& work) {
    build(candidate, work);
    const auto index = candidate.start->clone();
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> moved_in(work.fat.size(), 0);
    const double began = cpu_seconds();
    QueryCounts query_counts = replay_steps(*index, candidate, work, found, moved_in);
    const double stepped = cpu_seconds();
    cast_rays(*index, work, query_counts);
    const double cast = cpu_seconds();
    candidate.step_us.push_back(1e6 * (stepped - began) / static_cast<double>(work.steps.size()));
    candidate.rays_per_second.push_back(static_cast<double>(work.rays.size()) / (cast - stepped));
    candidate.query_counts = query_counts;
}

// The kinds take turns, so that other load on the machine affects all of them equally.
bool measure_cell(const Cell& cell, const Workload& work, std::vector<Candidate>& candidates,
                  int repetitions) {
    for (int k = 0; k < repetitions; k++)
        for (Candidate& candidate : candidates) {
            show_progress(cell.arrangement + ", " + std::to_string(cell.bodies) +
                          " bodies, moving " + cell.moving + ": " + candidate.name +
                          ", repetition " + std::to_string(k + 1) + " of " +
                          std::to_string(repetitions));
            repeat_once(candidate, work);
        }
    show_progress("");
    bool same = true;
    for (const Candidate& c : candidates)
        same = same && c.query_counts == candidates[0].query_counts;
    if (same) return true;
    std::fprintf(stderr,
                 "jostle-bench: %s, %u bodies, moving %s: the kinds return different results\n",
                 cell.arrangement.c_str(), cell.bodies, cell.moving.c_str());
    for (const Candidate& c : candidates)
        std::fprintf(stderr, "  %-6s %zu pairs (sum %016llx), %zu rays hit (sum %.17g)\n",
                     c.name.c_str(), c.query_counts.pairs,
                     static_cast<unsigned long long>(c.query_counts.pair_sum),
                     c.query_counts.ray_hits, c.query_counts.ray_sum);
    return false;
}

void print_head(const Flags& flags) {
    std::printf("%-11s %7s %6s %8s %8s", "arrangement", "bodies", "moving", "moves", "pairs");
    for (const std::string& kind : flags.kinds) std::printf(" %9s us", kind.c_str());
    for (const std::string& kind : flags.kinds) std::printf(" %7s k/s", kind.c_str());
    std::printf("\n");
}

void print_row(const Cell& cell, const Workload& work, const std::vector<Candidate>& candidates) {
    const auto steps = static_cast<double>(work.steps.size());
    std::printf("%-11s %7u %6s %8.1f %8.1f", cell.arrangement.c_str(), cell.bodies,
                cell.moving.c_str(), static_cast<double>(work.moves) / steps,
                static_cast<double>(candidates[0].query_counts.pairs) / steps);
    for (const Candidate& c : candidates) std::printf(" %12.3f", spread_of(c.step_us).median);
    for (const Candidate& c : candidates)
        std::printf(" %11.1f", 1e-3 * spread_of(c.rays_per_second).median);
    std::printf("\n");
    std::fflush(stdout);
}

nlohmann::ordered_json to_json(const Spread& s) {
    return {{"median", rounded(s.median)}, {"low", rounded(s.low)}, {"high", rounded(s.high)}};
}

void add_rows(nlohmann::ordered_json& rows, const Cell& cell, const Workload& work,
              const std::vector<Candidate>& candidates) {
    const auto steps = static_cast<double>(work.steps.size());
    for (const Candidate& c : candidates)
        rows.push_back({{"arrangement", cell.arrangement},
                        {"bodies", cell.bodies},
                        {"moving", cell.moving},
                        {"kind", c.name},
                        {"steps", work.steps.size()},
                        {"moves_per_step", rounded(static_cast<double>(work.moves) / steps)},
                        {"pairs", c.query_counts.pairs},
                        {"rays", work.rays.size()},
                        {"ray_hits", c.query_counts.ray_hits},
                        {"step_us", to_json(spread_of(c.step_us))},
                        {"rays_per_second", to_json(spread_of(c.rays_per_second))},
                        {"build_ms", to_json(spread_of(c.build_ms))}});
}

int write_json(const Flags& flags, const nlohmann::ordered_json& rows) {
    if (flags.json.empty()) return 0;
    const nlohmann::ordered_json head = {{"benchmark", "broadphase"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"repetitions", flags.repetitions}};
    return write_result(flags.json, head, rows) ? 0 : 1;
}

int run(const Flags& flags) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    print_head(flags);
    for (const std::string& arrangement : flags.arrangements)
        for (const std::uint32_t bodies : flags.bodies)
            for (const std::string& moving : flags.moving) {
                const Cell cell{arrangement, moving, bodies};
                const Workload work = generate_workload(arrangement_names.at(arrangement),
                                                        moving_names.at(moving), bodies);
                std::vector<Candidate> candidates;
                for (const std::string& kind : flags.kinds)
                    candidates.push_back(Candidate{.name = kind});
                if (!measure_cell(cell, work, candidates, flags.repetitions)) return 1;
                print_row(cell, work, candidates);
                add_rows(rows, cell, work, candidates);
            }
    return write_json(flags, rows);
}

template <class Value>
CLI::IsMember one_of(const std::map<std::string, Value>& contains) {
    std::vector<std::string> keys;
    for (const auto& [name, value] : contains) keys.push_back(name);
    return CLI::IsMember(keys);
}

}  // namespace

void add_broadphase(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "broadphase", "Compare broad phases by time per step and rays per second");
    const auto flags = std::make_shared<Flags>();
    const auto list = [&](const char* name, auto& values, const char* meaning) {
        return command->add_option(name, values, meaning)->delimiter(',');
    };
    list("--bodies", flags->bodies,
         "Numbers of bodies [default: 100,1000,10000,100000;\n1 to 1000000]")
        ->type_name("N")
        ->check(CLI::Range(1u, 1000000u).description(""));
    list("--arrangements", flags->arrangements, "Arrangements [default: pile,flat,sizes]")
        ->type_name("NAME")
        ->check(one_of(arrangement_names).description(""));
    list("--moving", flags->moving, "Shares of moving bodies [default: all,few,none]")
        ->type_name("NAME")
        ->check(one_of(moving_names).description(""));
    list("--kinds", flags->kinds, "Broad phases [default: tree,sweep,grid,octree,kdtree]")
        ->type_name("NAME")
        ->check(one_of(kind_names).description(""));
    command
        ->add_option("--repetitions", flags->repetitions,
                     "Repeat N times; show the median [default: 5; 1 to 1000]")
        ->type_name("N")
        ->check(CLI::Range(1, 1000).description(""));
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    command->footer(footer);
    command->callback([flags, &status] { status = run(*flags); });
}

}  // namespace jostle::bench

// SPDX-License-Identifier: MIT
#include "tools/sim/report.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "jostle/base/format_text.h"

namespace jostle::sim {
namespace {

using physics::IslandSubsteps;

constexpr std::size_t shown_islands = 8;

struct SubstepTotal {
    int islands = 0, bodies = 0, contacts = 0, joints = 0, direct = 0, short_of = 0;
    double error = 0;
};

std::map<int, SubstepTotal> totals_by_substeps(const std::vector<IslandSubsteps>& island_substeps) {
    std::map<int, SubstepTotal> sums;
    for (const IslandSubsteps& e : island_substeps) {
        SubstepTotal& sum = sums[e.substeps];
        sum.islands++;
        sum.bodies += e.bodies;
        sum.contacts += e.contacts;
        sum.joints += e.joints;
        sum.direct += e.direct ? 1 : 0;
        sum.short_of += e.target_substeps > e.substeps ? 1 : 0;
        sum.error = std::max(sum.error, e.error);
    }
    return sums;
}

}  // namespace

std::string to_text(const std::vector<IslandSubsteps>& island_substeps) {
    if (island_substeps.empty())
        return "islands by sub-steps: no awake island has contacts or joints\n";
    std::string out =
        "islands by sub-steps; error: maximum, m after one second; short: islands limited by the "
        "budget\n"
        "  sub-steps islands  bodies contacts  joints  direct   short    error\n";
    for (const auto& [substeps, s] : totals_by_substeps(island_substeps))
        out += format_text("  %9d %7d %7d %8d %7d %7d %7d %8.2g\n", substeps, s.islands, s.bodies,
                           s.contacts, s.joints, s.direct, s.short_of, s.error);
    std::vector<IslandSubsteps> worst = island_substeps;
    std::stable_sort(
        worst.begin(), worst.end(),
        [](const IslandSubsteps& x, const IslandSubsteps& y) { return x.error > y.error; });
    worst.resize(std::min(worst.size(), shown_islands));
    if (worst.front().error == 0) return out;
    out += "largest errors:\n";
    for (const IslandSubsteps& e : worst)
        out += format_text("  body %u with %d others: %.2g m, %d sub-steps%s\n", e.body.index,
                           e.bodies - 1, e.error, e.substeps,
                           e.target_substeps > e.substeps ? ", limited by the budget" : "");
    return out;
}

std::string to_json(const std::vector<IslandSubsteps>& island_substeps) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const IslandSubsteps& e : island_substeps)
        all.push_back({{"body", e.body.index},
                       {"bodies", e.bodies},
                       {"contacts", e.contacts},
                       {"joints", e.joints},
                       {"direct", e.direct},
                       {"substeps", e.substeps},
                       {"target_substeps", e.target_substeps},
                       {"error_m", e.error}});
    return all.dump(2) + "\n";
}

}  // namespace jostle::sim

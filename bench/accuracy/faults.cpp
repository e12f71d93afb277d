// SPDX-License-Identifier: MIT
#include "bench/accuracy/faults.h"

#include <algorithm>
#include <istream>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/flag_selection.h"
#include "bench/result_file.h"
#include "jostle/base/format_text.h"

namespace jostle::bench::accuracy {
namespace {

constexpr double failed_ratio = 1e9;

std::vector<const Row*> rows_by_rate(const std::vector<Row>& rows, const Experiment& experiment,
                                     const std::string& mode) {
    std::vector<const Row*> chosen;
    for (const Row& row : rows)
        if (row.scene == experiment.name && row.mode == mode && row.unsupported.empty() &&
            row.engine == engine_kinds()[0].name)
            chosen.push_back(&row);
    std::sort(chosen.begin(), chosen.end(),
              [](const Row* a, const Row* b) { return a->rate_hz < b->rate_hz; });
    return chosen;
}

void add_worse(std::vector<Fault>& faults, Fault fault) {
    for (Fault& other : faults)
        if (other.scene == fault.scene && other.mode == fault.mode && other.rule == fault.rule) {
            if (fault.ratio > other.ratio) other = std::move(fault);
            return;
        }
    faults.push_back(std::move(fault));
}

void check_finer(const std::vector<const Row*>& rows, const Experiment& experiment,
                 std::vector<Fault>& faults) {
    const Row* best = nullptr;
    for (const Row* row : rows) {
        const double allowed = best ? std::max(best->error, experiment.floor()) : 0;
        if (best && !row->usable())
            add_worse(faults, {row->scene, row->mode, "finer", failed_ratio,
                               format_text("%s at %g Hz, but not at %g Hz", row->failed.c_str(),
                                           row->rate_hz, best->rate_hz)});
        else if (best && row->error > worse_ratio * allowed)
            add_worse(faults, {row->scene, row->mode, "finer", row->error / allowed,
                               format_text("error %.3g at %g Hz, %.3g at %g Hz", row->error,
                                           row->rate_hz, best->error, best->rate_hz)});
        if (row->usable() && (!best || row->error < best->error)) best = row;
    }
}

void check_limit(const Row& row, double error, double limit, const char* rule,
                 std::vector<Fault>& faults) {
    if (limit <= 0) return;
    if (!row.usable())
        add_worse(faults, {row.scene, row.mode, rule, failed_ratio,
                           format_text("%s at %g Hz", row.failed.c_str(), row.rate_hz)});
    else if (error > limit)
        add_worse(faults,
                  {row.scene, row.mode, rule, error / limit,
                   format_text("error %.3g at %g Hz, limit %g", error, row.rate_hz, limit)});
}

bool is_member(const std::string& scene, const std::string& family) {
    const Experiment* experiment = find_experiment(scene);
    return experiment && experiment->family == family;
}

// A known fault of a family covers all of its members.
bool same(const Fault& fault, const KnownFault& known) {
    return (fault.scene == known.scene || is_member(fault.scene, known.scene)) &&
           fault.mode == known.mode && fault.rule == known.rule;
}

bool ran(const KnownFault& known, const std::vector<const Experiment*>& experiments) {
    return std::any_of(experiments.begin(), experiments.end(), [&](const Experiment* e) {
        return e->name == known.scene || e->family == known.scene;
    });
}

// The worst fault that this known one covers; null: none.
const Fault* worst_of(const std::vector<Fault>& faults, const KnownFault& known) {
    const Fault* worst = nullptr;
    for (const Fault& fault : faults)
        if (same(fault, known) && (!worst || fault.ratio > worst->ratio)) worst = &fault;
    return worst;
}

std::string where(const std::string& scene, const std::string& mode, const std::string& rule) {
    return scene + (mode == engine_kinds()[0].modes[0] ? "" : " " + mode) + ", " + rule;
}

// The values of a member of a family, which a reader needs to reproduce it.
std::string parameters_of(const std::string& scene) {
    const Experiment* experiment = find_experiment(scene);
    if (!experiment || experiment->family.empty()) return "";
    return "; " + experiment->about.substr(experiment->about.find(": ") + 2);
}

std::string times(double ratio) {
    return ratio == failed_ratio ? "" : format_text(" (%.2f times)", ratio);
}

}  // namespace

std::vector<Fault> faults_of(const std::vector<Row>& rows,
                             const std::vector<const Experiment*>& experiments) {
    const EngineKind& jostle = engine_kinds()[0];
    std::vector<Fault> faults;
    for (const Experiment* experiment : experiments)
        for (const std::string& mode : jostle.modes) {
            const std::vector<const Row*> chosen = rows_by_rate(rows, *experiment, mode);
            // A world with a tolerance takes fewer sub-steps at a finer rate.
            if (!mode.starts_with("tol")) check_finer(chosen, *experiment, faults);
            if (mode != jostle.modes[0]) continue;
            for (const Row* row : chosen) {
                if (row->rate_hz < experiment->limit_from_hz) continue;
                check_limit(*row, row->error, experiment->limit, "limit", faults);
                check_limit(*row, row->second_error, experiment->second_limit, "second limit",
                            faults);
            }
        }
    return faults;
}

std::vector<KnownFault> known_faults_from(std::istream& in) {
    std::vector<KnownFault> known;
    const auto json = nlohmann::ordered_json::parse(in);
    for (const auto& row : json.at("rows"))
        known.push_back({.scene = row.at("scene"),
                         .mode = row.value("mode", engine_kinds()[0].modes[0]),
                         .rule = row.at("rule"),
                         .ratio = row.at("ratio"),
                         .cause = row.at("cause")});
    return known;
}

nlohmann::ordered_json to_json(const std::vector<KnownFault>& known) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const KnownFault& fault : known) {
        nlohmann::ordered_json row = {{"scene", fault.scene}};
        if (fault.mode != engine_kinds()[0].modes[0]) row["mode"] = fault.mode;
        row["rule"] = fault.rule;
        row["ratio"] = rounded(fault.ratio);
        row["cause"] = fault.cause;
        rows.push_back(row);
    }
    return rows;
}

std::vector<KnownFault> updated(const std::vector<KnownFault>& known,
                                const std::vector<Fault>& faults,
                                const std::vector<const Experiment*>& experiments) {
    std::vector<KnownFault> after;
    for (KnownFault other : known) {
        const Fault* found = worst_of(faults, other);
        if (!found && ran(other, experiments)) continue;
        // The ratio of a family also covers members that did not run.
        if (found && found->scene == other.scene) other.ratio = found->ratio;
        after.push_back(other);
    }
    return after;
}

JudgedFaults judge(const std::vector<Fault>& faults, const std::vector<KnownFault>& known,
                   const std::vector<const Experiment*>& experiments) {
    JudgedFaults judged;
    for (const Fault& fault : faults) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const KnownFault& other) {
            return same(fault, other) && fault.ratio <= other.ratio * worse_ratio;
        });
        if (found == known.end())
            judged.failures.push_back(fault);
        else
            judged.explained.push_back({fault, found->cause});
    }
    for (const KnownFault& other : known)
        if (ran(other, experiments) && !worst_of(faults, other)) judged.obsolete.push_back(other);
    return judged;
}

std::string to_text(const JudgedFaults& judged) {
    std::string text;
    for (const Fault& fault : judged.failures)
        text += "FAULT: " + where(fault.scene, fault.mode, fault.rule) + ": " + fault.words +
                times(fault.ratio) + parameters_of(fault.scene) + "\n";
    for (const auto& [fault, cause] : judged.explained)
        text += "known: " + where(fault.scene, fault.mode, fault.rule) + ": " + fault.words +
                times(fault.ratio) + "; " + cause + "\n";
    for (const KnownFault& other : judged.obsolete)
        text += "obsolete: " + where(other.scene, other.mode, other.rule) +
                ": the rows no longer have this fault\n";
    return text;
}

}  // namespace jostle::bench::accuracy

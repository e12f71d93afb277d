// SPDX-License-Identifier: MIT
//
// Analysis of rows: orders of convergence, least work for an error, the Pareto set, and a score
// against the peers. Pure arithmetic; the tests use synthetic rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/accuracy/run_row.h"

namespace jostle::bench::accuracy {

// log(error / error at the higher rate) / log(higher rate / rate), for neighbouring rates of one
// scene, engine and mode.
struct Order {
    double from_hz = 0, to_hz = 0, order = 0;
};
std::vector<Order> observed_orders(const std::vector<Row>& rows, const std::string& scene,
                                   const std::string& engine, const std::string& mode);

// The row of the engine with the least CPU time whose error is at most the tolerance.
std::optional<Row> least_work(const std::vector<Row>& rows, const std::string& scene,
                              const std::string& engine, double tolerance);

// Pareto-optimal rows of the scene in time and error, the cheapest first.
std::vector<Row> pareto_set(const std::vector<Row>& rows, const std::string& scene);

// Least work of the best peer divided by that of Jostle, at one tolerance. 0.01 if only a peer
// reaches it, 100 if only Jostle does.
struct Comparison {
    std::string scene;
    double tolerance = 0;
    std::optional<Row> ours, best_peer;  // at least one is present
    double ratio = 1;
};
struct Score {
    std::vector<Comparison> comparisons;
    double mean = 1;  // geometric mean of the ratios
    // The comparisons in which both sides reach the tolerance, whose ratios are measured.
    int both_count = 0;
    double both_mean = 1;
};
// Scenes and tolerances that no engine reaches, or that no peer has rows for, are omitted. The
// members of families have a score of their own.
enum class Scope { fixed, families };
Score score_of(const std::vector<Row>& rows, const std::string& us, Scope scope = Scope::fixed);

}  // namespace jostle::bench::accuracy

// SPDX-License-Identifier: MIT
//
// What rows say together: orders of convergence, the least work for an error, the rows that no
// other beats, and one score against the peers. Arithmetic alone; tests make up the rows.
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

// Rows of the scene that no other row beats in time and error at once, the cheapest first.
std::vector<Row> pareto_set(const std::vector<Row>& rows, const std::string& scene);

// Least work of the best peer over ours, at one tolerance. 0.01 where only a peer reaches it, 100
// where only we do.
struct Comparison {
    std::string scene;
    double tolerance = 0;
    std::optional<Row> ours, best_peer;  // not both absent
    double ratio = 1;
};
struct Score {
    std::vector<Comparison> comparisons;
    double mean = 1;  // geometric, of the ratios
};
// Scenes and tolerances that nobody reaches, or that no peer has rows for, are left out.
Score score_of(const std::vector<Row>& rows, const std::string& us);

}  // namespace jostle::bench::accuracy

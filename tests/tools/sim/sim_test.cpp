// SPDX-License-Identifier: MIT
//
// The program as a child process: checks its output files.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "jostle/physics/physics.h"
#include "tests/tools/sim/sim_program.h"

namespace {

using jostle::test::Sim;
namespace physics = jostle::physics;

TEST_F(Sim, reports_every_documented_value) {
    ASSERT_EQ(run("stack --seconds 3 --json " + file("r.json")), 0) << output();
    const auto json = report();
    for (const char* key :
         {"steps", "bodies", "contacts", "ms_per_step_mean", "ms_per_step_p99", "state_hash",
          "energy_joules", "max_penetration_m", "awake_bodies", "stages", "worst_step",
          "work_per_step_mean", "work_per_step_worst", "steps_at_overload_level"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["steps"], 180);
    EXPECT_GE(json["worst_step"]["step"], 2);
    EXPECT_GT(json["worst_step"]["stage_ms"], 0);
    EXPECT_GE(json["worst_step"]["ms"], json["worst_step"]["stage_ms"]);
    EXPECT_EQ(json["stages"].count(json["worst_step"]["stage"].get<std::string>()), 1u);
    EXPECT_EQ(json["steps_at_overload_level"], nlohmann::json({180, 0, 0, 0}));
    EXPECT_EQ(json["bodies"], 11);
    EXPECT_EQ(json["contacts"], 10);
    EXPECT_EQ(json["awake_bodies"], 0);
    EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16u);
    EXPECT_EQ(json["arithmetic"], physics::arithmetic_name(physics::arithmetic()));
    // Ten boxes of 1000 kg each, centres at 0.5 to 9.5 m: m g h = 1000 * 9.81 * 50 J.
    EXPECT_NEAR(json["energy_joules"].get<double>(), 490500, 500);
}

TEST_F(Sim, hash_is_identical_with_one_two_and_four_threads) {
    std::string hashes[3];
    const int threads[3] = {1, 2, 4};
    for (int i = 0; i < 3; i++) {
        ASSERT_EQ(run("pyramid --seconds 1 --threads " + std::to_string(threads[i]) + " --json " +
                      file("r.json")),
                  0);
        hashes[i] = report()["state_hash"];
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST_F(Sim, hash_is_identical_with_every_instruction_set) {
    std::string first;
    for (const physics::InstructionSet set : physics::available_instruction_sets()) {
        const std::string name = physics::instruction_set_name(set);
        ASSERT_EQ(run("pyramid --seconds 0.1 --instructions " + name + " --json " + file("r.json")),
                  0);
        EXPECT_EQ(report()["instructions"], name);
        const std::string hash = report()["state_hash"];
        if (first.empty()) first = hash;
        EXPECT_EQ(hash, first) << name;
    }
    EXPECT_EQ(run("pyramid --instructions abacus"), 2);
    EXPECT_NE(output().find("abacus is not one of scalar"), std::string::npos) << output();
}

TEST_F(Sim, reports_substeps_per_island) {
    ASSERT_EQ(run("machines --seconds 1 --error-tolerance 1e-3 --substep-report " + file("e.json")),
              0)
        << output();
    const auto island_substeps = nlohmann::json::parse(read(file("e.json")));
    ASSERT_GE(island_substeps.size(), 4u) << "car, wheels, gears, lift, gimbal";
    for (const auto& island : island_substeps) {
        EXPECT_GT(island["error_m"].get<double>(), 0);
        EXPECT_GE(island["substeps"].get<int>(), 2);
        EXPECT_GT(island["joints"].get<int>() + island["contacts"].get<int>(), 0);
    }
    ASSERT_EQ(
        run("machines --seconds 1 --error-tolerance 1e-3 --substep-budget 100 --substep-report -"),
        0);
    EXPECT_NE(output().find("largest errors:"), std::string::npos) << output();
    EXPECT_NE(output().find("limited by the budget"), std::string::npos) << output();
    ASSERT_EQ(run("stack --seconds 3 --substep-report -"), 0);
    EXPECT_NE(output().find("no awake island has contacts or joints"), std::string::npos);
    EXPECT_EQ(run("machines --converge --error-tolerance 1e-3"), 2)
        << "a tolerance chooses the sub-steps";
    EXPECT_EQ(run("machines --seconds 1 --error-tolerance -1"), 2);
    EXPECT_NE(output().find("is not a number from 0 to 1000"), std::string::npos) << output();
}

// The chain of the scene swings; no number of sub-steps reaches a nanometre.
TEST_F(Sim, reports_whether_the_error_tolerance_was_reached) {
    ASSERT_EQ(run("machines --seconds 2 --error-tolerance 1 --json " + file("r.json")), 0);
    EXPECT_NE(output().find("error tolerance 1 m: kept"), std::string::npos) << output();
    EXPECT_EQ(report()["error_tolerance"]["islands_over"], 0);
    ASSERT_EQ(run("machines --seconds 2 --error-tolerance 1e-9 --json " + file("r.json")), 0);
    EXPECT_NE(output().find("error tolerance 1e-09 m: not kept: "), std::string::npos) << output();
    EXPECT_GE(report()["error_tolerance"]["islands_over"], 1);
    EXPECT_GT(report()["error_tolerance"]["worst_m"], 1e-9);
    ASSERT_EQ(run("free_space --seconds 0.1 --error-tolerance 1e-3"), 0);
    EXPECT_NE(output().find("not measured: no island has contacts or joints"), std::string::npos);
    ASSERT_EQ(run("machines --seconds 0.1 --json " + file("r.json")), 0);
    EXPECT_EQ(output().find("error tolerance"), std::string::npos);
    EXPECT_TRUE(report()["error_tolerance"].is_null());
}

TEST_F(Sim, traces_one_row_per_body_and_tick) {
    ASSERT_EQ(run("stack --seconds 0.1 --trace " + file("t.csv")), 0) << output();
    std::istringstream lines(read(file("t.csv")));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "tick,body,name,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz");
    int rows = 0;
    while (std::getline(lines, line)) rows++;
    EXPECT_EQ(rows, 7 * 10);  // the start and six ticks, ten boxes
}

TEST_F(Sim, continues_from_a_saved_world_bit_identically) {
    ASSERT_EQ(run("wall --seconds 2 --json " + file("r.json")), 0);
    const std::string straight = report()["state_hash"];
    ASSERT_EQ(run("wall --seconds 1 --save " + file("w.world")), 0);
    ASSERT_EQ(run("wall --seconds 1 --load " + file("w.world") + " --json " + file("r.json")), 0);
    EXPECT_EQ(report()["state_hash"], straight);
}

// The midpoint rule rotates free bodies: second order, for any number of sub-steps.
TEST_F(Sim, tumbling_plank_converges_with_second_order) {
    std::ofstream(file("plank.json")) << R"({ "name": "plank", "world": { "gravity": { "y": 0 } },
      "bodies": [ { "name": "plank", "angular_velocity": { "x": 3, "y": 0.1, "z": 0.1 },
          "may_sleep": false,
          "shapes": [ { "box": { "half_extents": { "x": 0.3, "y": 0.2, "z": 0.1 } } } ] } ] })";
    ASSERT_EQ(run(file("plank.json") +
                  " --converge --seconds 2 --rates 30,60,120,960,1920 --substep-counts 4,8 "
                  "--tolerance 0.01,0.1 --json " +
                  file("r.json")),
              0)
        << output();
    const auto json = report();
    EXPECT_EQ(json["verdict"], "agreed");
    EXPECT_EQ(json["bodies"], 1);
    EXPECT_EQ(json["scale_m"], 1);  // its centre does not move
    ASSERT_EQ(json["rows"].size(), 10u);
    for (const std::size_t k : {1u, 2u, 6u, 7u})
        EXPECT_NEAR(json["rows"][k]["order"].get<double>(), 2, 0.1) << output();
    EXPECT_TRUE(json["rows"][0]["order"].is_null());
    // The coarse tolerance is listed first and is not more expensive.
    const auto& cheapest = json["cheapest"];
    EXPECT_EQ(cheapest[0]["tolerance"], 0.1);
    EXPECT_LE(cheapest[0]["cpu_us_per_second"], cheapest[1]["cpu_us_per_second"]);
    EXPECT_NE(output().find("The two finest runs agree"), std::string::npos);
    EXPECT_NE(output().find("--hz 30"), std::string::npos) << output();
}

// Sub-steps do not affect a falling ball, so their times differ by noise alone.
TEST_F(Sim, convergence_prefers_the_fewest_sub_steps_of_equal_settings) {
    std::ofstream(file("ball.json")) << R"({ "name": "ball", "bodies": [
        { "name": "ball", "may_sleep": false, "linear_velocity": { "x": 3 },
          "shapes": [ { "sphere": { "radius": 0.1 } } ] } ] })";
    for (int k = 0; k < 3; k++) {
        ASSERT_EQ(run(file("ball.json") +
                      " --converge --seconds 2 --rates 30,60 --substep-counts 1,2,4,8,16 --json " +
                      file("r.json")),
                  0)
            << output();
        EXPECT_EQ(report()["cheapest"][0]["substeps"], 1) << output();
    }
    for (const auto& row : report()["rows"]) EXPECT_TRUE(row["worse_than_hz"].is_null());
}

// A rod of 1 m on a hinge, released horizontally.
TEST_F(Sim, pendulum_converges) {
    std::ofstream(file("pendulum.json")) << R"({ "name": "pendulum", "bodies": [
        { "name": "pivot", "type": "BODY_TYPE_STATIC",
          "shapes": [ { "sphere": { "radius": 0.05 }, "filter": { "mask": 0 } } ] },
        { "name": "rod", "position": { "x": 0.5 }, "may_sleep": false,
          "shapes": [ { "box": { "half_extents": { "x": 0.5, "y": 0.05, "z": 0.05 } } } ] } ],
      "joints": [ { "name": "hinge", "body_a": "pivot", "body_b": "rod", "hinge": {},
                    "frame": { "position": { "x": 0 } } } ] })";
    ASSERT_EQ(
        run(file("pendulum.json") +
            " --converge --seconds 2 --rates 30,60,120,960,1920 --substep-counts 4,8 --json " +
            file("r.json")),
        0)
        << output();
    const auto json = report();
    EXPECT_EQ(json["verdict"], "agreed");
    // The centre swings through half a circle with a radius of 0.5 m.
    EXPECT_NEAR(json["scale_m"].get<double>(), std::hypot(1, 0.5), 0.02);
    for (std::size_t k = 1; k < 3; k++) {
        const auto& finer = json["rows"][k];
        EXPECT_LT(finer["error"], json["rows"][k - 1]["error"]) << output();
        EXPECT_GT(finer["cpu_us_per_second"], json["rows"][k - 1]["cpu_us_per_second"]);
    }
    EXPECT_LT(json["rows"][1]["error"], 0.02);
    // At least first order: joints of a maximal-coordinate solver.
    EXPECT_GT(json["rows"][1]["order"].get<double>(), 0.7) << output();
}

TEST_F(Sim, reports_a_billiards_break_as_chaotic_with_agreement_time) {
    ASSERT_EQ(run("billiards --converge --seconds 4 --finest-hz 240 --substep-counts 4,8 --json " +
                  file("r.json")),
              0)
        << output();
    const auto json = report();
    EXPECT_EQ(json["verdict"], "chaotic");
    EXPECT_GT(json["perturbation_growth"].get<double>(), 100);
    EXPECT_GT(json["doubt"].get<double>(), 0.1);
    // The cue ball reaches the others after this time; afterwards the scene is chaotic.
    EXPECT_GT(json["agreement_s"].get<double>(), 0.1);
    EXPECT_LT(json["agreement_s"].get<double>(), 2);
    EXPECT_TRUE(json["cheapest"][0]["hz"].is_null());
    EXPECT_NE(output().find("The scene is chaotic"), std::string::npos);
}

TEST_F(Sim, skips_and_reports_runs_over_budget) {
    ASSERT_EQ(run("billiards --converge --seconds 4 --budget 0.1"), 0) << output();
    EXPECT_NE(output().find("Skipped because they would exceed --budget"), std::string::npos)
        << output();
}

TEST_F(Sim, rejects_invalid_convergence_options) {
    const auto refused = [&](const std::string& flags, const char* why) {
        EXPECT_EQ(run("stack " + flags), 2) << flags;
        EXPECT_NE(output().find(why), std::string::npos) << flags << ": " << output();
    };
    refused("--seconds nan", "nan is not a number from 0");
    refused("--converge --tolerance nan", "nan is not a number from");
    refused("--converge --tolerance 0", "0 is not a number from");
    refused("--converge --tolerance x", "x is not a number from");
    refused("--converge --scale -1", "-1 is not a number from");
    refused("--converge --budget inf", "inf is not a number from");
    refused("--converge --rates 60", "one rate cannot be compared");
    refused("--converge --rates 60,90", "90 Hz is not a multiple of 60 Hz");
    refused("--converge --rates 60,1e9", "1e9 is not a number from 4 to 10000");
    refused("--converge --substep-counts 0", "not in range");
    refused("--converge --seconds 0.001", "less than one step at 30 Hz");
    refused("--converge --finest-hz 40", "raise --finest-hz");
    refused("--converge --trace t.csv", "--trace");
    refused("--converge --threads 2", "--threads");
    refused("--tolerance 0.1", "--converge");
    std::ofstream(file("still.json"))
        << R"({"name": "still", "bodies": [{"name": "a", "type": "BODY_TYPE_STATIC", "shapes": [{"plane": {}}]}]})";
    EXPECT_EQ(run(file("still.json") + " --converge"), 2);
    EXPECT_NE(output().find("still has no dynamic body"), std::string::npos) << output();
    EXPECT_EQ(run("stack --converge --json /nowhere/r.json"), 1);
    EXPECT_NE(output().find("cannot write /nowhere/r.json"), std::string::npos);
}

TEST_F(Sim, exits_with_2_and_an_error_message_on_invalid_flags) {
    EXPECT_EQ(run("nowhere"), 2);
    EXPECT_NE(output().find("unknown scene \"nowhere\""), std::string::npos);
    EXPECT_EQ(run(""), 2);
    EXPECT_EQ(run("stack --substeps 99"), 2);
    std::ofstream(file("bad.json")) << "{\"name\": \"x\", \"bodies\": [{\"shape\": []}]}";
    EXPECT_EQ(run(file("bad.json")), 2);
    EXPECT_NE(output().find("bodies[0].shape: unknown field"), std::string::npos);
    EXPECT_EQ(run("stack --load " + file("bad.json")), 2);
}

}  // namespace

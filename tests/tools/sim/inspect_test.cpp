// SPDX-License-Identifier: MIT
//
// jostle-sim --inspect on scenes with known constraint systems.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/tools/sim/sim_program.h"

namespace {

using jostle::test::Sim;
using testing::HasSubstr;
using testing::StartsWith;

nlohmann::json method(const nlohmann::json& group, const std::string& name) {
    for (const auto& line : group["methods"])
        if (line["method"] == name) return line;
    return {};
}

constexpr const char* linkage = PROJECT_FOLDER "/scenes/data/linkage.json";

TEST_F(Sim, inspects_a_linkage_with_three_redundant_rows) {
    ASSERT_EQ(run(std::string(linkage) + " --inspect coupler --at 0 --json " + file("r.json")), 0)
        << output();
    EXPECT_THAT(output(), HasSubstr("Rank 17 of 20: 3 redundant rows"));
    EXPECT_THAT(output(), HasSubstr("D rotation x = A rotation x - B rotation x + C rotation x"));
    EXPECT_THAT(output(), HasSubstr("Remaining degrees of freedom of the bodies: 1 of 18."));
    EXPECT_THAT(output(), HasSubstr("Cholesky                 fails: not positive definite"));
    const auto json = report();
    EXPECT_EQ(json["scene"], "linkage");
    EXPECT_EQ(json["step"], 0);
    ASSERT_EQ(json["groups"].size(), 1u);
    const auto& group = json["groups"][0];
    EXPECT_EQ(group["bodies"], nlohmann::json({"left", "right", "coupler"}));
    EXPECT_EQ(group["rows"].size(), 20u);
    EXPECT_EQ(group["matrix"].size(), 400u);
    EXPECT_EQ(group["rank"], 17);
    EXPECT_EQ(group["free_motions"], 1);
    EXPECT_EQ(group["redundancies"].size(), 3u);
    EXPECT_EQ(group["methods"].size(), 9u);
    EXPECT_EQ(group["treatments"].size(), 10u);
    EXPECT_TRUE(method(group, "Cholesky").contains("failed"));
    EXPECT_LT(method(group, "minimum norm (SVD)")["residual"].get<double>(), 1e-10);
    const auto swept = method(group, "Gauss-Seidel");
    EXPECT_TRUE(swept["converged"].get<bool>());
    EXPECT_GT(swept["residuals"].size(), 10u);
    EXPECT_LT(swept["residuals"].back().get<double>(), 1e-10);
}

// Ten boxes of 1000 kg: the impulse of the lowest one on the ground in a sub-step.
TEST_F(Sim, inspects_the_weight_of_a_stack) {
    ASSERT_EQ(run("stack --inspect --at 120 --iterations 4000 --json " + file("r.json") +
                  " --csv " + file("r.csv")),
              0)
        << output();
    const auto json = report();
    ASSERT_EQ(json["groups"].size(), 1u);
    const auto& group = json["groups"][0];
    const auto swept = method(group, "projected Gauss-Seidel");
    EXPECT_EQ(swept["out_of_bounds"], 0);
    double impulse = 0;
    for (std::size_t k = 0; k < group["rows"].size(); k++) {
        const std::string name = group["rows"][k]["name"];
        if (name.starts_with("box 0/ground normal")) impulse += swept["impulses"][k].get<double>();
    }
    const double weight = 10 * 1000 * 9.81;
    EXPECT_NEAR(impulse / group["h"].get<double>(), weight, 2e-3 * weight);
    EXPECT_EQ(group["rank"], 60);
    EXPECT_TRUE(group["free_motions"].is_null());
    const std::string csv = read(file("r.csv"));
    EXPECT_THAT(csv, StartsWith("scene,step,group,method,converged,iteration,residual\n"));
    EXPECT_THAT(csv, HasSubstr("\nstack,120,0,conjugate gradients,1,1,"));
    std::size_t lines = 1;  // the names of the columns
    for (const auto& line : group["methods"])
        if (line.contains("residuals")) lines += line["residuals"].size();
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), lines);
}

TEST_F(Sim, marks_forces_that_have_not_converged) {
    ASSERT_EQ(run("stack --inspect --at 120 --iterations 3"), 0) << output();
    EXPECT_THAT(output(), HasSubstr("~: not converged after 3 iterations"));
    EXPECT_THAT(output(), testing::ContainsRegex("box 0/ground normal.*[0-9]~"));
    ASSERT_EQ(run(std::string(linkage) + " --inspect coupler --at 0"), 0) << output();
    EXPECT_THAT(output(), testing::Not(HasSubstr("~")));
}

TEST_F(Sim, lists_all_groups_of_a_scene) {
    ASSERT_EQ(run("machines --inspect all --at 10 --json " + file("r.json")), 0) << output();
    EXPECT_THAT(output(), HasSubstr("Use a body, as in --inspect chassis"));
    const auto json = report();
    EXPECT_GT(json["groups"].size(), 4u);
    for (const auto& group : json["groups"]) {
        EXPECT_LE(group["rank"].get<std::size_t>(), group["rows"].size());
        EXPECT_EQ(group["methods"].size(), 1u);
    }
    ASSERT_EQ(run("pyramid --inspect --at 60"), 0) << output();
    EXPECT_THAT(output(), HasSubstr("465 bodies with more than 1500 rows"));
    ASSERT_EQ(run("free_space --inspect --at 0"), 0) << output();
    EXPECT_THAT(output(), HasSubstr("there is nothing to solve"));
}

TEST_F(Sim, inspects_a_loaded_world) {
    ASSERT_EQ(run("stack --seconds 0.5 --save " + file("w.bin")), 0) << output();
    ASSERT_EQ(run("stack --inspect 3 --at 40 --load " + file("w.bin")), 0) << output();
    EXPECT_THAT(output(), HasSubstr("stack after step 40"));
    EXPECT_EQ(run("stack --inspect 1 --at 10 --load " + file("w.bin")), 2);
    EXPECT_THAT(output(), HasSubstr("the world is at step 30 already"));
}

TEST_F(Sim, rejects_an_unknown_body) {
    const auto refused = [&](const std::string& arguments, int status, const char* why) {
        EXPECT_EQ(run(arguments), status) << arguments;
        EXPECT_THAT(output(), HasSubstr(why)) << arguments;
    };
    refused("stack --inspect missing", 2, "the scene has no body 'missing'");
    refused("stack --inspect 99", 2, "a number from 0 to 10");
    refused("stack --inspect ground", 1, "is not dynamic");
    refused("free_space --inspect 3 --at 0", 1, "touches nothing");
    refused("pyramid --inspect 5", 1, "more than 1500 rows");
    refused("stack --at 3", 2, "--inspect");
    refused("stack --inspect --position-correction 2", 2, "2 is not a number from 0 to 1");
    refused("stack --inspect --converge", 2, "--converge");
    refused("stack --inspect --seconds 3", 2, "--seconds");
    refused("stack --inspect --json /nowhere/r.json", 1, "cannot write /nowhere/r.json");
    refused("stack --inspect --csv /nowhere/r.csv", 1, "cannot write /nowhere/r.csv");
}

}  // namespace

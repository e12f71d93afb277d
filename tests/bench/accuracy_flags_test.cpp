// SPDX-License-Identifier: MIT
//
// jostle-bench accuracy and stability as programs: flags, files and exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class AccuracyFlags : public testing::Test {
protected:
    AccuracyFlags()
        : folder_(fs::temp_directory_path() / ("jostle-accuracy-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~AccuracyFlags() override { fs::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    // Returns the exit status; stdout and stderr are written to out.txt.
    int run(const std::string& arguments) const {
        const std::string command =
            std::string(JOSTLE_BENCH " ") + arguments + " > " + file("out.txt") + " 2>&1";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string output() const { return read("out.txt"); }
    std::string read(const char* name) const {
        std::ifstream in(file(name));
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path folder_;
};

TEST_F(AccuracyFlags, accuracy_writes_rows_scenes_and_work_table) {
    ASSERT_EQ(
        run("accuracy --scene f1,j1 --rates 30,60 --peers none --modes sub1,default --json " +
            file("a.json") + " --csv " + file("a.csv") + " --scenes-csv " + file("scenes.csv")),
        0)
        << output();
    EXPECT_THAT(output(), HasSubstr("order between rates"));
    EXPECT_THAT(output(), HasSubstr("Pareto set"));
    const auto json = nlohmann::json::parse(read("a.json"));
    EXPECT_EQ(json["benchmark"], "accuracy");
    ASSERT_EQ(json["rows"].size(), 8u);  // two scenes, two modes, two rates
    EXPECT_EQ(json["rows"][0]["scene"], "f1");
    EXPECT_EQ(json["rows"][0]["mode"], "sub8");
    EXPECT_EQ(json["rows"][0]["rate_hz"], 30);
    EXPECT_GT(json["rows"][0]["cpu_us_per_second"], 0);
    EXPECT_EQ(json["work"].size(), 6u);  // three tolerances per scene
    EXPECT_THAT(read("a.csv"), HasSubstr("j1,jostle,sub1,60,"));
    EXPECT_THAT(read("scenes.csv"),
                HasSubstr("scene,family,description,error,second_error,tolerances\n"));
    EXPECT_THAT(read("scenes.csv"),
                HasSubstr("\"position error at the end, m\",none,0.1 0.01 1e-06\n"));
}

TEST_F(AccuracyFlags, accuracy_merges_earlier_rows) {
    const std::string one = " --rates 60 --peers none --modes default ";
    ASSERT_EQ(run("accuracy --scene f1" + one + "--json " + file("a.json")), 0) << output();
    ASSERT_EQ(run("accuracy --scene f3" + one + "--merge " + file("a.json") + " --json " +
                  file("b.json")),
              0)
        << output();
    const auto json = nlohmann::json::parse(read("b.json"));
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][0]["scene"], "f1");
    EXPECT_THAT(output(), HasSubstr("f1: free fall"));
    EXPECT_EQ(run("accuracy --scene f1" + one + "--merge " + file("none.json")), 1);
    EXPECT_THAT(output(), HasSubstr("none.json"));
}

TEST_F(AccuracyFlags, regression_run_stores_results_and_detects_regressions) {
    const std::string against = " --compare-to " + file("short.json");
    EXPECT_EQ(run("accuracy --regression --scene f1,j1" + against), 1);
    EXPECT_THAT(output(), HasSubstr("no rows in"));
    EXPECT_THAT(output(), HasSubstr("--update"));
    std::ofstream(file("short.json")) << R"({"rows": []})";
    ASSERT_EQ(run("accuracy --regression --scene f1,j1" + against + " --update"), 0) << output();
    const auto json = nlohmann::json::parse(read("short.json"));
    ASSERT_EQ(json["rows"].size(), 12u);  // two scenes, four rates; j1 iteratively as well
    EXPECT_FALSE(json["rows"][4].contains("mode"));
    EXPECT_EQ(json["rows"][8]["mode"], "iterative");
    EXPECT_FALSE(json["rows"][0].contains("cpu_us_per_second"));
    EXPECT_EQ(run("accuracy --regression --scene f1,j1" + against), 0) << output();
    EXPECT_THAT(output(), HasSubstr("0 values worse"));

    auto forged = json;  // as if j1 had been 100 times better at 60 Hz
    forged["rows"][5]["error"] = json["rows"][5]["error"].get<double>() / 100;
    std::ofstream(file("short.json")) << forged;
    EXPECT_EQ(run("accuracy --regression --scene j1" + against), 1);
    EXPECT_THAT(output(), HasSubstr("WORSE: j1 at 60 Hz: error"));
    EXPECT_THAT(output(), HasSubstr("(100.00 times)"));
    EXPECT_THAT(output(), HasSubstr("accuracy --regression --compare-to " + file("short.json") +
                                    " --update"));
    // --update with some of the scenes does not change the other rows.
    ASSERT_EQ(run("accuracy --regression --scene j1" + against + " --update"), 0) << output();
    EXPECT_EQ(nlohmann::json::parse(read("short.json"))["rows"], json["rows"]);
}

TEST_F(AccuracyFlags, draws_members_of_families) {
    const std::string two = "accuracy --regression --scene gate,c8 --draw 2 --seed ";
    ASSERT_EQ(run(two + "5"), 0) << output();
    EXPECT_THAT(output(), HasSubstr("gate-s5-2"));
    EXPECT_THAT(output(), Not(HasSubstr("c8"))) << "belongs to no family";
    EXPECT_THAT(output(), HasSubstr("0 faults, 0 known faults"));
    const std::string first = output();
    ASSERT_EQ(run(two + "5"), 0);
    EXPECT_EQ(output(), first);
    ASSERT_EQ(run("accuracy --scene fall --draw 1 --rates 60 --peers none --modes default"), 0);
    EXPECT_THAT(output(), HasSubstr("fall-s2-1: a box in free fall: freedom"));
    EXPECT_EQ(run("accuracy --scene gate --draw 0"), 2);
    EXPECT_EQ(run("accuracy --scene gate --seed 3"), 2);
    EXPECT_EQ(run(two + "5 --compare-to " + file("short.json")), 2);
}

TEST_F(AccuracyFlags, known_faults_file_must_be_readable) {
    EXPECT_EQ(run("accuracy --regression --scene f1 --known-faults " + file("none.json")), 1);
    EXPECT_THAT(output(), HasSubstr("none.json"));
    EXPECT_EQ(run("accuracy --known-faults x.json"), 2);
}

TEST_F(AccuracyFlags, regression_run_excludes_other_output_flags) {
    EXPECT_EQ(run("accuracy --compare-to short.json"), 2);
    EXPECT_THAT(output(), HasSubstr("--regression"));
    EXPECT_EQ(run("accuracy --regression --update"), 2);
    EXPECT_THAT(output(), HasSubstr("--compare-to"));
    EXPECT_EQ(run("accuracy --regression --rates 60"), 2);
    EXPECT_THAT(output(), HasSubstr("--rates"));
    EXPECT_EQ(run("accuracy --regression --compare-to /nowhere/short.json --update"), 1);
    EXPECT_THAT(output(), HasSubstr("cannot write /nowhere/short.json"));
}

TEST_F(AccuracyFlags, stability_writes_verdicts) {
    ASSERT_EQ(run("stability --scene s1,s22 --peers none --json " + file("s.json")), 0) << output();
    const auto json = nlohmann::json::parse(read("s.json"));
    EXPECT_EQ(json["benchmark"], "stability");
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][0]["id"], "s1");
    EXPECT_EQ(json["rows"][0]["engine"], "jostle");
    EXPECT_EQ(json["rows"][0]["pass"], true);
    EXPECT_EQ(json["rows"][0]["limit"], 0.1);
    EXPECT_LT(json["rows"][0]["figure"], 0.1);
}

TEST_F(AccuracyFlags, integrators_and_contact_models_write_rows) {
    ASSERT_EQ(run("integrators --field kepler --method verlet,rk4 --rates 240,480 --json " +
                  file("i.json") + " --csv " + file("i.csv")),
              0)
        << output();
    const auto json = nlohmann::json::parse(read("i.json"));
    ASSERT_EQ(json["rows"].size(), 4u);
    EXPECT_EQ(json["rows"][1]["method"], "verlet");
    EXPECT_NEAR(json["rows"][1]["order"].get<double>(), 2, 0.1);
    EXPECT_THAT(read("i.csv"), HasSubstr("kepler,rk4,480,"));
    ASSERT_EQ(run("contact-models --model xpbd,penalty --rates 60 --json " + file("r.json") +
                  " --csv " + file("r.csv")),
              0)
        << output();
    const auto contact_models = nlohmann::json::parse(read("r.json"));
    ASSERT_EQ(contact_models["rows"].size(), 2u);
    EXPECT_EQ(contact_models["rows"][0]["blown"], true);
    EXPECT_LT(contact_models["rows"][1]["slide_error"], 0.01);
    EXPECT_THAT(read("r.csv"), HasSubstr("penalty,60,blown"));
    const std::pair<const char*, const char*> wrong[] = {
        {"integrators --field moon", "unknown field moon; must be one of all, oscillator"},
        {"integrators --method euler", "unknown method euler; must be one of all, explicit"},
        {"integrators --rates nan", "nan is not a valid rate"},
        {"integrators --rates 2.5", "2.5 is not a valid rate"},
        {"contact-models --model fast", "unknown model fast; must be one of all, penalty"},
        {"contact-models --rates 0", "0 is not a valid rate"}};
    for (const auto& [flags, why] : wrong) {
        EXPECT_EQ(run(flags), 2) << flags;
        EXPECT_THAT(output(), HasSubstr(why));
    }
    EXPECT_EQ(run("contact-models --csv /nowhere/r.csv"), 1);
    EXPECT_EQ(run("integrators --json /nowhere/i.json"), 1);
}

TEST_F(AccuracyFlags, errors_list_the_accepted_names) {
    EXPECT_EQ(run("accuracy --scene q9"), 2);
    EXPECT_THAT(output(), HasSubstr("unknown scene q9"));
    EXPECT_THAT(output(), HasSubstr("c5-e0.8"));
    EXPECT_EQ(run("accuracy --modes fast"), 2);
    EXPECT_THAT(output(), HasSubstr("sub8"));
    EXPECT_EQ(run("accuracy --peers havoc"), 2);
    EXPECT_THAT(output(), HasSubstr("bullet"));
    EXPECT_EQ(run("accuracy --rates 7"), 2);
    EXPECT_THAT(output(), HasSubstr("divides 19200"));
    EXPECT_EQ(run("stability --scene s0"), 2);
    EXPECT_THAT(output(), HasSubstr("s6-tilt"));
}

TEST_F(AccuracyFlags, help_lists_scenes_and_tests) {
    EXPECT_EQ(run("accuracy --help"), 0);
    EXPECT_THAT(output(), HasSubstr("j3-r1000"));
    EXPECT_EQ(run("stability --help"), 0);
    EXPECT_THAT(output(), HasSubstr("s22"));
}

TEST_F(AccuracyFlags, unwritable_output_fails_before_the_run) {
    EXPECT_EQ(run("accuracy --scene f1 --json /nowhere/a.json"), 1);
    EXPECT_THAT(output(), HasSubstr("cannot write /nowhere/a.json"));
    EXPECT_EQ(run("stability --scene s1 --json /nowhere/s.json"), 1);
    EXPECT_THAT(output(), HasSubstr("cannot write /nowhere/s.json"));
}

}  // namespace

// SPDX-License-Identifier: MIT
//
// jostle-bench accuracy and stability: flags, files and exit status of the real program.
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

class LabFlags : public testing::Test {
protected:
    LabFlags()
        : folder_(fs::temp_directory_path() / ("jostle-accuracy-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~LabFlags() override { fs::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    // Exit status; output and messages go to out.txt.
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

TEST_F(LabFlags, accuracy_writes_rows_work_table_and_plots) {
    ASSERT_EQ(run("accuracy --scene f1,j1 --rates 30,60 --peers none --modes sub1,default --json " +
                  file("a.json") + " --csv " + file("a.csv") + " --plot " + file("plots")),
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
    EXPECT_EQ(json["work"].size(), 6u);  // three tolerances a scene
    EXPECT_THAT(read("a.csv"), HasSubstr("j1,jostle,sub1,60,"));
    EXPECT_THAT(read("plots/j1.svg"), HasSubstr("sub1"));
}

TEST_F(LabFlags, accuracy_adds_the_rows_of_before) {
    const std::string one = " --rates 60 --peers none --modes default ";
    ASSERT_EQ(run("accuracy --scene f1" + one + "--json " + file("a.json")), 0) << output();
    ASSERT_EQ(
        run("accuracy --scene f3" + one + "--add " + file("a.json") + " --json " + file("b.json")),
        0)
        << output();
    const auto json = nlohmann::json::parse(read("b.json"));
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][0]["scene"], "f1");
    EXPECT_THAT(output(), HasSubstr("f1: free fall"));
    EXPECT_EQ(run("accuracy --scene f1" + one + "--add " + file("none.json")), 1);
    EXPECT_THAT(output(), HasSubstr("none.json"));
}

TEST_F(LabFlags, stability_writes_verdicts) {
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

TEST_F(LabFlags, what_does_not_exist_is_named_with_what_there_is) {
    EXPECT_EQ(run("accuracy --scene q9"), 2);
    EXPECT_THAT(output(), HasSubstr("there is no scene q9"));
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

TEST_F(LabFlags, help_lists_scenes_and_tests) {
    EXPECT_EQ(run("accuracy --help"), 0);
    EXPECT_THAT(output(), HasSubstr("j3-r1000"));
    EXPECT_EQ(run("stability --help"), 0);
    EXPECT_THAT(output(), HasSubstr("s22"));
}

TEST_F(LabFlags, a_file_that_cannot_be_written_is_named_before_anything_runs) {
    EXPECT_EQ(run("accuracy --scene f1 --json /nowhere/a.json"), 1);
    EXPECT_THAT(output(), HasSubstr("cannot write /nowhere/a.json"));
    EXPECT_EQ(run("stability --scene s1 --json /nowhere/s.json"), 1);
    EXPECT_THAT(output(), HasSubstr("cannot write /nowhere/s.json"));
}

}  // namespace

// SPDX-License-Identifier: MIT
//
// The real program as a child process: what it writes is what others read.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace {

namespace fs = std::filesystem;

class Sim : public testing::Test {
protected:
    Sim() : folder_(fs::temp_directory_path() / ("jostle-sim-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~Sim() override { fs::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    // Exit status; output and messages go to out.txt.
    int run(const std::string& arguments) const {
        const std::string command = JOSTLE_SIM " " + arguments + " > " + file("out.txt") + " 2>&1";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string output() const { return read(file("out.txt")); }
    static std::string read(const std::string& path) {
        std::ifstream in(path);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    nlohmann::json report() const { return nlohmann::json::parse(read(file("r.json"))); }

    fs::path folder_;
};

TEST_F(Sim, reports_every_figure_that_it_promises) {
    ASSERT_EQ(run("stack --seconds 3 --json " + file("r.json")), 0) << output();
    const auto json = report();
    for (const char* key :
         {"steps", "bodies", "contacts", "ms_per_step_mean", "ms_per_step_p99", "state_hash",
          "energy_joules", "max_penetration_m", "awake_bodies", "stages"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["steps"], 180);
    EXPECT_EQ(json["bodies"], 11);
    EXPECT_EQ(json["contacts"], 10);
    EXPECT_EQ(json["awake_bodies"], 0);
    EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16u);
    // Ten boxes of a tonne each, centres at 0.5 to 9.5 m: m g h = 1000 * 9.81 * 50 J.
    EXPECT_NEAR(json["energy_joules"].get<double>(), 490500, 500);
}

TEST_F(Sim, gives_the_same_hash_at_one_two_and_four_threads) {
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

TEST_F(Sim, traces_one_row_per_body_and_tick) {
    ASSERT_EQ(run("stack --seconds 0.1 --trace " + file("t.csv")), 0) << output();
    std::istringstream lines(read(file("t.csv")));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "tick,body,name,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz");
    int rows = 0;
    while (std::getline(lines, line)) rows++;
    EXPECT_EQ(rows, 7 * 10);  // start and six ticks, ten boxes
}

TEST_F(Sim, goes_on_from_a_saved_world_as_if_it_had_never_stopped) {
    ASSERT_EQ(run("wall --seconds 2 --json " + file("r.json")), 0);
    const std::string straight = report()["state_hash"];
    ASSERT_EQ(run("wall --seconds 1 --save " + file("w.world")), 0);
    ASSERT_EQ(run("wall --seconds 1 --load " + file("w.world") + " --json " + file("r.json")), 0);
    EXPECT_EQ(report()["state_hash"], straight);
}

TEST_F(Sim, says_what_is_wrong_and_exits_with_2) {
    EXPECT_EQ(run("nowhere"), 2);
    EXPECT_NE(output().find("there is no scene \"nowhere\""), std::string::npos);
    EXPECT_EQ(run(""), 2);
    EXPECT_EQ(run("stack --substeps 99"), 2);
    std::ofstream(file("bad.json")) << "{\"name\": \"x\", \"bodies\": [{\"shape\": []}]}";
    EXPECT_EQ(run(file("bad.json")), 2);
    EXPECT_NE(output().find("bodies[0].shape: there is no such field"), std::string::npos);
    EXPECT_EQ(run("stack --load " + file("bad.json")), 2);
}

}  // namespace

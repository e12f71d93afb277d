// SPDX-License-Identifier: MIT
//
// jostle-bench speed, threads, rollback and features as programs: flags, files and exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SpeedFlags : public testing::Test {
protected:
    SpeedFlags()
        : folder_(fs::temp_directory_path() / ("jostle-bench-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~SpeedFlags() override { fs::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    // Returns the exit status; stdout and stderr are written to out.txt.
    int run(const std::string& arguments, const char* subcommand = "speed") const {
        const std::string command = std::string(JOSTLE_BENCH " ") + subcommand + " " + arguments +
                                    " > " + file("out.txt") + " 2>&1";
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

TEST_F(SpeedFlags, writes_table_json_and_csv) {
    ASSERT_EQ(run("--scene bench_pyramid_465 --threads 1,2 --peers none --steps 3 --json " +
                  file("r.json") + " --csv " + file("r.csv")),
              0)
        << output();
    EXPECT_THAT(output(), HasSubstr("ms_mean"));
    const auto json = nlohmann::json::parse(read("r.json"));
    EXPECT_EQ(json["benchmark"], "speed");
    EXPECT_TRUE(json.contains("cpu") && json.contains("compiler"));
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][0]["clock"], "cpu");
    EXPECT_EQ(json["rows"][1]["threads"], 2);
    EXPECT_EQ(json["rows"][1]["clock"], "wall");
    const std::string csv = read("r.csv");
    EXPECT_TRUE(csv.starts_with("scene,name,engine,threads,steps,failed,count,")) << csv;
    EXPECT_THAT(csv, HasSubstr("\na,bench_pyramid_465,jostle,2,3,,,,,,,466,"));
}

TEST_F(SpeedFlags, threads_compares_worlds_with_identical_results) {
    const std::string what = "--scene a,h --threads 1,2 --steps 5 --rounds 1 --json ";
    ASSERT_EQ(run(what + file("t.json"), "threads"), 0) << output();
    const auto json = nlohmann::json::parse(read("t.json"));
    ASSERT_EQ(json["rows"].size(), 4u);
    EXPECT_EQ(json["rows"][0]["share"], 1);
    EXPECT_EQ(json["rows"][3]["threads"], 2);
    EXPECT_EQ(run("--scene a --steps 5 --max-ratio 0.0001", "threads"), 1);
    EXPECT_THAT(output(), HasSubstr("with 2 threads a step takes"));
    EXPECT_EQ(run("--scene nosuch", "threads"), 2);
    EXPECT_THAT(output(), HasSubstr("unknown scene nosuch"));
}

TEST_F(SpeedFlags, growth_writes_growth_rows) {
    ASSERT_EQ(run("--growth 20,40 --peers none --json " + file("g.json")), 0) << output();
    const auto json = nlohmann::json::parse(read("g.json"));
    EXPECT_EQ(json["benchmark"], "speed growth");
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][1]["bodies"], 40);
    EXPECT_EQ(json["rows"][1]["scene"], "pile");
    ASSERT_EQ(json["exponents"].size(), 1u);
    const double slope = std::log(json["rows"][1]["ms_mean"].get<double>() /
                                  json["rows"][0]["ms_mean"].get<double>()) /
                         std::log(2);
    EXPECT_NEAR(json["exponents"][0]["exponent"], slope, 1e-3 * std::abs(slope));
    EXPECT_THAT(output(), HasSubstr("exponent of bodies"));
}

TEST_F(SpeedFlags, growth_of_chains) {
    ASSERT_EQ(run("--growth 20 --growth-of chain --peers none --json " + file("g.json")), 0)
        << output();
    const auto json = nlohmann::json::parse(read("g.json"));
    EXPECT_EQ(json["rows"][0]["scene"], "chain");
    EXPECT_TRUE(json["exponents"][0]["exponent"].is_null());  // one size has no slope
    EXPECT_EQ(run("--growth-of chain"), 2);
    EXPECT_EQ(run("--growth 20 --growth-of cloth"), 2);
    EXPECT_THAT(output(), HasSubstr("pile"));
}

TEST_F(SpeedFlags, parameters_apply_to_the_scenes_that_have_them) {
    ASSERT_EQ(
        run("--scene a,wheels,wheels_mesh --wheels 2 --cell 4 --steps 2 --peers none --json " +
            file("p.json")),
        0)
        << output();
    const auto json = nlohmann::json::parse(read("p.json"));
    ASSERT_EQ(json["rows"].size(), 3u);
    EXPECT_TRUE(json["rows"][0]["wheels"].is_null());
    EXPECT_EQ(json["rows"][1]["wheels"], 2);
    EXPECT_EQ(json["rows"][1]["bodies"], 181);
    EXPECT_TRUE(json["rows"][1]["cell_m"].is_null());
    EXPECT_EQ(json["rows"][2]["cell_m"], 4);
    EXPECT_THAT(output(), HasSubstr("wheels 2, cell 4"));
}

TEST_F(SpeedFlags, parameter_errors_name_option_range_and_scenes) {
    EXPECT_EQ(run("--scene wheels --wheels 3"), 2);
    EXPECT_THAT(output(), HasSubstr("--wheels: 3 is out of range for wheels; must be 2 to 32, "
                                    "even; scenes with --wheels: wheels (2 to 32, even), "
                                    "wheels_mesh (2 to 32, even)"));
    EXPECT_EQ(run("--scene a,drum --vertices 8"), 2);
    EXPECT_THAT(output(), HasSubstr("--vertices: no selected scene has this parameter; select one "
                                    "of hull_heap (8 to 128, even)"));
    for (const char* hostile :
         {"--count 0", "--count -1", "--count 2.5", "--count 1e99", "--count nan", "--count inf",
          "--count 99999999999999999999999", "--count ten", "--count ''", "--cell 0"}) {
        EXPECT_EQ(run(std::string("--scene mesh ") + hostile), 2) << hostile;
        EXPECT_THAT(output(), HasSubstr(std::string(hostile, 6)));
    }
    EXPECT_EQ(run("--scene drum --drum-speed ''"), 2);
    EXPECT_THAT(output(), HasSubstr("--drum-speed: '' is not a number"));
    EXPECT_EQ(run("--growth 20 --count 5"), 2);
    EXPECT_THAT(output(), HasSubstr("--count: not supported with --growth or --server"));
    EXPECT_EQ(run("--server --scene c --count 5"), 2);
    EXPECT_EQ(run("--server --scene drum"), 2);
    EXPECT_THAT(output(), HasSubstr("drum is not in the catalogue of jostle-server"));
}

TEST_F(SpeedFlags, help_lists_the_defaults_of_scene_options) {
    ASSERT_EQ(run("--help"), 0);
    EXPECT_THAT(output(), HasSubstr("--wheels N [default: 10; 2 to 32, even]"));
    EXPECT_THAT(output(), HasSubstr("--cell METRES [default: 0.4; 0.2 to 10]"));
    EXPECT_THAT(output(), HasSubstr("--drum-speed DEGREES [default: 90; 0 to 360]"));
}

TEST_F(SpeedFlags, server_row_counts_one_second_of_ticks_with_two_clients) {
    ASSERT_EQ(run("--server --scene c --clients 2 --seconds 1 --json " + file("s.json")), 0)
        << output();
    EXPECT_THAT(output(), HasSubstr("c bench_boxes_1000"));
    const auto json = nlohmann::json::parse(read("s.json"));
    EXPECT_EQ(json["benchmark"], "speed server");
    ASSERT_EQ(json["rows"].size(), 1u);
    const auto& row = json["rows"][0];
    EXPECT_EQ(row["hz"], 60);
    EXPECT_EQ(row["bodies"], 1001);
    EXPECT_EQ(row["connected"], 2);
    EXPECT_EQ(row["errors"], 0);
    // All due ticks, except a few at both ends of the second.
    EXPECT_NEAR(row["ticks"].get<int>() + row["late_ticks"].get<int>(), 60, 10);
    EXPECT_GT(row["ms_mean"], 0);
    EXPECT_GE(row["ms_worst"], row["ms_p99"]);
    EXPECT_GT(row["snapshots_per_second_per_client"], 0);
    EXPECT_GT(row["kbit_per_second_per_client"], 0);
}

TEST_F(SpeedFlags, server_and_solver_flags_are_mutually_exclusive) {
    EXPECT_EQ(run("--server --steps 5"), 2);
    EXPECT_EQ(run("--server --peers ode"), 2);
    EXPECT_EQ(run("--clients 2"), 2);
    EXPECT_EQ(run("--server --clients 0"), 2);
    EXPECT_EQ(run("--server --seconds 31"), 2);
}

TEST_F(SpeedFlags, rollback_restores_the_saved_state_and_writes_a_row_per_scene) {
    ASSERT_EQ(run("--bodies 60 --repetitions 2 --steps 3 --json " + file("b.json"), "rollback"), 0)
        << output();
    EXPECT_THAT(output(), HasSubstr("restore ms"));
    const auto json = nlohmann::json::parse(read("b.json"));
    EXPECT_EQ(json["benchmark"], "rollback");
    ASSERT_EQ(json["rows"].size(), 3u);
    EXPECT_EQ(json["rows"][2]["scene"], "woken");
    EXPECT_EQ(json["rows"][2]["contacts"], 60);
    EXPECT_GT(json["rows"][0]["save_ms"]["median"], 0);
    EXPECT_EQ(run("--scenes lake", "rollback"), 2);
    EXPECT_EQ(run("--bodies 0", "rollback"), 2);
}

TEST_F(SpeedFlags, features_measures_selected_features_and_enforces_the_limit) {
    const std::string two = "--feature nothing,joints --rounds 2 --steps 2 ";
    ASSERT_EQ(run(two + "--max-percent 1000 --json " + file("f.json"), "features"), 0) << output();
    EXPECT_THAT(output(), HasSubstr("joints"));
    const auto json = nlohmann::json::parse(read("f.json"));
    EXPECT_EQ(json["benchmark"], "features");
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][1]["feature"], "joints");
    EXPECT_LE(json["rows"][1]["low"], json["rows"][1]["high"]);
    EXPECT_EQ(run("--feature wings", "features"), 2);
    EXPECT_THAT(output(), HasSubstr("wings"));
    EXPECT_EQ(run("--rounds 1", "features"), 2);
}

TEST_F(SpeedFlags, unknown_scene_error_lists_known_scenes) {
    EXPECT_EQ(run("--scene a,z"), 2);
    EXPECT_THAT(output(), HasSubstr("unknown scene z"));
    EXPECT_THAT(output(), HasSubstr("i or bench_bullets_1000"));
}

TEST_F(SpeedFlags, unknown_peer_error_lists_known_peers) {
    EXPECT_EQ(run("--peers havoc"), 2);
    EXPECT_THAT(output(), HasSubstr("unknown peer havoc"));
    EXPECT_THAT(output(), HasSubstr("bullet"));
    EXPECT_THAT(output(), HasSubstr("ode"));
}

TEST_F(SpeedFlags, rejects_numbers_out_of_range_and_prints_the_range) {
    EXPECT_EQ(run("--threads 0"), 2);
    EXPECT_THAT(output(), HasSubstr("range"));
    EXPECT_EQ(run("--threads 65"), 2);
    EXPECT_EQ(run("--threads two"), 2);
    EXPECT_THAT(output(), HasSubstr("two"));
    EXPECT_EQ(run("--steps 0"), 2);
    EXPECT_EQ(run("--growth 0"), 2);
    EXPECT_EQ(run("--sleep maybe"), 2);
    EXPECT_EQ(run("--growth 10 --scene a"), 2);
}

TEST_F(SpeedFlags, unwritable_output_fails_before_the_run) {
    EXPECT_EQ(run("--scene b --json /nowhere/r.json"), 1);
    EXPECT_THAT(output(), HasSubstr("cannot write /nowhere/r.json: No such file or directory"));
    EXPECT_EQ(output().find("ms_mean"), std::string::npos);
}

}  // namespace

// SPDX-License-Identifier: MIT
//
// jostle-mesh as a program: subcommands, files and exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "jostle/base/base64.h"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

class MeshProgram : public testing::Test {
protected:
    MeshProgram()
        : folder_(fs::temp_directory_path() / ("jostle-mesh-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
        std::ofstream(file("corner.obj")) << tetrahedron;
    }
    ~MeshProgram() override { fs::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    // Returns the exit status; stdout and stderr are written to out.txt.
    int run(const std::string& arguments) const {
        const std::string command = JOSTLE_MESH " " + arguments + " > " + file("out.txt") + " 2>&1";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string output() const { return read("out.txt"); }
    std::string read(const char* name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path folder_;
};

TEST_F(MeshProgram, decompose_writes_a_scene_with_a_body_of_hulls) {
    ASSERT_EQ(run("decompose " + file("corner.obj") + " --scale 2 --scene " + file("s.json")), 0)
        << output();
    EXPECT_THAT(output(), HasSubstr("hulls      1"));
    EXPECT_THAT(output(), HasSubstr("volume     1.33333 m^3"));
    const auto scene = nlohmann::json::parse(read("s.json"));
    ASSERT_EQ(scene["bodies"].size(), 2u);
    EXPECT_EQ(scene["bodies"][1]["name"], "body");
}

TEST_F(MeshProgram, fracture_writes_a_file_a_scene_item_and_a_summary) {
    ASSERT_EQ(run("fracture --box 1 1 0.2 --chunks 12 --anchor -y --out " + file("w.fracture") +
                  " --scene " + file("item.json") + " --json -"),
              0)
        << output();
    const auto summary = nlohmann::json::parse(output());
    EXPECT_EQ(summary["chunks"], 12);
    EXPECT_GT(summary["anchored"], 0);
    const std::string bytes = read("w.fracture");
    EXPECT_EQ(summary["bytes"], bytes.size());
    const std::string shape = nlohmann::json::parse(read("item.json"))["shape"];
    EXPECT_EQ(jostle::decode_base64<std::string>(shape).value(), bytes);
}

TEST_F(MeshProgram, help_names_the_subcommands) {
    EXPECT_EQ(run("--help"), 0);
    EXPECT_THAT(output(), HasSubstr("decompose"));
    EXPECT_THAT(output(), HasSubstr("fracture"));
    EXPECT_EQ(run("decompose --help"), 0);
    EXPECT_THAT(output(), HasSubstr("--planes-per-axis"));
    EXPECT_EQ(run("fracture --help"), 0);
    EXPECT_THAT(output(), HasSubstr("--pattern"));
}

TEST_F(MeshProgram, invalid_flags_and_files_fail) {
    EXPECT_EQ(run(""), 2);
    EXPECT_THAT(output(), HasSubstr("subcommand"));
    EXPECT_EQ(run("melt"), 2);
    EXPECT_EQ(run("decompose"), 2);
    EXPECT_EQ(run("decompose /nowhere/a.obj"), 2);
    EXPECT_EQ(run("fracture"), 2);
    EXPECT_EQ(run("fracture --box 1 1 1 --hull 0 0 0 1 0 0 0 1 0 0 0 1"), 2);
    EXPECT_EQ(run("fracture --hull 0 0 0 1 0 0 0 1 0 0 0 1 1"), 2);
    EXPECT_THAT(output(), HasSubstr("must be a multiple of three"));
    EXPECT_EQ(run("fracture --box 1 1 1 --out /nowhere/w.fracture"), 1);
    EXPECT_THAT(output(), HasSubstr("jostle-mesh: cannot write /nowhere/w.fracture"));
    std::ofstream(file("open.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(run("decompose " + file("open.obj")), 1);
    EXPECT_THAT(output(), HasSubstr("open.obj"));
}

}  // namespace

// SPDX-License-Identifier: MIT
//
// jostle-sim as a child process in its own folder.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace jostle::test {

class Sim : public testing::Test {
protected:
    Sim()
        : folder_(std::filesystem::temp_directory_path() /
                  ("jostle-sim-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~Sim() override { std::filesystem::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    // Runs jostle-sim and returns its exit status; standard output and error go to out.txt.
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

    std::filesystem::path folder_;
};

}  // namespace jostle::test

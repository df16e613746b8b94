// Runs `weft render --stats` and reads the statistics file that the command writes.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"

namespace weft::test {

// Returns the statistics as JSON, or an empty object if the command fails. `arguments` are those after
// "render", without -o and --stats.
inline nlohmann::json render_stats(std::vector<std::string> arguments) {
    const ScratchFolder folder;
    for (const std::string& word :
         {std::string("-o"), folder / "a.png", std::string("--stats"), folder / "stats.json"})
        arguments.push_back(word);
    arguments.insert(arguments.begin(), "render");
    const RunResult run = run_weft(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.text();
    return run.exit_code == 0 ? nlohmann::json::parse(read_text(folder / "stats.json"))
                              : nlohmann::json::object();
}

}  // namespace weft::test

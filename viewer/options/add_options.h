// Purpose: declares the flags and arguments of each command. Parsing stores the values in the options of the
// command. Texts that need further conversion go to RawTexts.
#pragma once

#include <string>
#include <vector>

#include "viewer/options/options.h"

namespace CLI {
class App;
}

namespace weft::viewer {

// Texts of options such as --size 1280x720, which are converted to values after the whole command line is
// parsed.
struct RawTexts {
    std::string size = "1280x720";
    std::string bench_size = "640x360";
    std::vector<std::string> params;
    double exposure = 0;
    std::string limits;
};

void add_render(CLI::App& command, RenderOptions& options, RawTexts& raw);
void add_view(CLI::App& command, ViewOptions& options, RawTexts& raw);
void add_check(CLI::App& command, CheckOptions& options, RawTexts& raw);
void add_plan(CLI::App& command, PlanOptions& options, RawTexts& raw);
void add_schema(CLI::App& command, SchemaOptions& options, RawTexts& raw);
void add_explain(CLI::App& command, ExplainOptions& options, RawTexts& raw);
void add_diff(CLI::App& command, DiffOptions& options, RawTexts& raw);
void add_compare(CLI::App& command, CompareOptions& options, RawTexts& raw);
void add_doctor(CLI::App& command, DoctorOptions& options);
void add_limits(CLI::App& command, RawTexts& raw);

// The CLI11 objects and the options of the commands `bench compile` and `bench frame`.
struct BenchCommands {
    CLI::App* app = nullptr;
    CLI::App* compile = nullptr;
    BenchOptions compile_options;
    FrameBenchOptions frame_options;
};

void add_bench(CLI::App& app, BenchCommands& bench, RawTexts& raw);

}  // namespace weft::viewer

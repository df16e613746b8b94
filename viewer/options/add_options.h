// Purpose: declares the flags and arguments of each command. Parsing stores the values in the options of the
// command. Values that need further work go to RawTexts.
#pragma once

#include <string>
#include <vector>

#include "viewer/options/options.h"

namespace CLI {
class App;
}

namespace weft::viewer {

// Values of options that need further work after the whole command line is parsed. Example: the text of
// --size 1280x720 is converted to two numbers.
struct RawTexts {
    std::string size = "1280x720";
    std::string frames;
    std::string bench_size = "640x360";
    std::vector<std::string> params;
    std::vector<std::string> turns;
    std::vector<std::string> imports;
    double exposure = 0;
    std::string limits;
    std::vector<std::string> graph_path;
};

void add_render(CLI::App& command, RenderOptions& options, RawTexts& raw);
void add_view(CLI::App& command, ViewOptions& options, RawTexts& raw);
void add_check(CLI::App& command, CheckOptions& options, RawTexts& raw);
void add_plan(CLI::App& command, PlanOptions& options, RawTexts& raw);
void add_schema(CLI::App& command, SchemaOptions& options, RawTexts& raw);
void add_explain(CLI::App& command, ExplainOptions& options, RawTexts& raw);
void add_diff(CLI::App& command, DiffOptions& options, RawTexts& raw);
void add_compare(CLI::App& command, CompareOptions& options, RawTexts& raw);
void add_scene(CLI::App& command, SceneOptions& options, RawTexts& raw);
void add_doctor(CLI::App& command, DoctorOptions& options);
void add_limits(CLI::App& command, RawTexts& raw);
void add_graph_path(CLI::App& command, RawTexts& raw);

// The command `bench` with the options of its commands `bench compile` and `bench frame`.
struct BenchCommands {
    CLI::App* app = nullptr;      // The command `bench`.
    CLI::App* compile = nullptr;  // The command `bench compile`.
    BenchOptions compile_options;
    FrameBenchOptions frame_options;
};

void add_bench(CLI::App& app, BenchCommands& bench, RawTexts& raw);

}  // namespace weft::viewer

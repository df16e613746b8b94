#include <CLI/CLI.hpp>

#include "viewer/options/add_options.h"
#include "viewer/options/validators.h"

namespace weft::viewer {
namespace {

CLI::App* add_bench_compile(CLI::App& bench, BenchOptions& o) {
    CLI::App* command = bench.add_subcommand("compile", "measure the compile time of generated graphs");
    command->add_option("--passes", o.passes, "each writes one image and reads two")
        ->transform(whole_number_in(1, 1'000'000))
        ->capture_default_str();
    command->add_option("--shape", o.shape, "which passes one reads: chain, window32 or random")
        ->check(choice_validator({"chain", "window32", "random"}))
        ->capture_default_str();
    command->add_option("--seed", o.seed, "of std::mt19937")
        ->transform(whole_number_in(0, kMostSeed))
        ->capture_default_str();
    command->add_option("--queues", o.queues, "how many queues to plan for")
        ->transform(whole_number_in(1, kMostQueues))
        ->capture_default_str();
    command->add_flag("--json", o.json, "as JSON");
    return command;
}

void add_bench_frame(CLI::App& bench, FrameBenchOptions& o, RawTexts& raw) {
    CLI::App* command =
        bench.add_subcommand("frame", "how long graphs take for a frame, over numbers of lights");
    command->add_option("SCENE", o.scene, "as of weft render")->capture_default_str();
    command
        ->add_option("--graphs", o.graphs,
                     "shipped graphs by name, or files; all are compared with the first")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--lights", o.lights, "so many seeded lights, one after the other")
        ->delimiter(',')
        ->transform(whole_number_in(1, kMostLights))
        ->capture_default_str();
    command->add_option("--size", raw.bench_size, "in pixels")
        ->check(size_validator())
        ->capture_default_str();
    command->add_option("--camera", o.camera, "as of weft render");
    command->add_option("--seed", o.seed, "of the lights")
        ->transform(whole_number_in(0, kMostSeed))
        ->capture_default_str();
    command->add_option("--rounds", o.rounds, "so often each graph draws a frame, in turn with the others")
        ->transform(whole_number_in(1, 1000))
        ->capture_default_str();
    command->add_option("--plot", o.plot, "draw the times over the lights into this .svg")
        ->check(plot_validator());
    command->add_option("--device", o.device, "a device's index or part of its name");
    command->add_option("--timeout", o.timeout_s, "seconds to wait for a frame")
        ->transform(number_in(kTimeout))
        ->capture_default_str();
    add_limits(*command, raw);
    command->add_flag("--json", o.json, "as JSON");
}

}  // namespace

void add_bench(CLI::App& app, BenchCommands& bench, RawTexts& raw) {
    bench.app = app.add_subcommand("bench", "measure: `weft bench compile`, `weft bench frame`");
    bench.app->require_subcommand(1);
    bench.compile = add_bench_compile(*bench.app, bench.compile_options);
    add_bench_frame(*bench.app, bench.frame_options, raw);
}

}  // namespace weft::viewer

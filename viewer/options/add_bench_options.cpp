#include <CLI/CLI.hpp>

#include "viewer/options/add_options.h"
#include "viewer/options/validators.h"

namespace weft::viewer {
namespace {

CLI::App* add_bench_compile(CLI::App& bench, BenchOptions& o) {
    CLI::App* command = bench.add_subcommand("compile", "measure the compile time of generated graphs");
    command->add_option("--passes", o.passes, "number of passes; each pass writes one image and reads two")
        ->transform(whole_number_in(1, 1'000'000))
        ->capture_default_str();
    command
        ->add_option(
            "--shape", o.shape,
            "earlier images that a pass reads: chain (the last two), window32 (two of the last 32) or random")
        ->check(choice_validator({"chain", "window32", "random"}))
        ->capture_default_str();
    command->add_option("--seed", o.seed, "seed of the first random graph (std::mt19937)")
        ->transform(whole_number_in(0, kMostSeed))
        ->capture_default_str();
    command
        ->add_option("--seeds", o.seeds,
                     "number of graphs to compile; the seed of each further graph is greater by 1")
        ->transform(whole_number_in(1, 1000))
        ->capture_default_str();
    command->add_option("--queues", o.queues, "number of queues in the plan")
        ->transform(whole_number_in(1, kMostQueues))
        ->capture_default_str();
    command->add_flag("--json", o.json, "print the result as JSON");
    return command;
}

void add_bench_frame(CLI::App& bench, FrameBenchOptions& o, RawTexts& raw) {
    CLI::App* command =
        bench.add_subcommand("frame", "measure the frame times of graphs for several numbers of lights");
    command->add_option("SCENE", o.scene, "the scene, as in `weft render`")->capture_default_str();
    command
        ->add_option(
            "--graphs", o.graphs,
            "graphs to measure: names of shipped graphs, or .json files, such as deferred or weft:low "
            "for the tier low; each is compared with the first graph")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--lights", o.lights, "numbers of random lights to measure with")
        ->delimiter(',')
        ->transform(whole_number_in(1, kMostLights))
        ->capture_default_str();
    command->add_option("--size", raw.bench_size, "size of the picture in pixels")
        ->check(size_validator())
        ->capture_default_str();
    command->add_option("--camera", o.camera, "the camera, as in `weft render`");
    command
        ->add_option("--env", o.env, "the environment of the scene: sky, none, or a Radiance picture (.hdr)")
        ->check(env_validator())
        ->capture_default_str();
    command
        ->add_option("--env-gain", o.env_gain,
                     "a factor on the light of the environment picture, including its suns")
        ->transform(number_in({1e-6, 1e9, ""}))
        ->capture_default_str();
    command->add_option("--probes", o.probes, "the light probes of the scene, as in `weft render`")
        ->capture_default_str();
    command->add_option("--seed", o.seed, "seed of the random lights")
        ->transform(whole_number_in(0, kMostSeed))
        ->capture_default_str();
    command
        ->add_option("--rounds", o.rounds,
                     "number of rounds; in each round, each graph renders one measured frame")
        ->transform(whole_number_in(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--plot", o.plot,
                     "write a plot of the times over the numbers of lights to this .svg file")
        ->check(plot_validator());
    command->add_option("--device", o.device, "the Vulkan device: its index or a part of its name");
    command->add_option("--timeout", o.timeout_s, "seconds to wait for a frame before the command fails")
        ->transform(number_in(kTimeout))
        ->capture_default_str();
    add_graph_path(*command, raw);
    add_limits(*command, raw);
    command->add_flag("--json", o.json, "print the result as JSON");
}

}  // namespace

void add_bench(CLI::App& app, BenchCommands& bench, RawTexts& raw) {
    bench.app = app.add_subcommand("bench", "measure compile times or frame times");
    bench.app->require_subcommand(1);
    bench.compile = add_bench_compile(*bench.app, bench.compile_options);
    add_bench_frame(*bench.app, bench.frame_options, raw);
}

}  // namespace weft::viewer

#include "viewer/options/add_options.h"

#include <CLI/CLI.hpp>

#include "viewer/options/validators.h"

namespace weft::viewer {
namespace {

constexpr NumberRange kAnyDifference{-1e30, 1e30, ""};

void add_sandbox(CLI::App& command, bool& sandbox) {
    command.add_flag(
        "--sandbox", sandbox,
        "for untrusted files: run in a process that can open only the files that the command needs");
}

void add_size(CLI::App& command, RawTexts& raw) {
    command.add_option("--size", raw.size, "size of the output in pixels")
        ->check(size_validator())
        ->capture_default_str();
}

void add_queues(CLI::App& command, uint32_t& count) {
    command
        .add_option("--queues", count,
                    "number of queues in the plan: 1 = graphics; 2 adds compute, 3 adds transfer, 4 adds a "
                    "second compute queue")
        ->transform(whole_number_in(1, kMostQueues))
        ->capture_default_str();
}

// Adds the options of commands that compile a graph without a device.
void add_offline(CLI::App& command, OfflineOptions& o, RawTexts& raw) {
    command.add_option("--profile", o.profile,
                       "a device profile: a file, or the name of a shipped profile [default: lavapipe]");
    add_size(command, raw);
    add_queues(command, o.queues);
    command.add_option("--param", raw.params, "a parameter of the graph; may be repeated")
        ->check(param_validator());
    command
        .add_option("--import", raw.imports,
                    "an import of your program, such as props=drawlist:position,normal; may be repeated")
        ->check(import_validator());
    add_graph_path(command, raw);
    add_limits(command, raw);
}

void add_tier(CLI::App& command, OfflineOptions& o, const char* otherwise) {
    command.add_option("--tier", o.request.tier,
                       std::string("the quality tier of the graph [default: ") + otherwise + "]");
}

void add_camera(CLI::App& command, RenderOptions& o) {
    command.add_option("--camera", o.camera,
                       "the name of a camera in the scene, or EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG");
    command
        .add_option("--camera-path", o.camera_path,
                    "a JSON file with positions of the camera over time, between which it moves smoothly")
        ->excludes("--camera");
}

void add_probes(CLI::App& command, RenderOptions& o) {
    command.add_option("--probes", o.probes,
                       "the light probes of the scene: auto, none, or a file (.json) [default: "
                       "NAME.probes.json beside the scene, or auto]");
    command
        .add_option("--probe-rounds", o.probe_rounds,
                    "how often each light probe is lit before the first frame; 0: not before it")
        ->transform(whole_number_in(0, kMostProbeRounds))
        ->capture_default_str();
}

}  // namespace

void add_limits(CLI::App& command, RawTexts& raw) {
    command.add_option("--limits", raw.limits, "a JSON file that changes the limits for input files");
}

void add_graph_path(CLI::App& command, RawTexts& raw) {
    command
        .add_option(
            "--graph-path", raw.graph_path,
            "a folder in which included graphs are searched before the shipped graphs; may be repeated")
        ->check(folder_validator());
}

void add_swap(CLI::App& command, RenderOptions& o) {
    command
        .add_option(
            "--swap", o.swap,
            "graphs that replace each other while frames are rendered, for example ultra,low,high: tiers of "
            "the graph, or FILE.json, or FILE.json:TIER")
        ->delimiter(',')
        ->excludes("--tier");
    command.add_option("--every", o.every, "with --swap: the number of frames that each graph renders")
        ->transform(whole_number_in(1, 1000000))
        ->needs("--swap")
        ->capture_default_str();
}

void add_render(CLI::App& command, RenderOptions& o, RawTexts& raw) {
    command
        .add_option("SCENE", o.scene,
                    "the scene: a .gltf or .glb file, a folder that contains one, or builtin:NAME")
        ->capture_default_str();
    command.add_option("-o,--output", o.output, "the picture file to write: .png, .exr or .pfm")
        ->capture_default_str();
    command.add_option("--graph", o.request.path,
                       "the graph file (JSON) [default: the shipped graphs/weft.json]");
    add_graph_path(command, raw);
    command.add_option("--tier", o.request.tier, "the quality tier of the graph [default: none]");
    add_size(command, raw);
    command
        .add_option("--frames", raw.frames,
                    "N: render N frames and write the last one; A..B: render B frames and write the frames A "
                    "to B, for example to seq%04d.png [default: `frames` of the graph, or 1]")
        ->check(frames_validator());
    add_swap(command, o);
    command
        .add_option("--fixed-dt", o.fixed_dt_s,
                    "scene time between two frames in seconds, such as 0.02 or 1/60")
        ->transform(fraction_in({0, 3600, "s"}));
    add_camera(command, o);
    command
        .add_option("--env", o.env, "the environment of the scene: sky, none, or a Radiance picture (.hdr)")
        ->check(env_validator())
        ->capture_default_str();
    command
        .add_option("--env-gain", o.env_gain,
                    "a factor on the light of the environment picture, including its suns")
        ->transform(number_in({1e-6, 1e9, ""}))
        ->capture_default_str();
    command
        .add_option("--time", o.hour, "the hour of the day, 0 to 24, in builtin:atrium and builtin:lights")
        ->transform(number_in({0, 24, "hours"}));
    command.add_option("--lights", o.lights, "number of random lights that replace the scene's lights")
        ->transform(whole_number_in(1, kMostLights));
    command.add_option("--seed", o.seed, "seed of the random lights of --lights")
        ->transform(whole_number_in(0, kMostSeed))
        ->capture_default_str();
    command
        .add_option("--exposure", raw.exposure,
                    "fixed exposure of the picture in EV [default: automatic, or the exposure of the scene "
                    "if the graph has "
                    "no automatic exposure]")
        ->transform(number_in({-40, 40, "EV"}));
    add_probes(command, o);
    command.add_option("--param", raw.params, "a parameter of the graph; may be repeated")
        ->check(param_validator());
    command
        .add_option(
            "--turns", raw.turns,
            "rounds of a group that run in each frame, for an import of kind \"turns\"; may be repeated")
        ->check(turns_validator());
    command.add_option(
        "--resource", o.resource,
        "write the unchanged values of this resource instead of the output, for example hdr, hdr@lighting or "
        "hiz.mip(2)");
    command
        .add_option("--debug", o.request.debug,
                    "write this debug view of the graph instead of the output: the name of an entry of "
                    "`debug`, or of a resource, which is then shown with suitable colours")
        ->excludes("--resource");
    command.add_flag("--validate", o.validate,
                     "run under the Vulkan validation layer; any message gives exit code 5");
    command.add_flag("--verify-rest", o.verify_rest,
                     "render the frames twice, the second time without \"rest\", and compare the results");
    command.add_option("--stats", o.stats, "write times, memory and hashes to this JSON file");
    command.add_option("--device", o.device, "the Vulkan device: its index or a part of its name");
    add_queues(command, o.queues);
    command.add_option("--timeout", o.timeout_s, "seconds to wait for a frame before the command fails")
        ->transform(number_in(kTimeout))
        ->capture_default_str();
    add_limits(command, raw);
    add_sandbox(command, o.sandbox);
    command.add_option("--test-drop-barriers", o.drop_barriers_before)->group("");
}

void add_view(CLI::App& command, ViewOptions& o, RawTexts& raw) {
    o.render.output.clear();
    add_render(command, o.render, raw);
    for (const char* flag :
         {"--resource", "--debug", "--test-drop-barriers", "--output", "--frames", "--stats", "--sandbox",
          "--verify-rest", "--probe-rounds", "--camera-path", "--every", "--swap"})
        command.remove_option(command.get_option(flag));
    command.add_flag("--headless", o.headless, "run without a window");
    command.add_option("-o,--output", o.render.output,
                       "write the last frame to this picture file: .png, .exr or .pfm");
    command
        .add_option("--frames", o.render.frames,
                    "end after this many frames [default: end on SIGINT, SIGTERM, or when stdin closes]")
        ->transform(whole_number_in(1, 100'000'000));
    command.add_option("--stats", o.render.stats,
                       "write the number of frames, of reloads and of validation messages to this JSON file");
}

void add_check(CLI::App& command, CheckOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.files, "graph files")->required();
    add_tier(command, o.offline, "check without a tier, then with each tier");
    add_offline(command, o.offline, raw);
    command.add_flag("--run", o.run,
                     "run the tests in the graphs, on a device and under the Vulkan validation layer");
    command.add_option("--device", o.device, "the Vulkan device for --run: its index or a part of its name");
    add_sandbox(command, o.sandbox);
    CLI::Option* json = command.add_flag("--json", o.json, "print errors and warnings as JSON to stdout");
    command.add_flag("--sarif", o.sarif, "print errors and warnings as a SARIF 2.1.0 log to stdout")
        ->excludes(json);
}

void add_plan(CLI::App& command, PlanOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.file, "a graph file")->required();
    add_tier(command, o.offline, "none");
    add_offline(command, o.offline, raw);
    command
        .add_option("--format", o.format,
                    "format of the plan: text, json, dot (Graphviz), html, or cooked (graph and shaders for "
                    "a program)")
        ->check(choice_validator({"text", "json", "dot", "html", "cooked"}))
        ->capture_default_str();
    command.add_option("-o,--output", o.output, "write to this file instead of stdout");
    add_sandbox(command, o.sandbox);
}

void add_schema(CLI::App& command, SchemaOptions& o, RawTexts& raw) {
    command.add_option(
        "FILE", o.file,
        "a graph file; the schema then proposes the names in this graph [default: a schema for all graphs]");
    command.add_option("-o,--output", o.output, "write to this file instead of stdout");
    add_graph_path(command, raw);
    add_limits(command, raw);
}

void add_explain(CLI::App& command, ExplainOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.file, "a graph file")->required();
    command
        .add_option("QUESTION", o.question,
                    "the question: culled, barrier, alias, wait, rest, switch, views or resource")
        ->check(
            choice_validator({"culled", "barrier", "alias", "wait", "rest", "switch", "views", "resource"}))
        ->required();
    command
        .add_option("NAME", o.names,
                    "names for the question: culled PASS, barrier PASS PASS, alias RESOURCE RESOURCE, wait "
                    "PASS, rest PASS, switch PASS, views PASS, resource RESOURCE")
        ->required()
        ->expected(1, 2);
    add_tier(command, o.offline, "none");
    add_offline(command, o.offline, raw);
}

void add_diff(CLI::App& command, DiffOptions& o, RawTexts& raw) {
    command.add_option("FROM", o.from, "a graph file, or FILE:TIER")->required();
    command.add_option("TO", o.to, "another graph file, or the same file with another tier")->required();
    add_offline(command, o.offline, raw);
    command.add_flag("--json", o.json, "print the differences as JSON");
}

void add_compare(CLI::App& command, CompareOptions& o, RawTexts& raw) {
    command.add_option("REFERENCE", o.reference, "the reference picture: .png, .exr or .pfm")->required();
    command.add_option("TEST", o.test, "the picture to compare with the reference, of the same size")
        ->required();
    command
        .add_option("--metric", o.metric,
                    "flip: visible difference, 0 to 1; psnr: signal-to-noise ratio in dB; max: largest "
                    "difference of a channel")
        ->check(choice_validator({"flip", "psnr", "max"}))
        ->capture_default_str();
    command
        .add_option(
            "--max", o.max,
            "with the metrics flip and max: exit code 6 if the difference is greater than this number")
        ->transform(number_in(kAnyDifference));
    command.add_option("--min", o.min, "for psnr: exit code 6 if the result is below this number")
        ->transform(number_in(kAnyDifference));
    command.add_option("-o,--output", o.output, "write a picture of the differences to this .png file");
    command.add_flag("--json", o.json, "print the result as JSON");
    add_limits(command, raw);
}

void add_scene(CLI::App& command, SceneOptions& o, RawTexts& raw) {
    command.add_option("SCENE", o.scene, "the scene, as in `weft render`")->capture_default_str();
    command.add_option(
        "--probes", o.probes,
        "the light probes: auto, none, or a file (.json) [default: NAME.probes.json beside the "
        "scene, or auto]");
    command.add_option("--camera", o.camera,
                       "the camera, as in `weft render`; large scenes have probes around it");
    command
        .add_option("--time", o.hour, "the hour of the day, 0 to 24, in builtin:atrium and builtin:lights")
        ->transform(number_in({0, 24, "hours"}));
    command.add_option("-o,--output", o.picture,
                       "draw the probes from above and from the side to this .png file");
    command.add_option("--gltf", o.gltf, "write the scene as binary glTF 2.0 to this .glb file");
    command.add_option("--sky", o.sky,
                       "write the sky as an equirectangular picture in cd/m² to this .hdr file");
    command.add_flag("--json", o.json, "print the probes as JSON, in the format of a file with probes");
    add_limits(command, raw);
}

void add_doctor(CLI::App& command, DoctorOptions& o) {
    command.add_flag("--json", o.json, "print the profile of the chosen device as JSON to stdout");
    command.add_option("--device", o.device, "the Vulkan device: its index or a part of its name");
}

}  // namespace weft::viewer

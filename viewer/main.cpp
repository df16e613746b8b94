// The command line. It only fills the options of a command and returns the command's exit code.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <CLI/CLI.hpp>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "arguments.h"
#include "commands.h"
#include "driver_cache.h"
#include "files.h"
#include "memory_reserve.h"
#include "numbers.h"
#include "output.h"
#include "sandbox.h"
#include "usage_hint.h"

namespace weft::viewer {
namespace {

[[nodiscard]] int exit_with(ExitCode code) {
    return static_cast<int>(code);
}

CLI::Validator size_validator() {
    return CLI::Validator([](std::string& text) { return size_fault(text); }, "WxH");
}

CLI::Validator param_validator() {
    return CLI::Validator([](std::string& text) { return param_fault(text); }, "NAME=VALUE");
}

CLI::Validator env_validator() {
    return CLI::Validator([](std::string& text) { return env_fault(text); }, "sky|none|FILE.hdr");
}

// These replace what was written by a plain decimal number, which CLI11 reads the same everywhere.
CLI::Validator number_in(const NumberRange& range) {
    return CLI::Validator(
        [range](std::string& text) {
            std::string fault = number_fault(text, range);
            if (fault.empty()) text = decimal(*finite_number(text));
            return fault;
        },
        describe(range));
}

CLI::Validator choice_validator(std::vector<std::string> choices) {
    return CLI::Validator(
        [choices = std::move(choices)](std::string& text) { return choice_fault(text, choices); }, "");
}

CLI::Validator fraction_in(const NumberRange& range) {
    return CLI::Validator(
        [range](std::string& text) {
            std::string fault = fraction_fault(text, range);
            if (fault.empty()) text = decimal(*finite_fraction(text));
            return fault;
        },
        describe(range) + ", or a fraction");
}

CLI::Validator whole_number_in(uint64_t least, uint64_t most) {
    return CLI::Validator(
        [least, most](std::string& text) {
            std::string fault = whole_number_fault(text, least, most);
            if (fault.empty()) text = std::to_string(*whole_number(text));
            return fault;
        },
        std::to_string(least) + " to " + std::to_string(most));
}

constexpr uint64_t kMostSeed = 0xFFFFFFFF;
constexpr uint64_t kMostLights = 65'536;
constexpr uint64_t kMostQueues = 4;
constexpr NumberRange kTimeout{0.001, 3600, "s"};
constexpr NumberRange kAnyDifference{-1e30, 1e30, ""};

// Texts that need a second look after parsing.
struct RawTexts {
    std::string size = "1280x720";
    std::string bench_size = "640x360";
    std::vector<std::string> params;
    double exposure = 0;
    std::string limits;
};

void add_limits(CLI::App& command, RawTexts& raw) {
    command.add_option("--limits", raw.limits, "a JSON file of limits on what inputs may ask for");
}

void add_sandbox(CLI::App& command, bool& sandbox) {
    command.add_flag("--sandbox", sandbox, "for files of strangers: run where nothing else can be opened");
}

void add_render(CLI::App& command, RenderOptions& o, RawTexts& raw) {
    command.add_option("SCENE", o.scene, "a .gltf or .glb file, a folder that holds one, or builtin:NAME")
        ->capture_default_str();
    command.add_option("-o,--output", o.output, "the picture: .png, .exr or .pfm")->capture_default_str();
    command.add_option("--graph", o.graph, "the pipeline, a JSON file [the shipped graphs/deferred.json]");
    command.add_option("--tier", o.tier, "a quality tier of the graph [the graph as it is]");
    command.add_option("--size", raw.size, "in pixels")->check(size_validator())->capture_default_str();
    command.add_option("--frames", o.frames, "how many to render; the last is written [the graph's, else 1]")
        ->transform(whole_number_in(1, 1'000'000));
    command.add_option("--fixed-dt", o.fixed_dt_s, "seconds from frame to frame, such as 0.02 or 1/60")
        ->transform(fraction_in({0, 3600, "s"}));
    command.add_option("--camera", o.camera,
                       "a camera of the scene by name, or EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG");
    command.add_option("--env", o.env, "what surrounds the scene: sky, none, or a Radiance picture (.hdr)")
        ->check(env_validator())
        ->capture_default_str();
    command
        .add_option("--time", o.hour, "the hour of the day, 0 to 24, of builtin:atrium and builtin:lights")
        ->transform(number_in({0, 24, "hours"}));
    command.add_option("--lights", o.lights, "so many seeded lights in place of the scene's")
        ->transform(whole_number_in(1, kMostLights));
    command.add_option("--seed", o.seed, "of --lights")
        ->transform(whole_number_in(0, kMostSeed))
        ->capture_default_str();
    command.add_option("--exposure", raw.exposure, "in EV, in place of the scene's")
        ->transform(number_in({-40, 40, "EV"}));
    command.add_option("--param", raw.params, "a parameter of the graph; may be repeated")
        ->check(param_validator());
    command.add_option("--resource", o.resource,
                       "write this resource (name@pass.mip(e).layer(e)), not the output");
    command
        .add_option("--debug", o.debug, "write this debug view of the graph, or any resource made visible")
        ->excludes("--resource");
    command.add_flag("--validate", o.validate, "run under the validation layers; any message is exit code 5");
    command.add_option("--stats", o.stats, "write times, memory and hashes to this JSON file");
    command.add_option("--device", o.device, "a device's index or part of its name");
    command
        .add_option("--queues", o.queues,
                    "how many queues to plan for: 1 graphics, 2 + compute, 3 + transfer")
        ->transform(whole_number_in(1, kMostQueues))
        ->capture_default_str();
    command.add_option("--timeout", o.timeout_s, "seconds to wait for a frame")
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
         {"--resource", "--debug", "--test-drop-barriers", "--output", "--frames", "--stats", "--sandbox"})
        command.remove_option(command.get_option(flag));
    command.add_flag("--headless", o.headless, "without a window");
    command.add_option("-o,--output", o.render.output, "write the last frame: .png, .exr or .pfm");
    command.add_option("--frames", o.render.frames, "end after so many [SIGINT, SIGTERM, or stdin closes]")
        ->transform(whole_number_in(1, 100'000'000));
    command.add_option("--stats", o.render.stats,
                       "write how often was reloaded, and more, to this JSON file");
}

// How a graph is compiled where there is no device.
void add_offline(CLI::App& command, OfflineOptions& o, RawTexts& raw) {
    command.add_option("--profile", o.profile,
                       "a device profile: a file, or a shipped one's name [lavapipe]");
    command.add_option("--size", raw.size, "of the output")->check(size_validator())->capture_default_str();
    command.add_option("--queues", o.queues, "how many queues: graphics, compute, transfer, compute")
        ->transform(whole_number_in(1, kMostQueues))
        ->capture_default_str();
    command.add_option("--param", raw.params, "a parameter of the graph; may be repeated")
        ->check(param_validator());
    add_limits(command, raw);
}

void add_tier(CLI::App& command, OfflineOptions& o, const char* otherwise) {
    command.add_option("--tier", o.tier, std::string("a quality tier of the graph [") + otherwise + "]");
}

void add_check(CLI::App& command, CheckOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.files, "graph files")->required();
    add_tier(command, o.offline, "the graph as it is and all tiers");
    add_offline(command, o.offline, raw);
    command.add_flag("--run", o.run,
                     "run the graphs' own tests, on a device and under the validation layers");
    command.add_option("--device", o.device, "for --run: a device's index or part of its name");
    add_sandbox(command, o.sandbox);
    CLI::Option* json = command.add_flag("--json", o.json, "what was found, as JSON on stdout");
    command.add_flag("--sarif", o.sarif, "what was found, as a SARIF 2.1.0 log on stdout")->excludes(json);
}

void add_plan(CLI::App& command, PlanOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.file, "a graph file")->required();
    add_tier(command, o.offline, "the graph as it is");
    add_offline(command, o.offline, raw);
    command.add_option("--format", o.format, "text, json, dot or html")
        ->check(choice_validator({"text", "json", "dot", "html"}))
        ->capture_default_str();
    command.add_option("-o,--output", o.output, "a file in place of stdout");
    add_sandbox(command, o.sandbox);
}

void add_schema(CLI::App& command, SchemaOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.file, "a graph file, whose names become choices [all graphs]");
    command.add_option("-o,--output", o.output, "a file in place of stdout");
    add_limits(command, raw);
}

void add_explain(CLI::App& command, ExplainOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.file, "a graph file")->required();
    command.add_option("QUESTION", o.question, "culled, barrier, alias, wait or resource")
        ->check(choice_validator({"culled", "barrier", "alias", "wait", "resource"}))
        ->required();
    command.add_option("NAME", o.names, "PASS, PASS PASS, RESOURCE RESOURCE, PASS, RESOURCE")
        ->required()
        ->expected(1, 2);
    add_tier(command, o.offline, "the graph as it is");
    add_offline(command, o.offline, raw);
}

void add_diff(CLI::App& command, DiffOptions& o, RawTexts& raw) {
    command.add_option("FROM", o.from, "a graph file, or FILE:TIER")->required();
    command.add_option("TO", o.to, "another, or the same")->required();
    add_offline(command, o.offline, raw);
    command.add_flag("--json", o.json, "as JSON");
}

void add_compare(CLI::App& command, CompareOptions& o, RawTexts& raw) {
    command.add_option("REFERENCE", o.reference, "a .png, .exr or .pfm")->required();
    command.add_option("TEST", o.test, "another of the same size")->required();
    command
        .add_option("--metric", o.metric,
                    "flip: what a viewer sees, 0 to 1; psnr: in dB; max: the largest difference of a channel")
        ->check(choice_validator({"flip", "psnr", "max"}))
        ->capture_default_str();
    command.add_option("--max", o.max, "exit code 6 when the mean FLIP, or max, is above this")
        ->transform(number_in(kAnyDifference));
    command.add_option("--min", o.min, "exit code 6 when the PSNR is below this")
        ->transform(number_in(kAnyDifference));
    command.add_option("-o,--output", o.output, "write where they differ to this .png");
    command.add_flag("--json", o.json, "as JSON");
    add_limits(command, raw);
}

// `bench compile` and `bench frame`.
struct BenchCommands {
    CLI::App* app = nullptr;
    CLI::App* compile = nullptr;
    BenchOptions compile_options;
    FrameBenchOptions frame_options;
};

CLI::App* add_bench_compile(CLI::App& bench, BenchOptions& o) {
    CLI::App* command = bench.add_subcommand("compile", "how long compiling takes, on graphs made by a seed");
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
                     "shipped graphs by name, or files; the first is what others are held against")
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
        ->check(CLI::Validator([](std::string& text) { return plot_fault(text); }, "FILE.svg"));
    command->add_option("--device", o.device, "a device's index or part of its name");
    command->add_option("--timeout", o.timeout_s, "seconds to wait for a frame")
        ->transform(number_in(kTimeout))
        ->capture_default_str();
    add_limits(*command, raw);
    command->add_flag("--json", o.json, "as JSON");
}

void add_bench(CLI::App& app, BenchCommands& bench, RawTexts& raw) {
    bench.app = app.add_subcommand("bench", "measure: `weft bench compile`, `weft bench frame`");
    bench.app->require_subcommand(1);
    bench.compile = add_bench_compile(*bench.app, bench.compile_options);
    add_bench_frame(*bench.app, bench.frame_options, raw);
}

ExitCode run_bench(BenchCommands& bench, const RawTexts& raw, const Limits& limits) {
    if (bench.compile->parsed()) return run_bench_compile(bench.compile_options);
    bench.frame_options.limits = limits;
    bench.frame_options.size = parse_size(raw.bench_size);
    return run_bench_frame(bench.frame_options);
}

std::string folder_of(const std::string& file) {
    return file.empty() ? std::string() : std::filesystem::absolute(file).parent_path().string();
}

// A scene is a file, whose folder it may read, or a folder; built-in ones read nothing.
std::string folder_of_scene(const std::string& scene) {
    if (scene.starts_with("builtin:")) return {};
    return std::filesystem::is_directory(scene) ? scene : folder_of(scene);
}

// Nothing: the command goes on, in a sandbox if it was asked for. Else the exit code. At most one is there.
std::optional<ExitCode> enter_sandbox(RenderOptions* render, CheckOptions* check, PlanOptions* plan) {
    SandboxNeeds needs;
    if (render != nullptr && render->sandbox) {
        const bool is_file = render->env != "sky" && render->env != "none";
        needs = {{folder_of(render->graph), folder_of_scene(render->scene), is_file ? render->env : ""},
                 {&render->output, &render->stats},
                 true};
        render->named_output = render->output;
    } else if (check != nullptr && check->sandbox) {
        for (const std::string& file : check->files) needs.read.push_back(folder_of(file));
        needs.read.push_back(check->offline.profile);
        needs.device = check->run;
    } else if (plan != nullptr && plan->sandbox) {
        needs = {{folder_of(plan->file), plan->offline.profile}, {&plan->output}, false};
    } else {
        return std::nullopt;
    }
    return run_in_sandbox(needs);
}

// CLI11's own exit codes become usage errors.
int usage_exit(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
        std::ostringstream text;
        app.exit(error, text, text);
        return exit_with(print_data(text.str()));
    }
    std::fprintf(stderr, "weft: %s\n%sRun `weft --help`, or `weft COMMAND --help`.\n", error.what(),
                 usage_hint(app).c_str());
    return exit_with(ExitCode::usage);
}

int run(int argc, char** argv) {
    CLI::App app{"weft compiles a render graph written as JSON, proves the plan, and runs it on Vulkan.",
                 "weft"};
    app.set_version_flag("--version", "weft 0.1.0");
    app.require_subcommand(0, 1);  // so that a misspelt one is named
    RawTexts raw;
    RenderOptions render_options;
    ViewOptions view_options;
    CheckOptions check_options;
    PlanOptions plan_options;
    SchemaOptions schema_options;
    DoctorOptions doctor_options;
    ExplainOptions explain_options;
    DiffOptions diff_options;
    CompareOptions compare_options;
    BenchCommands bench;
    CLI::App* render = app.add_subcommand("render", "render a scene through a graph to a picture");
    add_render(*render, render_options, raw);
    CLI::App* view = app.add_subcommand("view", "draw on and on, and follow what changes in the files");
    add_view(*view, view_options, raw);
    CLI::App* check = app.add_subcommand("check", "find what is wrong with graph files");
    add_check(*check, check_options, raw);
    CLI::App* plan = app.add_subcommand("plan", "show the compiled frame: order, barriers, memory");
    add_plan(*plan, plan_options, raw);
    CLI::App* schema = app.add_subcommand("schema", "print the JSON schema of graphs, or of one graph");
    add_schema(*schema, schema_options, raw);
    CLI::App* explain = app.add_subcommand("explain", "say why a plan is as it is");
    add_explain(*explain, explain_options, raw);
    CLI::App* diff = app.add_subcommand("diff", "say what two plans have not in common");
    add_diff(*diff, diff_options, raw);
    CLI::App* compare = app.add_subcommand("compare", "say how far apart two pictures are");
    add_compare(*compare, compare_options, raw);
    CLI::App* doctor = app.add_subcommand("doctor", "say what this machine has and lacks");
    doctor->add_flag("--json", doctor_options.json, "the chosen device's profile, as JSON on stdout");
    doctor->add_option("--device", doctor_options.device, "a device's index or part of its name");
    add_bench(app, bench, raw);
    if (const std::string fault = future_fault({argv + std::min(argc, 1), argv + argc}); !fault.empty()) {
        std::fprintf(stderr, "weft: %s\n", fault.c_str());
        return exit_with(ExitCode::usage);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return usage_exit(app, error);
    }
    const Result<Limits> limits = load_limits(raw.limits);
    if (!limits) {
        report(limits.errors());
        return exit_with(exit_code_for(limits.errors()));
    }
    render_options.limits = compare_options.limits = schema_options.limits = *limits;
    render_options.size = parse_size(raw.size);
    render_options.params = parse_params(raw.params);
    view_options.render.limits = *limits;
    view_options.render.size = render_options.size;
    view_options.render.params = render_options.params;
    view_options.fixed_dt = view->count("--fixed-dt") > 0;
    if (view->count("--exposure") > 0) view_options.render.exposure_ev = static_cast<float>(raw.exposure);
    for (OfflineOptions* offline :
         {&check_options.offline, &plan_options.offline, &explain_options.offline, &diff_options.offline}) {
        offline->size = render_options.size;
        offline->params = render_options.params;
        offline->limits = *limits;
    }
    if (render->count("--exposure") > 0) render_options.exposure_ev = static_cast<float>(raw.exposure);
    if (const auto ended = enter_sandbox(render->parsed() ? &render_options : nullptr,
                                         check->parsed() ? &check_options : nullptr,
                                         plan->parsed() ? &plan_options : nullptr))
        return exit_with(*ended);
    const bool needs_device = render->parsed() || view->parsed() || doctor->parsed() ||
                              (check->parsed() && check_options.run) ||
                              (bench.app->parsed() && !bench.compile->parsed());
    if (needs_device) prepare_driver_cache();
    if (render->parsed()) return exit_with(run_render(render_options));
    if (view->parsed()) return exit_with(run_view(view_options));
    if (check->parsed()) return exit_with(run_check(check_options));
    if (plan->parsed()) return exit_with(run_plan(plan_options));
    if (schema->parsed()) return exit_with(run_schema(schema_options));
    if (explain->parsed()) return exit_with(run_explain(explain_options));
    if (diff->parsed()) return exit_with(run_diff(diff_options));
    if (compare->parsed()) return exit_with(run_compare(compare_options));
    if (doctor->parsed()) return exit_with(run_doctor(doctor_options));
    if (bench.app->parsed()) return exit_with(run_bench(bench, raw, *limits));
    std::fputs(
        "weft: say what to do: render, view, check, plan, schema, explain, diff, compare, bench or "
        "doctor\nRun "
        "`weft --help`.\n",
        stderr);
    return exit_with(ExitCode::usage);
}

}  // namespace
}  // namespace weft::viewer

int main(int argc, char** argv) {
    weft::viewer::hold_memory_reserve();
    weft::viewer::prepare_output();
    try {
        return weft::viewer::run(argc, argv);
    } catch (const std::bad_alloc&) {
        weft::viewer::report_out_of_memory();
        return static_cast<int>(weft::viewer::ExitCode::failed);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "weft: internal error: %s\n", error.what());
        return static_cast<int>(weft::viewer::ExitCode::failed);
    }
}

// Parses the command line into the options of a command, runs the command and returns its exit code.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>
#include <string>

#include "viewer/commands/commands.h"
#include "viewer/files/files.h"
#include "viewer/options/add_options.h"
#include "viewer/options/arguments.h"
#include "viewer/options/help_format.h"
#include "viewer/options/import_texts.h"
#include "viewer/options/usage_hint.h"
#include "viewer/options/validators.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/pictures/picture_sequence.h"
#include "viewer/process/driver_cache.h"
#include "viewer/process/memory_reserve.h"
#include "viewer/sandbox/sandbox.h"

namespace weft::viewer {
namespace {

[[nodiscard]] int exit_with(ExitCode code) {
    return static_cast<int>(code);
}

std::string folder_of(const std::string& file) {
    return file.empty() ? std::string() : std::filesystem::absolute(file).parent_path().string();
}

// Returns the folder that the loader of the scene must be able to read: the folder of the scene file, or the
// scene itself if it is a folder. Built-in scenes read no files.
std::string folder_of_scene(const std::string& scene) {
    if (scene.starts_with("builtin:")) return {};
    return std::filesystem::is_directory(scene) ? scene : folder_of(scene);
}

// The commands of the program, and the structs that receive the parsed options.
struct CommandLine {
    CLI::App app{"weft compiles a render graph written as JSON, checks the plan, and runs it on Vulkan.",
                 "weft"};
    RawTexts raw;
    RenderOptions render_options;
    ViewOptions view_options;
    CheckOptions check_options;
    PlanOptions plan_options;
    SchemaOptions schema_options;
    SceneOptions scene_options;
    DoctorOptions doctor_options;
    ExplainOptions explain_options;
    DiffOptions diff_options;
    CompareOptions compare_options;
    BenchCommands bench;
    CLI::App* render = app.add_subcommand("render", "render a scene with a graph and write a picture");
    CLI::App* view = app.add_subcommand("view", "render continuously, and reload files that change");
    CLI::App* check = app.add_subcommand("check", "check graph files and list their errors and warnings");
    CLI::App* plan = app.add_subcommand("plan", "show the compiled frame: order of passes, barriers, memory");
    CLI::App* schema = app.add_subcommand("schema", "print the JSON schema of all graphs, or of one graph");
    CLI::App* explain = app.add_subcommand("explain", "answer a question about a plan");
    CLI::App* diff = app.add_subcommand("diff", "list the differences between two plans");
    CLI::App* compare = app.add_subcommand("compare", "measure the difference of two pictures");
    CLI::App* scene = app.add_subcommand("scene", "describe a scene, and place its light probes");
    CLI::App* doctor = app.add_subcommand(
        "doctor", "list the Vulkan devices and layers, and what weft needs but does not find");

    CommandLine();
    void finish(const Limits& limits);
    [[nodiscard]] Status name_pictures();
    [[nodiscard]] std::optional<ExitCode> enter_sandbox();
    [[nodiscard]] bool needs_device() const;
    [[nodiscard]] ExitCode run_command();
};

CommandLine::CommandLine() {
    app.set_version_flag("--version", "weft 0.1.0");
    // The minimum is zero commands, although a command is required. With a minimum of one, the error of CLI11
    // for a misspelt command would not contain that word.
    app.require_subcommand(0, 1);
    add_render(*render, render_options, raw);
    add_view(*view, view_options, raw);
    add_check(*check, check_options, raw);
    add_plan(*plan, plan_options, raw);
    add_schema(*schema, schema_options, raw);
    add_explain(*explain, explain_options, raw);
    add_diff(*diff, diff_options, raw);
    add_compare(*compare, compare_options, raw);
    add_scene(*scene, scene_options, raw);
    add_doctor(*doctor, doctor_options);
    add_bench(app, bench, raw);
    format_help(app);
}

// Completes the options after parsing: converts texts such as "1280x720" to values, and copies options that
// several commands share.
void CommandLine::finish(const Limits& limits) {
    scene_options.limits = limits;
    render_options.limits = compare_options.limits = schema_options.limits = limits;
    bench.frame_options.limits = view_options.render.limits = limits;
    render_options.graph_path = view_options.render.graph_path = schema_options.graph_path = raw.graph_path;
    bench.frame_options.graph_path = raw.graph_path;
    bench.frame_options.size = parse_size(raw.bench_size);
    render_options.request.size = view_options.render.request.size = parse_size(raw.size);
    render_options.request.params = view_options.render.request.params = parse_params(raw.params);
    const FrameRange range = parse_frames(raw.frames);
    render_options.frames = range.frames;
    render_options.first_picture = range.first_picture;
    render_options.turns = view_options.render.turns = parse_turns(raw.turns);
    view_options.fixed_dt = view->count("--fixed-dt") > 0;
    if (view->count("--exposure") > 0) view_options.render.exposure_ev = static_cast<float>(raw.exposure);
    if (render->count("--exposure") > 0) render_options.exposure_ev = static_cast<float>(raw.exposure);
    for (OfflineOptions* offline :
         {&check_options.offline, &plan_options.offline, &explain_options.offline, &diff_options.offline}) {
        offline->request.size = render_options.request.size;
        offline->request.params = render_options.request.params;
        offline->limits = limits;
        offline->graph_path = raw.graph_path;
        offline->imports = parse_imports(raw.imports);
    }
}

// Finds the files of the pictures that `render --frames A..B` writes. Error: X524.
Status CommandLine::name_pictures() {
    RenderOptions& o = render_options;
    if (!render->parsed() || o.first_picture == 0) return Unit{};
    Result<std::vector<std::string>> files = picture_sequence(o.output, o.first_picture, o.frames);
    if (!files) return files.take_errors();
    o.pictures = std::move(*files);
    return Unit{};
}

// Enters the sandbox if the command has --sandbox. Returns nullopt if this process must run the command.
// Otherwise, returns the exit code with which this process must end, because a child process ran the command.
std::optional<ExitCode> CommandLine::enter_sandbox() {
    SandboxNeeds needs;
    if (render->parsed() && render_options.sandbox) {
        RenderOptions& o = render_options;
        const bool is_file = o.env != "sky" && o.env != "none";
        const bool is_probe_file = o.probes != "auto" && o.probes != "none";
        needs = {{folder_of(o.request.path), folder_of_scene(o.scene), is_file ? o.env : "",
                  is_probe_file ? o.probes : "", o.camera_path},
                 inputs_of(o),
                 {&o.stats},
                 true};
        o.named_output = o.pictures.size() == 1 ? o.pictures.front() : o.output;
        if (o.pictures.empty()) needs.outputs.push_back(&o.output);
        for (std::string& file : o.pictures) needs.outputs.push_back(&file);
    } else if (check->parsed() && check_options.sandbox) {
        for (const std::string& file : check_options.files) needs.read.push_back(folder_of(file));
        needs.read.push_back(check_options.offline.profile);
        needs.device = check_options.run;
    } else if (plan->parsed() && plan_options.sandbox) {
        PlanOptions& o = plan_options;
        needs = {{folder_of(o.file), o.offline.profile}, {o.file}, {&o.output}, false};
    } else {
        return std::nullopt;
    }
    needs.read.insert(needs.read.end(), raw.graph_path.begin(), raw.graph_path.end());
    return run_in_sandbox(needs);
}

bool CommandLine::needs_device() const {
    return render->parsed() || view->parsed() || doctor->parsed() || (check->parsed() && check_options.run) ||
           (bench.app->parsed() && !bench.compile->parsed());
}

ExitCode CommandLine::run_command() {
    if (render->parsed()) return run_render(render_options);
    if (view->parsed()) return run_view(view_options);
    if (check->parsed()) return run_check(check_options);
    if (plan->parsed()) return run_plan(plan_options);
    if (schema->parsed()) return run_schema(schema_options);
    if (explain->parsed()) return run_explain(explain_options);
    if (diff->parsed()) return run_diff(diff_options);
    if (compare->parsed()) return run_compare(compare_options);
    if (scene->parsed()) return run_scene(scene_options);
    if (doctor->parsed()) return run_doctor(doctor_options);
    if (bench.compile->parsed()) return run_bench_compile(bench.compile_options);
    if (bench.app->parsed()) return run_bench_frame(bench.frame_options);
    std::fputs(
        "weft: no command was given; wanted render, view, check, plan, schema, explain, diff, compare, "
        "scene, "
        "bench or doctor\nRun `weft --help`.\n",
        stderr);
    return ExitCode::usage;
}

// Prints the error of CLI11, and converts the exit code of CLI11 to the exit code of Weft for wrong usage.
int usage_exit(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help and --version also end with this exception.
        std::ostringstream text;
        app.exit(error, text, text);
        return exit_with(print_data(text.str()));
    }
    std::fprintf(stderr, "weft: %s\n%sRun `weft --help`, or `weft COMMAND --help`.\n", error.what(),
                 usage_hint(app).c_str());
    return exit_with(ExitCode::usage);
}

int run(int argc, char** argv) {
    CommandLine line;
    if (const std::string fault = future_fault({argv + std::min(argc, 1), argv + argc}); !fault.empty()) {
        std::fprintf(stderr, "weft: %s\n", fault.c_str());
        return exit_with(ExitCode::usage);
    }
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return usage_exit(line.app, error);
    }
    const Result<Limits> limits = load_limits(line.raw.limits);
    if (!limits) {
        report(limits.errors());
        return exit_with(exit_code_for(limits.errors()));
    }
    line.finish(*limits);
    if (const Status named = line.name_pictures(); !named) {
        report(named.errors());
        return exit_with(exit_code_for(named.errors()));
    }
    if (const auto ended = line.enter_sandbox()) return exit_with(*ended);
    if (line.needs_device()) prepare_driver_cache();
    return exit_with(line.run_command());
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

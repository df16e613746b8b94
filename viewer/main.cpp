// The command line. It only fills the options of a command and returns the command's exit code.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <CLI/CLI.hpp>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"

namespace weft::viewer {
namespace {

// Flags of the command line's contract that this version cannot honour yet.
struct FutureFlag {
    const char* name;
    const char* what;
};
constexpr std::array kFutureRenderFlags{
    FutureFlag{"--tier", "quality tiers"},
    FutureFlag{"--seed", "seeded lights"},
    FutureFlag{"--time", "the time of day"},
    FutureFlag{"--lights", "generated lights"},
    FutureFlag{"--profile", "rendering to a profile"},
    FutureFlag{"--limits", "limits from a file"},
};
constexpr std::array kFutureCheckFlags{FutureFlag{"--tier", "quality tiers"}, FutureFlag{"--sarif", "SARIF"},
                                       FutureFlag{"--run", "graph tests"}};
constexpr std::array kFuturePlanFlags{FutureFlag{"--tier", "quality tiers"}};
constexpr std::array<std::string_view, 6> kFutureCommands{"view",   "explain", "diff",
                                                          "schema", "bench",   "compare"};

[[nodiscard]] int exit_with(ExitCode code) {
    return static_cast<int>(code);
}

CLI::Validator size_validator() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            unsigned width = 0, height = 0;
            char end = 0;
            const bool whole = std::sscanf(text.c_str(), "%5ux%5u%c", &width, &height, &end) == 2;
            if (whole && width > 0 && height > 0 && width <= 16384 && height <= 16384) return "";
            return "a size is WIDTHxHEIGHT in pixels, each 1 to 16384, not \"" + text + "\"";
        },
        "WxH");
}

Extent3D parse_size(const std::string& text) {
    Extent3D size;
    std::sscanf(text.c_str(), "%5ux%5u", &size.width, &size.height);
    return size;
}

// NAME=VALUE, where VALUE is a number, true or false.
CLI::Validator param_validator() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            const size_t equals = text.find('=');
            if (equals == std::string::npos || equals == 0)
                return "a parameter is NAME=VALUE, not \"" + text + "\"";
            std::string value = text.substr(equals + 1);
            if (value == "true" || value == "false") return "";
            double number = 0;
            return CLI::detail::lexical_cast(value, number)
                       ? ""
                       : "\"" + value + "\" is not a number, true or false";
        },
        "NAME=VALUE");
}

std::map<std::string, double> parse_params(const std::vector<std::string>& texts) {
    std::map<std::string, double> params;
    for (const std::string& text : texts) {
        const size_t equals = text.find('=');
        const std::string value = text.substr(equals + 1);
        double number = value == "true" ? 1 : 0;
        if (value != "true" && value != "false") CLI::detail::lexical_cast(value, number);
        params[text.substr(0, equals)] = number;
    }
    return params;
}

// Texts that need a second look after parsing.
struct RawTexts {
    std::string size = "1280x720";
    std::vector<std::string> params;
    double exposure = 0;
};

// A flag or command of the contract that is not there yet is refused by name, whatever else is wrong. Its
// values are of no interest.
template <size_t N>
[[nodiscard]] bool names_future_flag(const std::vector<std::string>& arguments,
                                     const std::array<FutureFlag, N>& flags) {
    for (const std::string& argument : arguments) {
        const std::string name = argument.substr(0, argument.find('='));
        for (const FutureFlag& flag : flags) {
            if (name != flag.name) continue;
            std::fprintf(stderr, "weft: %s: %s are not there yet in this version of weft\n", flag.name,
                         flag.what);
            return true;
        }
    }
    return false;
}

[[nodiscard]] bool names_future(const std::vector<std::string>& arguments) {
    if (arguments.empty()) return false;
    const std::string& command = arguments.front();
    if (std::find(kFutureCommands.begin(), kFutureCommands.end(), command) != kFutureCommands.end()) {
        std::fprintf(stderr, "weft: `%s` is not there yet in this version of weft\n", command.c_str());
        return true;
    }
    return (command == "render" && names_future_flag(arguments, kFutureRenderFlags)) ||
           (command == "check" && names_future_flag(arguments, kFutureCheckFlags)) ||
           (command == "plan" && names_future_flag(arguments, kFuturePlanFlags));
}

void add_render(CLI::App& command, RenderOptions& o, RawTexts& raw) {
    command.add_option("SCENE", o.scene, "a .gltf or .glb file, a folder that holds one, or builtin:NAME")
        ->capture_default_str();
    command.add_option("-o,--output", o.output, "the picture: .png, .exr or .pfm")->capture_default_str();
    command.add_option("--graph", o.graph, "the pipeline, a JSON file [the shipped graphs/deferred.json]");
    command.add_option("--size", raw.size, "in pixels")->check(size_validator())->capture_default_str();
    command.add_option("--frames", o.frames, "how many to render; the last is written [the graph's, else 1]")
        ->check(CLI::Range(1u, 1000000u));
    command.add_option("--fixed-dt", o.fixed_dt_s, "seconds from frame to frame")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--camera", o.camera,
                       "a camera of the scene by name, or EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG");
    command.add_option("--env", o.env, "what surrounds the scene: sky or none")
        ->check(CLI::IsMember({"sky", "none"}).description(""))
        ->capture_default_str();
    command.add_option("--exposure", raw.exposure, "in EV, in place of the scene's")
        ->check(CLI::Range(-40.0, 40.0));
    command.add_option("--param", raw.params, "a parameter of the graph; may be repeated")
        ->check(param_validator());
    command.add_option("--resource", o.resource,
                       "write this resource (name@pass.mip(e).layer(e)), not the output");
    command.add_flag("--validate", o.validate, "run under the validation layers; any message is exit code 5");
    command.add_option("--stats", o.stats, "write times, memory and hashes to this JSON file");
    command.add_option("--device", o.device, "a device's index or part of its name");
    command.add_option("--timeout", o.timeout_s, "seconds to wait for a frame")
        ->check(CLI::Range(0.001, 3600.0))
        ->capture_default_str();
    command.add_option("--test-drop-barriers", o.drop_barriers_before)->group("");
}

void add_check(CLI::App& command, CheckOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.files, "graph files")->required();
    command.add_option("--profile", o.profile, "a device profile [the shipped lavapipe]");
    command.add_option("--size", raw.size, "of the output")->check(size_validator())->capture_default_str();
    command.add_flag("--json", o.json, "what was found, as JSON on stdout");
}

void add_plan(CLI::App& command, PlanOptions& o, RawTexts& raw) {
    command.add_option("FILE", o.file, "a graph file")->required();
    command.add_option("--profile", o.profile, "a device profile [the shipped lavapipe]");
    command.add_option("--size", raw.size, "of the output")->check(size_validator())->capture_default_str();
    command.add_option("--format", o.format, "text, json or dot")
        ->check(CLI::IsMember({"text", "json", "dot"}).description(""))
        ->capture_default_str();
    command.add_option("-o,--output", o.output, "a file in place of stdout");
    command.add_option("--param", raw.params, "a parameter of the graph; may be repeated")
        ->check(param_validator());
}

// CLI11's own exit codes become usage errors.
int usage_exit(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::fprintf(stderr, "weft: %s\nRun `weft --help`, or `weft COMMAND --help`.\n", error.what());
    return exit_with(ExitCode::usage);
}

int run(int argc, char** argv) {
    CLI::App app{"weft compiles a render graph written as JSON, proves the plan, and runs it on Vulkan.",
                 "weft"};
    app.set_version_flag("--version", "weft 0.1.0");
    app.require_subcommand(0, 1);  // so that a misspelt one is named
    RawTexts raw;
    RenderOptions render_options;
    CheckOptions check_options;
    PlanOptions plan_options;
    DoctorOptions doctor_options;
    CLI::App* render = app.add_subcommand("render", "render a scene through a graph to a picture");
    add_render(*render, render_options, raw);
    CLI::App* check = app.add_subcommand("check", "find what is wrong with graph files");
    add_check(*check, check_options, raw);
    CLI::App* plan = app.add_subcommand("plan", "show the compiled frame: order, barriers, memory");
    add_plan(*plan, plan_options, raw);
    CLI::App* doctor = app.add_subcommand("doctor", "say what this machine has and lacks");
    doctor->add_flag("--json", doctor_options.json, "the chosen device's profile, as JSON on stdout");
    doctor->add_option("--device", doctor_options.device, "a device's index or part of its name");
    if (names_future({argv + std::min(argc, 1), argv + argc})) return exit_with(ExitCode::usage);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return usage_exit(app, error);
    }
    render_options.size = check_options.size = plan_options.size = parse_size(raw.size);
    render_options.params = plan_options.params = parse_params(raw.params);
    if (render->count("--exposure") > 0) render_options.exposure_ev = static_cast<float>(raw.exposure);
    if (render->parsed()) return exit_with(run_render(render_options));
    if (check->parsed()) return exit_with(run_check(check_options));
    if (plan->parsed()) return exit_with(run_plan(plan_options));
    if (doctor->parsed()) return exit_with(run_doctor(doctor_options));
    std::fputs("weft: say what to do: render, check, plan or doctor\nRun `weft --help`.\n", stderr);
    return exit_with(ExitCode::usage);
}

}  // namespace
}  // namespace weft::viewer

int main(int argc, char** argv) {
    try {
        return weft::viewer::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "weft: internal error: %s\n", error.what());
        return static_cast<int>(weft::viewer::ExitCode::failed);
    }
}

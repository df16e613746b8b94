// `weft bench frame`: measures the frame times of several graphs. The graphs and the reference passes take
// turns, one frame each, so that other load on the machine slows all of them down equally.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "viewer/bench/frame_bench.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/probe_source.h"
#include "viewer/commands/scene_source.h"
#include "viewer/commands/session_setup.h"
#include "viewer/files/files.h"
#include "viewer/options/graph_name.h"
#include "viewer/output/output.h"
#include "viewer/output/progress_text.h"
#include "viewer/output/report.h"
#include "weft/registry.h"

namespace weft::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint32_t kWarmFrames = 2;  // Unmeasured frames at the start; they use each frame slot once.
constexpr const char* kLightsParam = "maxLights";

// The session of a measured graph, or of the graph with the reference passes. All contestants take turns.
struct Contestant {
    std::unique_ptr<render::Session> session;
    render::FrameInput frame;
    std::vector<PassResult> passes;
    bool awake = false;  // True if all passes run in every frame.
    std::vector<RoundCost> warm_up;
};

// A measured graph: the path of its file and the name of a tier. Without a tier, the name is empty.
struct Chosen {
    std::string path, tier;
};

// Reads "NAME", "FILE.json", "NAME:TIER" or "FILE.json:TIER".
Chosen chosen_graph(const std::string& text) {
    const GraphName name = read_graph_name(text);
    const bool is_file = name.graph.ends_with(".json");
    return {is_file ? name.graph : (shipped_root() / "graphs" / (name.graph + ".json")).string(), name.tier};
}

// Returns the name of a measured graph for tables: "weft", or "weft:low" with a tier.
std::string short_name(const std::string& text) {
    const Chosen chosen = chosen_graph(text);
    const std::string name = std::filesystem::path(chosen.path).stem().string();
    return chosen.tier.empty() ? name : name + ":" + chosen.tier;
}

Diagnostic no_timestamps() {
    Diagnostic d;
    d.code = "X590";
    d.message = "the device has no timestamps, so `weft bench frame` cannot measure times";
    d.help = {"choose another device with --device; `weft doctor` lists the devices"};
    return d;
}

// Runs the command once: it renders the rounds for every number of lights and collects the results.
class Run {
 public:
    explicit Run(const FrameBenchOptions& options)
        : options_(options), progress_("measuring", isatty(STDERR_FILENO) == 1) {
        render_.scene = options.scene;
        render_.request.size = options.size;
        render_.camera = options.camera;
        render_.env = options.env;
        render_.env_gain = options.env_gain;
        render_.seed = options.seed;
        render_.device = options.device;
        render_.timeout_s = options.timeout_s;
        render_.limits = options.limits;
        render_.graph_path = options.graph_path;
    }

    [[nodiscard]] Result<FrameBench> measure() {
        Result<std::unique_ptr<vk::Device>> device = open_device(render_);
        if (!device) return device.take_errors();
        device_ = std::move(*device);
        bench_.scene = options_.scene;
        bench_.size = options_.size;
        bench_.device = device_->info().name;
        bench_.driver = device_->info().driver;
        bench_.rounds = options_.rounds;
        bench_.lights = options_.lights;
        for (const std::string& graph : options_.graphs) bench_.graphs.push_back(short_name(graph));
        for (const uint32_t lights : options_.lights)
            if (Status s = measure(lights); !s) return s.take_errors();
        bench_.yardsticks.trivial_ms = spread_of(trivial_ms_).median;
        bench_.yardsticks.bytes_per_s = spread_of(bytes_per_s_).median;
        bench_.yardsticks.flops_per_s = spread_of(flops_per_s_).median;
        find_common(bench_);
        std::fputs(progress_.finish().c_str(), stderr);
        return std::move(bench_);
    }

 private:
    void tell(uint32_t lights) {
        const size_t steps = 2 * options_.graphs.size() + 1;
        const std::chrono::duration<double> elapsed = Clock::now() - begin_;
        std::fputs(progress_
                       .at(elapsed.count(), "frames (now with " + std::to_string(lights) + " lights)",
                           ++done_, steps * (options_.rounds + 1) * options_.lights.size())
                       .c_str(),
                   stderr);
    }

    [[nodiscard]] Result<Contestant> enter(const scene::Scene& scene, const std::string& graph,
                                           uint32_t lights, bool awake) {
        const Chosen chosen = chosen_graph(graph);
        render_.request.path = chosen.path;
        render_.request.tier = chosen.tier;
        render_.request.rests = !awake;
        const bool draws_scene = graph != kYardsticks;
        // `scene.lights` also contains the suns of the environment picture.
        const auto all_lights = static_cast<double>(std::max(scene.lights.size(), size_t{1}));
        render_.request.params = draws_scene ? std::map<std::string, double>{{kLightsParam, all_lights}}
                                             : std::map<std::string, double>{};
        const float aspect = aspect_of(render_.request.size);
        Result<scene::Camera> camera = choose_camera(scene, {options_.scene, render_.camera, aspect});
        if (!camera) return camera.take_errors();
        render::SessionInput input = session_input(render_, passes_);
        input.timestamps = true;
        Diagnostics warnings;
        if (draws_scene && options_.probes != "none") {
            Result<FoundProbes> found = find_probes(
                scene, {options_.scene, options_.probes, glm::vec3(camera->transform[3])}, options_.limits);
            if (!found) return found.take_errors();
            input.probes = std::move(found->probes);
        }
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings);
        if (draws_scene && !awake && lights == options_.lights.front()) report(warnings);
        if (!session) return session.take_errors();
        Contestant contestant{std::move(*session), frame_input(render_, scene, *camera), {}, awake, {}};
        contestant.passes = pass_results(contestant.session->plan());
        const Result<std::vector<vk::FrameTiming>> warm =
            contestant.session->warm_up_probes(contestant.frame);
        if (!warm) return warm.errors();
        contestant.warm_up = round_costs(contestant.session->plan(), *warm);
        for (uint32_t frame = 0; frame < kWarmFrames; ++frame)
            if (Status s = contestant.session->render_frame(contestant.frame); !s) return s.take_errors();
        if (Status s = contestant.session->finish(); !s) return s.take_errors();
        static_cast<void>(contestant.session->take_timings());
        tell(lights);
        return contestant;
    }

    [[nodiscard]] Status draw(Contestant& contestant, uint32_t lights) {
        if (Status s = contestant.session->render_frame(contestant.frame); !s) return s;
        if (Status s = contestant.session->finish(); !s) return s;
        const std::vector<vk::FrameTiming> timings = contestant.session->take_timings();
        if (timings.empty() || !add_round(timings.back(), contestant.passes)) return no_timestamps();
        tell(lights);
        return Unit{};
    }

    [[nodiscard]] Status measure(uint32_t lights) {
        render_.lights = lights;
        Diagnostics warnings;
        Result<scene::Scene> scene = open_scene(
            {render_.scene, render_.env, render_.hour, render_.lights, render_.seed, render_.env_gain},
            options_.limits.scene, warnings);
        if (!scene) return scene.take_errors();
        if (lights == options_.lights.front()) report(warnings);
        std::vector<Contestant> contestants;
        std::vector<std::string> graphs = options_.graphs;
        graphs.emplace_back(kYardsticks);
        for (const std::string& graph : graphs) {
            Result<Contestant> contestant = enter(*scene, graph, lights, false);
            if (!contestant) return contestant.take_errors();
            contestants.push_back(std::move(*contestant));
            if (contestants.back().session->plan().graph.rest_unit_count == 0) continue;
            Result<Contestant> awake = enter(*scene, graph, lights, true);
            if (!awake) return awake.take_errors();
            contestants.push_back(std::move(*awake));
        }
        // Each round starts one place later in the list than the round before, so that no graph benefits from
        // always being first or last.
        for (uint32_t round = 0; round < options_.rounds; ++round)
            for (size_t i = 0; i < contestants.size(); ++i)
                if (Status s = draw(contestants[(i + round) % contestants.size()], lights); !s) return s;
        keep(contestants, lights);
        return Unit{};
    }

    void keep(std::vector<Contestant>& contestants, uint32_t lights) {
        std::vector<double> trivial_ms;
        for (const PassResult& pass : contestants.back().passes)
            for (const double ms : pass.ms) {
                if (pass.name == "trivial") trivial_ms.push_back(ms);
                if (pass.name == "copy") bytes_per_s_.push_back(static_cast<double>(pass.bytes) / ms * 1e3);
                if (pass.name == "multiplyAdd") flops_per_s_.push_back(pass.flops / ms * 1e3);
            }
        trivial_ms_.insert(trivial_ms_.end(), trivial_ms.begin(), trivial_ms.end());
        size_t graph = 0;
        for (Contestant& contestant : contestants) {
            // Skip the reference passes, the last contestant.
            if (&contestant == &contestants.back()) continue;
            if (contestant.awake)
                add_awake(contestant, bench_.results.back());
            else
                bench_.results.push_back({bench_.graphs[graph++],
                                          lights,
                                          std::move(contestant.passes),
                                          trivial_ms,
                                          {},
                                          std::move(contestant.warm_up)});
        }
    }

    // Adds the times of the frames in which all passes run to the result of the same graph.
    static void add_awake(Contestant& awake, GraphResult& result) {
        result.awake_ms.assign(result.trivial_ms.size(), 0);
        for (PassResult& pass : awake.passes) {
            for (size_t round = 0; round < pass.ms.size(); ++round) result.awake_ms[round] += pass.ms[round];
            const auto resting = std::ranges::find(result.passes, pass.name, &PassResult::name);
            if (resting != result.passes.end() && resting->rests) resting->awake_ms = std::move(pass.ms);
        }
    }

    static constexpr const char* kYardsticks = "bench/yardsticks";
    const FrameBenchOptions& options_;
    RenderOptions render_;
    const PassCatalog passes_ = registered_passes();
    std::unique_ptr<vk::Device> device_;
    FrameBench bench_;
    std::vector<double> trivial_ms_, bytes_per_s_, flops_per_s_;
    const Clock::time_point begin_ = Clock::now();
    ProgressText progress_;
    size_t done_ = 0;
};

}  // namespace

ExitCode run_bench_frame(const FrameBenchOptions& options) {
    if (const ExitCode code = check_outputs({options.plot}, {options.scene}); code != ExitCode::ok)
        return code;
    if (const Status scene = expect_scene(options.scene); !scene) return fail_on_device(scene.errors());
    Run run(options);
    const Result<FrameBench> bench = run.measure();
    if (!bench) return fail_on_device(bench.errors());
    // If one of the two outputs (standard output, plot) cannot be written, the command still writes the other
    // one.
    const ExitCode printed = print_data(options.json ? bench_json(*bench) : bench_text(*bench));
    const ExitCode plotted =
        options.plot.empty() ? ExitCode::ok : output_data(options.plot, bench_svg(*bench));
    return printed == ExitCode::ok ? plotted : printed;
}

}  // namespace weft::viewer

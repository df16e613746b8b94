// Purpose: the options of each command as a struct. The functions in add_options.h fill the structs, and the
// commands read them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/graph_request.h"
#include "weft/imports.h"
#include "weft/limits.h"

namespace weft::viewer {

struct RenderOptions {
    std::string scene = "builtin:atrium";
    std::string output = "frame.png";
    GraphRequest request;  // The graph; an empty path means the shipped graphs/weft.json.
    uint32_t frames = 0;   // Number of frames to render; 0 means the number that the graph declares.
    // With --frames A..B: A. Each frame from A to `frames` is written to a file of its own, and `output` is
    // the pattern of their names. 0: only the last frame is written. The first frame has the number 1.
    uint32_t first_picture = 0;
    std::vector<std::string> pictures;  // With --frames A..B: the files for the frames A to B.
    // The graphs of --swap, one after the other: tiers, or files with or without a tier. Each runs for
    // `every` frames.
    std::vector<std::string> swap;
    uint32_t every = 8;
    double fixed_dt_s = 1.0 / 60.0;
    std::string camera;
    std::string camera_path;  // File with keys of the camera; empty: the camera does not follow a path.
    std::string env = "sky";
    float env_gain = 1;  // Factor of the values of the environment picture.
    std::optional<float> hour;
    std::optional<uint32_t> lights;  // Number of generated lights that replace the lights of the scene.
    uint32_t seed = 1;
    std::optional<float> exposure_ev;
    // The resource that is written instead of the output, such as "normal" or "hdr@sky".
    std::string resource;
    std::string probes;         // "auto", "none", a file, or empty: see ProbeChoice::probes.
    uint32_t probe_rounds = 4;  // How often each irradiance probe is lit before the first frame.
    // The lists of --turns. The key is the name of an import of kind "turns"; the value is the list of the
    // rounds of a group that run in each frame.
    std::map<std::string, std::vector<uint32_t>, std::less<>> turns;
    bool validate = false;
    bool verify_rest = false;
    // If true, warnings and the progress of frames are not printed. Tests in graph files set it, because
    // `weft check` prints the warnings itself.
    bool quiet = false;
    std::string stats;
    std::string device;
    double timeout_s = 60;
    uint32_t queues = 1;
    // Name of a pass. The barriers before this pass are not recorded. Only tests use this option, to check
    // that the validation layers detect missing barriers.
    std::string drop_barriers_before;
    bool sandbox = false;
    std::string named_output;  // Name of the output file in messages; if empty, the path in `output` is used.
    Limits limits;
    std::vector<std::string> graph_path;  // Folders in which included graphs are searched.
};

// Returns the files that the command reads. A word such as "sky" is included, too, because a file may have
// that name.
[[nodiscard]] inline std::vector<std::string> inputs_of(const RenderOptions& options) {
    return {options.scene, options.request.path, options.env, options.probes, options.camera_path};
}

struct ViewOptions {
    // If `frames` is 0, the command renders until the user ends it. If `output` is empty, no picture is
    // written.
    RenderOptions render;
    bool headless = false;
    // If true, each frame advances time by render.fixed_dt_s, and frames are rendered as fast as possible. If
    // false, the program uses the real time.
    bool fixed_dt = false;
};

// Options for compiling a graph without a device.
struct OfflineOptions {
    GraphRequest request;  // The path is empty here; each command fills it from its argument FILE.
    std::string profile;   // A profile file, or the name of a shipped profile; if empty, "lavapipe".
    uint32_t queues = 1;
    Limits limits;
    std::vector<std::string> graph_path;
    // Imports that another program offers to the graph, by name.
    std::map<std::string, ImportDecl, std::less<>> imports;
};

struct CheckOptions {
    std::vector<std::string> files;
    OfflineOptions offline;
    bool json = false;
    bool sarif = false;  // Prints the errors as SARIF; `json` and `sarif` exclude each other.
    bool run = false;    // If true, the tests in the graph files also run on a device.
    std::string device;  // The device on which `run` runs the tests: an index, or part of the name.
    bool sandbox = false;
};

struct PlanOptions {
    std::string file;
    OfflineOptions offline;
    std::string format = "text";
    std::string output;
    bool sandbox = false;
};

struct SchemaOptions {
    std::string file;    // The graph whose names the schema proposes; if empty, the schema is for all graphs.
    std::string output;  // File to write; if empty, the command writes to stdout.
    Limits limits;
    std::vector<std::string> graph_path;
};

struct ExplainOptions {
    std::string file;
    OfflineOptions offline;
    std::string question;            // The question: culled, barrier, alias, wait or resource.
    std::vector<std::string> names;  // Names of the passes or resources that the question is about.
};

struct DiffOptions {
    std::string from, to;
    OfflineOptions offline;
    bool json = false;
};

struct CompareOptions {
    std::string reference, test;
    std::string metric = "flip";  // Method of comparison: flip, psnr or max.
    std::optional<double> max;    // Upper limit of the mean (metric flip) or the largest value (metric max).
    std::optional<double> min;    // Lower limit of the result of the metric psnr, in dB.
    std::string output;           // Path of the PNG file for the heat map; if empty, no heat map is written.
    bool json = false;
    Limits limits;
};

struct BenchOptions {
    uint32_t passes = 1000;
    std::string shape = "random";
    uint32_t seed = 1;    // The seed of the first graph. The seed of each further graph is greater by 1.
    uint32_t seeds = 30;  // Number of graphs to compile.
    uint32_t queues = 1;
    bool json = false;
};

struct FrameBenchOptions {
    std::string scene = "builtin:lights";
    // Graphs to compare: names of shipped graphs, or paths of files; with ":TIER" after it, a tier of the
    // graph.
    std::vector<std::string> graphs{"deferred", "tiled_deferred", "light_volumes", "light_indexed"};
    std::vector<uint32_t> lights{1, 10, 50, 100, 256, 1024, 3072};
    Extent3D size{640, 360, 1};
    std::string camera;
    std::string env = "sky";
    float env_gain = 1;
    std::string probes = "none";  // "auto", "none", a file, or empty: see ProbeChoice::probes.
    uint32_t seed = 1;
    uint32_t rounds = 7;
    std::string device;
    double timeout_s = 60;
    std::string plot;  // Path of the .svg file for the plot; if empty, no plot is drawn.
    bool json = false;
    Limits limits;
    std::vector<std::string> graph_path;
};

struct SceneOptions {
    std::string scene = "builtin:atrium";
    std::string probes;  // "auto", "none", a file, or empty: see ProbeChoice::probes.
    std::string camera;
    std::optional<float> hour;
    std::string picture;  // Path of the .png file for the picture of the probes; if empty, none is drawn.
    std::string gltf;     // Path of the .glb file for the scene; if empty, none is written.
    std::string sky;      // Path of the .hdr file for the sky; if empty, none is written.
    bool json = false;
    Limits limits;
};

struct DoctorOptions {
    bool json = false;
    std::string device;
};

}  // namespace weft::viewer

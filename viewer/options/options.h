// Purpose: what the command line asked for, one struct a command. Filled by add_options.h, read by the
// commands.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/limits.h"

namespace weft::viewer {

struct RenderOptions {
    std::string scene = "builtin:atrium";
    std::string output = "frame.png";
    std::string graph;  // empty: the shipped graphs/deferred.json
    std::string tier;   // empty: the graph as it is
    Extent3D size{1280, 720, 1};
    uint32_t frames = 0;  // 0: what the graph says
    double fixed_dt_s = 1.0 / 60.0;
    std::string camera;
    std::string env = "sky";
    std::optional<float> hour;
    std::optional<uint32_t> lights;  // so many seeded ones in place of the scene's
    uint32_t seed = 1;
    std::optional<float> exposure_ev;
    std::map<std::string, double> params;
    std::string resource;
    std::string debug;                  // a debug view, or a resource to be shown as one
    std::vector<std::string> observed;  // references that are read back every frame, besides `resource`
    bool validate = false;
    bool quiet = false;  // warnings were said before
    std::string stats;
    std::string device;
    double timeout_s = 60;
    uint32_t queues = 1;
    std::string drop_barriers_before;  // test hook
    bool sandbox = false;
    std::string named_output;  // what messages call the output; empty: as it is
    Limits limits;
};

// Files that the command line names to be read. A word like "sky" is a file of that name, too.
[[nodiscard]] inline std::vector<std::string> inputs_of(const RenderOptions& options) {
    return {options.scene, options.graph, options.env};
}

struct ViewOptions {
    RenderOptions render;  // 0 frames: until somebody ends it; its output: empty, no picture
    bool headless = false;
    bool fixed_dt = false;  // render.fixed_dt_s from frame to frame, as fast as can be; else as time goes by
};

// How a graph is compiled where there is no device.
struct OfflineOptions {
    std::string tier;     // empty: the graph as it is
    std::string profile;  // a file, or the name of a shipped one; empty: lavapipe
    Extent3D size{1280, 720, 1};
    uint32_t queues = 1;
    std::map<std::string, double> params;
    Limits limits;
};

struct CheckOptions {
    std::vector<std::string> files;
    OfflineOptions offline;
    bool json = false;
    bool sarif = false;  // not both
    bool run = false;    // the graphs' own tests
    std::string device;  // for them
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
    std::string file;    // empty: of all graphs
    std::string output;  // empty: stdout
    Limits limits;
};

struct ExplainOptions {
    std::string file;
    OfflineOptions offline;
    std::string question;            // culled, barrier, alias, wait, resource
    std::vector<std::string> names;  // of passes or resources
};

struct DiffOptions {
    std::string from, to;
    OfflineOptions offline;
    bool json = false;
};

struct CompareOptions {
    std::string reference, test;
    std::string metric = "flip";  // flip, psnr, max
    std::optional<double> max;    // of flip (the mean) and max
    std::optional<double> min;    // of psnr, in dB
    std::string output;           // the heat map; empty: none
    bool json = false;
    Limits limits;
};

struct BenchOptions {
    uint32_t passes = 1000;
    std::string shape = "random";
    uint32_t seed = 1;
    uint32_t queues = 1;
    bool json = false;
};

struct FrameBenchOptions {
    std::string scene = "builtin:lights";
    std::vector<std::string> graphs{"deferred", "tiled_deferred", "light_volumes",
                                    "light_indexed"};  // shipped ones by name, or files
    std::vector<uint32_t> lights{1, 10, 50, 100, 256, 1024, 3072};
    Extent3D size{640, 360, 1};
    std::string camera;
    uint32_t seed = 1;
    uint32_t rounds = 7;
    std::string device;
    double timeout_s = 60;
    std::string plot;  // an .svg; empty: none
    bool json = false;
    Limits limits;
};

struct DoctorOptions {
    bool json = false;
    std::string device;
};

}  // namespace weft::viewer

// Prints the results of `weft bench frame` as text tables.
#include <cmath>
#include <cstdio>

#include "viewer/bench/frame_bench.h"
#include "viewer/output/formatted.h"

namespace weft::viewer {
namespace {

double half_width(const Spread& spread) {
    return (spread.three_quarters - spread.quarter) / 2;
}

std::string table(const FrameBench& bench, bool with_common) {
    std::string text = "lights";
    for (const std::string& graph : bench.graphs) text += formatted("  %-33s", graph.c_str());
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
    for (size_t light = 0; light < bench.lights.size(); ++light) {
        text += formatted("%6u", bench.lights[light]);
        for (size_t graph = 0; graph < bench.graphs.size(); ++graph) {
            const Spread ms = spread_of(bench.at(light, graph).frame_ms(with_common));
            const double ratio = bench.ratio_to_first(light, graph, with_common);
            text += formatted("  %8.2f ±%-7.2f%7s %7.1ft", ms.median, half_width(ms),
                              std::isfinite(ratio) ? formatted("%.3fx", ratio).c_str() : "-",
                              bench.ratio_to_trivial(light, graph, with_common));
        }
        text += '\n';
    }
    return text;
}

std::string crossing_lines(const FrameBench& bench) {
    std::string text;
    for (const Crossing& c : bench.crossings())
        text +=
            formatted("%s is faster than %s with more than about %.0f lights (measured between %u and %u)\n",
                      c.faster.c_str(), c.slower.c_str(), c.lights, c.between[0], c.between[1]);
    return text.empty() ? "none\n" : text;
}

const char* pass_note(const PassResult& pass) {
    if (pass.awake_ms.empty()) return pass.common ? "  in all graphs" : "";
    return pass.common ? "  rests, in all graphs" : "  rests";
}

std::string pass_line(const FrameBench& bench, const std::string& graph, const PassResult& pass) {
    const Spread ms = spread_of(pass.running_ms());
    const double limit_ms = bench.yardsticks.limit_ms(static_cast<double>(pass.bytes), pass.flops);
    return formatted("%-16s %-16s %9.3f %8.3f %8.2f %9s %9.4f %8.1f %8.2ft%s\n", graph.c_str(),
                     pass.name.c_str(), ms.median, half_width(ms), static_cast<double>(pass.bytes) / 1e6,
                     pass.flops > 0 ? formatted("%.1f", pass.flops / 1e6).c_str() : "-", limit_ms,
                     ms.median / limit_ms, ms.median / bench.yardsticks.trivial_ms, pass_note(pass));
}

// Returns a table of the median frame times while passes rest, and in frames in which all passes run. Empty
// if no graph has passes that rest.
std::string awake_lines(const FrameBench& bench) {
    std::string text;
    for (const GraphResult& result : bench.results)
        if (!result.awake_ms.empty())
            text += formatted("%6u  %-16s %8.2f %8.2f\n", result.lights, result.graph.c_str(),
                              spread_of(result.frame_ms(true)).median, spread_of(result.awake_ms).median);
    if (text.empty()) return text;
    return "\nframe time in ms while passes with \"rest\" rest, and in a frame in which all passes run\n"
           "lights  graph             resting  running\n" +
           text;
}

// Returns a table with the costs of the rounds that lit the light probes; empty without probes.
std::string warm_up_table(const FrameBench& bench) {
    std::string lines;
    for (const GraphResult& result : bench.results)
        for (const RoundCost& cost : result.warm_up)
            lines += formatted("%-16s %6u  %-28s %7llu %9.4f %8.3ft\n", result.graph.c_str(), result.lights,
                               cost.pass.c_str(), static_cast<unsigned long long>(cost.rounds), cost.round_ms,
                               cost.round_ms / bench.yardsticks.trivial_ms);
    if (lines.empty()) return lines;
    return "\nlighting the probes before the first frame: time of one round, which is one probe\n"
           "graph            lights  pass                          rounds        ms /trivial\n" +
           lines;
}

}  // namespace

std::string bench_text(const FrameBench& bench) {
    const Yardsticks& y = bench.yardsticks;
    std::string text = bench.scene + ", " +
                       formatted("%ux%u, %u measured frames for each graph\n", bench.size.width,
                                 bench.size.height, bench.rounds) +
                       bench.device + ", " + bench.driver + '\n';
    text += formatted(
        "reference passes: trivial pass %.3f ms, copying %.2f GB/s, multiplying and adding %.1f GFLOP/s\n\n",
        y.trivial_ms, y.bytes_per_s / 1e9, y.flops_per_s / 1e9);
    text +=
        "frame time in ms: median ± half the interquartile range, ratio to the first graph (x), ratio to the "
        "trivial pass (t)\n" +
        table(bench, true);
    if (bench.graphs.size() > 1)
        text += "\nthe same without the passes that all graphs have in common\n" + table(bench, false) +
                "\nnumbers of lights at which one graph becomes faster than another, without the common "
                "passes\n" +
                crossing_lines(bench);
    text += awake_lines(bench);
    for (size_t light = 0; light < bench.lights.size(); ++light) {
        text += formatted(
            "\ntimes of the passes with %u lights (bound: the lowest possible time, from MB, MFLOP and the "
            "reference passes)\n",
            bench.lights[light]);
        text +=
            "graph            pass                    ms      ±ms       MB     MFLOP  bound ms   /bound  "
            "/trivial\n";
        for (size_t graph = 0; graph < bench.graphs.size(); ++graph)
            for (const PassResult& pass : bench.at(light, graph).passes)
                text += pass_line(bench, bench.graphs[graph], pass);
    }
    return text + warm_up_table(bench);
}

}  // namespace weft::viewer

// An example of a graph that is made in C++ instead of in a file, as an editor would do it. The program
// renders the sky, and then replaces the graph by one with another exposure.
// Usage: built_graph [--validate]
#include <weft/graph_builder.h>
#include <weft/memory_files.h>
#include <weft/registry.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>

#include "sample.h"

namespace {

// The shaders are shipped with Weft.
weft::GraphBuilder make_graph(double exposure_ev) {
    weft::GraphBuilder graph("sky");
    graph.import("backbuffer", "output");
    graph.param("exposure", exposure_ev).range(-8, 8).set("unit", "EV");
    graph.image("hdr", "b10g11r11f|rgba16f").size("output");
    graph.fullscreen("sky", "forward/sky.frag").out("hdr");
    graph.fullscreen("tonemap", "tonemap/tonemap.frag").in("hdr").out("backbuffer");
    return graph;
}

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));
    // The camera of this scene looks at the horizon.
    const weft::scene::Scene scene = take(weft::scene::make_builtin("mirror"));
    const weft::PassCatalog passes = weft::registered_passes();

    const weft::GraphBuilder graph = make_graph(0);
    weft::render::SessionInput input = session_input(graph.file_name(), passes);
    weft::MemoryFiles files;  // Must live longer than the session.
    files.put(input.request.path, graph.to_json());
    input.load.reader = files.reader(read_file);
    input.output = target.image;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, scene, input, warnings));
    take(session->render_frame(frame_input(scene, 0)));
    const std::vector<uint8_t> first = read_image(own, target.image, kSize_px.width, kSize_px.height);
    require_picture(first);

    files.put(input.request.path, make_graph(-3).to_json());
    weft::render::PrepareResult prepared = session->prepare(session->selection());
    take(session->swap_in(take(std::move(prepared.result))));
    take(session->render_frame(frame_input(scene, 1)));
    if (read_image(own, target.image, kSize_px.width, kSize_px.height) == first)
        throw std::runtime_error("the pictures of both graphs are equal");
    session.reset();
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}

#include "viewer/bench/bench_file.h"

#include <array>
#include <utility>

#include "viewer/output/formatted.h"

namespace weft::viewer {
namespace {

// Names of the input ports. A pass that reads one image has only the port "a".
constexpr std::array kReadPorts{"a", "b"};

std::string image_text(const ResourceDecl& image) {
    return formatted(R"(  "%s": {"format": "rgba8", "size": [%u, %u]})", image.name.c_str(),
                     image.extent.width, image.extent.height);
}

std::string pass_text(const ResolvedGraph& graph, const PassDecl& pass) {
    std::string in, out;
    size_t reads = 0;
    for (const UseDecl& use : pass.uses) {
        std::string& ports = use.is_output ? out : in;
        if (!ports.empty()) ports += ", ";
        ports += formatted(R"("%s": "%s")", use.port.c_str(), graph.resources[use.resource].name.c_str());
        reads += use.is_output ? 0 : 1;
    }
    return formatted(R"(  "%s": {"type": "compute", "shader": "read%zu.comp", "in": {%s}, "out": {%s}})",
                     pass.name.c_str(), reads, in.c_str(), out.c_str());
}

// Adds the block Params with the parameter `gain` of the graph. Only passes that read no image have this
// block.
void add_gain(ShaderInterface& interface) {
    interface.has_params = true;
    interface.params.push_constants = true;
    interface.params.stages = interface.stages;
    interface.params.size_bytes = sizeof(float);
    BlockMember& gain = interface.params.members.emplace_back();
    gain.name = "gain";
    gain.size_bytes = sizeof(float);
    gain.scalar = ScalarType::f32;
    gain.rows = 1;
}

}  // namespace

std::string bench_file_text(const ResolvedGraph& graph) {
    std::string images, passes;
    for (const ResourceDecl& image : graph.resources)
        images += (images.empty() ? "\n" : ",\n") + image_text(image);
    for (const PassDecl& pass : graph.passes)
        passes += (passes.empty() ? "\n" : ",\n") + pass_text(graph, pass);
    return formatted(R"({"version": 1, "name": "%s", "params": {"gain": {"default": 1}}, "resources": {)",
                     graph.name.c_str()) +
           images + "}, \"passes\": {" + passes + "}}\n";
}

ShaderCatalog bench_shaders() {
    ShaderCatalog catalog;
    for (size_t reads = 0; reads <= kReadPorts.size(); ++reads) {
        ShaderProgram program;
        program.reference = formatted("read%zu.comp", reads);
        program.modules.resize(1);
        ShaderInterface& interface = program.interface;
        interface.stages = stage_bit(ShaderStage::compute);
        interface.local_size = {8, 8, 1};
        const auto add = [&interface](const char* name, BindingKind kind) -> ShaderBinding& {
            ShaderBinding& binding = interface.bindings.emplace_back();
            binding.name = name;
            binding.set = kPortSet;
            binding.binding = static_cast<uint32_t>(interface.bindings.size() - 1);
            binding.kind = kind;
            binding.stages = interface.stages;
            return binding;
        };
        for (size_t port = 0; port < reads; ++port) add(kReadPorts.at(port), BindingKind::sampled_image);
        ShaderBinding& written = add("dst", BindingKind::storage_image);
        written.storage_format = Format::rgba8;
        written.reads = false;
        written.writes = true;
        if (reads == 0) add_gain(interface);
        catalog.emplace(program.reference, std::move(program));
    }
    return catalog;
}

std::map<std::string, std::string> bench_shader_texts() {
    std::map<std::string, std::string> texts;
    std::string inputs, sum;
    for (size_t reads = 0; reads <= kReadPorts.size(); ++reads) {
        texts[formatted("read%zu.comp", reads)] =
            "#version 460\nlayout(local_size_x = 8, local_size_y = 8) in;\n"
            "layout(rgba8) writeonly uniform image2D dst;\n" +
            (reads == 0 ? "layout(push_constant) uniform Params { float gain; };\n" : inputs) +
            "void main() {\n    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n" +
            "    imageStore(dst, at, " + (reads == 0 ? "vec4(gain)" : sum) + ");\n}\n";
        if (reads == kReadPorts.size()) break;
        inputs += formatted("uniform sampler2D %s;\n", kReadPorts.at(reads));
        sum += formatted("%stexelFetch(%s, at, 0)", reads == 0 ? "" : " + ", kReadPorts.at(reads));
    }
    return texts;
}

DeviceProfile bench_profile() {
    DeviceProfile profile;
    profile.name = "bench";
    profile.formats[Format::rgba8] =
        format_feature::kSampled | format_feature::kSampledLinear | format_feature::kStorage;
    return profile;
}

GraphLimits bench_limits() {
    GraphLimits limits;
    limits.json_bytes = limits.json_values = limits.expression_parts = 1ull << 40;
    limits.passes = limits.ports = limits.resources = limits.steps = 1ull << 40;
    limits.transient_bytes = 1ull << 60;
    return limits;
}

}  // namespace weft::viewer

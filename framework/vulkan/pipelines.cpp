#include "vulkan/pipelines.h"

#include "vulkan/executor_errors.h"
#include "vulkan/graphics_state.h"
#include "vulkan/shader_stages.h"
#include "vulkan/to_vk.h"

namespace weft::vk {
namespace {

Result<PipelineHandle> make_compute(Device& device, const PipelineRequest& request,
                                    const ShaderStages& stages) {
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = stages.infos()[0];
    info.layout = request.layout.pipeline.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result =
        device.fn().vkCreateComputePipelines(device.handle(), request.cache, 1, &info, nullptr, &pipeline);
    if (result != VK_SUCCESS)
        return failed_pass_call(request.plan, request.pass, "V412", "making its pipeline", result);
    return PipelineHandle(device, pipeline);
}

Diagnostic missing_inputs(const PipelineRequest& request, const std::string& list,
                          const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
    return pass_error(request.plan, request.pass, "V416",
                      "shader \"" + request.pass.shader + "\" reads vertex input " + text +
                          (list.empty() ? ", but nothing feeds it vertices"
                                        : ", which draw list \"" + list + "\" doesn't have"));
}

Result<PipelineHandle> make_graphics(Device& device, const PipelineRequest& request,
                                     const ShaderStages& stages, const std::string& list,
                                     const VertexFormat* vertices) {
    const GraphicsState state(request.plan.graph, request.pass, request.program.interface, vertices);
    if (!state.missing_inputs().empty()) return missing_inputs(request, list, state.missing_inputs());
    VkGraphicsPipelineCreateInfo info = state.info();
    info.stageCount = static_cast<uint32_t>(stages.infos().size());
    info.pStages = stages.infos().data();
    info.layout = request.layout.pipeline.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result =
        device.fn().vkCreateGraphicsPipelines(device.handle(), request.cache, 1, &info, nullptr, &pipeline);
    if (result != VK_SUCCESS)
        return failed_pass_call(request.plan, request.pass, "V412", "making its pipeline", result);
    return PipelineHandle(device, pipeline);
}

void name_pipeline(const Device& device, const PassDecl& pass, const std::string& variant,
                   VkPipeline pipeline) {
    device.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline),
                variant.empty() ? pass.name : pass.name + " " + variant);
}

const ImportDecl* find_list(const ImportCatalog* catalog, const std::string& list) {
    if (catalog == nullptr) return nullptr;
    const auto it = catalog->imports.find(list);
    return it != catalog->imports.end() && it->second.kind == ImportKind::draw_list ? &it->second : nullptr;
}

Status add_list(Device& device, const PipelineRequest& request, const std::string& list,
                std::vector<DrawPipeline>& out) {
    const ImportDecl* import = find_list(request.imports, list);
    if (import == nullptr)
        return pass_error(request.plan, request.pass, "V414", "no draw list \"" + list + "\" was given");
    for (uint32_t i = 0; i < import->variants.size(); ++i) {
        const DrawVariant& variant = import->variants[i];
        Result<ShaderStages> stages =
            ShaderStages::create(device, request.plan, request.pass, request.program, &variant);
        if (!stages) return stages.take_errors();
        Result<PipelineHandle> made = make_graphics(device, request, *stages, list, &import->vertex_format);
        if (!made) return made.take_errors();
        name_pipeline(device, request.pass, list + "/" + variant.name, made->get());
        out.push_back({list, i, std::move(*made)});
    }
    return Unit{};
}

}  // namespace

Result<std::vector<DrawPipeline>> make_pipelines(Device& device, const PipelineRequest& request) {
    std::vector<DrawPipeline> pipelines;
    if (request.pass.kind == PassKind::raster) {
        Diagnostics errors;
        for (const std::string& list : request.pass.draw_lists)
            if (Status added = add_list(device, request, list, pipelines); !added)
                append(errors, added.errors());
        if (!errors.empty()) return errors;
        return pipelines;
    }
    Result<ShaderStages> stages =
        ShaderStages::create(device, request.plan, request.pass, request.program, nullptr);
    if (!stages) return stages.take_errors();
    Result<PipelineHandle> made = request.pass.kind == PassKind::compute
                                      ? make_compute(device, request, *stages)
                                      : make_graphics(device, request, *stages, "", nullptr);
    if (!made) return made.take_errors();
    name_pipeline(device, request.pass, "", made->get());
    pipelines.push_back({"", 0, std::move(*made)});
    return pipelines;
}

Result<PipelineCacheHandle> make_pipeline_cache(Device& device) {
    VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    VkPipelineCache cache = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkCreatePipelineCache(device.handle(), &info, nullptr, &cache);
    if (result != VK_SUCCESS) return failed_call("V412", "making the pipeline cache", result);
    return PipelineCacheHandle(device, cache);
}

}  // namespace weft::vk

#include "vulkan/pipelines/pipelines.h"

#include "graph/plan/pipeline_hash.h"
#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/pipelines/graphics_state.h"
#include "vulkan/pipelines/shader_stages.h"

namespace weft::vk {
namespace {

// `create` is the function of the device for pipelines with this kind of `info`.
template <class Create, class Info>
Result<PipelineHandle> create_pipeline(Device& device, const PipelineRequest& request, Create create,
                                       Info info) {
    info.layout = request.layout.pipeline.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = create(device.handle(), request.cache, 1, &info, nullptr, &pipeline);
    if (result != VK_SUCCESS)
        return failed_pass_call(request.plan, request.pass, "V412", "creating the pipeline", result);
    return PipelineHandle(device, pipeline);
}

Result<PipelineHandle> make_compute(Device& device, const PipelineRequest& request) {
    Result<ShaderStages> stages =
        ShaderStages::create(device, request.plan, request.pass, request.program, nullptr);
    if (!stages) return stages.take_errors();
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = stages->infos()[0];
    return create_pipeline(device, request, device.fn().vkCreateComputePipelines, info);
}

Diagnostic missing_inputs(const PipelineRequest& request, const std::string& list,
                          const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
    return pass_error(request.plan, request.pass, "V416",
                      "shader \"" + request.pass.shader + "\" reads vertex input " + text +
                          (list.empty() ? ", but the pass draws no list with vertices"
                                        : ", which the draw list \"" + list + "\" does not have"));
}

// The properties of a draw list on which a pipeline depends.
struct ListPart {
    std::string list;
    const DrawVariant* variant = nullptr;
    const VertexFormat* vertices = nullptr;
};

// Expects that the draw list has all vertex inputs of the shader.
Status expect_inputs(const PipelineRequest& request, const ListPart& part) {
    const GraphicsState state(request.plan.graph, request.pass, request.program.interface, part.vertices);
    if (state.missing_inputs().empty()) return Unit{};
    return missing_inputs(request, part.list, state.missing_inputs());
}

Result<PipelineHandle> make_graphics(Device& device, const PipelineRequest& request, const ListPart& part) {
    const GraphicsState state(request.plan.graph, request.pass, request.program.interface, part.vertices);
    if (!state.missing_inputs().empty()) return missing_inputs(request, part.list, state.missing_inputs());
    Result<ShaderStages> stages =
        ShaderStages::create(device, request.plan, request.pass, request.program, part.variant);
    if (!stages) return stages.take_errors();
    VkGraphicsPipelineCreateInfo info = state.info();
    info.stageCount = static_cast<uint32_t>(stages->infos().size());
    info.pStages = stages->infos().data();
    return create_pipeline(device, request, device.fn().vkCreateGraphicsPipelines, info);
}

void name_pipeline(const Device& device, const PassDecl& pass, const ListPart& part, VkPipeline pipeline) {
    device.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline),
                part.variant == nullptr ? pass.name : pass.name + " " + part.list + "/" + part.variant->name);
}

Result<PipelineLease> lease_pipeline(Device& device, const PipelineRequest& request, const ListPart& part) {
    ++request.counts.all;
    const std::string hash =
        pipeline_hash({request.plan.graph, request.pass, request.program, part.variant, part.vertices});
    const auto make = [&] {
        Result<PipelineHandle> made = request.pass.kind == PassKind::compute
                                          ? make_compute(device, request)
                                          : make_graphics(device, request, part);
        if (made) name_pipeline(device, request.pass, part, made->get());
        return made;
    };
    return request.store.get(hash, make, request.counts.made);
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
        return pass_error(request.plan, request.pass, "V414",
                          "the program gave no draw list \"" + list + "\"");
    for (uint32_t i = 0; i < import->variants.size(); ++i) {
        const ListPart part{list, &import->variants[i], &import->vertex_format};
        if (request.draws != nullptr && !request.draws->draws_variant(list, i)) {
            if (Status complete = expect_inputs(request, part); !complete) return complete;
            continue;
        }
        Result<PipelineLease> pipeline = lease_pipeline(device, request, part);
        if (!pipeline) return pipeline.take_errors();
        out.push_back({list, i, std::move(*pipeline)});
    }
    return Unit{};
}

}  // namespace

Result<std::vector<DrawPipeline>> make_pipelines(Device& device, const PipelineRequest& request) {
    std::vector<DrawPipeline> pipelines;
    if (request.pass.kind == PassKind::raster && !request.pass.draws_without_list()) {
        Diagnostics errors;
        for (const std::string& list : request.pass.draw_lists)
            if (Status added = add_list(device, request, list, pipelines); !added)
                append(errors, added.errors());
        if (!errors.empty()) return errors;
        return pipelines;
    }
    Result<PipelineLease> pipeline = lease_pipeline(device, request, {});
    if (!pipeline) return pipeline.take_errors();
    pipelines.push_back({"", 0, std::move(*pipeline)});
    return pipelines;
}

Result<PipelineCacheHandle> make_pipeline_cache(Device& device) {
    VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    VkPipelineCache cache = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkCreatePipelineCache(device.handle(), &info, nullptr, &cache);
    if (result != VK_SUCCESS) return failed_call("V412", "creating the pipeline cache", result);
    return PipelineCacheHandle(device, cache);
}

}  // namespace weft::vk

// Purpose: the objects that render one graph at one size, and a fingerprint of them. Comparing fingerprints
// shows which objects a new plan can use again.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/files/device_object.h"
#include "render/files/file_store.h"
#include "weft/plan.h"
#include "weft/render/own_imports.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/executor.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

// Debug builds check every plan before it runs.
#ifdef NDEBUG
inline constexpr bool kAlwaysCheck = false;
#else
inline constexpr bool kAlwaysCheck = true;
#endif

// The object of a resource that the program uses between frames. One of the members is set. If the resource
// keeps its content, the executor owns the memory. Then each copy of the image in memory has an entry in
// ExportObjects, under the name of the copy. DeviceObject::image is only a view of this copy. Buffers that
// keep their content have no entry.
using ExportObjects = std::map<std::string, DeviceObject, std::less<>>;

struct RenderStage {
    vk::Image output;
    ExportObjects exports;
    std::map<std::string, vk::Image> own_images;  // The views of the program's own images.
    FileUses files;                   // The buffers and images of the plan whose content comes from files.
    std::vector<std::string> tables;  // The tables of textures that the scene and the program provide.
    // Declared last, so that the executor is destroyed before the objects that it uses.
    std::unique_ptr<vk::Executor> executor;
};

struct StageFingerprint {
    struct Program {
        uint64_t content_hash = 0;
        std::vector<ShaderBinding> bindings;
        std::optional<ParamsBlock> params;
    };
    std::string structure_hash, values_hash;
    // The shader programs of the graph, by the name under which the graph refers to them.
    std::map<std::string, Program, std::less<>> programs;
    std::map<std::string, uint64_t> files;  // Hashes of the contents of files, by the name of the resource.
    VkImage output = VK_NULL_HANDLE;
    ImportObjects imports;   // The objects of the program's own imports.
    uint32_t pipelines = 0;  // Number of pipelines of the stage.
    // The live resources of the plan with `"keep": "shared"`. The next plan retains them even if it does not
    // use them.
    std::vector<ResourceDecl> shared;
    // LoadedVersion::number of the load that made the graph; 0 if the graph was resolved again later, for
    // another size (see Session::resize()).
    uint64_t load = 0;
    // Number of the running graph's state. Each replacement adds 1, even if it replaces only values. The
    // number shows whether a replacement was prepared for the state that runs now or for an older one. 0: no
    // graph runs yet.
    uint64_t generation = 0;
};
[[nodiscard]] StageFingerprint take_fingerprint(const FramePlan& plan, const ShaderCatalog& shaders,
                                                VkImage output);
// True if the stage with fingerprint `from` can be kept for the plan with fingerprint `to`, and only the
// values and pipelines of the stage must be replaced.
[[nodiscard]] bool can_amend(const StageFingerprint& from, const StageFingerprint& to);
[[nodiscard]] uint32_t count_changed_programs(const StageFingerprint& from, const StageFingerprint& to);

}  // namespace weft::render

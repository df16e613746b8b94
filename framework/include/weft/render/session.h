// Purpose: renders one scene with one graph: loads, compiles, checks and runs the graph. This is the simplest
// way to embed Weft; `weft render` and the picture tests use it. Units: size in pixels. Threads: prepare()
// and prepare_part() may run on any thread, all other functions on the thread that submits.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "weft/load/load_graph.h"
#include "weft/render/draw_list.h"
#include "weft/render/frame_input.h"
#include "weft/render/own_imports.h"
#include "weft/render/pending_swap.h"
#include "weft/render/scene_part.h"
#include "weft/result.h"
#include "weft/scene/probes.h"
#include "weft/vulkan/frame_results.h"

namespace weft::scene {
struct Scene;
}
namespace weft::vk {
class Device;
class SharedPipelines;
}  // namespace weft::vk

namespace weft::render {

// Returns the creation info for the image Selection::output, with one mip. It contains pointers into
// `device`. The usage flags are those of OutputFormat::usage, or all that the device supports for the format.
[[nodiscard]] VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size,
                                                   const OutputFormat& output = {});

struct SessionInput {
    GraphRequest request;
    LoadSettings load;
    // The pass types in C++ that graphs may use: those of registered_passes() and of the program. create()
    // copies the catalogue. Error: W254 `passes` is null.
    const PassCatalog* passes = nullptr;
    const ParsedGraph* parsed = nullptr;  // The parsed graph of the request; null: create() parses it.
    VkImage output = VK_NULL_HANDLE;      // The embedder's output image; see Selection::output.
    // The program's own lists of views: the number of views of each, by name. A graph imports them with the
    // kind "views", and FrameInput::views has their matrices.
    std::map<std::string, uint32_t, std::less<>> views = {};
    // The program's own tables of textures, by name; see vk::ImportBindings::textures. A graph imports them
    // with the kind "textures". The views must outlive the session.
    std::map<std::string, std::vector<VkImageView>, std::less<>> textures = {};
    // Images and buffers of the program that graphs may import, by name. Error: W245 the scene has an import
    // of this name.
    std::map<std::string, OwnImport, std::less<>> imports = {};
    // Draw lists of the program, by name. If the scene has no instances, they may replace the lists of the
    // scene, such as "opaque". Errors: W245 the name is taken, W255 the vertex format has a fault.
    OwnDrawLists draw_lists = {};
    // Descriptor sets 2 and 3 of the program. They replace those of the scene, so the scene must have no
    // instances and no parts (W246). DrawList::record() binds them. Error: W256 a shader reads a set that is
    // missing here.
    OwnDrawSets draw_sets = {};
    // The light probes of the scene, from scene::place_probes() or scene::read_probes(). Empty: the scene has
    // none.
    scene::Probes probes = {};
    // True: FrameInput::transforms may move the instances of the scene. Then the buffers of the instances are
    // in memory that the CPU writes, one buffer for each frame slot.
    bool moves_instances = false;
    // False: the program adds no parts to the scene. Then no pipelines are created for kinds of materials that
    // the scene lacks, and the session starts earlier. Error of add_part(): W246.
    bool adds_parts = true;
    // Number of logical queues. The device must have been created with at least as many.
    uint32_t queues = 1;
    bool check_plan = false;  // True: the plan is checked before it runs. Debug builds always check it.
    // True: GPU times of each pass are measured. This records additional empty barriers after passes, so it
    // should be false in runs under validation.
    bool timestamps = false;
    // The store of pipelines that sessions on this device share; null: the session has its own store.
    vk::SharedPipelines* pipelines = nullptr;
    std::string drop_barriers_before;  // Hook for tests: name of a pass whose barriers are not recorded.
};

// How Session::warm_up_probes() lights the light probes.
struct ProbeWarmUp {
    // Number of updates (turns) of each irradiance probe. A reflection probe is updated once.
    uint32_t rounds = 4;
    // Number of probes that are updated in one frame, at least 1. With a large number, each frame takes long.
    // With a small number, many frames are rendered.
    uint32_t most_per_frame = 64;
    // Called after each frame with the number of updates of probes so far (`done`) and of all updates
    // (`all`). May be empty.
    std::function<void(uint32_t done, uint32_t all)> progress = {};
};

struct SessionParts;

class Session {
 public:
    // Creates a session. Errors: those of load_graph() (W…), of the checker (C…) and of the device (V…). If
    // `files` is not null, it receives the same paths as PrepareResult::files, even after an error.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    // Creates a session from a scene that the caller no longer needs. create() frees each texture after
    // copying it to the GPU, which halves the peak memory of textures.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, scene::Scene&& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    // Creates a session without a scene: the program draws its own draw lists. Graphs see one directional
    // light (`directionalLights` is 1), so that FrameInput::lights may contain a sun with shadows.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Selection& selection() const;
    // Returns the files that create() searched; see PrepareResult::files.
    [[nodiscard]] const std::set<std::filesystem::path>& first_files() const;
    // Prepares the selected graph while frames are rendered: reads it, compiles the changed parts, checks the
    // plan and creates its objects. May be called from any thread, and submits nothing. Errors: those of
    // create().
    [[nodiscard]] PrepareResult prepare(const Selection& selection);
    // Makes the prepared graph `next` the running one, from the next frame on. Resources with `history` or
    // `keep` keep their content as transition() decides. Returns false and does nothing if another swap was
    // made after `next` was prepared; then prepare again. After an error of the checker (C…) the running
    // graph continues.
    [[nodiscard]] Result<bool> swap_in(PendingSwap next);
    // Prepares the loaded graph at another size and swaps it in. Does nothing if the size and the image are
    // the same. After an error of the graph (W…, C…) or of memory, the running graph continues at the old
    // size. `output` replaces Selection::output; frames in flight may still use the old image. Errors: those
    // of create().
    [[nodiscard]] Status resize(Extent3D size, Diagnostics& warnings, VkImage output = VK_NULL_HANDLE);
    // Exchanges the object of one of the program's imports, for example because its size has changed. The
    // loaded graph is prepared with the new object and swapped in, as resize() does. `size` may be the old
    // size. Frames in flight may still use the old object: do not destroy it before two more frames have
    // begun.
    [[nodiscard]] Status rebind(const std::string& import, const ImportObject& object, const ImportSize& size,
                                Diagnostics& warnings);
    // Returns a resource in GraphRequest::exports of the running graph; nullopt if the graph does not have it
    // or no pass writes it.
    [[nodiscard]] std::optional<ExportedResource> exported(std::string_view name) const;

    // Makes a part of a scene: allocates its memory and fills it. May be called from any thread, and submits
    // nothing. Only meshes, textures, materials, instances and motion of `scene` are used. `moves_instances`
    // is the same as in SessionInput. Errors: V409 to V421.
    [[nodiscard]] Result<ScenePart> prepare_part(const scene::Scene& scene,
                                                 bool moves_instances = false) const;
    // Draws the part from the next frame on. The part belongs to the draw lists of the scene. The call
    // allocates no memory and waits for nothing. Returns the number of the part. Error: W246
    // SessionInput::draw_sets replaces descriptor sets that the part needs, or SessionInput::adds_parts is
    // false.
    [[nodiscard]] Result<PartId> add_part(ScenePart part);
    // Stops drawing the part. Frames in flight still use its memory. The memory is freed when these frames
    // have finished. Error: W247 there is no such part.
    [[nodiscard]] Status remove_part(PartId part);
    // Returns the number of pipelines that were created after create() returned, on the thread that called
    // create(). This thread renders the frames, so each of these pipelines delayed a frame.
    [[nodiscard]] uint64_t pipelines_made_between_frames() const;

    // Returns the number of irradiance probes of the scene. Grid points without a probe do not count.
    [[nodiscard]] uint32_t probe_count() const;
    // Returns the number of reflection probes of the scene.
    [[nodiscard]] uint32_t reflection_probe_count() const;
    // Lights all probes before the first frame. For this, it renders additional frames with the input
    // `first`, and chooses the probes that each of these frames updates. These frames have no picture: only
    // passes with "rest" and groups of passes run, and the passes whose results they need. Weft submits the
    // frames itself, drops their readbacks and does not count them, and the first frame sees no history.
    // Returns the times of the frames. Does nothing if the scene has no probes, or if no group of the graph
    // uses the import "probeTurns" or "reflectionTurns" to choose its rounds.
    [[nodiscard]] Result<std::vector<vk::FrameTiming>> warm_up_probes(const FrameInput& first,
                                                                      const ProbeWarmUp& settings = {});
    [[nodiscard]] Status render_frame(const FrameInput& input);
    [[nodiscard]] Status finish();
    // Returns true if the graph writes an output image. Some graphs write only other resources.
    [[nodiscard]] bool has_output() const;
    // Returns the output image of the last frame. Call this after finish(). Errors: W184 the graph has no
    // output, V426 its final layout is not transfer_src.
    [[nodiscard]] Result<vk::ReadbackData> read_output();
    [[nodiscard]] std::vector<vk::ReadbackData> take_readbacks();
    [[nodiscard]] std::vector<vk::FrameTiming> take_timings();
    [[nodiscard]] const FramePlan& plan() const;
    // Returns the number of frames that the graph file asks for.
    [[nodiscard]] uint32_t frames() const;
    // Returns the factor 2^EV of the last frame, with which radiance was multiplied.
    [[nodiscard]] float pre_exposure() const;

    // Gives tests access to the parts of the session. The tests include render/session_parts.h.
    [[nodiscard]] const SessionParts& parts() const { return *parts_; }

 private:
    explicit Session(std::unique_ptr<SessionParts> parts);
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, scene::Scene* owned, const SessionInput& input,
        Diagnostics& warnings, std::set<std::filesystem::path>* files);
    [[nodiscard]] Status render_frame(const FrameInput& input, bool warms_up);
    [[nodiscard]] Status change_selection(const Selection& selection, Diagnostics& warnings);

    std::unique_ptr<SessionParts> parts_;
};

}  // namespace weft::render

// Purpose: the graph that a session renders, and the preparation of the graph that replaces it. prepare() may
// run on any thread; all other functions must run on the thread that submits.
#pragma once

#include <filesystem>
#include <mutex>
#include <set>

#include "render/graph_loader.h"
#include "render/live_inputs.h"
#include "render/stage_maker.h"
#include "weft/render/frame_input.h"
#include "weft/render/pending_swap.h"

namespace weft::render {

class RunningGraph {
 public:
    // `device` must outlive the RunningGraph. Call load_first() and then start() before all other functions.
    RunningGraph(const vk::Device& device, const SessionInput& input, ImportCatalog imports);

    // Loads the first graph. Call it before the scene is uploaded, so that errors in the graph are found
    // before slow work. `parsed` is the parsed graph; if it is null, the function parses the graph file.
    [[nodiscard]] Status load_first(const ParsedGraph* parsed, Diagnostics& warnings);
    // Creates the executor of the first graph, with all its Vulkan objects. The graph runs after adopt() was
    // called with the result.
    [[nodiscard]] Result<PendingSwap> start(vk::Device& device, const GpuScene& scene,
                                            const StageSettings& settings);

    // Prepares the replacement of the running graph by the selected graph, as Session::prepare() describes.
    [[nodiscard]] PrepareResult prepare(const Selection& selection);
    // Prepares the loaded graph, without reading its files again, for another size or for other imports.
    [[nodiscard]] Result<PendingSwap> prepare_loaded(const Selection& selection, Diagnostics& warnings);
    // Stores the values of switches and scales for live_inputs(). Returns an amendment that gives the running
    // plan the values of the other parameters; null if the plan has these values already. Error W242: a
    // parameter does not exist, its change needs a new plan, or the graph does not allow the value.
    [[nodiscard]] Result<std::unique_ptr<vk::Amendment>> set_parameters(const ParameterValues& values);
    // Returns the switches and scales of the next frame. adopt() removes them.
    [[nodiscard]] const LiveInputs& live_inputs() const { return live_inputs_; }
    // True if `next` was prepared to replace the graph that runs now. False if another replacement came
    // first.
    [[nodiscard]] bool is_next(const SwapParts& next) const;
    // Makes `next` the running graph: stores its selection, graph and fingerprint.
    void adopt(SwapParts& next);

    [[nodiscard]] const Selection& selection() const { return selection_; }
    [[nodiscard]] const LoadedGraph& loaded() const { return loaded_; }
    // Returns the files that load_first() searched.
    [[nodiscard]] const std::set<std::filesystem::path>& first_files() const { return first_files_; }
    [[nodiscard]] bool checks_plans() const { return maker_->checks_plans(); }
    [[nodiscard]] uint64_t pipelines_made_between_frames() const {
        return maker_->pipelines_made_between_frames();
    }

 private:
    [[nodiscard]] StageFingerprint running() const;
    [[nodiscard]] Result<std::unique_ptr<vk::Amendment>> change_values(const ParameterValues& values);
    [[nodiscard]] ParameterValues find_wrong(const GraphRequest& from, const ParameterValues& values) const;
    // Stores the load number of `next` for the running graph. `next` comes from a later load, but its graph
    // is the same. So the next prepare() can notice that nothing has changed since that load.
    void note_same(const SwapParts& next);

    // Ensures that only one prepare() runs at a time.
    std::mutex preparing_;
    GraphLoader loader_;
    std::unique_ptr<StageMaker> maker_;
    std::set<std::filesystem::path> first_files_;
    Selection selection_;
    LoadedGraph loaded_;
    LiveInputs live_inputs_;
    mutable std::mutex fingerprint_mutex_;
    StageFingerprint fingerprint_;
};

}  // namespace weft::render

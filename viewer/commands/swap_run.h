// Purpose: replaces the running graph at fixed frames, for `weft render --swap`. A second thread prepares the
// next graph while frames are rendered, as a program would do. A graph replaces the running one exactly
// `every` frames after the one before, so the pictures do not depend on the speed of the machine.
#pragma once

#include <cstdint>
#include <future>
#include <string>
#include <vector>

#include "viewer/output/stats.h"
#include "weft/render/session.h"

namespace weft::viewer {

class SwapRun {
 public:
    // `targets`: the graphs that run one after the other, again and again: the name of a tier, or a file
    // FILE.json or FILE.json:TIER. The first one already runs. An empty list never swaps.
    SwapRun(render::Session& session, std::vector<std::string> targets, uint32_t every)
        : session_(session), targets_(std::move(targets)), every_(every) {}

    // Call it before each frame; `frame` is 0 for the first one. Begins to prepare the next graph, or swaps
    // it in. If the next graph has errors, the running graph stays, and errors() has the errors. After any
    // other error, for example a lost device, no frame can follow.
    [[nodiscard]] Status before_frame(uint32_t frame, uint32_t frames);
    [[nodiscard]] const std::vector<SwapRecord>& records() const { return records_; }
    [[nodiscard]] const Diagnostics& errors() const { return errors_; }

 private:
    struct Prepared {
        render::PrepareResult made;
        double ms = 0;
    };
    void begin(const std::string& target);
    [[nodiscard]] Status end(uint32_t frame);

    render::Session& session_;
    std::vector<std::string> targets_;
    uint32_t every_;
    size_t next_ = 1;
    std::future<Prepared> preparing_;
    std::vector<SwapRecord> records_;
    Diagnostics errors_;
};

// Returns the request for a target of --swap. The other values are those of `running`.
[[nodiscard]] GraphRequest swap_request(GraphRequest running, const std::string& target);

}  // namespace weft::viewer

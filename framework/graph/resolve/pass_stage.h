// Purpose: a base class for the stages of resolve() that handle one pass at a time. It holds the data about
// the pass that such a stage reads, and reports errors of the pass.
#pragma once

#include <string>
#include <utility>

#include "graph/resolve/version.h"

namespace weft {

// `Stage` is the result of the stage: one element of `passes` for each pass, and `suspects`.
template <class Stage>
class PassStage {
 public:
    // Keeps references to all arguments.
    PassStage(const Declared& declared, const VersionedGraph& graph, PassId pass, Stage& stage,
              Reporter& reporter)
        : declared_(declared),
          graph_(graph),
          pass_(pass),
          draft_(declared.expansion.passes[pass]),
          bound_(graph.passes[pass]),
          result_(stage.passes[pass]),
          suspects_(stage.suspects),
          evaluator_(declared.evaluator(pass, stage.suspects, reporter)),
          reporter_(declared.shapes, declared.expansion, stage.suspects, reporter) {}

 protected:
    [[nodiscard]] const PassDesc& desc() const { return *draft_.desc; }
    Diagnostic& report(SourceLoc loc, std::string code, std::string message) {
        return reporter_.error(pass_, loc, std::move(code), std::move(message));
    }

    const Declared& declared_;
    const VersionedGraph& graph_;
    PassId pass_;
    const PassDraft& draft_;
    const BoundPass& bound_;
    typename decltype(Stage::passes)::value_type& result_;  // the result for the pass
    const Suspects& suspects_;
    Evaluator evaluator_;  // knows the indices of the repeat that made the pass

 private:
    PassReporter reporter_;
};

}  // namespace weft

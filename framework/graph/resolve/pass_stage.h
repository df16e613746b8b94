// Purpose: the data that a stage of resolve() reads about one pass, and the stage's way to report its faults.
// Base of the classes that treat one pass.
#pragma once

#include <string>
#include <utility>

#include "graph/resolve/version.h"

namespace weft {

class PassStage {
 protected:
    // Keeps references to all arguments.
    PassStage(const Declared& declared, const VersionedGraph& graph, PassId pass, Suspects& suspects,
              Reporter& reporter)
        : declared_(declared),
          graph_(graph),
          pass_(pass),
          draft_(declared.expansion.passes[pass]),
          bound_(graph.passes[pass]),
          suspects_(suspects),
          evaluator_(declared.evaluator(pass, suspects, reporter)),
          reporter_(declared.shapes, declared.expansion, suspects, reporter) {}

    [[nodiscard]] const PassDesc& desc() const { return *draft_.desc; }
    Diagnostic& report(SourceLoc loc, std::string code, std::string message) {
        return reporter_.error(pass_, loc, std::move(code), std::move(message));
    }

    const Declared& declared_;
    const VersionedGraph& graph_;
    PassId pass_;
    const PassDraft& draft_;
    const BoundPass& bound_;
    const Suspects& suspects_;
    Evaluator evaluator_;  // knows the indices of the repeat that made the pass

 private:
    PassReporter reporter_;
};

}  // namespace weft

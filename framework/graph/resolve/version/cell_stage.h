// Purpose: a base class for the steps of version() that look at all cells of the resources. It holds the data
// that such a step reads and changes.
#pragma once

#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

class CellStage {
 public:
    // Keeps references to all arguments.
    CellStage(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
              Reporter& reporter)
        : declared_(declared),
          cells_(cells),
          graph_(graph),
          report_(declared.shapes, declared.expansion, graph.suspects, reporter),
          reporter_(reporter) {}

 protected:
    UseDecl& use(const CellUse& u) { return graph_.passes[u.pass].uses[u.use]; }

    const Declared& declared_;
    const std::vector<Cell>& cells_;
    VersionedGraph& graph_;
    PassReporter report_;
    Reporter& reporter_;
};

}  // namespace weft

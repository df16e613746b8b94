// Purpose: reports errors of passes and marks these passes as suspect, so that no consequences of an error
// are reported.
#pragma once

#include <string>

#include "graph/resolve/expand.h"

namespace weft {

class PassReporter {
 public:
    // Keeps references to all arguments.
    PassReporter(const Shapes& shapes, const Expansion& expansion, Suspects& suspects, Reporter& reporter)
        : shapes_(shapes), expansion_(expansion), suspects_(suspects), reporter_(reporter) {}

    // Reports an error and marks the pass as suspect. For later passes of a repeat, an error that is already
    // known is not reported again.
    Diagnostic& error(PassId pass, SourceLoc loc, std::string code, std::string message);

 private:
    const Shapes& shapes_;
    const Expansion& expansion_;
    Suspects& suspects_;
    Reporter& reporter_;
};

}  // namespace weft

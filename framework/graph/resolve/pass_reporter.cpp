#include "graph/resolve/pass_reporter.h"

namespace weft {

Diagnostic& PassReporter::error(PassId pass, SourceLoc loc, std::string code, std::string message) {
    suspects_.passes[pass] = 1;
    Diagnostic fault = reporter_.sources().error(loc, std::move(code), std::move(message));
    if (expansion_.passes[pass].instance == 0) return reporter_.add(std::move(fault));
    const uint64_t names = expansion_.passes.size() + shapes_.resources.size() + expansion_.tried_ports;
    return reporter_.add_once(std::move(fault), loc, names);
}

}  // namespace weft

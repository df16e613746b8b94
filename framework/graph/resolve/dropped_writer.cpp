#include "graph/resolve/dropped_writer.h"

#include "graph/resolve/pass_ports.h"

namespace weft {

const PassDesc* dropped_writer(const Expansion& expansion, const std::string& resource, Reporter& reporter) {
    for (const auto& [unused, desc] : expansion.dropped) {
        reporter.spend(1 + desc->out.size(), desc->loc);
        if (output_of(*desc, resource)) return desc;
    }
    return nullptr;
}

}  // namespace weft

// Purpose: finds the resource for a reference to an earlier frame, such as "color[-1]". Private to bind().
#pragma once

#include <map>
#include <string>

#include "graph/resolve/bind.h"

namespace weft {

class RoleFinder {
 public:
    RoleFinder(const Declared& declared, PassReporter& report, Reporter& reporter)
        : declared_(declared), report_(report), reporter_(reporter) {}

    // Returns the id of the ResourceDecl that a reference to `resource` selects: `resource` itself for this
    // frame, or its copy of an earlier frame. Returns kNoId if an error was reported, now or earlier. Errors:
    // W110, W121, W122.
    [[nodiscard]] ResourceId find(PassId pass, const RefDesc& ref, ResourceId resource, bool is_output);

 private:
    [[nodiscard]] bool written_by_any_pass(const std::string& name);
    void report_no_history(PassId pass, const RefDesc& ref, const ResourceDecl& resource);

    const Declared& declared_;
    PassReporter& report_;
    Reporter& reporter_;
    // The results of written_by_any_pass() so far, by the name of the resource.
    std::map<std::string, bool, std::less<>> is_written_;
};

}  // namespace weft

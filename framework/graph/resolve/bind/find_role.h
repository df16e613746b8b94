// Purpose: references to earlier frames. Private to bind().
#pragma once

#include <map>
#include <string>

#include "graph/resolve/bind.h"

namespace weft {

class RoleFinder {
 public:
    RoleFinder(const Declared& declared, PassReporter& report, Reporter& reporter)
        : declared_(declared), report_(report), reporter_(reporter) {}

    // The role that a reference to `resource` means; kNoId: reported. Errors: W110, W121, W122.
    [[nodiscard]] ResourceId find(PassId pass, const RefDesc& ref, ResourceId resource, bool is_output);

 private:
    [[nodiscard]] bool written_by_any_pass(const std::string& name);
    void report_no_history(PassId pass, const RefDesc& ref, const ResourceDecl& resource);

    const Declared& declared_;
    PassReporter& report_;
    Reporter& reporter_;
    std::map<std::string, bool, std::less<>> is_written_;  // answers of written_by_any_pass()
};

}  // namespace weft

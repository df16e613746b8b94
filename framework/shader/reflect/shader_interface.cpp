#include "weft/shader_interface.h"

#include <algorithm>
#include <string_view>

namespace weft {

const ShaderBinding* ShaderInterface::find(std::string_view name) const {
    const auto found = std::ranges::find_if(bindings, [&](const ShaderBinding& binding) {
        return binding.set == kPortSet && binding.name == name;
    });
    return found == bindings.end() ? nullptr : &*found;
}

}  // namespace weft

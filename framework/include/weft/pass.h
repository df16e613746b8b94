// Purpose: declares the types of passes written in C++. Most passes are only JSON and GLSL; C++ is for passes
// that need work on the CPU. Such a pass is a struct with static members, and pass_type<T>() converts it to a
// PassType. Passes use no Vulkan type: they write host data with Uploads and record commands with Recorder.
// The exception are passes that record Vulkan commands of their own; see weft/vulkan/raw_pass.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "weft/access.h"
#include "weft/declaration.h"
#include "weft/result.h"

namespace weft {

struct PortDecl {
    std::string_view name;
    Access access = Access::none;
    bool is_output = false;
    // The shader stages that access the port. They matter only for accesses by shaders, such as sampled_read,
    // in passes that record Vulkan commands of their own (weft/vulkan/raw_pass.h).
    ShaderStageMask stages = stage_bit(ShaderStage::compute);
};

struct In : PortDecl {
    constexpr In(std::string_view port, Access a,
                 ShaderStageMask shader_stages = stage_bit(ShaderStage::compute))
        : PortDecl{port, a, false, shader_stages} {}
};
struct Out : PortDecl {
    constexpr Out(std::string_view port, Access a,
                  ShaderStageMask shader_stages = stage_bit(ShaderStage::compute))
        : PortDecl{port, a, true, shader_stages} {}
};

// A parameter of a pass type: its name, default, range and unit. Graphs set it in "params"; `weft doctor` and
// the documentation list it.
struct ParamDecl {
    std::string_view name;
    double default_value = 0;
    double min = 0;
    double max = 0;
    std::string_view unit;
};

// Values of any C++ type that the program gives to its passes in each frame, by name. Only pointers are
// stored, so the values must stay valid until the frame is recorded.
class HostInputs {
 public:
    template <class T>
    void set(std::string name, const T& value) {
        values_.insert_or_assign(std::move(name), Entry{std::type_index(typeid(T)), &value});
    }
    template <class T>
    [[nodiscard]] const T* get(std::string_view name) const {
        const auto it = values_.find(name);
        if (it == values_.end() || it->second.type != std::type_index(typeid(T))) return nullptr;
        return static_cast<const T*>(it->second.value);
    }

 private:
    struct Entry {
        std::type_index type;
        const void* value;
    };
    std::map<std::string, Entry, std::less<>> values_;
};

// A pass gives its data to the current frame through this interface, before the frame is recorded: put()
// stores bytes for a port, and Recorder::copy_upload() copies these bytes to the resource of the port.
class Uploads {
 public:
    virtual ~Uploads() = default;
    // Stores `bytes` for a port: at most capacity(port) bytes.
    virtual void put(std::string_view port, std::span<const std::byte> bytes) = 0;
    [[nodiscard]] virtual uint64_t capacity(std::string_view port) const = 0;
    // For an import of kind "turns": chooses the rounds of groups that run in this frame, and their order. A
    // group is a set of passes; each round is one copy of all its passes. This list replaces the list of the
    // program.
    virtual void set_turns(std::string_view import, std::span<const uint32_t> rounds) = 0;
};

// The commands that a C++ pass may record. The resources of its ports are bound, and barriers have brought
// them into their declared states.
class Recorder {
 public:
    virtual ~Recorder() = default;
    virtual void copy_upload(std::string_view port) = 0;
    virtual void fill_buffer(std::string_view port, uint32_t word) = 0;
};

struct PassContext {
    std::span<const NamedValue> params;

    // Returns the value of a parameter. Asserts that the pass type declares a parameter of this name.
    [[nodiscard]] double param(std::string_view name) const;
};

// Describes a type of C++ pass by function pointers. The functions keep no state between calls.
struct PassType {
    std::string_view name;
    std::vector<PortDecl> ports;
    std::vector<ParamDecl> params;
    // Checks the extents and formats of the ports' resources. The result depends only on the arguments.
    Status (*check)(const PassDecl&, const ResolvedGraph&) = nullptr;
    void (*prepare)(const PassContext&, const HostInputs&, Uploads&) = nullptr;
    void (*record)(const PassContext&, Recorder&) = nullptr;
};

// Makes a PassType from T. T must have kType, kPorts (array of PortDecl), kParams (array of ParamDecl),
// check, prepare and record.
template <class T>
[[nodiscard]] PassType pass_type() {
    return PassType{T::kType,
                    {T::kPorts.begin(), T::kPorts.end()},
                    {T::kParams.begin(), T::kParams.end()},
                    &T::check,
                    &T::prepare,
                    &T::record};
}

using PassCatalog = std::map<std::string, PassType, std::less<>>;

}  // namespace weft

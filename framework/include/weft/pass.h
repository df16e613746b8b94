// Purpose: declares pass types to the compiler and the executor. Most passes are only JSON and GLSL; a C++
// pass is a struct with static members, which pass_type<T>() converts to a PassType. Passes use no Vulkan
// type: they write host data with Uploads and record commands with Recorder.
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
};

struct In : PortDecl {
    constexpr In(std::string_view port, Access a) : PortDecl{port, a, false} {}
};
struct Out : PortDecl {
    constexpr Out(std::string_view port, Access a) : PortDecl{port, a, true} {}
};

// A parameter of a pass type, for JSON, `weft doctor` and the documentation.
struct ParamDecl {
    std::string_view name;
    double default_value = 0;
    double min = 0;
    double max = 0;
    std::string_view unit;
};

// Typed values that the program gives to its passes each frame, by name. They must stay valid until the frame
// is recorded.
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

// This frame's upload memory. Recorder::copy_upload copies the bytes stored for a port to that port.
class Uploads {
 public:
    virtual ~Uploads() = default;
    // Stores at most `capacity(port)` bytes.
    virtual void put(std::string_view port, std::span<const std::byte> bytes) = 0;
    [[nodiscard]] virtual uint64_t capacity(std::string_view port) const = 0;
};

// The commands that a C++ pass may record. Its ports are bound and in their declared states.
class Recorder {
 public:
    virtual ~Recorder() = default;
    virtual void copy_upload(std::string_view port) = 0;
    virtual void fill_buffer(std::string_view port, uint32_t word) = 0;
};

struct PassContext {
    std::span<const NamedValue> params;

    [[nodiscard]] double param(std::string_view name) const;  // asserts that the pass type declares this
                                                              // parameter
};

// A C++ pass type as plain function pointers: pass types have no state.
struct PassType {
    std::string_view name;
    std::vector<PortDecl> ports;
    std::vector<ParamDecl> params;
    Status (*check)(const PassDecl&, const ResolvedGraph&) = nullptr;  // checks shapes and formats; a pure
                                                                       // function
    void (*prepare)(const PassContext&, const HostInputs&, Uploads&) = nullptr;
    void (*record)(const PassContext&, Recorder&) = nullptr;
};

// T must have kType, kPorts (array of PortDecl), kParams (array of ParamDecl), check, prepare and record.
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

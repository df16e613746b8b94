#include "graph/resolve/check/check_buffer_use.h"

#include <numeric>

#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

// The offsets of clears and of indirect commands must be multiples of this size, a 32-bit word.
constexpr uint64_t kWordBytes = 4;
constexpr uint32_t kVectorBytes = 16;  // The size of a vec4.

class BufferUseCheck {
 public:
    BufferUseCheck(const Declared& declared, PassId pass, const UseDecl& use, const ResourceDecl& buffer,
                   PassReporter& report)
        : declared_(declared),
          pass_(pass),
          use_(use),
          buffer_(buffer),
          bytes_(used_bytes(buffer, use)),
          report_(report) {}

    void run(const ShaderBinding* binding) {
        if (binding) check_block(*binding);
        if (use_.bytes) check_offset(alignment(binding), binding != nullptr);
    }

 private:
    void error(const char* code, const std::string& message, const std::string& help) {
        add_help(report_.error(pass_, use_.loc, code, message), help);
    }
    std::string port_text() const {
        return "port " + quote(use_.port) + " of pass " + quote(declared_.pass_name(pass_));
    }

    uint64_t alignment(const ShaderBinding* binding) const {
        const DeviceProfile& profile = declared_.input.profile;
        if (!binding) return kWordBytes;
        return binding->kind == BindingKind::uniform_buffer ? profile.uniform_offset_alignment_bytes
                                                            : profile.storage_offset_alignment_bytes;
    }

    // Reports an offset that is no multiple of the alignment, and names the nearest elements at which the
    // range could begin.
    void check_offset(uint64_t alignment, bool from_device) {
        if (bytes_.offset_bytes % alignment == 0) return;
        const uint64_t stride = buffer_.stride_bytes;
        const uint64_t step = alignment / std::gcd(alignment, stride);
        const uint64_t first = bytes_.offset_bytes / stride;
        const uint64_t below = first / step * step;
        const uint64_t count = buffer_.size_bytes / stride;
        Diagnostic& d =
            report_.error(pass_, use_.loc, "W194",
                          port_text() + " begins at element " + std::to_string(first) + " of " +
                              quote(buffer_.name) + ", which is byte " + std::to_string(bytes_.offset_bytes) +
                              "; it must begin at a multiple of " + std::to_string(alignment) + " bytes");
        add_help(d, "begin at element " + std::to_string(below) +
                        (below + step < count ? " or " + std::to_string(below + step) : "") +
                        (step > 1 ? ": every " + std::to_string(step) + ". element is possible" : ""));
        if (from_device)
            add_help(d, "the alignment comes from the device profile " + quote(declared_.input.profile.name));
    }

    void check_block(const ShaderBinding& binding) {
        const std::string part = quote(range_of(buffer_, use_.range));
        if (binding.block_bytes > bytes_.size_bytes) {
            error("W166",
                  port_text() + " needs " + std::to_string(binding.block_bytes) + " bytes, but " + part +
                      " has " + std::to_string(bytes_.size_bytes),
                  use_.bytes ? "select more elements of the buffer, or correct the block in the shader"
                             : "increase \"count\" of the buffer, or correct the block in the shader");
            return;
        }
        const uint64_t most = declared_.input.profile.max_uniform_buffer_bytes;
        if (binding.kind == BindingKind::uniform_buffer && bytes_.size_bytes > most) {
            error("W166",
                  port_text() + " is a uniform buffer of " + std::to_string(bytes_.size_bytes) +
                      " bytes; the device allows at most " + std::to_string(most),
                  "declare the block as a storage buffer: `readonly buffer`");
            return;
        }
        check_elements(binding);
    }

    // Returns true if the elements of the buffer are structs that C++ and GLSL share, such as ViewConstants.
    // This is unknown for imports.
    bool has_structs() const {
        const ResourceDesc* desc = declared_.shapes.origins[use_.resource].desc;
        return desc != nullptr && declared_.input.imports.strides.contains(desc->element);
    }

    void check_elements(const ShaderBinding& binding) {
        if (binding.members.empty() || !binding.members.back().is_runtime_array || buffer_.stride_bytes == 0)
            return;
        // The shader may declare elements of another size than those of the buffer, for example read a buffer
        // of vec4 as floats. But one of the two sizes must be a multiple of the other, so that no element
        // crosses the border of another element.
        // If the elements of the buffer are structs, the shader may declare them as words or vectors, but not
        // as another struct or as matrices.
        const uint32_t step = binding.members.back().array_stride_bytes;
        if (step == 0) return;
        const bool parts = buffer_.stride_bytes % step == 0 && (!has_structs() || step <= kVectorBytes);
        const bool wholes =
            step % buffer_.stride_bytes == 0 && (!has_structs() || step == buffer_.stride_bytes);
        if (parts || wholes) return;
        error("W166",
              port_text() + " has elements of " + std::to_string(step) +
                  " bytes in the shader, but elements of " + quote(buffer_.name) + " have " +
                  std::to_string(buffer_.stride_bytes),
              "use the same struct in the graph and in the shader");
    }

    const Declared& declared_;
    PassId pass_;
    const UseDecl& use_;
    const ResourceDecl& buffer_;
    ByteRange bytes_;
    PassReporter& report_;
};

}  // namespace

void check_buffer_use(const Declared& declared, PassId pass, const UseDecl& use, const ResourceDecl& buffer,
                      const ShaderBinding* binding, PassReporter& report) {
    BufferUseCheck(declared, pass, use, buffer, report).run(binding);
}

}  // namespace weft

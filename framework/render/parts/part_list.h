// Purpose: the parts of a scene that are drawn, and removed parts that frames in flight still use. A frame
// draws the parts that are in the list when the frame begins. All functions must be called on the thread that
// submits.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/parts/gpu_part.h"
#include "vulkan/memory/uploader.h"
#include "weft/render/frame_input.h"

namespace weft::render {

class PartList {
 public:
    void add_first(std::unique_ptr<GpuPart> part);
    // Submits the uploads of the part, and draws it from the next frame on.
    [[nodiscard]] Result<PartId> add(std::unique_ptr<GpuPart> part, std::unique_ptr<vk::UploadBatch> uploads);
    // Draws the part no longer. Its memory is freed when the frame `until` has begun: frames in flight may
    // use it until then. Returns false if there is no such part. The first part cannot be removed.
    [[nodiscard]] bool remove(PartId part, uint64_t until);
    // Frees the removed parts whose `until` is at most `frame`: no frame in flight uses them any more. Also
    // frees the staging memory of finished uploads.
    void drop_retired(uint64_t frame);

    // Returns null if there is no such part.
    [[nodiscard]] GpuPart* find(PartId part) const;
    [[nodiscard]] GpuPart& first() const { return *parts_.front().part; }
    // Begins a frame of all parts.
    void begin_frame(uint32_t slot, double time_s);

    // Calls `visit` for each part, in the order in which the parts were added.
    template <class Visit>
    void each(const Visit& visit) const {
        for (const Entry& entry : parts_) visit(*entry.part);
    }
    // Returns a number that changes whenever the draws of a list change.
    [[nodiscard]] uint64_t version(std::string_view list) const;
    // Returns a number that changes whenever a part is added or removed.
    [[nodiscard]] uint64_t parts_version() const { return parts_version_; }

 private:
    struct Entry {
        PartId id = kFirstPart;
        std::unique_ptr<GpuPart> part;
        // Null if the copies have finished. Declared after `part`, so that `uploads` is destroyed first: its
        // destructor waits for the copies to the part.
        std::unique_ptr<vk::UploadBatch> uploads;
        uint64_t until = 0;  // Only for removed parts: see remove().
    };
    void note_change(const GpuPart& part);

    std::vector<Entry> parts_;
    std::vector<Entry> retired_;
    std::map<std::string, uint64_t, std::less<>> versions_;
    uint64_t parts_version_ = 0;
    PartId next_ = kFirstPart + 1;
};

}  // namespace weft::render

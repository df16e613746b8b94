#include "weft/device_profile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <string_view>

namespace weft {
namespace {

using Json = nlohmann::ordered_json;
namespace ff = format_feature;

struct FeatureName {
    FormatFeatureMask bit;
    const char* name;
};
constexpr std::array kFeatureNames{
    FeatureName{ff::kSampled, "sampled"},     FeatureName{ff::kSampledLinear, "linear"},
    FeatureName{ff::kStorage, "storage"},     FeatureName{ff::kColorAttachment, "color"},
    FeatureName{ff::kColorBlend, "blend"},    FeatureName{ff::kDepthAttachment, "depth"},
    FeatureName{ff::kTransferSrc, "copySrc"}, FeatureName{ff::kTransferDst, "copyDst"},
    FeatureName{ff::kBlitSrc, "blitSrc"},     FeatureName{ff::kBlitDst, "blitDst"},
};

constexpr std::array<const char*, 3> kQueueNames{"graphics", "compute", "transfer"};

struct Limit {
    const char* name;
    uint32_t DeviceProfile::*value;
};
constexpr std::array kLimits{
    Limit{"maxImage2dPx", &DeviceProfile::max_image_2d_px},
    Limit{"maxImageLayers", &DeviceProfile::max_image_layers},
    Limit{"maxPushConstantsBytes", &DeviceProfile::max_push_constants_bytes},
    Limit{"maxColorAttachments", &DeviceProfile::max_color_attachments},
    Limit{"maxWorkgroupInvocations", &DeviceProfile::max_workgroup_invocations},
    Limit{"maxSharedBytes", &DeviceProfile::max_shared_bytes},
    Limit{"maxSampledImagesPerStage", &DeviceProfile::max_sampled_images_per_stage},
    Limit{"maxStorageImagesPerStage", &DeviceProfile::max_storage_images_per_stage},
    Limit{"maxDrawIndirectCount", &DeviceProfile::max_draw_indirect_count},
};
struct WideLimit {
    const char* name;
    uint64_t DeviceProfile::*value;
};
constexpr std::array kWideLimits{
    WideLimit{"maxUniformBufferBytes", &DeviceProfile::max_uniform_buffer_bytes},
    WideLimit{"maxStorageBufferBytes", &DeviceProfile::max_storage_buffer_bytes},
    WideLimit{"bufferImageGranularityBytes", &DeviceProfile::buffer_image_granularity_bytes},
};
struct Switch {
    const char* name;
    bool DeviceProfile::*value;
};
constexpr std::array kSwitches{
    Switch{"storageReadWithoutFormat", &DeviceProfile::storage_read_without_format},
    Switch{"descriptorIndexing", &DeviceProfile::descriptor_indexing},
    Switch{"nonSolidFill", &DeviceProfile::non_solid_fill},
    Switch{"depthClamp", &DeviceProfile::depth_clamp},
    Switch{"depthBiasClamp", &DeviceProfile::depth_bias_clamp},
    Switch{"drawIndirectCount", &DeviceProfile::draw_indirect_count},
};

struct CapabilityName {
    ShaderCapabilityMask bit;
    const char* name;
};
namespace sc = shader_capability;
constexpr std::array kCapabilityNames{
    CapabilityName{sc::kImageGatherExtended, "ImageGatherExtended"},
    CapabilityName{sc::kImageCubeArray, "ImageCubeArray"},
    CapabilityName{sc::kSubgroupVote, "GroupNonUniformVote"},
    CapabilityName{sc::kSubgroupArithmetic, "GroupNonUniformArithmetic"},
    CapabilityName{sc::kSubgroupBallot, "GroupNonUniformBallot"},
    CapabilityName{sc::kSubgroupShuffle, "GroupNonUniformShuffle"},
    CapabilityName{sc::kSubgroupShuffleRelative, "GroupNonUniformShuffleRelative"},
    CapabilityName{sc::kSubgroupClustered, "GroupNonUniformClustered"},
    CapabilityName{sc::kSubgroupQuad, "GroupNonUniformQuad"},
};

struct SampleCounts {
    const char* name;
    SampleCountMask DeviceProfile::*value;
};
constexpr std::array kSampleCounts{
    SampleCounts{"colorSamples", &DeviceProfile::color_samples},
    SampleCounts{"integerSamples", &DeviceProfile::integer_samples},
    SampleCounts{"depthSamples", &DeviceProfile::depth_samples},
};
constexpr uint32_t kMostSamples = 64;

// Alignments that a profile file may omit. DeviceProfile contains the default value of each omitted
// alignment.
constexpr std::array kMemoryLimits{
    WideLimit{"imageAlignmentBytes", &DeviceProfile::image_alignment_bytes},
    WideLimit{"bufferAlignmentBytes", &DeviceProfile::buffer_alignment_bytes},
    WideLimit{"imageRowAlignmentBytes", &DeviceProfile::image_row_alignment_bytes},
    WideLimit{"storageOffsetAlignmentBytes", &DeviceProfile::storage_offset_alignment_bytes},
    WideLimit{"uniformOffsetAlignmentBytes", &DeviceProfile::uniform_offset_alignment_bytes},
};

constexpr WideLimit kExtraBytes{"imageExtraBytes", &DeviceProfile::image_extra_bytes};

struct ContentName {
    MemoryContentMask bit;
    const char* name;
};
constexpr std::array kContentNames{ContentName{memory_content::kBuffers, "buffers"},
                                   ContentName{memory_content::kColorImages, "colorImages"},
                                   ContentName{memory_content::kDepthImages, "depthImages"}};

Json features_to_json(FormatFeatureMask mask) {
    Json names = Json::array();
    for (const FeatureName& feature : kFeatureNames) {
        if (mask & feature.bit) names.push_back(feature.name);
    }
    return names;
}

// Reads the values of a profile file into a DeviceProfile and collects the errors. The position of an error
// is a JSON pointer, such as "/memoryTypes", because the JSON parser keeps no lines and columns.
struct ProfileReader {
    const std::string& file;
    Diagnostics faults;

    void fault(const std::string& pointer, std::string message, std::string help) {
        Diagnostic d;
        d.code = "W140";
        d.file = file;
        d.pointer = pointer;
        d.message = std::move(message);
        d.help = {std::move(help)};
        faults.push_back(std::move(d));
    }

    void formats(const Json& object, DeviceProfile& profile) {
        for (const auto& [name, list] : object.items()) {
            const std::optional<Format> format = format_from_name(name);
            if (!format || !list.is_array()) {
                fault("/formats/" + name, "\"" + name + "\" is not a known format with a list of features",
                      "use the names that `weft doctor --json` writes");
                continue;
            }
            FormatFeatureMask mask = 0;
            for (const Json& item : list) {
                const auto it =
                    std::find_if(kFeatureNames.begin(), kFeatureNames.end(), [&](const FeatureName& f) {
                        return item.is_string() && item.get<std::string>() == f.name;
                    });
                if (it == kFeatureNames.end()) {
                    fault("/formats/" + name, "unknown format feature " + item.dump(),
                          "use sampled, linear, storage, color, blend, depth, copySrc, copyDst, "
                          "blitSrc, blitDst");
                } else {
                    mask |= it->bit;
                }
            }
            profile.formats[*format] = mask;
        }
    }

    bool sample_counts(const std::string& key, const Json& list, DeviceProfile& profile) {
        const auto it = std::find_if(kSampleCounts.begin(), kSampleCounts.end(),
                                     [&](const SampleCounts& s) { return key == s.name; });
        if (it == kSampleCounts.end() || !list.is_array()) return false;
        SampleCountMask mask = 0;
        for (const Json& item : list) {
            const uint64_t count = item.is_number_unsigned() ? item.get<uint64_t>() : 0;
            if (std::has_single_bit(count) && count <= kMostSamples)
                mask |= static_cast<SampleCountMask>(count);
            else
                fault("/" + key, item.dump() + " is not a sample count", "use 1, 2, 4, 8, 16, 32 and 64");
        }
        if ((mask & 1) == 0) fault("/" + key, "the sample count 1 is missing", "add 1 to the list");
        profile.*it->value = mask;
        return true;
    }

    void capabilities(const Json& list, DeviceProfile& profile) {
        profile.shader_capabilities = 0;
        for (const Json& item : list) {
            const auto it =
                std::find_if(kCapabilityNames.begin(), kCapabilityNames.end(), [&](const CapabilityName& c) {
                    return item.is_string() && item.get<std::string>() == c.name;
                });
            if (it != kCapabilityNames.end()) {
                profile.shader_capabilities |= it->bit;
                continue;
            }
            std::string known;
            for (const CapabilityName& c : kCapabilityNames)
                known += (known.empty() ? "" : ", ") + std::string(c.name);
            fault("/shaderCapabilities", "unknown shader capability " + item.dump(), "use one of " + known);
        }
    }

    void queues(const Json& list, DeviceProfile& profile) {
        profile.queue_families.clear();
        for (const Json& item : list) {
            const std::string kind = item.value("kind", "");
            const auto it = std::find(kQueueNames.begin(), kQueueNames.end(), kind);
            if (it == kQueueNames.end()) {
                fault("/queueFamilies", "a queue family has the unknown kind \"" + kind + "\"",
                      "use graphics, compute or transfer");
                continue;
            }
            profile.queue_families.push_back(
                {static_cast<QueueKind>(it - kQueueNames.begin()), item.value("count", 1u)});
        }
        if (profile.queue_families.empty())
            fault("/queueFamilies", "the list of queue families is empty", "add at least one queue family");
    }

    void heaps(const Json& list, DeviceProfile& profile) {
        for (const Json& item : list)
            profile.memory_heaps.push_back(
                {item.value("bytes", uint64_t{0}), item.value("deviceLocal", true)});
    }

    MemoryContentMask contents(const Json& item) {
        if (!item.contains("holds")) return memory_content::kAll;
        MemoryContentMask mask = 0;
        for (const Json& word : item.at("holds")) {
            const auto it = std::find_if(kContentNames.begin(), kContentNames.end(),
                                         [&](const ContentName& c) { return word == c.name; });
            if (it == kContentNames.end())
                fault("/memoryTypes", "unknown content of a memory type: " + word.dump(),
                      "use buffers, colorImages and depthImages");
            else
                mask |= it->bit;
        }
        return mask;
    }

    void types(const Json& list, DeviceProfile& profile) {
        for (const Json& item : list)
            profile.memory_types.push_back({item.value("heap", 0u), item.value("deviceLocal", true),
                                            item.value("hostVisible", false),
                                            item.value("lazilyAllocated", false), contents(item)});
    }

    // Checks values that depend on each other or that the file may omit. For example, a memory type names a
    // heap by its index in "memoryHeaps". So this check runs after all keys have been read.
    void check_memory(const DeviceProfile& profile) {
        if (profile.memory_types.size() > 32)
            fault("/memoryTypes", std::to_string(profile.memory_types.size()) + " memory types are too many",
                  "list at most 32 memory types");
        MemoryContentMask held = 0;
        for (const MemoryTypeProfile& type : profile.memory_types) {
            if (!type.lazily_allocated) held |= type.holds;
            if (type.heap >= profile.memory_heaps.size())
                fault("/memoryTypes", "a memory type names the unknown heap " + std::to_string(type.heap),
                      "the profile has " + std::to_string(profile.memory_heaps.size()) +
                          " heaps, counted from 0");
        }
        if (!profile.memory_types.empty() && held != memory_content::kAll)
            fault("/memoryTypes", "the memory types do not cover all kinds of resources",
                  "list a memory type that is not lazily allocated for each of buffers, colorImages and "
                  "depthImages");
        for (const WideLimit& l : kMemoryLimits)
            if (!std::has_single_bit(profile.*l.value))
                fault(std::string("/") + l.name, "the alignment must be a power of two",
                      "correct the value, which is " + std::to_string(profile.*l.value));
        if (!std::has_single_bit(profile.buffer_image_granularity_bytes))
            fault("/bufferImageGranularityBytes", "the granularity must be a power of two",
                  "correct the value, which is " + std::to_string(profile.buffer_image_granularity_bytes));
    }

    void member(const std::string& key, const Json& value, DeviceProfile& profile) {
        if (key == "name" && value.is_string()) {
            profile.name = value.get<std::string>();
        } else if (key == "formats" && value.is_object()) {
            formats(value, profile);
        } else if (key == "shaderCapabilities" && value.is_array()) {
            capabilities(value, profile);
        } else if (key == "queueFamilies" && value.is_array()) {
            queues(value, profile);
        } else if (key == "memoryHeaps" && value.is_array()) {
            heaps(value, profile);
        } else if (key == "memoryTypes" && value.is_array()) {
            types(value, profile);
        } else if (!sample_counts(key, value, profile) && !limit(key, value, profile)) {
            fault("/" + key, "unknown key or wrong type",
                  "compare the profile with the output of `weft doctor --json`");
        }
    }

    static bool limit(const std::string& key, const Json& value, DeviceProfile& profile) {
        for (const Limit& l : kLimits) {
            if (key == l.name && value.is_number_unsigned())
                return profile.*l.value = value.get<uint32_t>(), true;
        }
        for (const std::span<const WideLimit> limits :
             {std::span<const WideLimit>(kWideLimits), std::span<const WideLimit>(kMemoryLimits),
              std::span<const WideLimit>(&kExtraBytes, 1)})
            for (const WideLimit& l : limits) {
                if (key == l.name && value.is_number_unsigned())
                    return profile.*l.value = value.get<uint64_t>(), true;
            }
        for (const Switch& s : kSwitches) {
            if (key == s.name && value.is_boolean()) return profile.*s.value = value.get<bool>(), true;
        }
        return false;
    }
};

}  // namespace

FormatFeatureMask DeviceProfile::features(Format format) const {
    const auto it = formats.find(format);
    return it == formats.end() ? 0 : it->second;
}

SampleCountMask DeviceProfile::samples(Format format) const {
    switch (format_info(format).numeric) {
        case NumericClass::float_like:
            return color_samples;
        case NumericClass::sint:
        case NumericClass::uint:
            return format_info(format).stencil ? depth_samples : integer_samples;
        case NumericClass::depth:
            return depth_samples;
    }
    return 1;
}

Result<DeviceProfile> parse_profile(const std::string& json, const std::string& file) {
    ProfileReader reader{file, {}};
    DeviceProfile profile;
    const Json root = Json::parse(json, nullptr, false);
    if (!root.is_object()) {
        reader.fault("", "the profile is not a JSON object",
                     "use a profile in the format that `weft doctor --json` writes");
        return std::move(reader.faults);
    }
    try {
        for (const auto& [key, value] : root.items()) reader.member(key, value, profile);
    } catch (const nlohmann::json::exception& e) {
        reader.fault("", e.what(), "compare the profile with the output of `weft doctor --json`");
    }
    reader.check_memory(profile);
    if (!reader.faults.empty()) return std::move(reader.faults);
    return profile;
}

namespace {

Json content_to_json(MemoryContentMask mask) {
    Json names = Json::array();
    for (const ContentName& content : kContentNames)
        if (mask & content.bit) names.push_back(content.name);
    return names;
}

void write_memory(const DeviceProfile& profile, Json& root) {
    const DeviceProfile standard;
    for (const WideLimit& l : kMemoryLimits)
        if (profile.*l.value != standard.*l.value) root[l.name] = profile.*l.value;
    if (profile.image_extra_bytes != 0) root[kExtraBytes.name] = profile.image_extra_bytes;
    for (const MemoryHeapProfile& heap : profile.memory_heaps)
        root["memoryHeaps"].push_back({{"bytes", heap.size_bytes}, {"deviceLocal", heap.device_local}});
    for (const MemoryTypeProfile& type : profile.memory_types) {
        Json object{{"heap", type.heap},
                    {"deviceLocal", type.device_local},
                    {"hostVisible", type.host_visible},
                    {"lazilyAllocated", type.lazily_allocated}};
        if (type.holds != memory_content::kAll) object["holds"] = content_to_json(type.holds);
        root["memoryTypes"].push_back(std::move(object));
    }
}

}  // namespace

std::string profile_to_json(const DeviceProfile& profile) {
    Json root;
    root["name"] = profile.name;
    for (const QueueFamilyProfile& family : profile.queue_families) {
        root["queueFamilies"].push_back(
            {{"kind", kQueueNames.at(static_cast<size_t>(family.kind))}, {"count", family.count}});
    }
    for (const Limit& l : kLimits) root[l.name] = profile.*l.value;
    for (const WideLimit& l : kWideLimits) root[l.name] = profile.*l.value;
    for (const SampleCounts& s : kSampleCounts)
        for (uint32_t count = 1; count <= kMostSamples; count <<= 1)
            if (profile.*s.value & count) root[s.name].push_back(count);
    for (const Switch& s : kSwitches) root[s.name] = profile.*s.value;
    root["shaderCapabilities"] = Json::array();
    for (const CapabilityName& c : kCapabilityNames)
        if (profile.shader_capabilities & c.bit) root["shaderCapabilities"].push_back(c.name);
    write_memory(profile, root);
    for (const auto& [format, mask] : profile.formats) {
        root["formats"][std::string(format_info(format).name)] = features_to_json(mask);
    }
    return root.dump(2) + "\n";
}

}  // namespace weft

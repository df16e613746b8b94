#include "shader/gate/capability_table.h"

#include <spirv.h>

#include <algorithm>
#include <array>

namespace weft::shader {
namespace {

namespace sc = shader_capability;
using enum CapabilityRule;

// Texts that tell the user what to do instead of using a capability. If several errors of a stage have the
// same text, only the first is reported.
constexpr const char* kOtherDevice = "write the shader without this feature, or choose another device";
constexpr const char* kCubes = "use a samplerCube port for each cube, or choose another device";
constexpr const char* kGather =
    "use textureGatherOffset() with constant offsets, or four calls of texelFetch()";
constexpr const char* kFormat = "declare the format of the image, for example layout(rgba16f)";
constexpr const char* kPointer = "store the data in a storage buffer, and pass an index instead of a pointer";
constexpr const char* kWide = "use float, int and uint; where 32 bits are not enough, use two of them";
constexpr const char* kNarrow =
    "use float, int and uint; pack smaller numbers into a uint with packHalf2x16() or packUnorm4x8()";
constexpr const char* kFloatAtomic =
    "use integer atomics; for the minimum or maximum of positive floats, store floatBitsToUint(x) in a uint";
constexpr const char* kSample =
    "shade once per pixel; to read single samples of an input, use texelFetch() with a sampler2DMS";
constexpr const char* kStoreSamples =
    "write to an image with one sample, or draw to a multisampled attachment";
constexpr const char* kClip =
    "pass the distance to the fragment stage, and `discard` there if it is negative";
constexpr const char* kLayer =
    "draw the layers in a pass with `views`, or each layer in a separate pass; `repeat` creates these passes";
constexpr const char* kPrimitive =
    "compute the primitive or layer number in the vertex stage, and pass it to the fragment stage as `flat "
    "out uint`";
constexpr const char* kDraw =
    "use gl_VertexIndex and gl_InstanceIndex, which already include the first vertex and instance of the "
    "draw";
constexpr const char* kIndex = "declare the size of the array, and use only constants as its index";
constexpr const char* kSparse = "use texture() and textureLod(); Weft has no sparse images";
constexpr const char* kStage = "use vertex, fragment and compute stages; a pass has no other stages";
constexpr const char* kRay = "march along the ray in a buffer or a depth image; Weft has no ray tracing";
constexpr const char* kSubgroupOld = "use GL_KHR_shader_subgroup_vote and GL_KHR_shader_subgroup_ballot";
constexpr const char* kOverlap = "use the blend state of the pass, or atomics on a storage buffer";
constexpr const char* kFeedback = "write the data to a storage buffer";
constexpr const char* kMemory =
    "remove `#pragma use_vulkan_memory_model`; `barrier()` and `memoryBarrierShared()` work without it";
constexpr const char* kSharedBlock = "declare `shared` variables instead of a block";
constexpr const char* kVendor = "use features of core GLSL 4.60; extensions of vendors are not supported";
constexpr const char* kStencil = "write the stencil value with the stencil state of the pass";
constexpr const char* kCoverage = "compare the depth in the shader, and `discard` where the test fails";
constexpr const char* kClock = "measure the passes with `weft render --stats FILE`";
constexpr const char* kDesktop = "use textures and storage buffers of Vulkan; this feature belongs to OpenGL";

constexpr CapabilityRow row(uint32_t capability, const char* name, const char* words, const char* remedy) {
    return {capability, name, never, 0, words, remedy};
}
constexpr CapabilityRow free_row(uint32_t capability, const char* name) {
    return {capability, name, always, 0, "", ""};
}
constexpr CapabilityRow table(uint32_t capability, const char* name) {
    return {capability, name, tables, 0, "", ""};
}
constexpr CapabilityRow subgroup(uint32_t capability, const char* name, ShaderCapabilityMask needs,
                                 const char* words) {
    return {capability, name, compute, needs, words, kOtherDevice};
}

constexpr std::array kTable{
    free_row(SpvCapabilityShader, "Shader"),
    free_row(SpvCapabilityMatrix, "Matrix"),
    free_row(SpvCapabilityImageQuery, "ImageQuery"),
    free_row(SpvCapabilityDerivativeControl, "DerivativeControl"),
    free_row(SpvCapabilityStorageImageExtendedFormats, "StorageImageExtendedFormats"),
    free_row(SpvCapabilityStorageImageWriteWithoutFormat, "StorageImageWriteWithoutFormat"),
    free_row(SpvCapabilityDemoteToHelperInvocation, "DemoteToHelperInvocation"),
    // Every Vulkan device supports the next five capabilities. The interface check (W206) tests later whether
    // a pass can bind resources of these kinds.
    free_row(SpvCapabilitySampled1D, "Sampled1D"),
    free_row(SpvCapabilityImage1D, "Image1D"),
    free_row(SpvCapabilitySampledBuffer, "SampledBuffer"),
    free_row(SpvCapabilityImageBuffer, "ImageBuffer"),
    free_row(SpvCapabilityInputAttachment, "InputAttachment"),

    CapabilityRow{SpvCapabilityStorageImageReadWithoutFormat, "StorageImageReadWithoutFormat", device, 0,
                  "imageLoad", kFormat},
    CapabilityRow{SpvCapabilityImageGatherExtended, "ImageGatherExtended", device, sc::kImageGatherExtended,
                  "textureGatherOffset*", kGather},
    CapabilityRow{SpvCapabilityImageCubeArray, "ImageCubeArray", device, sc::kImageCubeArray,
                  "imageCubeArray iimageCubeArray uimageCubeArray", kCubes},
    CapabilityRow{SpvCapabilitySampledCubeArray, "SampledCubeArray", device, sc::kImageCubeArray,
                  "samplerCubeArray* isamplerCubeArray usamplerCubeArray", kCubes},

    subgroup(SpvCapabilityGroupNonUniform, "GroupNonUniform", 0, "subgroup* gl_Subgroup* gl_NumSubgroups"),
    subgroup(SpvCapabilityGroupNonUniformVote, "GroupNonUniformVote", sc::kSubgroupVote,
             "subgroupAll subgroupAny subgroupAllEqual"),
    subgroup(SpvCapabilityGroupNonUniformArithmetic, "GroupNonUniformArithmetic", sc::kSubgroupArithmetic,
             "subgroupAdd subgroupMul subgroupM* subgroupAnd subgroupOr subgroupXor subgroupInclusive* "
             "subgroupExclusive*"),
    subgroup(SpvCapabilityGroupNonUniformBallot, "GroupNonUniformBallot", sc::kSubgroupBallot,
             "subgroupBallot* subgroupBroadcast* subgroupInverseBallot gl_Subgroup*Mask gl_Subgroup*"),
    subgroup(SpvCapabilityGroupNonUniformShuffle, "GroupNonUniformShuffle", sc::kSubgroupShuffle,
             "subgroupShuffle subgroupShuffleXor"),
    subgroup(SpvCapabilityGroupNonUniformShuffleRelative, "GroupNonUniformShuffleRelative",
             sc::kSubgroupShuffleRelative, "subgroupShuffleUp subgroupShuffleDown"),
    subgroup(SpvCapabilityGroupNonUniformClustered, "GroupNonUniformClustered", sc::kSubgroupClustered,
             "subgroupClustered*"),
    subgroup(SpvCapabilityGroupNonUniformQuad, "GroupNonUniformQuad", sc::kSubgroupQuad, "subgroupQuad*"),

    row(SpvCapabilityPhysicalStorageBufferAddresses, "PhysicalStorageBufferAddresses",
        "buffer_reference buffer_reference_align", kPointer),
    row(SpvCapabilityVariablePointers, "VariablePointers", "use_variable_pointers", kPointer),
    row(SpvCapabilityVariablePointersStorageBuffer, "VariablePointersStorageBuffer", "use_variable_pointers",
        kPointer),

    row(SpvCapabilityFloat64, "Float64", "double dvec* dmat* float64_t f64vec* f64mat*", kWide),
    row(SpvCapabilityInt64, "Int64",
        "int64_t uint64_t i64vec* u64vec* i64image* u64image* clockRealtimeEXT clockARB timeAMD", kWide),
    row(SpvCapabilityInt64Atomics, "Int64Atomics", "atomic* int64_t uint64_t", kWide),
    row(SpvCapabilityInt64ImageEXT, "Int64ImageEXT", "i64image* u64image*", kWide),
    row(SpvCapabilityInt16, "Int16", "int16_t uint16_t i16vec* u16vec*", kNarrow),
    row(SpvCapabilityInt8, "Int8", "int8_t uint8_t i8vec* u8vec*", kNarrow),
    row(SpvCapabilityFloat16, "Float16", "float16_t f16vec* f16mat* f16texture* f16image* f16sampler*",
        kNarrow),
    row(SpvCapabilityStorageBuffer16BitAccess, "StorageBuffer16BitAccess",
        "float16_t f16vec* int16_t uint16_t i16vec* u16vec*", kNarrow),
    row(SpvCapabilityStorageUniform16, "StorageUniform16",
        "float16_t f16vec* int16_t uint16_t i16vec* u16vec*", kNarrow),
    row(SpvCapabilityStoragePushConstant16, "StoragePushConstant16",
        "float16_t f16vec* int16_t uint16_t i16vec* u16vec*", kNarrow),
    row(SpvCapabilityStorageInputOutput16, "StorageInputOutput16",
        "float16_t f16vec* int16_t uint16_t i16vec* u16vec*", kNarrow),
    row(SpvCapabilityStorageBuffer8BitAccess, "StorageBuffer8BitAccess", "int8_t uint8_t i8vec* u8vec*",
        kNarrow),
    row(SpvCapabilityUniformAndStorageBuffer8BitAccess, "UniformAndStorageBuffer8BitAccess",
        "int8_t uint8_t i8vec* u8vec*", kNarrow),
    row(SpvCapabilityStoragePushConstant8, "StoragePushConstant8", "int8_t uint8_t i8vec* u8vec*", kNarrow),

    row(SpvCapabilityAtomicFloat16AddEXT, "AtomicFloat16AddEXT", "atomicAdd imageAtomicAdd", kFloatAtomic),
    row(SpvCapabilityAtomicFloat16MinMaxEXT, "AtomicFloat16MinMaxEXT", "atomicM* imageAtomicM*",
        kFloatAtomic),
    row(SpvCapabilityAtomicFloat32AddEXT, "AtomicFloat32AddEXT", "atomicAdd imageAtomicAdd", kFloatAtomic),
    row(SpvCapabilityAtomicFloat32MinMaxEXT, "AtomicFloat32MinMaxEXT", "atomicM* imageAtomicM*",
        kFloatAtomic),
    row(SpvCapabilityAtomicFloat64AddEXT, "AtomicFloat64AddEXT", "atomicAdd imageAtomicAdd", kFloatAtomic),
    row(SpvCapabilityAtomicFloat64MinMaxEXT, "AtomicFloat64MinMaxEXT", "atomicM* imageAtomicM*",
        kFloatAtomic),

    row(SpvCapabilitySampleRateShading, "SampleRateShading", "gl_SampleID gl_SamplePosition sample", kSample),
    row(SpvCapabilityInterpolationFunction, "InterpolationFunction", "interpolateAt*", kSample),
    row(SpvCapabilityStorageImageMultisample, "StorageImageMultisample",
        "image2DMS* iimage2DMS* uimage2DMS* subpassInputMS", kStoreSamples),
    row(SpvCapabilityImageMSArray, "ImageMSArray", "image2DMSArray iimage2DMSArray uimage2DMSArray",
        kStoreSamples),
    row(SpvCapabilitySampleMaskPostDepthCoverage, "SampleMaskPostDepthCoverage", "post_depth_coverage",
        kCoverage),
    row(SpvCapabilityFragmentFullyCoveredEXT, "FragmentFullyCoveredEXT", "gl_FragFullyCoveredNV", kCoverage),
    row(SpvCapabilitySampleMaskOverrideCoverageNV, "SampleMaskOverrideCoverageNV", "override_coverage",
        kCoverage),
    row(SpvCapabilityClipDistance, "ClipDistance", "gl_ClipDistance", kClip),
    row(SpvCapabilityCullDistance, "CullDistance", "gl_CullDistance", kClip),
    row(SpvCapabilityMultiViewport, "MultiViewport", "gl_ViewportIndex", kLayer),
    row(SpvCapabilityShaderLayer, "ShaderLayer", "gl_Layer", kLayer),
    row(SpvCapabilityShaderViewportIndex, "ShaderViewportIndex", "gl_ViewportIndex", kLayer),
    row(SpvCapabilityShaderViewportIndexLayerEXT, "ShaderViewportIndexLayerEXT", "gl_Layer gl_ViewportIndex",
        kLayer),
    row(SpvCapabilityMultiView, "MultiView", "gl_ViewIndex", kLayer),
    row(SpvCapabilityDeviceGroup, "DeviceGroup", "gl_DeviceIndex", kOtherDevice),
    row(SpvCapabilityGeometry, "Geometry", "gl_PrimitiveID gl_Layer", kPrimitive),
    row(SpvCapabilityDrawParameters, "DrawParameters", "gl_BaseVertex* gl_BaseInstance* gl_DrawID*", kDraw),
    row(SpvCapabilityTransformFeedback, "TransformFeedback", "xfb_buffer xfb_stride xfb_offset", kFeedback),
    row(SpvCapabilityStencilExportEXT, "StencilExportEXT", "gl_FragStencilRefARB", kStencil),
    row(SpvCapabilityMinLod, "MinLod", "textureClamp* textureGradClamp* sparseTextureClamp*", kSparse),
    row(SpvCapabilitySparseResidency, "SparseResidency", "sparse*", kSparse),

    table(SpvCapabilityShaderNonUniform, "ShaderNonUniform"),
    table(SpvCapabilityRuntimeDescriptorArray, "RuntimeDescriptorArray"),
    table(SpvCapabilitySampledImageArrayNonUniformIndexing, "SampledImageArrayNonUniformIndexing"),
    row(SpvCapabilityInputAttachmentArrayDynamicIndexing, "InputAttachmentArrayDynamicIndexing",
        "subpassLoad", kIndex),
    row(SpvCapabilityUniformTexelBufferArrayDynamicIndexing, "UniformTexelBufferArrayDynamicIndexing",
        "samplerBuffer isamplerBuffer usamplerBuffer textureBuffer", kIndex),
    row(SpvCapabilityStorageTexelBufferArrayDynamicIndexing, "StorageTexelBufferArrayDynamicIndexing",
        "imageBuffer iimageBuffer uimageBuffer", kIndex),
    row(SpvCapabilityUniformBufferArrayNonUniformIndexing, "UniformBufferArrayNonUniformIndexing",
        "nonuniformEXT", kIndex),
    row(SpvCapabilityStorageBufferArrayNonUniformIndexing, "StorageBufferArrayNonUniformIndexing",
        "nonuniformEXT", kIndex),
    row(SpvCapabilityStorageImageArrayNonUniformIndexing, "StorageImageArrayNonUniformIndexing",
        "nonuniformEXT", kIndex),
    row(SpvCapabilityInputAttachmentArrayNonUniformIndexing, "InputAttachmentArrayNonUniformIndexing",
        "nonuniformEXT", kIndex),
    row(SpvCapabilityUniformTexelBufferArrayNonUniformIndexing, "UniformTexelBufferArrayNonUniformIndexing",
        "nonuniformEXT", kIndex),
    row(SpvCapabilityStorageTexelBufferArrayNonUniformIndexing, "StorageTexelBufferArrayNonUniformIndexing",
        "nonuniformEXT", kIndex),

    row(SpvCapabilityFragmentShaderPixelInterlockEXT, "FragmentShaderPixelInterlockEXT", "pixel_interlock_*",
        kOverlap),
    row(SpvCapabilityFragmentShaderSampleInterlockEXT, "FragmentShaderSampleInterlockEXT",
        "sample_interlock_*", kOverlap),
    row(SpvCapabilityFragmentShaderShadingRateInterlockEXT, "FragmentShaderShadingRateInterlockEXT",
        "shading_rate_interlock_*", kOverlap),
    row(SpvCapabilityVulkanMemoryModel, "VulkanMemoryModel", "use_vulkan_memory_model", kMemory),
    row(SpvCapabilityVulkanMemoryModelDeviceScope, "VulkanMemoryModelDeviceScope", "use_vulkan_memory_model",
        kMemory),
    row(SpvCapabilityWorkgroupMemoryExplicitLayoutKHR, "WorkgroupMemoryExplicitLayoutKHR",
        "GL_EXT_shared_memory_block", kSharedBlock),
    row(SpvCapabilityWorkgroupMemoryExplicitLayout8BitAccessKHR, "WorkgroupMemoryExplicitLayout8BitAccessKHR",
        "GL_EXT_shared_memory_block", kSharedBlock),
    row(SpvCapabilityWorkgroupMemoryExplicitLayout16BitAccessKHR,
        "WorkgroupMemoryExplicitLayout16BitAccessKHR", "GL_EXT_shared_memory_block", kSharedBlock),
    row(SpvCapabilityShaderClockKHR, "ShaderClockKHR", "clock*", kClock),
    row(SpvCapabilitySubgroupBallotKHR, "SubgroupBallotKHR",
        "ballotARB readInvocationARB readFirstInvocationARB gl_SubGroup*", kSubgroupOld),
    row(SpvCapabilitySubgroupVoteKHR, "SubgroupVoteKHR", "anyInvocation* allInvocations*", kSubgroupOld),
    row(SpvCapabilityGroups, "Groups", "minInvocations* maxInvocations* addInvocations*", kSubgroupOld),

    row(SpvCapabilityTessellation, "Tessellation", "", kStage),
    row(SpvCapabilityTessellationPointSize, "TessellationPointSize", "", kStage),
    row(SpvCapabilityGeometryPointSize, "GeometryPointSize", "", kStage),
    row(SpvCapabilityGeometryStreams, "GeometryStreams", "", kStage),
    row(SpvCapabilityGeometryShaderPassthroughNV, "GeometryShaderPassthroughNV", "", kStage),
    row(SpvCapabilityMeshShadingEXT, "MeshShadingEXT", "gl_PrimitiveShadingRateEXT perprimitiveEXT", kStage),
    row(SpvCapabilityMeshShadingNV, "MeshShadingNV", "perprimitiveNV", kStage),
    row(SpvCapabilityRayQueryKHR, "RayQueryKHR", "rayQuery* accelerationStructureEXT", kRay),
    row(SpvCapabilityRayTracingKHR, "RayTracingKHR", "GL_EXT_ray_tracing", kRay),
    row(SpvCapabilityRayTracingNV, "RayTracingNV", "GL_NV_ray_tracing", kRay),
    row(SpvCapabilityRayTracingMotionBlurNV, "RayTracingMotionBlurNV", "GL_NV_ray_tracing_motion_blur", kRay),
    row(SpvCapabilityRayTraversalPrimitiveCullingKHR, "RayTraversalPrimitiveCullingKHR",
        "GL_EXT_ray_flags_primitive_culling", kRay),
    row(SpvCapabilityRayCullMaskKHR, "RayCullMaskKHR", "GL_EXT_ray_cull_mask", kRay),
    row(5383, "ShaderInvocationReorderNV", "GL_NV_shader_invocation_reorder", kRay),

    row(SpvCapabilityFragmentShadingRateKHR, "FragmentShadingRateKHR",
        "gl_ShadingRateEXT gl_PrimitiveShadingRateEXT", kVendor),
    row(SpvCapabilityFragmentDensityEXT, "FragmentDensityEXT",
        "gl_FragSizeEXT gl_FragInvocationCountEXT gl_FragmentSizeNV gl_InvocationsPerPixelNV", kVendor),
    row(SpvCapabilityFragmentBarycentricKHR, "FragmentBarycentricKHR",
        "gl_BaryCoord* pervertexEXT pervertexNV", kVendor),
    row(SpvCapabilityComputeDerivativeGroupQuadsNV, "ComputeDerivativeGroupQuadsNV",
        "derivative_group_quadsNV", kVendor),
    row(SpvCapabilityComputeDerivativeGroupLinearNV, "ComputeDerivativeGroupLinearNV",
        "derivative_group_linearNV", kVendor),
    row(SpvCapabilityGroupNonUniformPartitionedNV, "GroupNonUniformPartitionedNV", "subgroupPartition*",
        kVendor),
    row(SpvCapabilityCooperativeMatrixNV, "CooperativeMatrixNV", "fcoopmatNV icoopmatNV ucoopmatNV", kVendor),
    row(SpvCapabilityIntegerFunctions2INTEL, "IntegerFunctions2INTEL",
        "absoluteDifference countLeadingZeros countTrailingZeros addSaturate subtractSaturate average* "
        "multiply32x16",
        kVendor),
    row(SpvCapabilityFloat16ImageAMD, "Float16ImageAMD", "f16texture* f16image* f16sampler*", kVendor),
    row(SpvCapabilityFragmentMaskAMD, "FragmentMaskAMD", "fragmentMaskFetchAMD fragmentFetchAMD", kVendor),
    row(SpvCapabilityImageGatherBiasLodAMD, "ImageGatherBiasLodAMD", "textureGather* sparseTextureGather*",
        kVendor),
    row(SpvCapabilityImageReadWriteLodAMD, "ImageReadWriteLodAMD", "imageLoadLodAMD imageStoreLodAMD",
        kVendor),
    row(SpvCapabilityImageFootprintNV, "ImageFootprintNV", "textureFootprint*", kVendor),
    row(SpvCapabilityPerViewAttributesNV, "PerViewAttributesNV",
        "gl_PositionPerViewNV gl_ViewportMaskPerViewNV", kVendor),
    row(SpvCapabilityShaderViewportMaskNV, "ShaderViewportMaskNV", "gl_ViewportMask*", kVendor),
    row(SpvCapabilityShaderStereoViewNV, "ShaderStereoViewNV", "gl_SecondaryPositionNV", kVendor),
    row(SpvCapabilityShaderSMBuiltinsNV, "ShaderSMBuiltinsNV",
        "gl_WarpsPerSMNV gl_SMCountNV gl_WarpIDNV gl_SMIDNV", kVendor),
    row(4165, "CoreBuiltinsARM", "gl_CoreIDARM gl_CoreCountARM gl_CoreMaxIDARM gl_WarpIDARM gl_WarpMaxIDARM",
        kVendor),

    row(SpvCapabilityAtomicStorage, "AtomicStorage", "atomic_uint", kDesktop),
    row(SpvCapabilityAtomicStorageOps, "AtomicStorageOps", "atomicCounter*", kDesktop),
    row(SpvCapabilityImageRect, "ImageRect", "image2DRect", kDesktop),
    row(SpvCapabilitySampledRect, "SampledRect", "sampler2DRect*", kDesktop),
};

}  // namespace

std::span<const CapabilityRow> capability_table() {
    return kTable;
}

const CapabilityRow* find_capability(uint32_t capability) {
    const auto* found = std::ranges::find(kTable, capability, &CapabilityRow::capability);
    return found == kTable.end() ? nullptr : found;
}

}  // namespace weft::shader

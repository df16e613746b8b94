// Purpose: returns the name of an enumeration value of a plan, such as "transient", for JSON dumps and other
// texts. Returns "?" for an unknown value.
#pragma once

#include "weft/plan.h"

namespace weft {

[[nodiscard]] const char* enum_name(ResourceKind value);
[[nodiscard]] const char* enum_name(ResourceLifetime value);
[[nodiscard]] const char* enum_name(ImageKind value);
[[nodiscard]] const char* enum_name(PassKind value);
[[nodiscard]] const char* enum_name(QueueKind value);
[[nodiscard]] const char* enum_name(EdgeKind value);
[[nodiscard]] const char* enum_name(CullReason value);
[[nodiscard]] const char* enum_name(LoadOp value);
[[nodiscard]] const char* enum_name(StoreOp value);
[[nodiscard]] const char* enum_name(BarrierReason value);
[[nodiscard]] const char* enum_name(OnResize value);
[[nodiscard]] const char* enum_name(ViewSource value);
[[nodiscard]] const char* enum_name(ViewLowering value);
[[nodiscard]] const char* enum_name(EachPart value);
[[nodiscard]] const char* enum_name(SamplerFilter value);
[[nodiscard]] const char* enum_name(SamplerReduction value);
[[nodiscard]] const char* enum_name(SamplerWrap value);
[[nodiscard]] const char* enum_name(CompareOp value);
[[nodiscard]] const char* enum_name(CullMode value);
[[nodiscard]] const char* enum_name(FrontFace value);
[[nodiscard]] const char* enum_name(Topology value);
[[nodiscard]] const char* enum_name(FillMode value);
[[nodiscard]] const char* enum_name(BlendFactor value);
[[nodiscard]] const char* enum_name(BlendOp value);
[[nodiscard]] const char* enum_name(StencilOp value);
[[nodiscard]] const char* enum_name(Builtin value);
[[nodiscard]] const char* enum_name(ParamCost value);
[[nodiscard]] const char* enum_name(ScalarType value);
[[nodiscard]] const char* enum_name(ExprOp value);

}  // namespace weft

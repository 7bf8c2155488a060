// SPDX-License-Identifier: MIT
#include "techniques/amortized/amortized_passes.h"

#include "techniques/amortized/amortized_shared.h"
#include "techniques/amortized/buffer_layout.h"

namespace reprise::amortized {
namespace {

constexpr uint32_t kResolveShader[] = {
#include "amortized_resolve.comp.inc"
};
constexpr uint32_t kResidualShader[] = {
#include "amortized_residual.comp.inc"
};
constexpr uint32_t kCoverageShader[] = {
#include "amortized_coverage.comp.inc"
};
constexpr uint32_t kGatherShader[] = {
#include "amortized_gather.comp.inc"
};
constexpr uint32_t kBlendShader[] = {
#include "amortized_blend.comp.inc"
};
constexpr uint32_t kRequestThresholdShader[] = {
#include "amortized_request_threshold.comp.inc"
};
constexpr uint32_t kRequestListShader[] = {
#include "amortized_request_list.comp.inc"
};

// reproject.glsl: depth, motion, four images of past motion, four subpixel buffers.
std::vector<Binding> afterReprojection(std::initializer_list<Binding> own) {
  std::vector<Binding> bindings = {
      Binding::kTexel, Binding::kTexel, Binding::kLinear, Binding::kLinear, Binding::kTexel,
      Binding::kTexel, Binding::kTexel, Binding::kTexel,  Binding::kTexel,  Binding::kTexel};
  for (const Binding binding : own) bindings.push_back(binding);
  return bindings;
}

std::vector<uint32_t> specializationOf(const Variant& variant) {
  return {variant.slots, variant.exact_motion ? 1u : 0u, variant.silhouettes ? 1u : 0u,
          variant.residuals ? 1u : 0u, variant.shutter ? 1u : 0u};
}

}  // namespace

RequestPasses declareRequestPasses(Declaration& declaration, const Variant& variant) {
  declaration.makeRequests(kRequestBins);
  RequestPasses passes;
  passes.gather = declaration.pass(
      {.name = "gather",
       .spirv = kGatherShader,
       .bindings = afterReprojection({Binding::kBuffer, Binding::kStorage, Binding::kConstants,
                                      Binding::kTexel, Binding::kTexel, Binding::kTexel,
                                      Binding::kTexel, Binding::kStorage, Binding::kStorage,
                                      Binding::kStorage, Binding::kStorage, Binding::kStorage,
                                      Binding::kStorage, Binding::kStorage}),
       .constant_bytes = sizeof(AmortizedConstants),
       .specialization = specializationOf(variant)});
  passes.threshold = declaration.pass({.name = "request threshold",
                                       .spirv = kRequestThresholdShader,
                                       .bindings = {Binding::kBuffer, Binding::kConstants},
                                       .constant_bytes = sizeof(RequestConstants),
                                       .specialization = {}});
  passes.list =
      declaration.pass({.name = "request list",
                        .spirv = kRequestListShader,
                        .bindings = {Binding::kTexel, Binding::kBuffer, Binding::kConstants},
                        .constant_bytes = sizeof(RequestConstants),
                        .specialization = {REPRISE_REQUEST_GROUP_SIZE}});
  passes.blend = declaration.pass(
      {.name = "blend",
       .spirv = kBlendShader,
       .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                    Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                    Binding::kTexel, Binding::kStorage, Binding::kStorage, Binding::kStorage,
                    Binding::kStorage, Binding::kConstants},
       .constant_bytes = sizeof(AmortizedConstants),
       .specialization = specializationOf(variant)});
  return passes;
}

PassHandle declareResolvePass(Declaration& declaration, const Variant& variant) {
  return declaration.pass(
      {.name = "resolve",
       .spirv = kResolveShader,
       .bindings = afterReprojection(
           {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
            Binding::kTexel, Binding::kStorage, Binding::kStorage, Binding::kStorage,
            Binding::kStorage, Binding::kStorage, Binding::kStorage, Binding::kConstants}),
       .constant_bytes = sizeof(AmortizedConstants),
       .specialization = specializationOf(variant)});
}

PassHandle declareCoveragePass(Declaration& declaration) {
  return declaration.pass({.name = "coverage",
                           .spirv = kCoverageShader,
                           .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel,
                                        Binding::kStorage, Binding::kConstants},
                           .constant_bytes = sizeof(CoverageConstants),
                           .specialization = {}});
}

ResidualPasses declareResidualPasses(Declaration& declaration) {
  const auto pass = [&](const char* name, uint32_t columns) {
    return declaration.pass({.name = name,
                             .spirv = kResidualShader,
                             .bindings = {Binding::kTexel, Binding::kStorage, Binding::kConstants},
                             .constant_bytes = sizeof(ResidualConstants),
                             .specialization = {columns}});
  };
  ResidualPasses passes;
  passes.rows = pass("residual rows", 0);
  passes.columns = pass("residual columns", 1);
  return passes;
}

}  // namespace reprise::amortized

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
constexpr uint32_t kRequestFindShader[] = {
#include "amortized_request_find.comp.inc"
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
      Binding::kTexel, Binding::kTexel,  Binding::kLinear, Binding::kLinear, Binding::kTexel,
      Binding::kTexel, Binding::kLinear, Binding::kLinear, Binding::kLinear, Binding::kLinear};
  for (const Binding binding : own) bindings.push_back(binding);
  return bindings;
}

std::vector<uint32_t> reprojectionSpecialization(const Variant& variant) {
  return {variant.slots, variant.exact_motion ? 1u : 0u, variant.silhouettes ? 1u : 0u};
}

}  // namespace

RequestPasses declareRequestPasses(Declaration& declaration, const Variant& variant) {
  declaration.makeRequests(kRequestBins);
  RequestPasses passes;
  passes.find = declaration.pass(
      {.name = "request",
       .spirv = kRequestFindShader,
       .bindings = afterReprojection({Binding::kBuffer, Binding::kStorage, Binding::kConstants,
                                      Binding::kLinear, Binding::kLinear}),
       .constant_bytes = sizeof(AmortizedConstants),
       .specialization = reprojectionSpecialization(variant)});
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
  return passes;
}

PassHandle declareResolvePass(Declaration& declaration, const Variant& variant) {
  std::vector<uint32_t> specialization = reprojectionSpecialization(variant);
  specialization.push_back(variant.residuals ? 1 : 0);
  return declaration.pass(
      {.name = "resolve",
       .spirv = kResolveShader,
       .bindings = afterReprojection(
           {Binding::kTexel, Binding::kTexel, Binding::kLinear, Binding::kTexel, Binding::kLinear,
            Binding::kStorage, Binding::kStorage, Binding::kStorage, Binding::kStorage,
            Binding::kStorage, Binding::kStorage, Binding::kConstants, Binding::kLinear}),
       .constant_bytes = sizeof(AmortizedConstants),
       .specialization = std::move(specialization)});
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

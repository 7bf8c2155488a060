// SPDX-License-Identifier: MIT
//
// Reprise: temporal antialiasing and supersampling for Vulkan renderers. C API.
//
// The order of calls
//   1. repriseGetRequirements   before the device is created: what the device must have enabled
//   2. repriseCreateContext     one context a view
//   3. reprisePrepare           builds pipelines and history images; may take milliseconds
//   then every frame:
//   4. repriseGetSamplePlan     how to sample this frame (jitter, mip bias, shading offset)
//   5. repriseRecordRequest     optional: asks for extra shading evaluations (techniques that can)
//   6. repriseRecord            records the resolve into the host's command buffer
//
// Conventions, each as an equation (x to the right, y down, pixel centres at + 0.5)
//   sampling   pixel (x, y) sampled the scene at screen position
//              sample_px = (x + 0.5 - jitter_px.x, y + 0.5 - jitter_px.y),
//              so image content moves by +jitter_px. For a projection matrix whose clip space has
//              y down (Vulkan) that is clip.xy += 2 * jitter_px / extent_px * clip.w;
//              for y up (OpenGL, Direct3D) the y term changes sign.
//   motion     prev_px = px + motion * motion_scale, in pixels of the input, both positions free
//              of jitter. With REPRISE_CONTEXT_MOTION_INCLUDES_JITTER the image holds
//              motion + (previous jitter - jitter), which the library subtracts.
//   depth      one number a pixel; view_depth, the distance along the view axis, is
//              depth                                   with REPRISE_DEPTH_PLANAR
//              near * far / (far - depth * (far - near))           REPRISE_DEPTH_DEVICE
//              near * far / (near + depth * (far - near))          REPRISE_DEPTH_DEVICE_REVERSED
//              near / depth                                        ..._REVERSED_INFINITE
//              near / (1 - depth)                                  ..._DEVICE_INFINITE
//              near + depth * (far - near)                         REPRISE_DEPTH_ORTHOGRAPHIC
//              Units are the host's own; they cancel.
//   colour     linear light, RGB, any scale. scene = color / pre_exposure. The output has the
//              exposure of the input of the same frame. Alpha is not read; the output's alpha is 1.
//              NaN, infinite and negative texels are read as 0.
//
// Images and synchronization
//   The host owns the instance, device, queues and command buffers. The library records compute
//   work and barriers for its own images; it never submits and never waits. When repriseRecord's
//   commands execute:
//     inputs  must be readable: writes made available and visible to
//             VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT / VK_ACCESS_SHADER_READ_BIT, in the layout that
//             RepriseImage::layout names (SHADER_READ_ONLY_OPTIMAL, DEPTH_STENCIL_READ_ONLY_OPTIMAL
//             or GENERAL); they are left in it.
//     output  must be in VK_IMAGE_LAYOUT_GENERAL, earlier accesses finished, and is left in it; its
//             last access is COMPUTE_SHADER / SHADER_WRITE. The host places the barrier that its
//             own next access needs.
//   History images belong to the context. Queue-family ownership stays with the host: record a
//   context on one queue family only.
//
// Errors: every call that can fail returns a RepriseResult and, if the context (or its creation
// structure) has a message callback, says in one line what is wrong. A call that fails changes
// nothing.
//
// Threads: one thread at a time a context; contexts are independent.
#ifndef REPRISE_REPRISE_H
#define REPRISE_REPRISE_H

#include <stddef.h>
#include <stdint.h>
#include <vulkan/vulkan_core.h>

#ifdef __cplusplus
extern "C" {
#endif

#define REPRISE_VERSION_MAJOR 0
#define REPRISE_VERSION_MINOR 1
#define REPRISE_VERSION_PATCH 0

typedef struct RepriseContext_T* RepriseContext;

typedef enum RepriseResult {
  REPRISE_SUCCESS = 0,
  REPRISE_ERROR_INVALID_ARGUMENT = -1,  // null, out of range, wrong size field, unknown name
  REPRISE_ERROR_UNSUPPORTED = -2,       // the technique or the device cannot do what is asked
  REPRISE_ERROR_NOT_PREPARED = -3,      // reprisePrepare has not been called since the last change
  REPRISE_ERROR_OUT_OF_MEMORY = -4,     // host or device
  REPRISE_ERROR_DEVICE = -5             // any other Vulkan failure; the message holds the VkResult
} RepriseResult;

typedef enum RepriseMessageSeverity {
  REPRISE_MESSAGE_INFO = 0,
  REPRISE_MESSAGE_WARNING = 1,
  REPRISE_MESSAGE_ERROR = 2
} RepriseMessageSeverity;

// `text` is one line, UTF-8, valid during the call only. Called on the thread of the failing call.
typedef void (*RepriseMessageCallback)(RepriseMessageSeverity severity, const char* text,
                                       void* user);

// -------------------------------------------------------------------------------------------------
// Techniques and their settings. The command line's flags and the documentation's tables are made
// from these tables.

typedef enum RepriseSettingType {
  REPRISE_SETTING_FLOAT = 0,
  REPRISE_SETTING_INTEGER = 1,
  REPRISE_SETTING_BOOLEAN = 2,  // 0 or 1
  REPRISE_SETTING_CHOICE = 3    // index into `choices`
} RepriseSettingType;

typedef struct RepriseSettingInfo {
  const char* name;
  RepriseSettingType type;
  double minimum;
  double maximum;
  double default_value;
  const char* const* choices;  // REPRISE_SETTING_CHOICE: NULL-terminated; otherwise NULL
  const char* unit;            // "" where it has none
  const char* effect;          // what raising it (or each choice) does
  const char* source;          // where the setting and its default come from
  uint32_t needs_prepare;      // 1: takes effect at the next reprisePrepare; 0: at the next record
} RepriseSettingInfo;

typedef struct RepriseSettingValue {
  const char* name;
  double value;      // used when text is NULL
  const char* text;  // a choice's name, "true"/"false", or a number; NULL: use value
} RepriseSettingValue;

// A named set of values for some settings; the rest keep their defaults.
typedef struct ReprisePresetInfo {
  const char* name;
  const RepriseSettingValue* values;
  uint32_t value_count;
  const char* purpose;
} ReprisePresetInfo;

typedef enum RepriseTechniqueFlags {
  REPRISE_TECHNIQUE_UPSAMPLES = 1 << 0,      // output extent may exceed input extent
  REPRISE_TECHNIQUE_USES_HISTORY = 1 << 1,   // keeps state from frame to frame
  REPRISE_TECHNIQUE_USES_REACTIVE = 1 << 2,  // reads RepriseFrame::reactive
  REPRISE_TECHNIQUE_USES_ID = 1 << 3,        // reads RepriseFrame::id
  REPRISE_TECHNIQUE_REQUESTS = 1 << 4        // repriseRecordRequest writes sample requests
} RepriseTechniqueFlags;

typedef struct RepriseTechniqueInfo {
  const char* name;     // as in RepriseContextInfo::technique
  const char* summary;  // one line
  const char* source;   // publication or origin
  uint32_t flags;       // RepriseTechniqueFlags
  const RepriseSettingInfo* settings;
  uint32_t setting_count;
  const ReprisePresetInfo* presets;
  uint32_t preset_count;
} RepriseTechniqueInfo;

uint32_t repriseGetTechniqueCount(void);
// NULL when index >= repriseGetTechniqueCount().
const RepriseTechniqueInfo* repriseGetTechnique(uint32_t index);
// NULL when no technique has that name.
const RepriseTechniqueInfo* repriseFindTechnique(const char* name);
// "0.1.0"; static storage.
const char* repriseGetVersion(void);
// "invalid argument" and so on; static storage; never NULL.
const char* repriseResultText(RepriseResult result);

// -------------------------------------------------------------------------------------------------
// Requirements

typedef struct RepriseRequirements {
  size_t size;                      // = sizeof(RepriseRequirements), set by the caller
  uint32_t vulkan_version;          // lowest apiVersion of the device
  uint32_t device_extension_count;  // 0 today
  const char* const* device_extensions;
  VkPhysicalDeviceFeatures features;  // those that the host must enable are VK_TRUE
} RepriseRequirements;

// What a device must have enabled for `technique`. With a physical device given, also checks that
// it offers all of it: REPRISE_ERROR_UNSUPPORTED otherwise. VK_NULL_HANDLE and NULL: no check.
RepriseResult repriseGetRequirements(const char* technique, VkInstance instance,
                                     VkPhysicalDevice physical_device,
                                     PFN_vkGetInstanceProcAddr get_instance_proc_addr,
                                     RepriseRequirements* requirements);

// -------------------------------------------------------------------------------------------------
// Context

typedef enum RepriseDepthKind {
  REPRISE_DEPTH_DEVICE = 0,             // [0, 1], 0 at the near plane
  REPRISE_DEPTH_DEVICE_REVERSED = 1,    // [0, 1], 1 at the near plane
  REPRISE_DEPTH_DEVICE_INFINITE = 2,    // [0, 1), far plane at infinity
  REPRISE_DEPTH_REVERSED_INFINITE = 3,  // (0, 1], far plane at infinity (0)
  REPRISE_DEPTH_PLANAR = 4,             // view depth itself
  REPRISE_DEPTH_ORTHOGRAPHIC = 5        // [0, 1], linear between near and far
} RepriseDepthKind;

typedef enum RepriseContextFlags {
  REPRISE_CONTEXT_MOTION_INCLUDES_JITTER = 1 << 0
} RepriseContextFlags;

typedef struct RepriseContextInfo {
  size_t size;  // = sizeof(RepriseContextInfo)
  VkInstance instance;
  VkPhysicalDevice physical_device;
  VkDevice device;
  PFN_vkGetInstanceProcAddr get_instance_proc_addr;
  VkPipelineCache pipeline_cache;       // optional
  const char* technique;                // a name from repriseGetTechnique
  const char* preset;                   // optional: a preset's name
  const RepriseSettingValue* settings;  // optional: override defaults and preset
  uint32_t setting_count;
  VkExtent2D max_input_extent;   // [1, device's maxImageDimension2D] px
  VkExtent2D max_output_extent;  // likewise; {0, 0}: as max_input_extent
  uint32_t frames_in_flight;     // [1, 8]: how many recorded frames may be unfinished at a time
  RepriseDepthKind depth_kind;
  uint32_t flags;                           // RepriseContextFlags
  RepriseMessageCallback message_callback;  // optional
  void* message_user;
} RepriseContextInfo;

RepriseResult repriseCreateContext(const RepriseContextInfo* info, RepriseContext* context);
// The device must have finished all work recorded with the context. NULL is ignored.
void repriseDestroyContext(RepriseContext context);

// Changes settings. Those with needs_prepare take effect at the next reprisePrepare, which must
// then come before the next record. History is kept where its images stay the same.
RepriseResult repriseSetSettings(RepriseContext context, const RepriseSettingValue* values,
                                 uint32_t count);
// The value now set (a choice: its index).
RepriseResult repriseGetSetting(RepriseContext context, const char* name, double* value);

// Holds a frame time: called once a frame, before repriseGetSamplePlan, with the time that the last
// frame took (its GPU time, not the interval between presents, which a display rounds up). Where
// the median of some frames is above the target, the technique's settings step down to a cheaper
// rung; where there is room for long enough, they step up again. `amortized`: `effort` and
// `budget`. No prepare is needed, history is kept, and the settings chosen are a function of the
// times alone; repriseGetSetting tells them. Times in (0, 10) s.
// REPRISE_ERROR_UNSUPPORTED: the technique has nothing to trade.
RepriseResult repriseHoldFrameTime(RepriseContext context, double measured_s, double target_s);

// Other maximum extents: history is dropped and reprisePrepare must follow. The device must have
// finished all work recorded with the context.
RepriseResult repriseResize(RepriseContext context, VkExtent2D max_input_extent,
                            VkExtent2D max_output_extent);

// Creates what is missing: history images, pipelines. Never called by the library itself. The
// device must have finished all work recorded with the context if settings with needs_prepare were
// changed.
RepriseResult reprisePrepare(RepriseContext context);

// Forgets history: the next record gives the current frame alone, as RepriseFrame::reset does.
RepriseResult repriseReset(RepriseContext context);

// -------------------------------------------------------------------------------------------------
// Plan

typedef enum RepriseShadingOffset {
  REPRISE_SHADING_OFFSET_NONE = 0,
  // Each pixel shades at its quadrant's centre plus a Gaussian: equation shadingOffset in
  // equations/shading_offset.h, which a host's shader may include.
  REPRISE_SHADING_OFFSET_HASH_GAUSSIAN = 1
} RepriseShadingOffset;

typedef struct RepriseSamplePlan {
  size_t size;         // = sizeof(RepriseSamplePlan), set by the caller
  float jitter_px[2];  // [-1, 1] input pixels, whole frame; see 'sampling' above
  float mip_bias;      // (levels) to add to the bias of every material texture fetch
  uint32_t period;     // frames after which the jitter repeats; 0: never
  RepriseShadingOffset shading_offset;
  float shading_offset_sigma_px;
  uint32_t shading_offset_seed;
  uint32_t shading_offset_quadrant;  // [0, 3]; 4: the pixel centre
  uint32_t coarse_size;  // pixels a side that share one shading evaluation; 1: each its own
  // Coarse pixels begin here, and coarse_size farther, and before: a shift of the grid's whole
  // pixels. Each shades at its centre - jitter_px, for every surface in it (but see
  // coarse_covered), and alpha tests stay at the pixels' rate. A bias for derivatives across coarse
  // pixels is part of mip_bias.
  int32_t coarse_origin_px[2];  // [0, coarse_size)
  // Bit a - 1: the technique would read RepriseFrame::motion_back[a - 1].
  uint32_t motion_back;
  // 4: the technique would read RepriseFrame::depth_samples; 0: it would not.
  uint32_t depth_samples;
  // 1: only pixels whose x + y is even are shaded; 2: those where it is odd; 0: all.
  uint32_t checkerboard;
  // 1: a surface that covers a part of a coarse pixel is best shaded amid the pixels that it covers
  // (interpolation at the centroid), not at a centre that lies beside it; 0: at the centre.
  uint32_t coarse_covered;
} RepriseSamplePlan;

// The plan of frame `frame_index`: a pure function of the index, the settings and the extents; with
// `phlm:jitter=still` also of whether the cameras of the last two recorded frames differ.
RepriseResult repriseGetSamplePlan(RepriseContext context, uint64_t frame_index,
                                   RepriseSamplePlan* plan);

// The same for a frame of other extents than the maximum ({0, 0}: as in RepriseFrame): the length
// of the jitter and the mip bias follow the ratio of output to input.
RepriseResult repriseGetSamplePlanAt(RepriseContext context, uint64_t frame_index,
                                     VkExtent2D input_extent, VkExtent2D output_extent,
                                     RepriseSamplePlan* plan);

// -------------------------------------------------------------------------------------------------
// Record

typedef struct RepriseImage {
  VkImageView view;      // 2D, one mip level, one layer; aspect colour or depth
  VkExtent2D extent;     // of the image, at least the frame's extent, px
  VkImageLayout layout;  // ignored for the output (always GENERAL)
} RepriseImage;

typedef struct RepriseCamera {
  // Column-major (as GLSL and GLM store them), no jitter. view: world to camera, right-handed, -z
  // forward. projection: to Vulkan clip space, y down.
  float view[16];
  float projection[16];
} RepriseCamera;

// How far back a frame's motion can be given (frames).
#define REPRISE_MAX_MOTION_BACK 8
// Largest side of a coarse pixel (px).
#define REPRISE_MAX_COARSE_SIZE 4

typedef struct RepriseFrame {
  size_t size;            // = sizeof(RepriseFrame)
  uint64_t frame_index;   // the one whose plan the frame was rendered with
  RepriseImage color;     // any sampled float or unorm format
  RepriseImage depth;     // any sampled one-channel float or unorm format, or a depth aspect
  RepriseImage motion;    // any sampled two-channel float format
  RepriseImage reactive;  // optional (view VK_NULL_HANDLE): .r in [0, 1]; 1: take the current frame
  RepriseImage id;      // optional: unsigned integer format, .r; history of another id is rejected
  RepriseImage output;  // storage image, any float or unorm format with STORAGE_IMAGE support
  VkExtent2D input_extent;  // the sub-rectangle at (0, 0) that holds this frame; {0,0}: the maximum
  // Likewise; {0, 0}: the maximum, or input_extent where the maxima of input and output are equal.
  VkExtent2D output_extent;
  float jitter_px[2];           // [-1, 1] the jitter the frame was rendered with
  float motion_scale[2];        // motion in px = texel * motion_scale; {1, 1} for pixels,
                                // {w, h} for uv, {w/2, h/2} for Vulkan NDC; not 0
  float near_plane;             // (0, inf), not used for REPRISE_DEPTH_PLANAR
  float far_plane;              // (near, inf], not used for infinite and planar kinds
  const RepriseCamera* camera;  // optional; makes the depth test exact under camera motion
  float pre_exposure;           // (0, inf)
  float frame_time_s;           // [0, inf) seconds since the last frame
  uint32_t reset;               // 1: forget history before this frame (a cut, the first frame)
  // Optional: the sum of the evaluations that requests asked for (rgb) and their number (a), in the
  // exposure of `color`; 0 where none was served. Any sampled float format.
  RepriseImage extra;
  // Optional: depth of the same projection as `depth`, multisampled: 4 samples at Vulkan's standard
  // positions (VkPhysicalDeviceLimits::standardSampleLocations). Coverage of silhouettes.
  RepriseImage depth_samples;
  // Optional: motion_back[a - 1] is the motion to the frame a frames back, scaled by motion_scale,
  // free of jitter whatever the context's flags say; entries without a view are not given. An image
  // of four channels holds in its third and fourth the view depths that the pixel's surface has now
  // and had then (0: not known): they part what moves by itself from what it moves close to.
  const RepriseImage* motion_back;
  uint32_t motion_back_count;  // [0, REPRISE_MAX_MOTION_BACK]
  VkQueryPool timestamps;      // optional: 2 * repriseGetPassCount queries are written,
  uint32_t first_timestamp;    // two a pass, from this index on; the host resets them
  // How the frame was shaded, as RepriseSamplePlan has it; all 0: every pixel by itself. A host
  // that shades coarsely as it likes tells it here.
  uint32_t coarse_size;  // [0, REPRISE_MAX_COARSE_SIZE]
  int32_t coarse_origin_px[2];
  uint32_t checkerboard;
} RepriseFrame;

// Sample requests: which pixels deserve more shading than one evaluation, known once this frame's
// depth and motion are. `buffer`, std430:
//   uint32_t groups_x, groups_y, groups_z;  // VkDispatchIndirectCommand: one invocation an entry,
//                                           // REPRISE_REQUEST_GROUP_SIZE x 1 x 1 a group
//   uint32_t count;                         // entries
//   uint32_t entries[];                     // x | y << 14 | mask << 28; one a pixel at most, in no
//                                           // order. Bit q of mask: evaluate at the pixel's centre
//                                           // + quadrantOffset(q) (equations/shading_offset.h)
// A host that serves them sums a pixel's evaluations into RepriseFrame::extra.
#define REPRISE_REQUEST_GROUP_SIZE 64

typedef struct RepriseSampleRequests {
  size_t size;      // = sizeof(RepriseSampleRequests), set by the caller
  VkBuffer buffer;  // the context's own; INDIRECT_BUFFER and STORAGE_BUFFER usage
  uint64_t bytes;
} RepriseSampleRequests;

// Valid after reprisePrepare until the next; REPRISE_ERROR_UNSUPPORTED where the technique, as it
// is set, requests nothing.
RepriseResult repriseGetSampleRequests(RepriseContext context, RepriseSampleRequests* requests);

// Optional, before repriseRecord of the same frame: fills the request buffer from depth, motion
// and history (`color` and `output` are not looked at). Afterwards the buffer is readable by
// indirect dispatch and by compute shaders. A host that skips it gets one evaluation a pixel.
RepriseResult repriseRecordRequest(RepriseContext context, VkCommandBuffer commands,
                                   const RepriseFrame* frame);
RepriseResult repriseRecord(RepriseContext context, VkCommandBuffer commands,
                            const RepriseFrame* frame);

// Passes in the order in which they are recorded; names are static. Valid after reprisePrepare.
// Passes whose names begin with "request" are repriseRecordRequest's: their queries are written by
// that call alone.
uint32_t repriseGetPassCount(RepriseContext context);
const char* repriseGetPassName(RepriseContext context, uint32_t index);

// -------------------------------------------------------------------------------------------------
// Memory

typedef struct RepriseMemoryItem {
  const char* name;   // "history color" ...; static storage
  VkFormat format;    // VK_FORMAT_UNDEFINED: a buffer
  VkExtent2D extent;  // px; {0, 0} for a buffer
  uint32_t copies;    // 2 for ping-pong
  uint64_t bytes;     // of all copies, as allocated
} RepriseMemoryItem;

// Writes up to `capacity` items and sets *count to how many there are. items may be NULL to ask
// only. Valid after reprisePrepare.
RepriseResult repriseGetMemory(RepriseContext context, RepriseMemoryItem* items, uint32_t capacity,
                               uint32_t* count);

#ifdef __cplusplus
}
#endif

#endif

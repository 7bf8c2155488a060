// SPDX-License-Identifier: MIT
//
// Any glTF 2.0 file as a scene: "gltf:PATH/camera". Its cameras are `path`, fitted to what the file
// holds, `still`, `view` anywhere by numbers, and `camera:NAME` for each of the file's own.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lab/scene/scene.h"

namespace reprise::lab {

// Whether `text` begins with "gltf:".
bool namesGltf(const std::string& text);

// "gltf:PATH/camera" in two; the camera's part may be empty. Throws std::invalid_argument where
// there is no ".gltf" or ".glb" in it.
struct GltfName {
  std::string path;
  std::string camera;
};
GltfName splitGltfName(const std::string& text);

// Reads the file: its name is "gltf:PATH". Throws SceneFileError.
std::shared_ptr<const SceneInfo> gltfSceneInfo(const std::string& path);

// What every such scene has, for lists: "gltf:PATH".
SceneInfo gltfPattern();

}  // namespace reprise::lab

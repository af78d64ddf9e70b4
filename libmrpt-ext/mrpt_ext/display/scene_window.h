#pragma once

#include "mrpt_ext/observations/mrpt_scene.h"

namespace mrpt_ext
{
/// A window that shows a 3-D scene and can be turned and zoomed with the mouse.
///
/// It lives in a shared library of its own, loaded only when a window is asked for: MRPT's windows bring some three
/// hundred libraries, which add half a second to the start.
class SceneWindow
{
 public:
  virtual ~SceneWindow() = default;
  /// Shows `scene` in place of the one before; the window keeps the viewpoint that the user chose.
  virtual void show(const MrptScene::Ptr& scene) = 0;
  /// False once the user has closed it.
  [[nodiscard]] virtual bool isOpen() const = 0;
};

/// Initial view: a point on the ground and the visible width [m] around it.
struct SceneView
{
  float x = 0, y = 0, width = 10;
};

/// The function of the library that opens a window, and its name there. Null when there is no display.
using OpenSceneWindow = SceneWindow* (*)(const char* title, const SceneView& view);
constexpr const char* kOpenSceneWindow = "mrpt_ext_open_scene_window";
}  // namespace mrpt_ext

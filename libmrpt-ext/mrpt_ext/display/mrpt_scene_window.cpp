#include <mrpt/gui/CDisplayWindow3D.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "mrpt_ext/display/scene_window.h"

// Last: it has macros with common names.
#include <X11/Xlib.h>

namespace mrpt_ext
{
namespace
{
/// Ends the program without MRPT's window thread: in one of ten runs it crashes when the window or the program's static
/// objects are destroyed (MRPT 2.5.8, C3DWindowDialog's destructor).
void leaveAtOnce(int status, void*)
{
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  std::_Exit(status);
}

/// Its window is never destroyed, for the same reason: it goes with the program.
class MrptSceneWindow : public SceneWindow
{
 public:
  MrptSceneWindow(const char* title, const SceneView& view)
      : window_(*new mrpt::gui::CDisplayWindow3D(title, 1000, 800))
  {
    window_.setCameraPointingToPoint(view.x, view.y, 0);
    window_.setCameraZoom(1.5F * view.width);
    window_.setCameraElevationDeg(60);
    window_.setCameraAzimuthDeg(-90);
  }

  void show(const MrptScene::Ptr& scene) override
  {
    window_.get3DSceneAndLock() = scene;
    window_.unlockAccess3DScene();
    window_.forceRepaint();
  }

  [[nodiscard]] bool isOpen() const override { return window_.isOpen(); }

 private:
  mrpt::gui::CDisplayWindow3D& window_;
};

/// Asked first, because MRPT waits for seconds and prints errors when there is no display.
bool hasDisplay()
{
  Display* display = XOpenDisplay(nullptr);
  if (!display) return false;
  XCloseDisplay(display);
  return true;
}
}  // namespace
}  // namespace mrpt_ext

extern "C" mrpt_ext::SceneWindow* mrpt_ext_open_scene_window(const char* title, const mrpt_ext::SceneView& view)
{
  if (!mrpt_ext::hasDisplay()) return nullptr;
  auto* window = new mrpt_ext::MrptSceneWindow(title, view);
  on_exit(mrpt_ext::leaveAtOnce, nullptr);
  return window;
}

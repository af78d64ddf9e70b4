#include "mrpt_ext/scene/live_view.h"

#include <dlfcn.h>

#include <ostream>

#include "mrpt_ext/display/scene_window.h"
#include "mrpt_ext/scene/run_scene.h"

namespace mrpt_ext
{
namespace
{
constexpr std::chrono::milliseconds kPoll(50);  // between two checks whether the window is open

SceneView viewOf(const LandmarkTable& map)
{
  const auto [low, high] = map.boundingBox();
  const Vector2d middle = (low + high) / 2;
  return {static_cast<float>(middle.x()), static_cast<float>(middle.y()),
          static_cast<float>((high - low).maxCoeff() + 2)};
}

std::unique_ptr<SceneWindow> openWindow(const LandmarkTable& map, std::ostream& err)
{
  // Never unloaded: MRPT's window thread may outlive the window.
  void* library = dlopen(MRPT_EXT_DISPLAY_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  void* function = library ? dlsym(library, kOpenSceneWindow) : nullptr;
  if (!function)
  {
    err << "--gui: no window, this build has none (" << dlerror() << "); the run goes on without it\n";
    return nullptr;
  }
  const auto open = reinterpret_cast<OpenSceneWindow>(function);
  std::unique_ptr<SceneWindow> window(open("landmark-localization", viewOf(map)));
  if (!window) err << "--gui: no window, there is no display (DISPLAY); the run goes on without it\n";
  return window;
}
}  // namespace

LiveView::LiveView(const LandmarkTable& map, double speed, std::ostream& err)
    : map_(map), speed_(speed), window_(openWindow(map, err))
{
  if (window_) drawing_ = std::thread([this] { drawUntilDone(); });
}

LiveView::~LiveView()
{
  if (!drawing_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_all();
  drawing_.join();
}

bool LiveView::isOpen() const { return window_ && window_->isOpen(); }

void LiveView::show(PlaybackStep step)
{
  if (!isOpen()) return;
  if (!start_) start_ = {step.time, Clock::now()};
  const auto due = start_->second + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>((step.time - start_->first) / speed_));
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(step);
  }
  changed_.notify_all();
  while (isOpen() && Clock::now() < due)
    std::this_thread::sleep_for(std::min<Clock::duration>(kPoll, due - Clock::now()));
}

void LiveView::waitUntilClosed() const
{
  while (isOpen()) std::this_thread::sleep_for(kPoll);
}

void LiveView::drawUntilDone()
{
  std::unique_lock lock(mutex_);
  while (true)
  {
    changed_.wait(lock, [this] { return done_ || next_; });
    if (!next_) return;
    const PlaybackStep step = std::move(*next_);
    next_.reset();
    lock.unlock();
    if (window_->isOpen()) window_->show(runScene(map_, step));
    lock.lock();
  }
}
}  // namespace mrpt_ext

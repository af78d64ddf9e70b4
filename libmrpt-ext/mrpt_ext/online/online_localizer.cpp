#include "mrpt_ext/online/online_localizer.h"

#include <algorithm>

#include "mrpt_ext/configuration/configured_files.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/geometry/arc_motion.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/physical_limits.h"
#include "mrpt_ext/online/online_snapshot.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLongestFix = 60;  // [s] between the two ranges of a running fix, to notice ranges logged twice

/// By odometry, with its noise.
GaussianPose moved(const GaussianPose& pose, const OdometryPath& odometry, double from, double to,
                   const MotionModel& model)
{
  const OdometryMotion motion = odometry.between(from, to);
  return compound(pose, nominalMotion(model, motion).increment, incrementCovariance(model, motion));
}
}  // namespace

OnlineOptions onlineOptions(const LocalizationConfig& config)
{
  return {.filter = config.filter,
          .frames = config.frames,
          .seed_window = config.seed_window,
          .seed = config.seed,
          .lateness = config.lateness,
          .odometry_wait = config.odometry_wait,
          .step_budget_ms = config.step_budget_ms};
}

OnlineLocalizer OnlineLocalizer::fromIni(const std::filesystem::path& ini, const std::filesystem::path& map)
{
  const Settings settings = Settings::load(ini, localizationKeys());
  const LandmarkTable landmarks =
      map.empty() ? configuredMap(settings) : correctedMap(settings, readLandmarkMapFile(map));
  return {onlineOptions(localizationConfig(settings, landmarks)), landmarks};
}

OnlineLocalizer::OnlineLocalizer(const OnlineOptions& options, const LandmarkTable& map)
    : options_(options),
      map_(map),
      overview_{.odometry = OdometryPath(options.frames.odometry), .fix_span = kLongestFix},
      frames_(map_, options_.frames, overview_, options.lateness),
      search_(std::make_shared<const GlobalPoseSearch>(map_)),
      steps_([this](const Frame& frame) { return process(frame); }, options.step_budget_ms),
      recent_(options.frames.odometry)
{
  restart({}, 0);
}

void OnlineLocalizer::addOdometry(double t, const Pose2& pose) { add(OdometryRecord{t, pose}); }

void OnlineLocalizer::addVelocity(double t, double v, double omega)
{
  OdometryRecord next{t, {}};
  {
    const std::lock_guard lock(exchange_);
    if (last_odometry_)
      next.pose = compose(last_odometry_->pose, arcMotion(forward_, angular_, std::max(0.0, t - last_odometry_->time)));
    forward_ = v;
    angular_ = omega;
  }
  add(next);
}

void OnlineLocalizer::addDetections(double t, const std::string& sensor, std::vector<Detection> detections,
                                    const Pose2& T_robot_sensor, double sensor_height)
{
  add(Reading{.time = t,
              .sensor = sensor,
              .T_robot_sensor = T_robot_sensor,
              .sensor_height = sensor_height,
              .detections = std::move(detections)});
}

void OnlineLocalizer::add(Record record)
{
  if (const std::string why = whyImpossible(record); !why.empty()) throw dataError(why);
  const std::lock_guard lock(exchange_);
  if (const auto* odometry = std::get_if<OdometryRecord>(&record))
  {
    if (last_odometry_ && odometry->time < last_odometry_->time)
    {
      ++late_odometry_;
      return;
    }
    last_odometry_ = *odometry;
    recent_.add(*odometry);
  }
  inbox_.push_back(std::move(record));
}

void OnlineLocalizer::post(Event event)
{
  const std::lock_guard lock(exchange_);
  inbox_.push_back(std::move(event));
}

void OnlineLocalizer::take(const Event& event, std::vector<OnlineEstimate>& finished)
{
  if (const auto* restart = std::get_if<Restart>(&event)) restarts_.push_back(*restart);
  if (const auto* map = std::get_if<LandmarkTable>(&event))
  {
    collectAll(finished);  // in the map that the frames were seen in
    take(*map);
  }
  if (const auto* record = std::get_if<Record>(&event)) take(*record);
}

void OnlineLocalizer::take(const Record& record)
{
  if (const auto* odometry = std::get_if<OdometryRecord>(&record)) overview_.odometry.add(*odometry);
  newest_ = std::max(newest_, timeOf(record));
  frames_.push(record);
}

void OnlineLocalizer::take(const LandmarkTable& map)
{
  map_ = map;
  search_ = std::make_shared<const GlobalPoseSearch>(map_);
  restarts_.push_front(handover());
}

std::vector<OnlineEstimate> OnlineLocalizer::estimates()
{
  const std::lock_guard work(work_);
  std::vector<Event> events;
  {
    const std::lock_guard lock(exchange_);
    events.swap(inbox_);
  }
  std::vector<OnlineEstimate> finished;
  bool any = false;
  for (const Event& event : events)
  {
    take(event, finished);
    any = processReady(finished) || any;
  }
  if (any) return finished;
  steps_.goOn();
  collect(finished);
  return finished;
}

std::vector<OnlineEstimate> OnlineLocalizer::finish()
{
  std::vector<OnlineEstimate> finished = estimates();
  const std::lock_guard work(work_);
  newest_ = std::numeric_limits<double>::infinity();
  frames_.close();
  processReady(finished);
  collectAll(finished);
  return finished;
}

bool OnlineLocalizer::working() const
{
  const std::lock_guard work(work_);
  return steps_.hasWaiting();
}

bool OnlineLocalizer::processReady(std::vector<OnlineEstimate>& finished)
{
  bool any = false;
  for (auto stamp = frames_.readyStamp(); stamp && odometryReaches(*stamp); stamp = frames_.readyStamp())
  {
    any = true;
    steps_.add(frames_.pop());
    collect(finished);
    static_cast<void>(frames_.takeObjectFrames());
    // A restart moves its pose to the frame that it waits for.
    if (!steps_.hasWaiting()) overview_.odometry.forgetBefore(frames_.odometryNeededFrom());
  }
  return any;
}

void OnlineLocalizer::collect(std::vector<OnlineEstimate>& finished)
{
  while (const auto frame = steps_.next()) finished.push_back(stated(*frame));
}

void OnlineLocalizer::collectAll(std::vector<OnlineEstimate>& finished)
{
  while (steps_.hasWaiting())
  {
    steps_.goOn();
    collect(finished);
  }
}

bool OnlineLocalizer::odometryReaches(double stamp) const
{
  const Trajectory& odometry = overview_.odometry.trajectory();
  return options_.frames.independent || odometry.empty() || odometry.back().time >= stamp ||
         newest_ - stamp > options_.odometry_wait;
}

Estimate OnlineLocalizer::process(const Frame& frame)
{
  for (; !restarts_.empty() && restarts_.front().time <= frame.time; restarts_.pop_front())
    restart(restarts_.front(), frame.time);
  return filter_->process(frame);
}

OnlineEstimate OnlineLocalizer::stated(const SlicedLocalizer::Finished& finished)
{
  const FilterStep& step = filter_->lastStep();
  {
    const std::lock_guard lock(exchange_);
    newest_estimate_ = finished.estimate.point;
    recent_.forgetBefore(finished.frame.time);
  }
  return {.time = finished.frame.time,
          .best = finished.estimate.point,
          .modes = step.modes.modes,
          .verdict = step.verdict,
          .reason = reasonWithLateness(step.reason, finished.steps_late),
          .biases = step.biases,
          .steps_late = finished.steps_late};
}

void OnlineLocalizer::restart(const Restart& restart, double time)
{
  ParticleFilterOptions filter = options_.filter;
  if (starts_ > 0 && !restart.pose && filter.initial_mode == InitialMode::gaussian)
    filter.initial_mode = InitialMode::analytic;
  if (restart.pose)
  {
    const Trajectory& odometry = overview_.odometry.trajectory();
    const double first = odometry.empty() ? time : std::min(time, odometry.front().time);
    filter.initial_mode = InitialMode::gaussian;
    filter.initial_pose_measured = restart.measured;
    filter.initial_pose = moved(*restart.pose, overview_.odometry, std::max(first, restart.time), time, filter.motion);
  }
  for (std::size_t k = 0; k < restart.biases.size(); ++k)
  {
    filter.biases[k].mean = restart.biases[k].mean;
    filter.biases[k].std = restart.biases[k].std;
  }
  filter_ =
      std::make_unique<ParticleFilterLocalizer>(filter, map_, options_.seed_window, options_.seed, starts_++, search_);
}

std::optional<PoseEstimate> OnlineLocalizer::poseAt(double t) const
{
  const std::lock_guard lock(exchange_);
  if (!newest_estimate_ || t <= newest_estimate_->time || !newest_estimate_->heading_known) return newest_estimate_;
  PoseEstimate estimate = *newest_estimate_;
  estimate.pose = moved(estimate.pose, recent_, estimate.time, t, options_.filter.motion);
  estimate.time = t;
  return estimate;
}

void OnlineLocalizer::reset(double t, const std::optional<GaussianPose>& pose) { post(Restart{t, pose, {}, false}); }

void OnlineLocalizer::setMap(const LandmarkTable& map) { post(map); }

OnlineLocalizer::Restart OnlineLocalizer::handover() const
{
  const std::lock_guard lock(exchange_);
  Restart restart{-std::numeric_limits<double>::infinity(), {}, filter_->lastStep().biases, true};
  if (!newest_estimate_) return restart;
  restart.time = newest_estimate_->time;
  if (newest_estimate_->verdict == Verdict::ok && newest_estimate_->heading_known)
    restart.pose = newest_estimate_->pose;
  return restart;
}

std::string OnlineLocalizer::snapshot() const
{
  const std::lock_guard work(work_);
  const Restart saved = handover();
  return textOf(OnlineSnapshot{.pose = saved.pose, .biases = saved.biases});
}

void OnlineLocalizer::restore(const std::string& snapshot)
{
  OnlineSnapshot saved = snapshotFrom(snapshot);
  if (!saved.biases.empty() && saved.biases.size() != options_.filter.biases.size())
    throw dataError("snapshot: it has " + std::to_string(saved.biases.size()) + " systematic errors, expected the " +
                    std::to_string(options_.filter.biases.size()) + " of this configuration");
  post(Restart{-std::numeric_limits<double>::infinity(), saved.pose, std::move(saved.biases), true});
}

UnusableDetections OnlineLocalizer::unusable() const
{
  const std::lock_guard work(work_);
  UnusableDetections counts = frames_.unusable();
  const std::lock_guard lock(exchange_);
  if (late_odometry_ > 0) counts["odometry: older than the record before"] = late_odometry_;
  return counts;
}
}  // namespace mrpt_ext

#include "mrpt_ext/importers/rosbag2/well_known_definitions.h"

#include <map>

#include "mrpt_ext/importers/rosbag2/message_definition.h"

namespace mrpt_ext
{
namespace
{
/// Fields of the structures that messages share, in the form of .msg files; what comes behind in each text is what the
/// one before is made of.
const std::string kHeader = R"(
===
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
===
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
)";

const std::string kPose = R"(
===
MSG: geometry_msgs/Pose
Point position
Quaternion orientation
===
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
===
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
===
MSG: geometry_msgs/PoseWithCovariance
Pose pose
float64[36] covariance
)";

const std::string kVector = R"(
===
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
)";

const std::string kTwist = R"(
===
MSG: geometry_msgs/TwistWithCovariance
Twist twist
float64[36] covariance
===
MSG: geometry_msgs/Twist
Vector3 linear
Vector3 angular
)";

const std::string kTransform = R"(
===
MSG: geometry_msgs/Transform
Vector3 translation
Quaternion rotation
)";

const std::string kTransformStamped = R"(std_msgs/Header header
string child_frame_id
geometry_msgs/Transform transform
)";

const std::string kReflector = R"(
===
MSG: sick_scan_xd/NAVReflectorData
uint16 cartesian_data_valid
int32 x
int32 y
uint16 polar_data_valid
uint32 dist
uint32 phi
uint16 opt_reflector_data_valid
uint16 local_id
uint16 global_id
uint8 type
uint16 sub_type
uint16 quality
uint32 timestamp
uint16 size
uint16 hit_count
uint16 mean_echo
uint16 start_index
uint16 end_index
)";

const std::string kReflectorInRosAxes = R"(int8 pos_valid
float32 pos_x
float32 pos_y
)";

std::string tags(const std::string& centre_and_corners)
{
  return "std_msgs/Header header\nAprilTagDetection[] detections\n" + kHeader + R"(
===
MSG: apriltag_msgs/AprilTagDetection
string family
int32 id
int32 hamming
float32 goodness
float32 decision_margin
)" + centre_and_corners +
         "float64[9] homography\n";
}

std::string objects(const std::string& hypothesis, const std::string& end_of_detection)
{
  return "std_msgs/Header header\nDetection3D[] detections\n" + kHeader + R"(
===
MSG: vision_msgs/Detection3D
std_msgs/Header header
ObjectHypothesisWithPose[] results
BoundingBox3D bbox
)" + end_of_detection +
         R"(===
MSG: vision_msgs/BoundingBox3D
geometry_msgs/Pose center
geometry_msgs/Vector3 size
===
MSG: vision_msgs/ObjectHypothesis
string class_id
float64 score
===
MSG: vision_msgs/ObjectHypothesisWithPose
)" + hypothesis +
         "geometry_msgs/PoseWithCovariance pose\n" + kPose + kVector;
}

std::map<std::string, std::vector<std::string>> makeDefinitions()
{
  const std::string landmarks =
      "std_msgs/Header header\nuint8 landmark_filter\nuint16 num_reflectors\nNAVReflectorData[] reflectors\n" +
      kHeader + kReflector;
  const std::string header = "std_msgs/Header header\n";
  return {
      {"nav_msgs/Odometry",
       {header +
        "string child_frame_id\ngeometry_msgs/PoseWithCovariance pose\ngeometry_msgs/TwistWithCovariance twist\n" +
        kHeader + kPose + kTwist + kVector}},
      {"tf2_msgs/TFMessage",
       {"geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\n" + kTransformStamped +
        kHeader + kTransform + kVector + kPose}},
      {"geometry_msgs/TransformStamped", {kTransformStamped + kHeader + kTransform + kVector + kPose}},
      {"geometry_msgs/PoseStamped", {header + "Pose pose\n" + kHeader + kPose}},
      {"geometry_msgs/PoseWithCovarianceStamped", {header + "PoseWithCovariance pose\n" + kHeader + kPose}},
      {"geometry_msgs/PointStamped", {header + "Point point\n" + kHeader + kPose}},
      {"apriltag_msgs/AprilTagDetectionArray", {tags("float64[2] centre\nfloat64[8] corners\n")}},
      {"sensor_msgs/CameraInfo",
       {header +
        "uint32 height\nuint32 width\nstring distortion_model\nfloat64[] d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\n"
        "uint32 binning_x\nuint32 binning_y\nRegionOfInterest roi\n" +
        kHeader +
        "===\nMSG: sensor_msgs/RegionOfInterest\nuint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool "
        "do_rectify\n"}},
      {"vision_msgs/Detection3DArray",
       {objects("ObjectHypothesis hypothesis\n", "string id\n"), objects("string id\nfloat64 score\n", "")}},
      {"sick_scan_xd/NAVLandmarkData", {landmarks + kReflectorInRosAxes, landmarks}},
      {"sensor_msgs/Range",
       {header +
            "uint8 radiation_type\nfloat32 field_of_view\nfloat32 min_range\nfloat32 max_range\nfloat32 range\n"
            "float32 variance\n" +
            kHeader,
        header + "uint8 radiation_type\nfloat32 field_of_view\nfloat32 min_range\nfloat32 max_range\nfloat32 range\n" +
            kHeader}},
      {"sensor_msgs/LaserScan",
       {header +
        "float32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\n"
        "float32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities\n" +
        kHeader}}};
}
}  // namespace

std::vector<std::string> wellKnownDefinitions(const std::string& type)
{
  static const auto kDefinitions = makeDefinitions();
  const auto found = kDefinitions.find(shortTypeName(type));
  return found == kDefinitions.end() ? std::vector<std::string>() : found->second;
}
}  // namespace mrpt_ext
